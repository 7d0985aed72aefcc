#!/usr/bin/python3
"""SIGINT and SIGTERM are obeyed wherever the program is: while it reduces a body, tries motions for
an estimate, or is in the midst of a motion; what was finished is kept, and the run goes on. Waiting and
bounds are in processor time of the program, which other work on the machine does not change; the bounds are
generous: they tell obedience from its absence, not fast from slow.

usage: check_signals.py PROGRAM MPIEXEC
"""
import os
import pathlib
import signal
import subprocess
import tempfile
import time

import h5py

from program_runs import ProgramRuns, main

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
# A mass that knocks at a stop, for a short and for an endless time. It is pushed at two frequencies whose
# ratio is irrational, so that no state comes again and no periodic motion can be found.
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
subsection Excitation other
  set Type = force
  set At = mass.head
  set Amplitude = 5 N
  set Frequency = sqrt(2) * 1.5 Hz
end
set Analyses = cases
subsection Analysis one
  set Type = TYPE
  subsection Transient
    set Duration = 100 s
    set Sampling interval = 50 s
  end
  subsection Steady state
    set Excitation = push
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
           "steady state": ("Analysis/one/Steady state/Settling cycles", "5, 1000000000")}
OBEDIENT = 10  # seconds of processor time
HUNG = 600  # seconds, after which a process that does nothing is given up


def processor_time(pid):
    """Of a process, its children, and those it has waited for [s]; 0 once it is gone."""
    try:
        numbers = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
        children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except (FileNotFoundError, ProcessLookupError):
        return 0
    own = sum(map(int, numbers[11:15])) / os.sysconf("SC_CLK_TCK")
    return own + sum(map(processor_time, children))


class Signals(ProgramRuns):
    def start(self, *arguments, ranks=1):
        """A process with a file `printed` of its own."""
        number, path = tempfile.mkstemp(dir=self.folder)
        with open(number, "w", encoding="utf-8") as printed:
            process = subprocess.Popen(self.command(*arguments, ranks=ranks), cwd=self.folder,
                                       stdout=printed, stderr=subprocess.STDOUT)
        process.printed = pathlib.Path(path)
        return process

    def wait_for_handlers(self, *processes):
        """Before that a signal ends any program; of one rank."""
        interrupt = 1 << (signal.SIGINT - 1)
        for process in processes:
            status = pathlib.Path(f"/proc/{process.pid}/status")
            while process.poll() is None and not interrupt & int(
                    status.read_text().split("SigCgt:")[1].split()[0], 16):
                time.sleep(0.02)

    def wait_until_printed(self, text, *processes):
        for process in processes:
            while process.poll() is None and text not in process.printed.read_text():
                time.sleep(0.02)

    def wait_for_work(self, seconds, *processes):
        """Until each has computed for so long, or is over."""
        for process in processes:
            end = processor_time(process.pid) + seconds
            while process.poll() is None and processor_time(process.pid) < end:
                time.sleep(0.02)

    def end(self, process, number):
        """Exit code and what was printed behind a signal."""
        self.assertIsNone(process.poll(), "the work is shorter than the test needs it")
        latest = processor_time(process.pid) + OBEDIENT
        process.send_signal(number)
        for _ in range(HUNG * 50):
            # It stays a zombie, whose times can be read.
            over = os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT)
            if processor_time(process.pid) > latest or over:
                break
            time.sleep(0.02)
        used = processor_time(process.pid)
        if not over:
            process.kill()
        process.wait()
        self.assertTrue(over, "the signal was not obeyed")
        self.assertLess(used, latest)
        return process.returncode, process.printed.read_text()

    def knocking(self, kind):
        path, values = ENDLESS[kind]
        text = KNOCKING.replace("TYPE", kind).replace("PATH", path).replace("VALUES", values)
        if kind == "steady state":
            text = text.replace("set Settling cycles = 1\n",
                                "set Minimum settling cycles = 0\n"
                                "    set Steadiness tolerance = 0\n    set Settling cycles = 1\n")
        file = self.folder / f"{kind}.prm"
        file.write_text(text)
        return file

    def test_a_reduction_ends_at_once(self):
        self.file.write_text(PLATE)
        started = {number: self.start(self.file, "--output", self.folder / f"out{number}")
                   for number in (signal.SIGINT, signal.SIGTERM)}
        self.wait_for_handlers(*started.values())
        self.wait_for_work(1.5, *started.values())
        for number, process in started.items():
            code, text = self.end(process, number)
            self.assertEqual(code, 4, text)
            self.assertEqual(text.count("stopped by a signal"), 1)
            self.assertFalse((self.folder / f"out{number}").exists())

    def test_a_reduction_on_two_ranks_ends(self):
        self.file.write_text(PLATE)
        process = self.start(self.file, "--output", self.folder / "out", ranks=2)
        self.wait_for_work(2, process)
        code, text = self.end(process, signal.SIGTERM)
        self.assertNotEqual(code, 0)
        self.assertLessEqual(text.count("stopped by a signal"), 1)

    def stop_and_resume(self, kinds, ranks, numbers):
        """All kinds beside each other."""
        started = {kind: self.start(self.knocking(kind), "--output", self.folder / kind,
                                    ranks=ranks) for kind in kinds}
        for number in numbers:
            self.wait_until_printed("cases: 1 of 2", *started.values())
            self.wait_for_work(0.3, *started.values())  # the endless motion has begun
            for kind, process in started.items():
                code, text = self.end(process, number)
                if ranks == 1:
                    self.expect_first_kept(kind, code, text)
                started[kind] = self.start("--resume", self.folder / kind, ranks=ranks)
        self.wait_until_printed("cases: 1 of 2", *started.values())
        for process in started.values():
            self.end(process, signal.SIGTERM)

    def expect_first_kept(self, kind, code, text):
        self.assertEqual(code, 4, text)
        self.assertIn("--resume", text)
        with h5py.File(self.folder / kind / "results.h5") as file:
            self.assertEqual(file["analysis/cases/status"][()].tolist(), [0, -1])

    def test_a_motion_ends_and_goes_on(self):
        self.stop_and_resume(ENDLESS, 1, (signal.SIGTERM, signal.SIGINT))

    def test_a_motion_on_two_ranks_ends_and_goes_on(self):
        self.stop_and_resume(["steady state"], 2, (signal.SIGTERM,))

    def test_a_check_ends_by_itself_and_by_a_signal(self):
        files = [self.knocking(kind) for kind in ENDLESS]
        started = [self.start(file, "--check") for file in files]
        stopped = self.start(files[0], "--check")
        self.wait_for_handlers(stopped)
        self.wait_for_work(1, stopped)
        if stopped.poll() is None:
            self.assertEqual(self.end(stopped, signal.SIGTERM)[0], 4)
        for process in started:
            self.assertEqual(process.wait(timeout=HUNG), 0, process.printed.read_text())
            self.assertIn("of computing", process.printed.read_text())


if __name__ == "__main__":
    main()
