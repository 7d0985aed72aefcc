#!/usr/bin/python3
"""Rigid stops as a user runs them: params/impact-oscillator.prm against closed forms and another
method.

usage: check_rigid.py PROGRAM MPIEXEC
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

PROGRAM = sys.argv[1]
FILE = pathlib.Path(__file__).resolve().parents[2] / "params" / "impact-oscillator.prm"
GRAVITY, OMEGA, RESTITUTION = 9.81, 2 * np.pi * 10, 0.5
RELEASE = (np.pi + np.arcsin(1 / 1.5)) / OMEGA  # 1.5 g sin(omega t) = -g


def run(folder, *overrides):
    command = [PROGRAM, str(FILE), "--output", str(folder), "--overwrite"]
    for override in overrides:
        command += ["--set", override]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    return h5py.File(folder / "results.h5")["analysis"]


def table(time):
    """Height and speed of the table, whose acceleration is 1.5 g sin(omega t)."""
    return (-1.5 * GRAVITY / OMEGA**2 * np.sin(OMEGA * time),
            -1.5 * GRAVITY / OMEGA * np.cos(OMEGA * time))


def flight_of(start):
    """The instant at which a ball meets the table that leaves it at `start`, by bisection."""
    height, speed = table(start)

    def gap(time):
        return height + speed * (time - start) - GRAVITY / 2 * (time - start)**2 - table(time)[0]

    low = start + 0.01
    high = low
    while gap(high) > 0:
        high += 1e-3
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if gap(middle) > 0 else (low, middle)
    return low, table(low)[1] - (speed - GRAVITY * (low - start))


class Rigid(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        cls.results = run(cls.path / "flight")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_ball_is_thrown_off_and_falls(self):
        impact = self.results["ball/contact/table/impact"]
        instant, approach = flight_of(RELEASE)
        self.assertAlmostEqual(np.ravel(impact["time"])[0], instant, delta=1e-10)
        self.assertAlmostEqual(np.ravel(impact["approach_speed"])[0], approach, delta=1e-9)
        self.assertAlmostEqual(np.ravel(impact["separation_speed"])[0], RESTITUTION * approach,
                               delta=1e-9)

    def test_ball_rests_with_its_weight(self):
        ball = self.results["ball"]
        time, force = np.ravel(ball["time"]), np.ravel(ball["contact/table/normal_force"])
        held = time < RELEASE
        weight = 0.1 * GRAVITY * (1 + 1.5 * np.sin(OMEGA * time[held]))
        np.testing.assert_allclose(force[held], weight, atol=1e-8)

    def test_chatter_is_completed_and_counted(self):
        ball = self.results["ball"]
        impact = ball["contact/table/impact"]
        last = np.ravel(impact["chatter_duration"]) > 0
        # One in each of the nine periods after the first release; every period is the same.
        self.assertEqual(np.ravel(ball["chatters"])[0], 9)
        rests = np.ravel(impact["time"])[last] + np.ravel(impact["chatter_duration"])[last]
        self.assertGreaterEqual(len(rests), 8)
        np.testing.assert_allclose(np.diff(rests), 0.1, atol=1e-9)
        releases = (np.ravel(impact["time"]) + np.ravel(impact["duration"]))[last]
        np.testing.assert_allclose(releases, RELEASE + 0.1 * np.arange(1, len(rests) + 1),
                                   atol=1e-10)
        self.assertIn("chatters", (self.path / "flight" / "summary.txt").read_text())

    def test_ledgers_close(self):
        for analysis in ("ball", "beam"):
            self.assertLess(np.max(self.results[analysis]["energy_residual"]), 1e-10)

    def test_beam_never_passes_the_stop(self):
        self.assertGreater(np.min(self.results["beam/contact/stop/gap/minimum"]), -1e-11)
        self.assertGreater(np.max(self.results["beam/contact/stop/impacts"]), 10)

    def test_methods_agree(self):
        points = ["Analyses=beam", "Analysis/beam/Stepped sweep/Points=1",
                  "Analysis/beam/Stepped sweep/Direction=forward",
                  "Analysis/beam/Stepped sweep/First frequency=9 Hz",
                  "Analysis/beam/Stepped sweep/Last frequency=9 Hz",
                  "Analysis/beam/Stepped sweep/Minimum settling cycles=2",
                  "Analysis/beam/Stepped sweep/Settling cycles=2",
                  "Analysis/beam/Stepped sweep/Recorded cycles=2"]
        exact = run(self.path / "short", *points)["beam"]
        other = run(self.path / "rk", *points, "Integration/Method=rk",
                    "Integration/Relative tolerance=1e-12")["beam"]
        # From rest: later on each impact multiplies what the methods differ by.
        for name in ("contact/stop/impacts", "contact/stop/impulse/maximum", "chatters",
                     "contact/stop/dissipated_energy"):
            np.testing.assert_allclose(other[name], exact[name], rtol=1e-6, atol=1e-12,
                                       err_msg=name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
