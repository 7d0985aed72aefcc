#!/usr/bin/python3
"""Runs the program as a user does: ranks, interruption and resume, overrides, exit codes.

usage: check_runs.py PROGRAM MPIEXEC
"""
import signal
import subprocess

import h5py
import numpy as np

from program_runs import ProgramRuns, datasets, main

FILE = """
subsection Body left
  set Type = lumped
  subsection Mass head
    set Mass = 1 kg
    set Stiffness = 1 kN/m
    set Damping = 1 N s/m
  end
end
subsection Body right
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = 5 kN/m
    set Damping = 2 N s/m
  end
end
subsection Contact heads
  set Between = left.head, right.head
  set Clearance = 2 mm
  subsection Linear penalty
    set Stiffness = 1 MN/m
  end
end
subsection Excitation shaker
  set Type = force
  set At = left.head
  set Amplitude = 8 N
  set Frequency = 5 Hz
end
subsection Integration
  set Relative tolerance = 1e-6
end
subsection Analysis response
  set Type = stepped sweep
  subsection Stepped sweep
    set First frequency = 3 Hz
    set Last frequency = 8 Hz
    set Points = 3
    set Settling cycles = POINTS
    set Recorded cycles = 2
  end
end
subsection Analysis map
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = response
    subsection Key clearance
      set Path = Contact/heads/Clearance
      set First = 1 mm
      set Last = 6 mm
      set Points = 3
    end
    subsection Key stiffness
      set Path = Contact/heads/Linear penalty/Stiffness
      set Values = 0.1 MN/m, 1 MN/m
    end
  end
end
"""


BEAM = """
subsection Body beam
  subsection Geometry
    set Line = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m
  end
  subsection Section
    set Width = 20 mm
    set Thickness = 20 mm
  end
  subsection Material
    set Young modulus = 200 GPa
    set Density = 8000 kg/m^3
  end
  subsection Support root
    set At = start
    set Fix = all
  end
  subsection Point root
    set At = start
  end
  subsection Point tip
    set At = end
  end
end
subsection Excitation push
  set Type = force
  set At = beam.tip
  set Direction = y
  set Amplitude = 10 N
  set History = constant
end
subsection Analysis push
  set Type = transient
  set Record = stresses
  subsection Transient
    set Duration = 0.1 s
  end
end
"""


