#!/usr/bin/python3
"""Stepped sweeps as a user runs them: any key, from rest, with bracketed jumps.

usage: check_sweeps.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

from isolator import isolator
from program_runs import ProgramRuns, main

FILE = isolator() + """
subsection Integration
  set Relative tolerance = 1e-9
end
subsection Analysis frequency
  set Type = stepped sweep
  subsection Stepped sweep
    set First frequency = 1.2 rad/s
    set Last frequency = 1.4 rad/s
    set Points = 5
    set Settling cycles = 150
    set Recorded cycles = 2
    set Jump tolerance = 1e-4
  end
end
subsection Analysis clearance
  set Type = stepped sweep
  subsection Stepped sweep
    set Parameter = Contact/right/Clearance
    set First = 800 mm
    set Last = 1.2 m
    set Points = 3
    set Recorded cycles = 2
    set Jump tolerance = 1e-3
  end
end
subsection Analysis rest
  set Type = stepped sweep
  subsection Stepped sweep
    set Parameter = Contact/right/Clearance
    set First = 800 mm
    set Last = 1.2 m
    set Points = 3
    set Recorded cycles = 2
    set Start = initial conditions
  end
end
subsection Analysis one
  set Type = stepped sweep
  subsection Stepped sweep
    set First frequency = 1.1 rad/s
    set Last frequency = 1.1 rad/s
    set Points = 1
    set Direction = forward
    set Recorded cycles = 2
  end
end
subsection Analysis grid
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = one
    subsection Key clearance
      set Path = Contact/right/Clearance
      set Values = 0.8 m, 1 m, 1.2 m
    end
  end
end
subsection Analysis shifted
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = one
    subsection Key first
      set Path = Analysis/one/Stepped sweep/First frequency
      set Values = 1.1 rad/s, 1.2 rad/s
    end
    subsection Key last
      set Tied to = first
      set Path = Analysis/one/Stepped sweep/Last frequency
      set Values = 1.1 rad/s, 1.2 rad/s
    end
  end
end
subsection Analysis linear
  set Type = frequency response
  subsection Frequency response
    set First frequency = 0.5 rad/s
    set Last frequency = 2 rad/s
    set Points = 16
  end
end
"""
PEAK = "point/mass.head/displacement_x/largest"


class Sweeps(ProgramRuns):
    def setUp(self):
        super().setUp()
        self.file.write_text(FILE)

    def read(self, out, path):
        with h5py.File(out / "results.h5") as file:
            return file["analysis/" + path][()]

    def test_ranks_and_resume_give_the_same_bytes(self):
        self.expect_same_bytes()

    def test_what_the_sweeps_give(self):
        out = self.folder / "out"
        done = self.run_program(self.file, "--output", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # With few settling cycles the upper jump is late, but it is there, and so is the lower.
        rising = 2 * np.pi * self.read(out, "frequency/jump_to")[:, 0]
        falling = 2 * np.pi * self.read(out, "frequency/jump_to")[:, 1]
        self.assertEqual(np.count_nonzero(~np.isnan(rising)), 1)
        self.assertEqual(np.count_nonzero(~np.isnan(falling)), 1)
        self.assertAlmostEqual(np.nanmax(rising), 1.362748, delta=5e-4)
        self.assertAlmostEqual(np.nanmax(falling), 1.231279, delta=5e-4)
        self.assertIn("jump_from", (out / "summary.txt").read_text())
        # Where the response is unique: carried over, from rest and grid agree.
        grid = self.read(out, "grid/" + PEAK)[:, 0, 0]
        for values in (self.read(out, "clearance/" + PEAK)[:, 0],
                       self.read(out, "clearance/" + PEAK)[:, 1],
                       self.read(out, "rest/" + PEAK)[:, 0]):
            np.testing.assert_allclose(values, grid, rtol=1e-5)
        axis = self.read(out, "clearance/Contact.right.Clearance")
        np.testing.assert_allclose(axis, [0.8, 1, 1.2], rtol=1e-15)
        # A grid that changes an axis tells its values at each point.
        own = self.read(out, "shifted/own/frequency").ravel()
        np.testing.assert_allclose(own, [np.nan, 1.2 / (2 * np.pi)], rtol=1e-15)
        # 0.52 over 2 z sqrt(1 - z^2) with z = 0.01
        peak = self.read(out, "linear/peak/point/mass.head/displacement_x/amplitude")
        self.assertAlmostEqual(float(peak), 0.52 / (0.02 * np.sqrt(1 - 1e-4)), delta=1e-9)


if __name__ == "__main__":
    main()
