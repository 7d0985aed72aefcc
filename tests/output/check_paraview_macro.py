"""The macro for ParaView: check_paraview_macro.py MACRO FOLDER

FOLDER is the example that write_examples makes. What needs no ParaView is tested everywhere, the picture where pvpython
and xvfb-run are installed.
"""

import importlib.util
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path

import numpy as np
from PIL import Image

MACRO, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
INSTALLED = all(map(shutil.which, ("pvpython", "xvfb-run")))


def macro():
    """The module, beside a ParaView in which nothing is open."""
    simple = types.SimpleNamespace(GetActiveSource=lambda: None)
    sys.modules["paraview"] = types.SimpleNamespace(simple=simple)
    specification = importlib.util.spec_from_file_location("paraview_motion", MACRO)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


class Source:
    """A model of 2 m by 1 m by 0.5 m whose largest displacement depends on the time."""

    def __init__(self, largest):
        self.largest, self.TimestepValues, self.time = largest, list(largest), None

    def UpdatePipeline(self, time):  # noqa: N802, the name is ParaView's
        self.time = time

    def GetDataInformation(self):  # noqa: N802
        return types.SimpleNamespace(GetBounds=lambda: (0, 2, -1, 0, 3, 3.5))

    def GetPointDataInformation(self):  # noqa: N802
        data_range = {"displacement": (0, self.largest[self.time])}
        return types.SimpleNamespace(
            GetArray=lambda name: types.SimpleNamespace(GetRange=lambda _: data_range[name]))


class WithoutParaView(unittest.TestCase):
    def test_the_largest_displacement_of_all_instants_is_a_tenth_of_the_size(self):
        factor = macro().usual_factor(Source({0.0: 1e-3, 0.5: 4e-3, 1.0: 2e-3}))
        self.assertAlmostEqual(factor * 4e-3, 0.2)

    def test_a_model_at_rest_is_shown_as_it_is(self):
        self.assertEqual(macro().usual_factor(Source({0.0: 0.0})), 1)


@unittest.skipUnless(INSTALLED, "no ParaView")
class WithParaView(unittest.TestCase):
    def picture(self, *options):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "motion.png")
            done = subprocess.run(
                ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", "pvpython", MACRO,
                 FOLDER / "release.pvd", "--picture", file, *options],
                capture_output=True, text=True, timeout=600, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            return np.asarray(Image.open(file).convert("RGB")).astype(int)

    def test_the_motion_is_drawn_and_moves(self):
        first, last = self.picture("--instant", "1"), self.picture("--instant", "3")
        self.assertEqual(first.shape, (800, 1100, 3))
        coloured = np.ptp(first, axis=2) > 40
        self.assertGreater(coloured.sum(), 500)  # neither white ground nor grey
        self.assertLess(coloured.mean(), 0.5)
        self.assertGreater((np.abs(first - last).max(axis=2) > 40).sum(), 500)


if __name__ == "__main__":
    unittest.main()
