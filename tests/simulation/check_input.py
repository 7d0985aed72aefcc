#!/usr/bin/python3
"""Input that no test inside one process can give: files that are none, requests beyond the memory,
folders that cannot be used, and results that cannot be written.

usage: check_input.py FORK_SERVER TREE
"""
import os
import pathlib
import shutil
import sys
import unittest

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from fork_server import ForkServer  # noqa: E402
from program_runs import InAFolder  # noqa: E402

SERVER, TREE = sys.argv[1], pathlib.Path(sys.argv[2])
TRACE = ("PETSC ERROR", "terminate called", "bad_alloc", "HDF5-DIAG", "std::")

MASS = """
subsection Body mass
  set Type = lumped
  subsection Mass head
    set Mass = 1 kg
    set Stiffness = 100 N/m
    set Damping = 1 N s/m
  end
end
subsection Excitation push
  set Type = force
  set At = mass.head
  set Amplitude = 1 N
  set Frequency = 1.5 Hz
end
subsection Analysis one
  set Type = steady state
  subsection Steady state
    set Settling cycles = 20
    set Recorded cycles = 5
  end
end
subsection Analysis cases
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = one
    subsection Key stiffness
      set Path = Body/mass/Mass/head/Stiffness
      set First = 90 N/m
      set Last = 120 N/m
      set Points = 150
    end
  end
end
"""

PLATE = """
subsection Body plate
  set Type = shell
  subsection Geometry
    set Plate = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m -> 0 m, 1 m, 0 m
    set Divisions = 4, 4
  end
  subsection Shell plate
    set Thickness = 5 mm
  end
  subsection Material
    set Young modulus = 200 GPa
    set Poisson ratio = 0.3
    set Density = 7850 kg/m^3
  end
  subsection Support edges
    set At = edges
    set Fix = all
  end
  subsection Point centre
    set Position = 0.5, 0.5, 0
  end
  subsection Modes
    set Number = 3
  end
end
subsection Analysis modes
  set Type = modal
end
"""

RECORDED = """
  set History = recorded
  subsection Recorded
    set File = push.csv
    set Time column = time
    set Value column = force
  end
end
"""


