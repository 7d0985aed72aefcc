#!/usr/bin/python3
"""Loci of special points in two keys as a user runs them.

usage: check_loci.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

from isolator import isolator
from program_runs import ProgramRuns, main

ISOLATOR = "set Variables = f = 0.52, lambda = 1.3, mu = 2\n" + isolator(
    "mu * 1 N/m", "f * 1 N", "lambda * 1 rad/s") + """
subsection Analysis folds
  set Type = locus
  subsection Locus
    subsection First key
      set First frequency = 0.5 rad/s
      set Last frequency = 2 rad/s
    end
    subsection Second key
      set Parameter = Variables/mu
      set First = 0.5
      set Last = 3
    end
  end
end
subsection Analysis grazes
  set Type = locus
  set Record = extreme values, impacts
  subsection Locus
    set Kinds = graze
    subsection First key
      set First frequency = 0.2 rad/s
      set Last frequency = 2 rad/s
    end
    subsection Second key
      set Parameter = Variables/f
      set First = 0.2
      set Last = 0.9
    end
  end
end
subsection Analysis family
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = folds
    subsection Key f
      set Path = Variables/f
      set Values = 0.5, 0.52, 0.54
    end
  end
end
"""


class Loci(ProgramRuns):
    def setUp(self):
        super().setUp()
        self.file.write_text(ISOLATOR)

    def test_ranks_and_resume_give_the_same_bytes(self):
        self.expect_same_bytes()

    def test_results(self):
        out = self.folder / "out"
        done = self.run_program(self.file, "--output", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(out / "results.h5") as file:
            folds = file["analysis/folds"]
            self.assertEqual(folds["special/kind"][()].tolist(), [1])
            # One curve that comes down to the cusp and goes up again, both folds of mu = 2 on it.
            self.assertEqual(folds["end/reason"][()].tolist(), [0, 0])
            self.assertEqual(folds["end/Variables.mu"][()].tolist(), [3, 3])
            order = folds["arclength"][()]
            self.assertTrue((np.diff(order) > 0).all())
            self.assertLess(order[0], 0)
            self.assertLess(folds["locus_residual"][()].max(), 1e-10)
            # At folds a multiplier of half the motion is 1, and so is its square.
            multipliers = folds["multiplier_real"][()]
            np.testing.assert_allclose(np.abs(multipliers - 1).min(axis=1), 0, atol=1e-8)
            self.assertTrue((folds["kind"][()] == 1).all())

            grazes = file["analysis/grazes"]
            number = grazes["locus"][()]
            self.assertGreaterEqual(len(np.unique(number)), 1)
            w = 2 * np.pi * grazes["frequency"][()]
            np.testing.assert_allclose(grazes["Variables.f"][()],
                                       np.abs(1 - w**2 + 0.02j * w), atol=1e-12)
            np.testing.assert_allclose(
                grazes["point/mass.head/displacement_x/largest"][()], 1, atol=1e-9)
            self.assertEqual(file["analysis/family/status"][()].tolist(), [0, 0, 0])
            cusps = file["analysis/family/special/Variables.mu"][:, 0]
            self.assertEqual(cusps[1], folds["special/Variables.mu"][0])

    def test_without_a_special_point(self):
        # 0.01 / 0.02 in resonance does not touch the stops.
        out = self.folder / "out"
        done = self.run_program(self.file, "--output", out, "--set", "Analyses=folds",
                                "--set", "Variables/f=0.01")
        self.assertEqual(done.returncode, 3)
        self.assertIn("no special point of the kinds", done.stdout + done.stderr)


if __name__ == "__main__":
    main()
