"""Rules that hold for all figures: check_drawing_rules.py PROGRAM"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from vibroimpact.plots import figure_axes, labels, style  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402

from plot_examples import write_all  # noqa: E402


class Names(unittest.TestCase):
    def test_stay_as_the_user_wrote_them(self):
        for path, shown in (("Variables/fm", "fm"), ("Variables/cd", "cd"), ("Contact/heads/Clearance", "Clearance"),
                            ("Variables/lambda", r"$\lambda$"), ("Variables/m2", "$m_{2}$")):
            self.assertEqual(labels.key_label(path), shown)
        self.assertEqual(labels.own_name("peak_force"), "peak force")

    def test_prefixes_of_compound_units(self):
        for unit, value, shown in (("N s/m", 6e5, "kN s/m"), ("N/m", 2e3, "kN/m"), ("m", 2e-3, "mm"),
                                   ("m/s^2", 2e3, "m/s²"), ("m^2", 1e-6, "m$^{2}$"), ("kg", 1e-3, "kg"),
                                   ("Hz", 2e3, "Hz"), ("N s", 2e-3, "mN s")):
            with self.subTest(unit):
                self.assertEqual(labels.scale_for(unit, [value]).unit, shown)

    def test_of_an_axis_with_several_quantities_is_what_they_share(self):
        self.assertEqual(figure_axes.common_label(["First, maximum", "Second, maximum"]), "maximum")
        self.assertEqual(figure_axes.common_label(["Force", "Gap"]), "")
        self.assertEqual(labels.Scale(1e-3, "mm").label(""), "(mm)")


class Colours(unittest.TestCase):
    def test_eight_contacts_differ(self):
        for count in (2, 4, 8, 12):
            self.assertEqual(len({str(style.contact_colour(k, count)) for k in range(count)}), count)


class Files(unittest.TestCase):
    def test_side_by_side_are_those_drawn_one_by_one(self):
        with tempfile.TemporaryDirectory() as folder:
            write_all(Path(folder))
            made = []
            for jobs in ("1", "3"):
                out = Path(folder, jobs)
                run = subprocess.run([PROGRAM, folder, "--analysis", "sweep", "--dpi", "50", "--jobs", jobs,
                                      "--output", out], capture_output=True, text=True, check=False)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                names = [Path(line).name for line in run.stdout.splitlines()]
                made.append([(name, (out / name).read_bytes()) for name in names])
            self.assertGreater(len(made[0]), 3)
            self.assertEqual(*made)

    def test_arrays_read_once_cannot_be_changed(self):
        with tempfile.TemporaryDirectory() as folder:
            write_all(Path(folder))
            with Results(Path(folder)) as results:
                values = results.analysis("sweep").read("frequency").values
                with self.assertRaises(ValueError):
                    values[0] = 1


if __name__ == "__main__":
    unittest.main()
