#!/usr/bin/python3
"""SIGINT and SIGTERM are obeyed wherever the program is: while it reduces a body, tries motions for
an estimate, or is in the midst of a motion; what was finished is kept, and the run goes on. The
bounds are generous: they tell obedience from its absence, not fast from slow.

usage: check_signals.py PROGRAM MPIEXEC
"""
import signal
import subprocess
import sys
import time
import unittest

import h5py

import check_runs

# Takes minutes to reduce.
PLATE = """
subsection Body plate
  set Type = shell
  subsection Geometry
    set Plate = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m -> 0 m, 1 m, 0 m
    set Divisions = 300, 300
  end
  subsection Material
    set Young modulus = 200 GPa
    set Density = 8000 kg/m^3
  end
  subsection Shell sheet
    set Thickness = 3 mm
  end
  subsection Support edges
    set At = edges
    set Fix = all
  end
  subsection Modes
    set Number = 40
  end
end
subsection Analysis modes
  set Type = modal
end
"""
# A mass that knocks at a stop, for a short and for an endless time.
KNOCKING = """
subsection Body mass
  set Type = lumped
  subsection Mass head
    set Mass = 1 kg
    set Stiffness = 100 N/m
    set Damping = 1 N s/m
  end
end
subsection Contact stop
  set Between = mass.head
  set Clearance = 5 mm
  set Law = hertz
  subsection Hertz
    set Stiffness = 1e8 N/m^1.5
  end
end
subsection Excitation push
  set Type = force
  set At = mass.head
  set Amplitude = 20 N
  set Frequency = 1.5 Hz
end
set Analyses = cases
subsection Analysis one
  set Type = TYPE
  subsection Transient
    set Duration = 100 s
    set Sampling interval = 50 s
  end
  subsection Response
    set Settling cycles = 1
    set Recorded cycles = 1
  end
end
subsection Analysis cases
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = one
    subsection Key swept
      set Path = PATH
      set Values = VALUES
    end
  end
end
"""
ENDLESS = {"transient": ("Analysis/one/Transient/Duration", "100 s, 4e7 s"),
           "response": ("Analysis/one/Response/Settling cycles", "5, 1000000000")}
OBEDIENT = 10  # seconds


class Signals(check_runs.Runs):
    def start(self, *arguments, ranks=1):
        return subprocess.Popen(self.command(*arguments, ranks=ranks), cwd=self.folder, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def end(self, process, number):
        """Exit code and what was printed behind a signal."""
        self.assertIsNone(process.poll(), "the work is shorter than the test needs it")
        sent = time.monotonic()
        process.send_signal(number)
        try:
            out, error = process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            self.fail("the signal was not obeyed")
        self.assertLess(time.monotonic() - sent, OBEDIENT)
        return process.returncode, out + error

    def knocking(self, kind):
        path, values = ENDLESS[kind]
        text = KNOCKING.replace("TYPE", kind).replace("PATH", path).replace("VALUES", values)
        if kind == "response":
            text = text.replace("set Settling cycles = 1\n",
                                "set Minimum settling cycles = 0\n"
                                "    set Steadiness tolerance = 0\n    set Settling cycles = 1\n")
        self.file.write_text(text)

    def test_a_reduction_ends_at_once(self):
        self.file.write_text(PLATE)
        for number in (signal.SIGINT, signal.SIGTERM):
            out = self.folder / f"out{number}"
            process = self.start(self.file, "--output", out)
            time.sleep(2)
            code, text = self.end(process, number)
            self.assertEqual(code, 4, text)
            self.assertEqual(text.count("stopped by a signal"), 1)
            self.assertFalse(out.exists())

    def test_a_reduction_on_two_ranks_ends(self):
        self.file.write_text(PLATE)
        process = self.start(self.file, "--output", self.folder / "out", ranks=2)
        time.sleep(2)
        code, text = self.end(process, signal.SIGTERM)
        self.assertNotEqual(code, 0)
        self.assertLessEqual(text.count("stopped by a signal"), 1)

    def test_a_motion_ends_and_goes_on(self):
        for kind in ENDLESS:
            self.knocking(kind)
            for ranks in (1, 2):
                out = self.folder / f"{kind}{ranks}"
                process = self.start(self.file, "--output", out, ranks=ranks)
                for _ in range(2):
                    self.wait_for_journal(out / "journal", 1000, process)
                    code, text = self.end(process, signal.SIGTERM)
                    if ranks == 1:
                        self.assertEqual(code, 4, text)
                        self.assertIn("--resume", text)
                        with h5py.File(out / "results.h5") as file:
                            self.assertEqual(file["analysis/cases/status"][()].tolist(), [0, -1])
                    process = self.start("--resume", out, ranks=ranks)
                    time.sleep(2)
                self.end(process, signal.SIGINT)

    def test_a_check_ends_by_itself_and_by_a_signal(self):
        for kind in ENDLESS:
            self.knocking(kind)
            started = self.start(self.file, "--check")
            out, error = started.communicate(timeout=60)
            self.assertEqual(started.returncode, 0, out + error)
            self.assertIn("of computing", out)
        process = self.start(self.file, "--check")
        time.sleep(1.5)
        if process.poll() is None:
            self.assertEqual(self.end(process, signal.SIGTERM)[0], 4)


if __name__ == "__main__":
    # Not those of the class it borrows the set-up from.
    own = [name for name in vars(Signals) if name.startswith("test_")]
    done = unittest.TextTestRunner().run(unittest.TestSuite(map(Signals, own)))
    sys.exit(0 if done.wasSuccessful() else 1)
