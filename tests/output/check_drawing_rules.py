"""Rules that hold for all figures: check_drawing_rules.py PROGRAM"""

import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path
from unittest import mock

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from vibroimpact.plots import basins, envelopes, figure_axes, labels, maps, style, traces  # noqa: E402
from vibroimpact.plots.measures import Panel, Sheet, without_rounding  # noqa: E402
from vibroimpact.plots.results import Array, Results  # noqa: E402

from plot_examples import write_all  # noqa: E402


class Names(unittest.TestCase):
    def test_stay_as_the_user_wrote_them(self):
        for path, shown in (("Variables/fm", "fm"), ("Variables/cd", "cd"), ("Contact/heads/Clearance", "Clearance"),
                            ("Variables/lambda", r"$\lambda$"), ("Variables/m2", "$m_{2}$"), ("Variables/k_t", "k_t"),
                            ("Variables/slip_load", "slip load")):
            self.assertEqual(labels.key_label(path), shown)
        self.assertEqual(labels.own_name("peak_force"), "peak force")

    def test_prefixes_of_compound_units(self):
        for unit, value, shown in (("N s/m", 6e5, "kN s/m"), ("N/m", 2e3, "kN/m"), ("m", 2e-3, "mm"),
                                   ("m/s^2", 2e3, "m/s²"), ("m^2", 1e-6, "m$^{2}$"), ("kg", 1e-3, "kg"),
                                   ("Hz", 2e3, "Hz"), ("N s", 2e-3, "mN s"), ("um", 1.0, "µm"), ("N/um", 1.0, "N/µm")):
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


class Lines(unittest.TestCase):
    def setUp(self):
        _, self.axes = plt.subplots()
        self.addCleanup(plt.close, "all")

    def test_a_jump_is_a_gap_and_never_slanted(self):
        along, values = np.arange(6.0), np.array([5, 5.5, 6.5, 0, 0, 0])
        shown = traces.trace(along, values, np.zeros(6, bool), None, False)
        traces.draw(self.axes, shown, "black", linestyle="-")
        line, jump = self.axes.get_lines()
        self.assertTrue(np.isnan(line.get_ydata()[3]))
        x, y = (np.diff(data) for data in jump.get_data())
        self.assertTrue(np.all((x == 0) | (y == 0)))

    def test_what_has_not_settled_is_a_circle_as_in_the_legend(self):
        loose = np.array([False, True, False])
        shown = traces.trace(np.arange(3.0), np.ones(3), loose, None, False)
        traces.draw(self.axes, shown, "black", linestyle="-", marker=">")
        self.assertIn("o", [line.get_marker() for line in self.axes.get_lines() if line.get_fillstyle() == "none"])

    def test_a_contact_force_jumps_where_the_gap_closes(self):
        time = np.arange(6.0)
        gap = np.array([1.5, 0.5, -0.5, -0.5, 0.5, 1.5])
        time, force, gap, other = envelopes.with_jumps(time, np.array([0, 0, 3, 2, 0, 0.0]), gap, 2 * time)
        np.testing.assert_allclose(time, [0, 1, 1.5, 1.5, 2, 3, 3.5, 3.5, 4, 5])
        np.testing.assert_allclose(force, [0, 0, 0, 3.5, 3, 2, 1.5, 0, 0, 0])
        np.testing.assert_allclose(other, 2 * time)
        np.testing.assert_allclose(gap[[2, 3, 6, 7]], 0)

    def test_a_block_of_cycles_is_an_envelope(self):
        time = np.linspace(0, 1, 20001)
        envelopes.draw(self.axes, time, np.sin(5e3 * time), "black")
        self.assertEqual(len(self.axes.collections), 1)
        np.testing.assert_allclose(self.axes.get_lines()[1].get_ydata(), 1, atol=0.01)
        envelopes.draw(self.axes, time, np.sin(50 * time), "black")
        self.assertEqual(len(self.axes.get_lines()[-1].get_xdata()), len(time))

    def test_motions_have_the_numbers_that_the_program_gives_where_all_exist(self):
        self.assertEqual(basins.numbered([[0], [1, 0], [1]]), [[1], [0, 1], [0]])


class Panels(unittest.TestCase):
    def test_of_zeros_or_rounding_are_left_out(self):
        values = {"a": [1.0, 2.0], "b": [0.0, 0.0], "c": [1e-11, 2e-11], "d": [np.nan, np.nan]}
        analysis = mock.Mock(read=lambda path: Array(np.array(values[path]), "m"))
        shown = without_rounding(analysis, Sheet("", "", [Panel(name, [(name, "")]) for name in values]))
        self.assertEqual([panel.label for panel in shown.panels], ["a"])
        values["a"] = [1e-16, 2e-16]
        self.assertEqual(without_rounding(analysis, Sheet("", "", [Panel("a", [("a", "")])])).panels, [])

    def test_a_map_without_values_has_ends(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(maps.ends_of(np.ma.masked_invalid([np.nan, np.nan])), (0, 1))


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