class Input(InAFolder):
    @classmethod
    def setUpClass(cls):
        cls.server = ForkServer(SERVER)

    @classmethod
    def tearDownClass(cls):
        cls.server.__exit__()

    def run_program(self, text, *arguments, **limits):
        if text is not None:
            self.file.write_text(text)
        limits.setdefault("seconds", 60)
        done = self.server.run([*(["case.prm"] if text is not None else []), *arguments],
                               self.folder, **limits)
        self.assertFalse(done.timed_out)
        for trace in TRACE:
            self.assertNotIn(trace, done.stdout + done.stderr)
        return done

    def refused(self, text, *parts, arguments=("--check",), **limits):
        done = self.run_program(text, *arguments, **limits)
        self.assertEqual(done.code, 1, done.stdout + done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)

    def changed(self, text, old, new):
        self.assertIn(old, text)
        return text.replace(old, new)

    def test_the_files_are_sound(self):
        for text in (MASS, PLATE):
            self.assertEqual(self.run_program(text, "--check").code, 0)

    def test_a_mesh_must_be_a_file(self):
        os.mkfifo(self.folder / "pipe.msh")
        plate = "set Plate = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m -> 0 m, 1 m, 0 m\n    set Divisions = 4, 4"
        for name in ("/dev/zero", "pipe.msh", ".", "nowhere.msh"):
            self.refused(self.changed(PLATE, plate, f"set Mesh = {name}"),
                         f"case.prm:5: Body plate / Geometry / Mesh = {name}", "must name a file")

    def test_a_record_must_be_a_text_and_may_begin_with_a_mark(self):
        text = self.changed(MASS, "\n  set Amplitude = 1 N\n  set Frequency = 1.5 Hz\nend\n", RECORDED)
        text = text[:text.index("subsection Analysis")] + """
subsection Analysis one
  set Type = transient
  subsection Transient
    set Duration = 1 s
  end
end
"""
        record = "time,force\n0,0\n0.5,1\n1,0\n"
        (self.folder / "push.csv").write_bytes(b"\xef\xbb\xbf" + record.encode())
        self.assertEqual(self.run_program(text, "--check").code, 0)
        (self.folder / "push.csv").write_bytes(record.encode("utf-16"))
        self.refused(text, "Recorded / File = push.csv", "NUL bytes")
        (self.folder / "push.csv").unlink()
        os.mkfifo(self.folder / "push.csv")
        self.refused(text, "Recorded / File = push.csv", "must name a file")

    def test_the_command_line_names_what_is_empty(self):
        for option in ("--output", "--resume", "--body-cache"):
            self.refused(MASS, f"command line: {option} must not be empty", arguments=(option, ""))

    def test_a_folder_that_cannot_be_made_is_named(self):
        (self.folder / "file").write_text("")
        for name in ("file", "file/below", "/proc/below", "x" * 300):
            self.refused(MASS, f"the result folder {name}", arguments=("--output", name))

    def test_more_memory_than_there_is(self):
        """Both figures, and nothing of the kind where it suffices."""
        both = (" of memory are needed, but ", " MB are available")
        self.refused(self.changed(PLATE, "Divisions = 4, 4", "Divisions = 900, 900"),
                     "case.prm:6: Body plate / Geometry / Divisions = 900, 900", *both,
                     megabytes=1500)
        motion = MASS[:MASS.index("subsection Analysis")] + """
subsection Analysis one
  set Type = transient
  subsection Transient
    set Duration = 1 s
    set Sampling interval = SAMPLING
  end
end
"""
        self.refused(motion.replace("SAMPLING", "0.1 us"),
                     "case.prm:21: Analysis one / Transient / Sampling interval = 0.1 us",
                     "1e+07 samples about 2.4 GB", *both, megabytes=1500)
        self.assertEqual(self.run_program(motion.replace("SAMPLING", "1 ms"), "--check",
                                          megabytes=1500).code, 0)

    def whole(self):
        """The values of an undisturbed run."""
        if not (self.folder / "whole").exists():
            self.assertEqual(self.run_program(MASS, "--output", "whole").code, 0)
        return self.values("whole")

    def values(self, out):
        with h5py.File(self.folder / out / "results.h5") as file:
            return file["analysis/cases/point/mass.head/displacement_x/largest"][()]

    def expect_kept(self, done, out):
        self.assertEqual(done.code, 2, done.stdout + done.stderr)
        self.assertIn(f"go on with --resume {out}", done.stderr)
        self.assertTrue((self.folder / out / "parameters.prm").is_file())
        resumed = self.run_program(None, "--resume", out)
        self.assertEqual(resumed.code, 0, resumed.stdout + resumed.stderr)
        np.testing.assert_array_equal(self.values(out), self.whole())

    def test_results_that_cannot_be_written_are_rebuilt_by_resume(self):
        """A folder stands where the new file is to be made."""
        self.whole()
        out = self.folder / "blocked"
        self.assertEqual(self.run_program(MASS, "--output", "blocked").code, 0)
        (out / "results.h5").unlink()
        (out / "results.h5.unfinished").mkdir()
        (out / "results.h5.unfinished" / "something").write_text("")
        done = self.run_program(None, "--resume", "blocked")
        self.assertEqual(done.code, 2, done.stdout + done.stderr)
        self.assertIn("results.h5", done.stderr)
        self.assertFalse((out / "results.h5").exists())
        shutil.rmtree(out / "results.h5.unfinished")
        self.expect_kept(done, "blocked")

    def test_a_full_disk_loses_nothing(self):
        """No file may grow beyond what the journal takes, which results.h5 does."""
        self.whole()
        journal = sum(file.stat().st_size for file in (self.folder / "whole/journal").iterdir())
        results = (self.folder / "whole/results.h5").stat().st_size
        parameters = (self.folder / "whole/parameters.prm").stat().st_size
        self.assertLess(parameters, 0.6 * journal)  # else nothing would begin
        self.assertLess(journal, results)
        for limit in ((journal + results) / 2, 0.6 * journal):  # the second ends in the middle
            done = self.run_program(MASS, "--output", f"full-{limit:.0f}", file_bytes=limit)
            self.assertIn("File too large", done.stderr)
            self.expect_kept(done, f"full-{limit:.0f}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
