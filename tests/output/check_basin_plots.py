"""Figures of basins colour each cell by its motion, mark the motions and give their shares:
check_basin_plots.py PROGRAM
"""

import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

from vibroimpact.plots import basins, style  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import to_hex  # noqa: E402

from plot_examples import Writer  # noqa: E402

Y, W = np.array([-1.0, 0.0, 1.0, 2.0]), np.array([-0.5, 0.5])
CELLS = np.array([[0, 0, 1, -1], [0, 1, 1, -2.0]])
LAMBDA = np.array([1.0, 2.0, 3.0])
# The larger motion is alone at first and second of two afterwards; it ends before the last value.
SHARES = np.array([[1.0, np.nan], [0.25, 0.75], [0.9, np.nan]])
STATES = np.array([[[5.0, 1.0], [np.nan, np.nan]], [[0.1, 0.0], [5.1, 1.1]],
                   [[0.2, 0.0], [np.nan, np.nan]]])


def write(folder):
    writer = Writer(folder)
    writer.analysis("plane", "basins", [("Variables.w", W, "1")])
    writer.scale("Variables.y", Y, "1")
    writer.field("cell/attractor", CELLS, "1", ("Variables.y",))
    writer.field("attractors/first_axis", np.array([[-0.5, 1.5]] * 2), "1", ("attractor",))
    writer.field("attractors/second_axis", np.array([[0.2, -0.4]] * 2), "1", ("attractor",))
    writer.analysis("random", "basin shares", [("Variables.lambda", LAMBDA, "1")],
                    ["Variables/lambda"])
    writer.field("attractors/share", SHARES, "1", ("attractor",))
    writer.field("attractors/state", STATES, "SI", ("attractor", "state"))
    writer.file.close()


def height_at(corners, x):
    """Of a stack of rectangles at x."""
    crossing = [a[1] for a, b in zip(corners, corners[1:])
                if a[1] == b[1] and min(a[0], b[0]) <= x <= max(a[0], b[0])]
    return max(crossing) - min(crossing)


class BasinFigures(unittest.TestCase):
    def setUp(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder)
        results = self.enterContext(Results(folder))
        self.enterContext(plt.rc_context(style.SETTINGS))
        self.addCleanup(plt.close, "all")
        self.figures = {name: draw() for analysis in results.analyses()
                        for name, draw in figures(results, analysis)}

    def test_names(self):
        self.assertEqual(set(self.figures), {"plane-basins", "random-shares"})

    def test_cells_have_the_colours_of_their_motions(self):
        axes = self.figures["plane-basins"].axes[0]
        mesh = axes.collections[0]
        np.testing.assert_array_equal(mesh.get_array().reshape(CELLS.shape), CELLS)
        wanted = {0: style.COLOURS[0], 1: style.COLOURS[1], -1: basins.MARKS[-1][1],
                  -2: basins.MARKS[-2][1]}
        for mark, colour in wanted.items():
            self.assertEqual(to_hex(mesh.cmap(mesh.norm(mark))).upper(), colour.upper())
        corners = mesh.get_coordinates()
        np.testing.assert_allclose(corners[0, :, 0], [-1.5, -0.5, 0.5, 1.5, 2.5])
        np.testing.assert_allclose(corners[:, 0, 1], [-1, 0, 1])

    def test_motions_are_marked_and_their_shares_stand_in_the_legend(self):
        axes = self.figures["plane-basins"].axes[0]
        np.testing.assert_allclose(axes.get_lines()[0].get_xydata(), [[-0.5, 0.2], [1.5, -0.4]])
        texts = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(texts, ["motion 1: 0.3750", "motion 2: 0.3750", "undecided: 0.1250",
                                 "no motion: 0.1250", "motion at phase 0"])
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("$y$", "$w$"))

    def test_shares_follow_each_motion(self):
        axes = self.figures["random-shares"].axes[0]
        heights = []
        for layer in axes.collections:
            corners = layer.get_paths()[0].vertices
            # Steps change halfway between two values, none is slanted.
            steps = np.diff(corners, axis=0)
            self.assertTrue(np.all((steps == 0).any(axis=1)))
            heights.append([height_at(corners, x) for x in LAMBDA])
        np.testing.assert_allclose(heights, [[0, 0.25, 0.9], [1, 0.75, 0], [0, 0, 0.1]], atol=1e-12)
        texts = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(texts, ["motion 1", "motion 2", "undecided"])

    def test_small_entries_and_a_single_jump_do_not_part_a_motion(self):
        gone = [np.nan] * 3
        states = np.array([[[1, 0, 0], [5, 1e-3, 0]],         # two motions, the third entry is noise
                           [[1.2, 0, 1e-3], [4.8, 0, -1e-3]],
                           [[2.9, 0, 0], [1.3, 1e-3, 1e-3]],  # the order changes, one jumps
                           [[1.4, 0, 0], gone]])
        self.assertEqual(basins.follow(states), [[0, 1], [0, 1], [1, 0], [0]])


if __name__ == "__main__":
    unittest.main()
