#!/usr/bin/python3
"""Two storeys with damped modes beside a neighbour that they cannot hit: an independent integration
in space, the gap of the contact that is switched off, one derived quantity in a motion and a grid.

usage: check_storeys.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np
from scipy.linalg import eigh
from scipy.integrate import solve_ivp

from program_runs import ProgramRuns, main

FILE = """
set Variables = push = 3 m/s^2
subsection Body lower
  set Type = lumped
  subsection Mass floor
    set Mass = 20 t
    set Stiffness = 30 MN/m
  end
end
subsection Body upper
  set Type = lumped
  subsection Mass floor
    set Mass = 15 t
  end
end
subsection Connection columns
  set Between = lower.floor, upper.floor
  set Stiffness = 20 MN/m
end
subsection System damping
  set Damping ratio = 0.05, 0.03
end
subsection Contact neighbour
  set Between = upper.floor, stop
  set Clearance = 20 mm
  set Law = linear penalty
  subsection Linear penalty
    set Stiffness = 500 MN/m
  end
end
subsection Excitation ground
  set Type = base acceleration
  set Amplitude = push
  set Frequency = 4 Hz
end
subsection Integration
  set Relative tolerance = 1e-11
end
subsection Analysis modes
  set Type = modal
end
subsection Analysis beside
  set Type = transient
  set Active contacts = none
  set Observed contacts = neighbour
  set Record = extreme values, energy
  subsection Transient
    set Duration = 1 s
  end
end
subsection Analysis pushes
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = beside
    subsection Key push
      set Path = Variables/push
      set Values = 1 m/s^2, 3 m/s^2
    end
  end
end
subsection Derived room
  set From = beside, pushes
  set Operation = expression
  set Fields = gap = recorded/contact/neighbour/gap/minimum
  set Expression = gap/(20 mm)
end
"""

MASS = np.diag([20e3, 15e3])
STIFFNESS = np.array([[50e6, -20e6], [-20e6, 20e6]])
OMEGA = 2 * np.pi * 4


def smallest_gap():
    """Motion relative to the ground, the gap to a stop fixed in space."""
    squares, shapes = eigh(STIFFNESS, MASS)
    rates = 2 * np.array([0.05, 0.03]) * np.sqrt(squares)
    damping = MASS @ shapes @ np.diag(rates) @ shapes.T @ MASS

    def rate(t, y):
        push = 3 * np.sin(OMEGA * t)
        force = -STIFFNESS @ y[:2] - damping @ y[2:] - MASS @ np.full(2, push)
        return np.concatenate([y[2:], np.linalg.solve(MASS, force)])

    motion = solve_ivp(rate, (0, 1), np.zeros(4), method="DOP853", rtol=1e-12, atol=1e-14,
                       dense_output=True)
    times = np.linspace(0, 1, 200001)
    ground = -3 * np.sin(OMEGA * times) / OMEGA**2
    return np.min(0.02 - motion.sol(times)[1] - ground)


class Storeys(ProgramRuns):
    def setUp(self):
        super().setUp()
        self.file.write_text(FILE)

    def test_damped_modes_observed_gap_and_derived_grid(self):
        done = self.run_program(self.file, "--output", "out")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "out" / "results.h5") as results:
            analysis = results["analysis"]
            np.testing.assert_allclose(analysis["modes/system/damping_ratio"], [0.05, 0.03],
                                       rtol=1e-12)
            beside = analysis["beside"]
            gap = beside["recorded/contact/neighbour/gap/minimum"][()]
            self.assertLess(abs(gap - smallest_gap()), 1e-10)
            self.assertLess(gap, 0)
            lost = beside["recorded/system_damping/dissipated_energy"][()]
            self.assertGreater(lost, 0)
            self.assertLess(abs(beside["recorded/energy/residual"][()]), 1e-10 * lost)
            room = analysis["pushes/derived/room"][()]
            self.assertEqual(room.shape, (2,))
            self.assertEqual(room[1], beside["derived/room"][()])

    def test_an_active_contact_cannot_be_observed(self):
        self.file.write_text(FILE.replace("Active contacts = none", "Active contacts = neighbour"))
        done = self.run_program(self.file, "--output", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("must not name neighbour, which is among Active contacts", done.stderr)


if __name__ == "__main__":
    main()
