"""Figures of branches show stable parts solid, unstable ones dashed, every special point, and what
--overlay asks for: check_branch_plots.py PROGRAM
"""

import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

from vibroimpact.plots import command_line, overlays, style  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.results import ResultError, Results  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from plot_examples import Writer  # noqa: E402

PEAK = "point/block.head/displacement_x/largest"
# An S: the frequency turns at the third and the sixth point; a second branch of two points.
FREQUENCY = np.array([1.0, 2.0, 3.0, 2.5, 2.0, 1.5, 2.5, 4.0, 3.2, 3.6])
HEIGHT = np.array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 7.4, 7.8]) * 1e-3
STABLE = np.array([1, 1, 1, 0, 0, 1, 1, 0, 1, 1.0])
BRANCH = np.array([0] * 8 + [1] * 2)
MULTIPLIERS = {"real": np.array([[0.1 * i, 0.2] for i in range(10)]), "imaginary": np.zeros((10, 2))}
# Two folds and a period doubling; the multiplier of it is not the largest.
SPECIAL = {"real": np.array([[1.0, 0.3], [0.5, 1.0], [1.7, -1.0]]), "imaginary": np.zeros((3, 2))}
SWEPT = np.array([1.0, 2.0, 3.0])


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
        field(f"multiplier_{part}", MULTIPLIERS[part], "1", "branch_point", "multiplier")
        field(f"special/multiplier_{part}", SPECIAL[part], "1", "special_point", "multiplier")
    field("special/kind", np.array([1, 1, 3]), "1", "special_point")
    field("special/frequency", np.array([3.0, 1.5, 3.1]), "Hz", "special_point")
    field("special/" + PEAK, np.array([3.2, 5.7, 7.3]) * 1e-3, "m", "special_point")
    field("end/branch", np.array([0, 0, 1]), "1", "branch_end")
    field("end/frequency", np.array([1.0, 4.0, 3.6]), "Hz", "branch_end")
    field("end/reason", np.array([0, 1, 5]), "1", "branch_end")
    write_sweep(writer)
    write_balance(writer)
    writer.file.close()


def write_sweep(writer):
    """Both directions over the frequency; and one over another key."""
    writer.analysis("sweep", "stepped sweep", [("direction", ["forward", "backward"], "1"),
                                               ("frequency", SWEPT, "Hz")])
    writer.field(PEAK, np.array([SWEPT, SWEPT + 4]) * 1e-3, "m")
    writer.analysis("gaps", "stepped sweep", [("Variables.gap", SWEPT, "m")])
    writer.field(PEAK, SWEPT, "m")


def write_balance(writer):
    """Two numbers of harmonics; no multipliers, one fold."""
    writer.analysis("balance", "harmonic balance",
                    [("Analysis.balance.Harmonic balance.Harmonics", np.array([1.0, 3.0]), "1")],
                    ["Analysis/balance/Harmonic balance/Harmonics"])

    def field(path, values, unit, inner):
        writer.field(path, np.array([values, values]), unit, (inner,))

    field("frequency", SWEPT, "Hz", "branch_point")
    field("branch", np.zeros(3), "1", "branch_point")
    field("arclength", SWEPT, "1", "branch_point")
    field(PEAK, SWEPT * 1e-3, "m", "branch_point")
    field("special/kind", np.array([1]), "1", "special_point")
    field("special/frequency", np.array([2.5]), "Hz", "special_point")
    field("special/" + PEAK, np.array([2.5e-3]), "m", "special_point")
    field("end/branch", np.array([0]), "1", "branch_end")
    field("end/frequency", np.array([3.0]), "Hz", "branch_end")
    field("end/reason", np.array([1]), "1", "branch_end")


