#!/usr/bin/python3
"""Impacts of two clamped beams against independent reference figures, from file to summary.

The references were computed with closed-form modes and an event-located solver.
usage: check_beams.py PROGRAM SOURCE_FOLDER
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
IMPACT = "analysis.{}.contact.heads.impact[1]."


def summary(file, *overrides):
    """The lines of summary.txt of a run, as numbers by name."""
    with tempfile.TemporaryDirectory() as folder:
        arguments = [part for override in overrides for part in ("--set", override)]
        subprocess.run([PROGRAM, str(file), "--output", folder, *arguments], check=True,
                       stdout=subprocess.DEVNULL)
        lines = (pathlib.Path(folder) / "summary.txt").read_text().splitlines()
    pairs = [line.split(" = ", 1) for line in lines]
    return {name: float(value.split(" ")[0]) for name, value in pairs}


class Contact(unittest.TestCase):
    """Peak force, impulse and duration to 1e-4 with 100 modes per beam."""

    def check(self, overrides, force, impulse, duration, restitution):
        found = summary(SOURCE / "params/verification/beam-contact.prm", *overrides)
        prefix = IMPACT.format("impact")
        for name, value in [("peak_force", force), ("impulse", impulse), ("duration", duration),
                            ("restitution_coefficient", restitution)]:
            self.assertLess(abs(found[prefix + name] / value - 1), 1e-4, name)
        self.assertLess(found["analysis.impact.energy_residual"], 1e-5)

    def test_slow_elastic(self):
        self.check([], 220.879, 1.166983e-2, 97.261e-6, 0.98711)

    def test_fast_elastic(self):
        self.check(["Variables/V=1 m/s"], 1522.66, 5.82540e-2, 70.421e-6, 0.98902)

    def test_damped(self):
        self.check(["Contact/heads/Law=hunt-crossley"], 199.577, 9.93377e-3, 102.167e-6, 0.68800)


class Release(unittest.TestCase):
    def test_first_impact_to_the_digits_known(self):
        found = summary(SOURCE / "params/verification/beam-release.prm")
        prefix = IMPACT.format("release")
        for name, value, digits in [("time", 0.0896910, 7), ("approach_speed", 1.005842, 6),
                                    ("peak_force", 1533.33, 2), ("impulse", 0.0585934, 7),
                                    ("restitution_coefficient", 0.98902, 5)]:
            self.assertAlmostEqual(found[prefix + name], value, delta=0.6 * 10**-digits, msg=name)


class Convergence(unittest.TestCase):
    """Peak force within 1 % takes 7 to 11 modes, or 3 to 4 elements; one mode is 12 % high."""

    def test_modes_and_elements(self):
        found = summary(SOURCE / "params/verification/beam-convergence.prm")
        modes = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 20, 30, 50, 100]
        elements = [1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50]
        peak = "analysis.{}[{}].contact.heads.impact[1].peak_force"
        error = [found[peak.format("modes", i + 1)] / 220.879 - 1 for i in range(len(modes))]
        self.assertAlmostEqual(error[0], 0.12, delta=0.01)
        within = next(n for n, e in zip(modes, error) if abs(e) < 0.01)
        self.assertTrue(7 <= within <= 11, within)
        error = [found[peak.format("elements", i + 1)] / 220.879 - 1 for i in range(len(elements))]
        within = next(n for n, e in zip(elements, error) if abs(e) < 0.01)
        self.assertTrue(3 <= within <= 4, within)


class LumpedLimit(unittest.TestCase):
    """One mode per beam is a mass on a spring: modal mass of unit tip displacement 1.32731649 times
    that of the beam, 52.9875 g, at 2.95 Hz."""

    TWO_MASSES = """
subsection Body NAME
  set Type = lumped
  subsection Mass head
    set Mass = 1.32731649 * 52.9875 g
    set Stiffness = 1.32731649 * 0.0529875 * (2 * pi * 2.95)^2
  end
end
"""

    def test_two_masses_move_as_the_beams_in_one_mode(self):
        text = (SOURCE / "params/verification/beam-release.prm").read_text()
        first, last = text.index("subsection Body left"), text.index("subsection Contact")
        masses = "".join(self.TWO_MASSES.replace("NAME", name) for name in ("left", "right"))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "two-masses.prm"
            file.write_text(text[:first] + masses + text[last:])
            lumped = summary(file)
        beams = summary(SOURCE / "params/verification/beam-release.prm", "Variables/modes=1")
        prefix = IMPACT.format("release")
        for name in ("time", "approach_speed", "peak_force", "impulse", "duration"):
            self.assertLess(abs(lumped[prefix + name] / beams[prefix + name] - 1), 2e-6, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