class Runs(ProgramRuns):
    def setUp(self):
        super().setUp()
        self.file.write_text(FILE.replace("POINTS", "8"))

    def test_ranks_give_the_same_bytes(self):
        reference = None
        for ranks in (1, 2, 3):
            out = self.folder / f"ranks{ranks}"
            done = self.run_program(self.file, "--output", out, ranks=ranks)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = datasets(out)
            self.assertGreater(len(found), 50)
            summary = (out / "summary.txt").read_text()
            reference = reference or (found, summary)
            self.assertEqual(found, reference[0])
            self.assertEqual(summary, reference[1])

    def test_failed_points_are_the_same_on_any_number_of_ranks(self):
        """Too many steps for half of them."""
        whole = self.folder / "whole"
        self.run_program(self.file, "--output", whole)
        with h5py.File(whole / "results.h5") as file:
            limit = int(np.median(file["analysis/map/steps"][()]))
        reference = None
        for ranks in (1, 2, 3):
            out = self.folder / f"failing{ranks}"
            done = self.run_program(self.file, "--output", out, "--set",
                                    f"Integration/Maximum steps={limit}", ranks=ranks)
            self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
            with h5py.File(out / "results.h5") as file:
                failed = np.count_nonzero(file["analysis/map/status"][()])
            self.assertGreater(failed, 0)
            self.assertLess(failed, 36)
            found = datasets(out)
            reference = reference or found
            self.assertEqual(found, reference)

    def test_a_body_cache_changes_no_byte(self):
        self.file.write_text(BEAM)
        reference, lines = None, []
        for name, cache in (("none", []), ("first", ["--body-cache", self.folder / "cache"]),
                            ("second", ["--body-cache", self.folder / "cache"])):
            out = self.folder / name
            done = self.run_program(self.file, "--output", out, *cache)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            lines.append([line for line in (done.stdout + done.stderr).splitlines()
                          if line.startswith("body beam: ")])
            reference = reference or (datasets(out), (out / "summary.txt").read_text())
            self.assertEqual(datasets(out), reference[0])
            self.assertEqual((out / "summary.txt").read_text(), reference[1])
        self.assertEqual(lines[0], [])
        self.assertIn("made and kept in", lines[1][0])
        self.assertIn("loaded from", lines[2][0])

    def test_the_stress_at_the_root_is_that_of_a_sudden_force(self):
        """M c / I with the five modes of the closed form."""
        self.file.write_text(BEAM)
        out = self.folder / "stress"
        self.assertEqual(self.run_program(self.file, "--output", out).returncode, 0)
        with h5py.File(out / "results.h5") as file:
            recorded = file["analysis/push/recorded/point"]
            stress = recorded["beam.root/von_mises_stress/maximum"][()]
            self.assertIn("beam.tip", recorded)
        roots = np.array([1.8751040687, 4.6940911330, 7.8547574382, 10.9955407349, 14.1371683910])
        shares = 4 / roots**2 * np.array([1, -1, 1, -1, 1])
        omega = roots**2 * np.sqrt(200e9 / 8000 / 12) * 0.02
        times = np.linspace(0, 0.1, 20001)
        dynamic = (shares * (1 - np.cos(np.outer(times, omega)))).sum(axis=1).max()
        self.assertAlmostEqual(stress / (dynamic * 10 * 6 / 0.02**3), 1, delta=0.005)
        refused = self.run_program(self.file, "--output", self.folder / "refused", "--set",
                                   "Analysis/push/Stresses/Points=beam.top")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("beam.top", refused.stderr)

    def test_a_killed_run_resumes_to_the_same_bytes(self):
        self.file.write_text(FILE.replace("POINTS", "40"))
        whole = self.folder / "whole"
        self.assertEqual(self.run_program(self.file, "--output", whole).returncode, 0)
        kept = sum(journal.stat().st_size for journal in (whole / "journal").iterdir())
        for number, (share, how) in enumerate([(0.2, signal.SIGTERM), (0.5, signal.SIGKILL)]):
            out = self.folder / f"cut{number}"
            process = subprocess.Popen(self.command(self.file, "--output", out), cwd=self.folder,
                                       stdout=subprocess.DEVNULL)
            self.wait_for_journal(out / "journal", share * kept, process)
            process.send_signal(how)
            code = process.wait()
            if how == signal.SIGTERM and code != 0:
                self.assertEqual(code, 4)
            done = self.run_program("--resume", out, ranks=2)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual(datasets(out), datasets(whole))

    def test_resume_with_other_parameters_is_refused(self):
        out = self.folder / "out"
        self.assertEqual(self.run_program(self.file, "--output", out).returncode, 0)
        other = self.folder / "other.prm"
        other.write_text(self.file.read_text().replace("2 mm", "3 mm"))
        done = self.run_program("--resume", out, other)
        self.assertEqual(done.returncode, 1)
        self.assertIn("3 mm", done.stderr)
        self.assertIn("2 mm", done.stderr)

    def test_resume_with_a_changed_record_is_refused(self):
        record = self.folder / "push.csv"
        record.write_text("0,0\n0.5,3\n1,0\n")
        recorded = self.folder / "recorded.prm"
        sweep = "subsection Stepped sweep\n"
        text = self.file.read_text().replace(sweep, sweep + "    set Excitation = shaker\n")
        recorded.write_text(text + """
subsection Excitation record
  set Type = force
  set At = right.head
  set History = recorded
  subsection Recorded
    set File = push.csv
  end
end
""")
        out = self.folder / "out"
        done = self.run_program(recorded, "--output", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("push.csv", (out / "parameters.prm").read_text())
        self.assertEqual(self.run_program("--resume", out, recorded).returncode, 0)
        record.write_text("0,0\n0.5,4\n1,0\n")
        for given in ([recorded], []):
            done = self.run_program("--resume", out, *given)
            self.assertEqual(done.returncode, 1)
            self.assertIn("push.csv", done.stderr)

    def test_existing_results_are_kept(self):
        out = self.folder / "out"
        self.assertEqual(self.run_program(self.file, "--output", out).returncode, 0)
        refused = self.run_program(self.file, "--output", out)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("--overwrite", refused.stderr)
        self.assertEqual(self.run_program(self.file, "--output", out, "--overwrite").returncode, 0)

    def test_bad_input_ends_all_ranks_with_one_message(self):
        done = self.run_program(self.file, "--set", "Contact/heads/Clearance=5 kg", ranks=3)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count("5 kg' is a mass"), 1)

    def test_command_line(self):
        self.assertEqual(self.run_program("--help").returncode, 0)
        self.assertEqual(self.run_program("--version").returncode, 0)
        checked = self.run_program(self.file, "--check")
        self.assertEqual(checked.returncode, 0)
        self.assertIn("of computing", checked.stdout)
        self.assertRegex(checked.stdout, r"in all .* on one core, .*; about \S+ MB of memory")
        self.assertNotIn("warning", checked.stdout)
        self.assertFalse((self.folder / "output").exists())
        for wrong in (["--sett", "a=b"], [], ["nowhere.prm"], [self.file, self.file],
                      [self.file, "--set", "novalue"], ["--print-parameters", "html"]):
            done = self.run_program(*wrong)
            self.assertEqual(done.returncode, 1, wrong)
            self.assertTrue(done.stderr.strip())

    def test_a_check_warns_of_a_run_of_days(self):
        # A motion of 1e11 periods, which can only be followed.
        self.file.write_text(FILE.replace("POINTS", "8") + """
subsection Analysis motion
  set Type = transient
  subsection Transient
    set Duration = 2e10 s
    set Sampling interval = 1e10 s
  end
end
""")
        checked = self.run_program(self.file, "--check", "--set", "Analyses=motion")
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertRegex(checked.stdout, r"in all about \d+ days on one core")
        self.assertRegex(checked.stdout, r"warning: a run takes about \d+ days on one core")

    def test_json_gives_the_same_results(self):
        reference = self.folder / "prm"
        self.assertEqual(self.run_program(self.file, "--output", reference).returncode, 0)
        json = self.folder / "case.json"
        json.write_text(to_json(self.file.read_text()))
        out = self.folder / "json"
        done = self.run_program(json, "--output", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(datasets(out), datasets(reference))


def to_json(text):
    """The .prm text as nested JSON objects."""
    import json
    stack = [{}]
    for line in map(str.strip, text.splitlines()):
        if line.startswith("subsection "):
            child = {}
            stack[-1][line[len("subsection "):]] = child
            stack.append(child)
        elif line == "end":
            stack.pop()
        elif line.startswith("set "):
            key, value = line[4:].split("=", 1)
            stack[-1][key.strip()] = value.strip()
    return json.dumps(stack[0])


if __name__ == "__main__":
    main()
