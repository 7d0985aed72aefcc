#!/usr/bin/python3
"""Designs of isolators as a user runs them: one in other units than the shipped file, a grid of them on several
ranks, conditions that no stop meets, a branch that cannot be followed.

usage: check_isolator.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

from program_runs import ProgramRuns, main

# 2 kg on 800 N/m: 20 rad/s; zeta_0 = 0.01, zeta_1 = 0.2, F/k_0 = 1.04 mm.
FILE = """
set Variables = k1 = 1600, d = 0.002, c1 = 16, omega = 30
set Analyses = {analyses}
subsection Body isolator
  set Type = lumped
  subsection Mass mass
    set Mass = 2 kg
    set Axis = y
    set Stiffness = 800 N/m
    set Damping = 0.8 N s/m
  end
end
subsection Contact up
  set Between = isolator.mass, stop
  set Direction = y
  set Clearance = d * 1 m
  set Law = bilinear stop
  subsection Bilinear stop
    set Stiffness = k1 * 1 N/m
    set Damping constant = c1 * 1 N s/m
  end
end
subsection Contact down
  set Between = isolator.mass, stop
  set Direction = -y
  set Clearance = d * 1 m
  set Law = bilinear stop
  subsection Bilinear stop
    set Stiffness = k1 * 1 N/m
    set Damping constant = c1 * 1 N s/m
  end
end
subsection Excitation force
  set Type = force
  set At = isolator.mass
  set Direction = y
  set Amplitude = 0.832 N
  set Frequency = omega * 1 rad/s
end
subsection Analysis curve
  set Type = branch
  set Record = extreme values
  subsection Branch
    set First frequency = 18 rad/s
    set Last frequency = 60 rad/s
    set Longest step = 0.05
    set Most points = {points}
  end
end
subsection Analysis design
  set Type = isolator design
  subsection Isolator design
    set Working frequency = {working} rad/s
    set Allowed displacement = 2.4 mm
    set Prefer = largest clearance
    set Points = 20
    set First unfolding parameters = 0.1
    set Second unfolding parameters = -0.1
    set Repeat = curve
    set Stiffness key = Variables/k1
    set Clearance key = Variables/d
  end
end
subsection Analysis designs
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = design
    subsection Key damping
      set Path = Variables/c1
      set Values = 12, 16, 20
    end
  end
end
"""


class Isolators(ProgramRuns):
    def design(self, code=0, working=55, points=5000):
        self.file.write_text(FILE.format(analyses="design", working=working, points=points),
                             encoding="utf-8")
        done = self.run_program(self.file, "--output", self.folder / "out")
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.output = done.stdout + done.stderr
        return h5py.File(self.folder / "out" / "results.h5")["analysis/design"]

    def test_a_design_in_units_is_the_dimensionless_one(self):
        """1.04 mm of static displacement: f = 1.75952 leaves 0.59107 mm of clearance."""
        design = self.design()
        stop = design["stop"]
        self.assertAlmostEqual(design["natural_frequency"][()], 20 / (2 * np.pi), 12)
        self.assertAlmostEqual(design["largest_force"][()], 6.5627305, 7)
        self.assertAlmostEqual(stop["clearance"][0], 1.04e-3 / 1.75952, 8)
        self.assertAlmostEqual(stop["stop_stiffness"][0], 800 * 1.69256, 2)
        self.assertEqual(stop["exact/folds"][0], 0)
        self.assertLess(abs(stop["exact/peak"][0] / 2.4e-3 - 1), 0.01)
        listed = list(stop["kind"][:]).index(9)
        np.testing.assert_allclose(stop["exact/fold_ratio"][listed], [1.548395, 1.755699], 0, 1e-6)
        self.assertEqual(stop["exact/folds"].attrs["unit"], "1")

    def test_conditions_that_no_stop_meets_fail_with_a_reason(self):
        design = self.design(code=3, working=30)
        self.assertEqual(design["status"][()], 1)
        self.assertIn("no stop meets all conditions", self.output)
        self.assertNotIn(1, design["stop/kind"][:])
        self.assertTrue(np.isnan(design["corner/resonance_and_jump/force"][()]))

    def test_a_branch_that_ends_early_has_no_number_of_folds(self):
        design = self.design(points=5)
        self.assertTrue(np.isnan(design["stop/exact/folds"][:]).all())
        self.assertIn("folds may be missing", str(design["reason"][()]))

    def test_same_bytes_on_all_ranks_and_after_a_kill(self):
        self.file.write_text(FILE.format(analyses="designs", working=55, points=5000),
                             encoding="utf-8")
        self.expect_same_bytes()


if __name__ == "__main__":
    main()
