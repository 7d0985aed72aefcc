#!/usr/bin/python3
"""Harmonic balances as a user runs them: over a grid and along a key on any number of ranks, resumed, and
from the coefficients of another one.

usage: check_balances.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

from check_basins import ISOLATOR
from program_runs import ProgramRuns, main

BALANCES = ISOLATOR[:ISOLATOR.index("subsection Analysis plane")] + """
set Analyses = harmonics, stiffness
subsection Analysis balance
  set Type = harmonic balance
  subsection Harmonic balance
    set First frequency = 1.1 rad/s
    set Last frequency = 1.6 rad/s
    set Longest step = 0.2
  end
end
subsection Analysis harmonics
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = balance
    subsection Key harmonics
      set Path = Analysis/balance/Harmonic balance/Harmonics
      set Values = 1, 2, 3, 5, 7, 9
    end
  end
end
subsection Analysis stiffness
  set Type = harmonic balance
  subsection Harmonic balance
    set Parameter = Contact/right/Bilinear stop/Stiffness
    set First = 1 N/m
    set Last = 3 N/m
    set Guess = GUESS
    set Longest step = 0.2
  end
end
"""


class BalancesRun(ProgramRuns):
    def test_ranks_and_resume(self):
        self.file.write_text(BALANCES.replace("GUESS", "0, -1.9, 1"))
        self.expect_same_bytes()

    def test_coefficients_are_a_guess(self):
        self.file.write_text(BALANCES.replace("GUESS", "0, -1.9, 1"))
        done = self.run_program(self.file, "--output", "first", "--set", "Analyses=stiffness")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "first/results.h5") as file:
            first = file["analysis/stiffness"]
            at_start = np.flatnonzero(first["arclength"][:] == 0)[0]
            coefficients = first["coefficients"][at_start, 0]
            self.assertGreater(first["point/mass.head/displacement_x/largest"][at_start], 1)
        guess = ", ".join(map(repr, coefficients.tolist()))
        self.file.write_text(BALANCES.replace("GUESS", guess))
        done = self.run_program(self.file, "--output", "again", "--set", "Analyses=stiffness")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "again/results.h5") as file:
            again = file["analysis/stiffness"]
            at_start = np.flatnonzero(again["arclength"][:] == 0)[0]
            np.testing.assert_allclose(again["coefficients"][at_start, 0], coefficients,
                                       atol=1e-11)


if __name__ == "__main__":
    main()