class BranchFigures(unittest.TestCase):
    def draw(self, cases, *requests, name="branch"):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder, cases)
        with Results(folder) as results, plt.rc_context(style.SETTINGS), \
                contextlib.ExitStack() as others:
            analysis = next(found for found in results.analyses() if found.name == name)
            overlays.attach(results, [analysis], [text.format(folder) for text in requests],
                            others)
            self.addCleanup(plt.close, "all")
            return {name: draw() for name, draw in figures(results, analysis)}

    def marks(self, axes):
        """Corners of each kind of marker."""
        found = {}
        for line in axes.get_lines():
            if line.get_linestyle() == "None" and len(line.get_xdata()):
                found.setdefault(line.get_marker(), []).extend(
                    np.round(np.array(line.get_data()).T, 9).tolist())
        return found

    def legend(self, axes):
        return [text.get_text() for text in axes.get_legend().get_texts()]

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
                                             "branch-multipliers", "branch-multiplier-moduli"})

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
        drawn = axes.collections[0]
        np.testing.assert_allclose(drawn.get_offsets()[:, 0], MULTIPLIERS["real"].ravel())
        np.testing.assert_allclose(drawn.get_array(), np.repeat(FREQUENCY, 2))
        family = self.draw(3)["branch-multipliers"].axes[0]
        self.assertEqual([len(line.get_xdata()) for line in family.get_lines()[1:]], [20, 20, 20])

    def test_moduli_of_multipliers_over_the_key(self):
        axes = self.draw(1)["branch-multiplier-moduli"].axes[0]
        # Along the S the second multiplier is the larger one up to the third point.
        solid = self.lines(axes, "-")
        self.assertIn([(1.0, 0.0), (2.0, 0.1), (3.0, 0.2)], solid)
        self.assertIn([(1.0, 0.2), (2.0, 0.2), (3.0, 0.2)], solid)
        self.assertIn([(3.0, 0.2), (2.5, 0.3), (2.0, 0.4), (1.5, 0.5)], self.lines(axes, "--"))
        self.assertEqual(self.marks(axes), {"o": [[3.0, 1.0], [1.5, 1.0]], "^": [[3.1, 1.0]]})
        self.assertEqual(self.legend(axes), ["stable", "unstable", "fold", "period doubling"])

    def test_harmonic_balance_is_one_kind_of_line(self):
        drawn = self.draw(1, name="balance")
        self.assertEqual(set(drawn), {"balance-displacement-x-block.head",
                                      "balance-displacement-x-peaks-block.head"})
        axes = drawn["balance-displacement-x-block.head"].axes[0]
        self.assertEqual(self.lines(axes, "-"), [[(1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]] * 2)
        self.assertEqual(self.lines(axes, "--"), [])
        self.assertEqual(self.legend(axes), ["1", "3", "fold"])

    def test_sweep_as_points_over_a_branch(self):
        axes = self.draw(1, "sweep")["branch-displacement-x-block.head"].axes[0]
        marks = self.marks(axes)
        self.assertEqual(marks[">"], [[1.0, 1.0], [2.0, 2.0], [3.0, 3.0]])
        self.assertEqual(marks["<"], [[1.0, 5.0], [2.0, 6.0], [3.0, 7.0]])
        self.assertEqual(self.legend(axes), ["branch", "stable", "unstable", "fold",
                                             "period doubling", "sweep"])
        self.assertEqual(self.lines(axes, "-")[0], self.corners(0, 1, 2))

    def test_harmonic_balance_over_a_branch(self):
        axes = self.draw(1, "balance")["branch-displacement-x-block.head"].axes[0]
        self.assertEqual(self.lines(axes, "-."), [[(1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]] * 2)
        self.assertEqual(self.legend(axes)[-2:], ["balance, Harmonics = 1",
                                                  "balance, Harmonics = 3"])
        colours = {line.get_color() for line in axes.get_lines() if line.get_linestyle() == "-."}
        self.assertEqual(len(colours - {style.COLOURS[0]}), 2)

    def test_branch_of_another_file_keeps_the_colours_of_its_cases(self):
        other = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(other, 3)
        axes = self.draw(3, f"{other}:branch")["branch-displacement-x-block.head"].axes[0]
        self.assertEqual(len(self.lines(axes, "-")), 2 * (3 + 2 + 2))
        self.assertEqual(len({line.get_color() for line in axes.get_lines()}), 3)
        self.assertEqual(self.legend(axes)[-3:], [f"branch ({other.name}), $\\mu$ = {mu}"
                                                  for mu in (1, 2, 3)])
        alone = self.draw(1, str(other))["branch-displacement-x-block.head"].axes[0]
        self.assertIn("sweep", self.legend(alone))

    def test_results_that_share_a_name_are_told_apart_by_their_folders(self):
        root = Path(self.enterContext(tempfile.TemporaryDirectory()))
        places = [root / "stiff" / "run", root / "soft" / "run", root / "soft" / "other"]
        for place in places:
            place.mkdir(parents=True)
            write(place, 1)
        drawn = self.draw(1, *(f"{place}:branch" for place in places), f"{places[0]}:sweep")
        self.assertEqual(self.legend(drawn["branch-displacement-x-block.head"].axes[0])[-4:],
                         ["branch (stiff/run)", "branch (soft/run)", "branch (other)", "sweep"])
        both = self.draw(1, "sweep", f"{places[0]}:sweep")
        self.assertEqual(self.legend(both["branch-displacement-x-block.head"].axes[0])[-2:],
                         ["sweep", "sweep (run)"])

    def test_overlays_that_do_not_fit(self):
        for requested, wanted in (
                ("gaps", "nothing in it runs along frequency"),
                ("nothing", "neither an analysis of"),
                ("{}:nothing", "holds no analysis nothing; there are: balance, branch")):
            with self.assertRaisesRegex(ResultError, wanted):
                self.draw(1, requested)

    def test_command_line(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder, 1)
        output = folder / "drawn"
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            code = command_line.main([str(folder), "--analysis", "branch", "--figure", "*moduli",
                                      "--overlay", "sweep", "--output", str(output)])
        self.assertEqual((code, printed.getvalue().strip()),
                         (0, str(output / "branch-multiplier-moduli.png")))
        with contextlib.redirect_stderr(io.StringIO()) as errors:
            self.assertEqual(command_line.main([str(folder), "--overlay", "gaps"]), 1)
        self.assertIn("--overlay gaps: nothing in it runs along frequency", errors.getvalue())


if __name__ == "__main__":
    unittest.main()
