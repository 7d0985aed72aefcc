"""Figures of branches show stable parts solid, unstable ones dashed, and every special point:
check_branch_plots.py PROGRAM
"""

import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

from vibroimpact_plots import style  # noqa: E402
from vibroimpact_plots.figure_list import figures  # noqa: E402
from vibroimpact_plots.results import Results  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402  (after style has chosen the backend)
import numpy as np  # noqa: E402

from plot_examples import Writer  # noqa: E402

PEAK = "point/block.head/displacement_x/peak_excursion"
# An S: the frequency turns at the third and the sixth point; a second branch of two points.
FREQUENCY = np.array([1.0, 2.0, 3.0, 2.5, 2.0, 1.5, 2.5, 4.0, 3.2, 3.6])
HEIGHT = np.array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 7.4, 7.8]) * 1e-3
STABLE = np.array([1, 1, 1, 0, 0, 1, 1, 0, 1, 1.0])
BRANCH = np.array([0] * 8 + [1] * 2)


def write(folder, cases):
    """With a grid over as many cases, the heights times 1, 2, ...; the last point is missing in all
    but the first."""
    writer = Writer(folder)
    grid = cases > 1
    axes = [("Variables.mu", np.arange(1.0, cases + 1), "1")] if grid else []
    writer.analysis("branch", "branch", axes, ["Variables/mu"] if grid else [])

    def field(path, values, unit, *inner):
        whole = np.array([case * values for case in range(1, cases + 1)]) if path.endswith(PEAK) \
            else np.array([values] * cases, dtype=float)
        if not path.startswith(("special", "end")):
            whole[1:, -1] = np.nan
        writer.field(path, whole if grid else whole[0], unit, inner)

    field("frequency", FREQUENCY, "Hz", "branch_point")
    field("branch", BRANCH, "1", "branch_point")
    field("arclength", np.arange(10.0), "1", "branch_point")
    field("stable", STABLE, "1", "branch_point")
    field(PEAK, HEIGHT, "m", "branch_point")
    for part in ("real", "imaginary"):
        field(f"multiplier_{part}", np.ones((10, 2)), "1", "branch_point", "multiplier")
    field("special/kind", np.array([1, 1, 3]), "1", "special_point")
    field("special/frequency", np.array([3.0, 1.5, 3.1]), "Hz", "special_point")
    field("special/" + PEAK, np.array([3.2, 5.7, 7.3]) * 1e-3, "m", "special_point")
    field("end/branch", np.array([0, 0, 1]), "1", "branch_end")
    field("end/frequency", np.array([1.0, 4.0, 3.6]), "Hz", "branch_end")
    field("end/reason", np.array([0, 1, 5]), "1", "branch_end")
    writer.file.close()


class BranchFigures(unittest.TestCase):
    def draw(self, cases):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder, cases)
        with Results(folder) as results, plt.rc_context(style.SETTINGS):
            self.found = dict(figures(results, results.analyses()[0]))
            self.addCleanup(plt.close, "all")
            return {name: draw() for name, draw in self.found.items()}

    def lines(self, axes, style_of_line):
        """Pieces of the curves of one kind, each as a list of corners."""
        pieces = []
        for line in axes.get_lines():
            if line.get_linestyle() != style_of_line or line.get_marker() != "None":
                continue
            data = np.array(line.get_data()).T
            for part in np.split(data, np.flatnonzero(np.isnan(data[:, 0]))):
                part = part[np.isfinite(part[:, 0])]
                if len(part):
                    pieces.append([tuple(np.round(corner, 9)) for corner in part])
        return pieces

    def corners(self, *numbers):
        return [(round(FREQUENCY[i], 9), round(HEIGHT[i] * 1e3, 9)) for i in numbers]

    def test_names(self):
        self.assertEqual(set(self.draw(1)), {"branch-displacement-x-block.head",
                                             "branch-displacement-x-peaks-block.head",
                                             "branch-multipliers"})

    def test_stable_parts_are_solid_and_unstable_ones_dashed(self):
        axes = self.draw(1)["branch-displacement-x-block.head"].axes[0]
        self.assertEqual(self.lines(axes, "-"),
                         [self.corners(0, 1, 2), self.corners(5, 6), self.corners(8, 9)])
        self.assertEqual(self.lines(axes, "--"), [self.corners(2, 3, 4, 5), self.corners(6, 7)])

    def test_special_points_have_markers_and_a_legend(self):
        axes = self.draw(1)["branch-displacement-x-block.head"].axes[0]
        marked = {line.get_marker(): np.array(line.get_data()).T.tolist()
                  for line in axes.get_lines() if len(line.get_xdata())
                  and line.get_linestyle() == "None"}
        self.assertEqual(set(marked), {"o", "^"})
        np.testing.assert_allclose(marked["o"], [[3.0, 3.2], [1.5, 5.7]])
        np.testing.assert_allclose(marked["^"], [[3.1, 7.3]])
        texts = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(texts, ["stable", "unstable", "fold", "period doubling"])

    def test_family_of_a_grid(self):
        axes = self.draw(3)["branch-displacement-x-block.head"].axes[0]
        solid = self.lines(axes, "-")
        self.assertEqual(len(solid), 3 + 2 + 2)  # the last point is missing in two cases
        self.assertEqual(solid[3][1], (2.0, 4.0))
        colours = {line.get_color() for line in axes.get_lines()}
        self.assertEqual(len(colours), 3)

    def test_multipliers_against_the_unit_circle(self):
        axes = self.draw(1)["branch-multipliers"].axes[0]
        circle = np.array(axes.get_lines()[0].get_data())
        np.testing.assert_allclose(np.hypot(*circle), 1)
        self.assertEqual(len(axes.get_lines()[1].get_xdata()), 20)


if __name__ == "__main__":
    unittest.main()
