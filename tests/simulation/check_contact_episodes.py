#!/usr/bin/python3
"""Nonlinear contacts of whole runs, counted by how they were solved: the same numbers on any number of
ranks and after a kill, all contacts of a motion, and the reason for those in steps.

usage: check_contact_episodes.py PROGRAM MPIEXEC
"""
import numpy as np

import h5py

from program_runs import ProgramRuns, main

FILE = """
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 1 kg
    set Stiffness = 1 kN/m
    set Damping = 2 N s/m
  end
end
subsection Contact stop
  set Between = block.head, stop
  set Clearance = 2 mm
  set Law = hertz
  subsection Hertz
    set Stiffness = 1e8 N/m^1.5
  end
end
subsection Excitation shaker
  set Type = force
  set At = block.head
  set Amplitude = 8 N
  set Frequency = 5 Hz
end
subsection Analysis response
  set Type = stepped sweep
  subsection Stepped sweep
    set First frequency = 4 Hz
    set Last frequency = 6 Hz
    set Points = 3
    set Settling cycles = 8
    set Recorded cycles = 2
  end
end
subsection Analysis map
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = response
    subsection Key clearance
      set Path = Contact/stop/Clearance
      set First = 1 mm
      set Last = 6 mm
      set Points = 40
    end
  end
end
subsection Analysis start
  set Type = transient
  subsection Transient
    set Duration = 8 s
  end
end
"""
REASONS = ("method", "system", "undecided", "law", "interrupted", "fast", "shape", "neighbour", "shallow", "pause")


class ContactEpisodes(ProgramRuns):
    def setUp(self):
        super().setUp()
        self.file.write_text(FILE)

    def run_to(self, name, *more):
        out = self.folder / name
        done = self.run_program(self.file, "--output", out, *more)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(out / "results.h5") as file:
            found = {}
            file["analysis"].visititems(
                lambda path, item: found.update({path: np.ravel(item[()])})
                if isinstance(item, h5py.Dataset) else None)
        return found, (out / "summary.txt").read_text()

    def test_same_numbers_on_all_ranks_and_after_a_kill(self):
        self.expect_same_bytes()
        with h5py.File(self.folder / "cut" / "results.h5") as file:
            self.assertGreater(np.sum(file["analysis/map/contact_episodes"]), 1000)

    def test_numbers_are_those_of_the_impacts(self):
        for name, more in (("exact", ()), ("rk", ("Integration/Method=rk",)),
                           ("short", ("Integration/Maximum step=1e-4 s",))):
            found, summary = self.run_to(name, "--set", "Analyses=start",
                                         *(part for key in more for part in ("--set", key)))
            whole, stepped = (found[f"start/{name}"][0]
                              for name in ("contact_episodes", "stepped_contacts"))
            self.assertEqual(whole + stepped, len(found["start/contact/stop/impact/time"]))
            reasons = {reason: found[f"start/stepped_contacts_{reason}"][0] for reason in REASONS}
            self.assertEqual(sum(reasons.values()), stepped)
            expected = {"exact": None, "rk": "method", "short": "interrupted"}[name]
            if expected is None:
                self.assertGreater(whole, 10)
                self.assertEqual(stepped, 0)
                self.assertNotIn("stepped_contacts_", summary)
            else:
                self.assertGreater(reasons[expected], 10)
                self.assertEqual(reasons[expected], stepped)
                self.assertIn(f"stepped_contacts_{expected}", summary)
                self.assertNotIn("stepped_contacts_pause", summary)


if __name__ == "__main__":
    main()
