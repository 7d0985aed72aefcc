"""Figures of loci: curves by kind, ticks to the side, filled wedges, special points, families:
check_loci_plots.py PROGRAM
"""

import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

from vibroimpact.plots import style  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from plot_examples import Writer  # noqa: E402

# A wedge of folds with its cusp at (2 Hz, 1), and a curve of period doublings.
FREQUENCY = np.array([1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 5.2, 5.0])
MU = np.array([3.0, 1.5, 1.0, 1.5, 3.0, 1.0, 2.0, 3.0])
LOCUS = np.array([0] * 5 + [1] * 3)
KIND = np.array([1] * 5 + [3] * 3)
SIDE = np.array([1, 1, 0, -1, -1, -1, -1, -1])


def write(folder, cases):
    writer = Writer(folder)
    grid = cases > 1
    axes = [("Variables.f", np.arange(1.0, cases + 1), "1")] if grid else []
    writer.analysis("folds", "locus", axes, ["Variables/f"] if grid else [])

    def field(path, values, unit, inner, description=""):
        values = np.array([values] * cases if grid else values, dtype=float)
        if grid and not path.startswith(("special", "end")):
            values[1:, -1] = np.nan  # the last point is missing in all but the first
        writer.field(path, values, unit, (inner,))
        writer.group[path].attrs["description"] = description

    for path, values in (("locus", LOCUS), ("kind", KIND), ("side", SIDE),
                         ("arclength", np.arange(8))):
        field(path, values, "1", "locus_point")
    # In the alphabet the second key comes first.
    field("Variables.mu", MU, "1", "locus_point", description="second key: swept key")
    field("frequency", FREQUENCY, "Hz", "locus_point",
          description="first key: excitation frequency")
    field("special/kind", [1, 2], "1", "special_point")
    field("special/Variables.mu", [1.0, 1.0], "1", "special_point")
    field("special/frequency", [2.0, 5.0], "Hz", "special_point")
    field("end/locus", [0, 0, 1, 1], "1", "locus_end")
    field("end/Variables.mu", [3, 3, 1, 3], "1", "locus_end")
    field("end/frequency", [1, 4, 5, 5], "Hz", "locus_end")
    field("end/reason", [0, 0, 2, 0], "1", "locus_end")
    writer.file.close()


class LociFigures(unittest.TestCase):
    def draw(self, cases=1):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder, cases)
        with Results(folder) as results, plt.rc_context(style.SETTINGS):
            found = dict(figures(results, results.analyses()[0]))
            self.addCleanup(plt.close, "all")
            self.assertEqual(list(found), ["folds-plane"])
            return found["folds-plane"]().axes[0]

    @staticmethod
    def curves(axes):
        return [line for line in axes.get_lines()
                if line.get_gid() is None and line.get_linestyle() != "None"]

    def test_curves_by_kind(self):
        axes = self.draw()
        self.assertEqual(axes.get_xlabel(), "Frequency (Hz)")
        self.assertIn("mu", axes.get_ylabel())
        curves = self.curves(axes)
        self.assertEqual([line.get_linestyle() for line in curves], ["-", "--"])
        np.testing.assert_allclose(curves[0].get_data(), (FREQUENCY[:5], MU[:5]))
        np.testing.assert_allclose(curves[1].get_data(), (FREQUENCY[5:], MU[5:]))

    def test_ticks_point_to_the_side(self):
        ticks = [line for line in self.draw().get_lines() if line.get_gid() == "side"]
        self.assertEqual(len(ticks), 2 * 24)
        for tick in ticks:
            (begin, end), (low, high) = tick.get_data()
            self.assertEqual(low, high)
            if begin != end:  # at the cusp there is none
                self.assertEqual(np.sign(end - begin), 1 if begin < 2 else -1)

    def test_wedges_are_filled(self):
        axes = self.draw()
        self.assertEqual(len(axes.patches), 1)
        corners = axes.patches[0].get_xy()
        np.testing.assert_allclose(corners[:5], np.array([FREQUENCY[:5], MU[:5]]).T)
        self.assertEqual(len(axes.texts), 0)  # no text lies over the curves

    def test_special_points_and_legend(self):
        axes = self.draw()
        marked = {line.get_marker(): np.array(line.get_data()).ravel().tolist()
                  for line in axes.get_lines() if line.get_linestyle() == "None"
                  and len(line.get_xdata())}
        self.assertEqual(marked, {"*": [2, 1], "D": [5, 1]})
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()],
                         ["fold;\nticks: three solutions", "period doubling;\nticks: period doubled", "cusp", "end on a grazing curve"])

    def test_family_of_a_grid(self):
        axes = self.draw(3)
        curves = self.curves(axes)
        self.assertEqual(len(curves), 6)
        self.assertEqual(len({line.get_color() for line in curves}), 3)
        self.assertEqual(len(curves[3].get_xdata()), 2)
        self.assertEqual(len(axes.texts) + len(axes.patches), 0)


if __name__ == "__main__":
    unittest.main()
