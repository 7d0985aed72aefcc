#!/usr/bin/python3
"""The shipped examples with many contacts: their pairs, that they touch, that the kept modes carry
the whole flexibility at the contacts, and that the energy balance closes.

usage: check_many_contacts.py PROGRAM SOURCE_TREE
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])


class Example:
    """Results of a parameter file."""

    def __init__(self, folder, name, analysis, *overrides):
        done = subprocess.run([PROGRAM, str(SOURCE / "params" / f"{name}.prm"), "--output", f"{folder}/{name}", "--overwrite",
                               *(word for each in overrides for word in ("--set", each))],
                              capture_output=True, text=True, check=False)
        self.output = done.stdout + done.stderr
        if done.returncode:
            raise AssertionError(self.output)
        self.file = h5py.File(f"{folder}/{name}/results.h5")
        self.analysis = self.file["analysis"][analysis]
        self.frames = len(list(pathlib.Path(folder, name, analysis).glob("frame-*.vtu")))

    def value(self, path):
        return self.analysis[path][()]

    def contact(self, path):
        return self.file["contact"][path][:]


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def check(self, name, analysis, group, contacts, touched, warned):
        example = Example(self.folder.name, name, analysis)
        self.assertEqual(example.value(f"group/{group}/contacts"), contacts)
        self.assertGreaterEqual(example.value(f"group/{group}/touched"), touched)
        self.assertEqual(example.value("unbalanced"), 0)
        self.assertEqual(example.value("status"), 0)
        np.testing.assert_allclose(example.contact("flexibility_share"), 1, atol=1e-11)
        # Few modes for short impacts, as the files say; nothing else is warned of.
        self.assertEqual(example.output.count("warning"), 1 if warned else 0)
        self.assertEqual("Largest impact error" in example.output, warned)
        self.assertGreater(example.frames, 100)
        return example

    def test_plate_on_stops(self):
        example = self.check("plate-on-stops", "rattle", "stops", 15, 5, True)
        np.testing.assert_array_equal(example.contact("clearance"), 4e-4)

    def test_nested_tubes(self):
        example = self.check("nested-tubes", "knock", "walls", 10, 4, True)
        np.testing.assert_allclose(example.contact("clearance"), 0.75e-3, rtol=1e-12)

    def test_frame_pounding(self):
        example = self.check("frame-pounding", "earthquake", "floors", 3, 1, False)
        np.testing.assert_allclose(example.contact("clearance"), 0.03, rtol=1e-12)
        self.assertIn("nodes without a partner: 1", example.output)
        storeys = {quantity: example.value(f"point/soft.left3/{quantity}_x") - example.value(f"point/soft.left2/{quantity}_x")
                   for quantity in ("displacement", "velocity", "acceleration")}
        for quantity, drift in (("elongation", storeys["displacement"]), ("elongation_rate", storeys["velocity"]),
                                ("elongation_acceleration", storeys["acceleration"])):
            np.testing.assert_allclose(example.value(f"connection/drift3/{quantity}"), drift, rtol=0,
                                       atol=1e-9 * abs(drift).max())

    def test_rattling_plates(self):
        """The thousand pairs thinned out to sixty, by the moments of the forces and by Runge-Kutta steps."""
        fewer = ["Analyses=rattle", "Analysis/rattle/Transient/Frames=0", "Analysis/rattle/Transient/First frame=0 s",
                 "Analysis/rattle/Transient/Duration=30 ms",
                 *(f"Body {body}/Interface face/Grid points=10, 6" for body in ("lower", "upper"))]
        sums = []
        for method in ("moments", "rk"):
            example = Example(self.folder.name, "rattling-plates", "rattle", *fewer, f"Integration/Method={method}")
            self.assertEqual(example.value("group/faces/contacts"), 60)
            self.assertEqual(example.value("unbalanced"), 0)
            self.assertEqual(example.value("moment_steps") > 0, method == "moments")
            sums.append([example.value(f"group/faces/{name}") for name in ("impacts", "impulse", "peak_force")])
        self.assertEqual(sums[0][0], sums[1][0])
        np.testing.assert_allclose(sums[0], sums[1], rtol=1e-4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
