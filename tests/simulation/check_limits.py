#!/usr/bin/python3
"""Points that cannot be computed are recorded with their reason, the others are not touched by it,
and summary, terminal and exit code say so.

usage: check_limits.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

import check_runs
from program_runs import ProgramRuns, main

# Three motions from rest, of which only the middle one meets the stop.
FILE = """
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
  set Clearance = 10 m
  subsection Linear penalty
    set Stiffness = 10 kN/m
  end
end
subsection Excitation push
  set Type = force
  set At = mass.head
  set Amplitude = 1 N
  set Frequency = 1.5 Hz
end
set Analyses = cases
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
    subsection Key swept
      set Path = PATH
      set Values = VALUES
    end
  end
end
"""
PATH = "analysis/cases/"


class Limits(ProgramRuns):
    def write(self, path="Contact/stop/Clearance", values="10 m, 5 mm, 11 m"):
        self.file.write_text(FILE.replace("PATH", path).replace("VALUES", values))

    def run_to(self, name, code, *arguments, ranks=1):
        out = self.folder / name
        done = self.run_program(self.file, "--output", out, *arguments, ranks=ranks)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return out, done.stdout + done.stderr

    def read(self, out, name):
        with h5py.File(out / "results.h5") as file:
            return file[PATH + name][()]

    def expect_middle_failed(self, out, text, reason):
        np.testing.assert_array_equal(self.read(out, "status"), [0, 1, 0])
        self.assertRegex(self.read(out, "reason")[1].decode(), reason)
        self.assertEqual(self.read(out, "reason")[0].decode(), "")
        summary = (out / "summary.txt").read_text()
        self.assertIn("analysis.cases.failed_points = 1 ", summary)
        self.assertRegex(summary, r"analysis.cases.failed_points\[1\] = 1 \[1\]  .*" + f"({reason})")
        self.assertRegex(text, "warning: analysis cases: 1 of 3 points failed:\n  1: .*" + f"({reason})")
        self.assertIn("1 points failed", text)
        self.assertTrue(np.isnan(self.read(out, "steps")[1]))

    def expect_others_same(self, out, whole):
        peak = "point/mass.head/displacement_x/largest"
        for name in ("steps", "events", "energy_residual", peak):
            np.testing.assert_array_equal(self.read(out, name)[[0, 2]],
                                          self.read(whole, name)[[0, 2]])

    def limit(self, key, count, reason):
        self.write()
        whole, _ = self.run_to("whole", 0)
        counts = self.read(whole, count)
        self.assertGreater(counts[1], 2 + max(counts[0], counts[2]))
        limit = int(max(counts[0], counts[2])) + 1
        for ranks in (1, 2):
            out, text = self.run_to(f"limited{ranks}", 3, "--set", f"Integration/{key}={limit}",
                                    ranks=ranks)
            self.expect_middle_failed(out, text, reason)
            self.expect_others_same(out, whole)

    def test_step_limit(self):
        self.limit("Maximum steps", "steps", r"\(Maximum steps\)")

    def test_event_limit(self):
        self.limit("Maximum events", "events", r"\(Maximum events\)")

    def test_numbers_that_are_none(self):
        self.write("Excitation/push/Amplitude", "1 N, 1e308 N, 2 N")
        for method in ("exact", "rk"):
            out, text = self.run_to(method, 3, "--set", f"Integration/Method={method}")
            self.expect_middle_failed(out, text, "no longer finite|too large for any step")

    def test_a_failed_case_is_told_beside_a_derived_quantity_that_fails(self):
        self.write("Excitation/push/Amplitude", "1 N, 1e308 N, 2 N")
        self.file.write_text(self.file.read_text() + """
subsection Derived d
  set From = cases
  set Operation = maximum
  set Field = point/mass.head/displacement_x/peakk
  set Along = Excitation.push.Amplitude
end
""")
        _, text = self.run_to("out", 1)
        self.assertIn("1 of 3 points failed", text)
        self.assertIn("peakk", text)
        self.assertIn("Everything else was written.", text)

    def test_points_that_did_not_settle_are_told(self):
        self.write()
        out, text = self.run_to("settled", 0, "--set", "Analysis/one/Steady state/Settling cycles=900")
        self.assertNotIn("steady", text)
        self.assertNotIn("unsettled", (out / "summary.txt").read_text())
        out, text = self.run_to("short", 0)
        self.assertIn("analysis cases: 3 of 3 points were recorded before", text)
        self.assertIn("analysis.cases.unsettled_points = 3 [1]", (out / "summary.txt").read_text())

    def test_every_point_of_a_case_that_cannot_be_built_has_the_reason(self):
        """Each value can be used, but not these two together."""
        self.write("Analysis/one/Stepped sweep/Last frequency", "5 Hz, 3 Hz")
        text = self.file.read_text()
        before, after = text.index("subsection Analysis one"), text.index("subsection Analysis cases")
        text = text[:before] + """
subsection Analysis one
  set Type = stepped sweep
  subsection Stepped sweep
    set First frequency = 1 Hz
    set Last frequency = 2 Hz
    set Points = 3
    set Settling cycles = 2
    set Recorded cycles = 1
  end
end
""" + text[after:]
        self.file.write_text(text.replace("    subsection Key swept", """    subsection Key first
      set Path = Analysis/one/Stepped sweep/First frequency
      set Values = 1 Hz, 4 Hz
    end
    subsection Key swept"""))
        out, _ = self.run_to("out", 3)
        impossible = np.zeros((2, 2, 3, 2), dtype=bool)
        impossible[1, 1] = True
        np.testing.assert_array_equal(self.read(out, "status"), impossible)
        np.testing.assert_array_equal(
            [b"greater than First frequency" in reason for reason in self.read(out, "reason").ravel()],
            impossible.ravel())

    def test_pictures_are_announced_where_there_are_some(self):
        self.write()
        out, text = self.run_to("lumped", 0)
        self.assertNotIn("ParaView", text)
        self.assertFalse((out / "modes.pvd").exists())
        self.file.write_text(check_runs.BEAM)
        out, text = self.run_to("beam", 0)
        self.assertIn("for ParaView: modes.pvd;", text)
        self.assertTrue((out / "modes.pvd").exists())

    def test_of_many_pictures_some_are_announced(self):
        motion = check_runs.BEAM[check_runs.BEAM.index("subsection Analysis push"):]
        motion = motion.replace("0.1 s", "1 ms\n    set Frames = 1")
        for last, end in (("c", ";"), ("d", ", ...;")):
            beam = check_runs.BEAM[:check_runs.BEAM.index("subsection Analysis push")]
            self.file.write_text(beam + "".join(
                motion.replace("Analysis push", "Analysis " + name)
                for name in "abcd" if name <= last))
            _, text = self.run_to(last, 0)
            self.assertIn("for ParaView: a.pvd, b.pvd, c.pvd, " +
                          ("modes.pvd" if last == "c" else "d.pvd") + end, text)

    def test_sections_of_other_laws_are_told(self):
        self.write()
        _, text = self.run_to("used", 0)
        self.assertNotIn("not used", text)
        hertz = "  subsection Hertz\n    set Stiffness = 1e8 N/m^1.5\n  end\n"
        self.file.write_text(self.file.read_text().replace("  subsection Linear", hertz
                                                           + "  subsection Linear"))
        out, text = self.run_to("unused", 0)
        self.assertEqual(text.count("the section Hertz is not used"), 1)
        self.assertNotIn("Linear penalty is not", text)
        # The stored parameters have every section; what stands there by default is no mistake.
        again = self.run_program(out / "parameters.prm", "--check")
        self.assertEqual(again.stdout.count("is not used"), 1, again.stdout)
        # A grid may use them all.
        text = self.file.read_text().replace("stop/Clearance", "stop/Law")
        self.file.write_text(text.replace("10 m, 5 mm, 11 m", "linear penalty, hertz"))
        _, text = self.run_to("grid", 0)
        self.assertNotIn("not used", text)

    def test_a_balance_that_does_not_close(self):
        self.write()
        out, text = self.run_to("whole", 0)
        self.assertNotIn("balance", text)
        np.testing.assert_array_equal(self.read(out, "unbalanced"), [0, 0, 0])
        self.assertNotIn("unbalanced_points", (out / "summary.txt").read_text())
        # Steps that nothing but their longest length limits.
        out, text = self.run_to("coarse", 0, "--set", "Integration/Method=rk", "--set",
                                "Integration/Relative tolerance=1e-13", "--set",
                                "Integration/Absolute tolerance=1 km", "--set",
                                "Integration/Maximum step=0.05 s")
        self.assertIn("is not closed", text)
        self.assertGreater(np.count_nonzero(self.read(out, "unbalanced")), 0)
        self.assertIn("analysis.cases.unbalanced_points", (out / "summary.txt").read_text())
        # What is advised helps.
        self.assertIn("a smaller Absolute tolerance", text)
        out, text = self.run_to("advised", 0, "--set", "Integration/Method=rk", "--set",
                                "Integration/Relative tolerance=1e-13", "--set",
                                "Integration/Absolute tolerance=1e-16 m", "--set",
                                "Integration/Maximum step=0.05 s")
        self.assertNotIn("balance", text)
        np.testing.assert_array_equal(self.read(out, "unbalanced"), [0, 0, 0])


if __name__ == "__main__":
    main()
