"""Figures of searches show every evaluation, the best so far, failed ones and those that miss a
constraint: check_search_plots.py PROGRAM
"""

import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

from vibroimpact.plots import searches, style  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from plot_examples import Writer  # noqa: E402

NAN = np.nan
# Two starts of up to five evaluations behind the result; the first one's second evaluation failed,
# its third misses the constraint, its fifth was not needed.
OBJECTIVE = np.array([[2.0, 4, NAN, 1, 2, NAN], [3.0, 5, 3, 4, 6, 7]])
EXCESS = np.array([[-0.5, -0.5, NAN, 0.3, -0.1, NAN], [-0.1, -0.1, -0.1, -0.1, -0.1, -0.1]])
# Two objectives of five evaluations; the second is dominated, the fourth misses the constraint.
FIRST, SECOND = [1.0, 2.5, 2, 0.5, 3], [3.0, 3.5, 2, 0.5, 1]
X = np.array([[0.4, 0.1, 0.2, 0.3, 0.4, NAN], [0.6, 0.5, 0.6, 0.7, 0.8, 0.9]])


def write(folder, sign):
    writer = Writer(folder)
    writer.analysis("search", "optimise",
                    [("start", np.array([1.0, 2]), "1"), ("evaluation", np.arange(6.0), "1")])
    writer.field("objective", sign * OBJECTIVE, "m")
    writer.field("excess/force", EXCESS, "1")
    writer.field("key/x", X, "1")
    writer.field("key/y", 1e-3 * X, "m")
    writer.analysis("fit", "estimate",
                    [("start", np.array([1.0, 2]), "1"), ("evaluation", np.arange(2.0), "1")])
    writer.field("sum_of_squares", np.array([[3.0, 3], [1, 1]]), "1")
    writer.field("key/x", X[:, :2], "1")
    writer.field("key/y", 10 * X[:, :2], "m")
    # Statistics stand in the result alone; the second start is the better one.
    for name, error in (("x", 0.1), ("y", 0.5)):
        row = np.full((2, 2), NAN)
        row[1, 0] = error
        writer.field(f"standard_error/{name}", row, "1" if name == "x" else "m")
        for end, sign in (("lower", -1), ("upper", 1)):
            writer.field(f"interval_{end}/{name}", row * 0 + X[1, 0] * (1 if name == "x" else 10)
                         + sign * 12.706 * error, "1" if name == "x" else "m")
    correlation = np.full((2, 2, 2, 2), NAN)
    correlation[1, 0] = [[1, 0.6], [0.6, 1]]
    writer.field("correlation", correlation, "1", ("fitted_key", "other_key"))
    at = np.broadcast_to([1.0, 2, 4], (2, 2, 3))
    start = np.arange(2.0)[:, None, None]
    for group, values, unit in (("abscissa", at, "Hz"), ("measured", 1e-3 * at, "m"),
                                ("model", 1e-3 * (at + start), "m"),
                                ("residual", at + start, "1")):
        writer.field(f"{group}/sweep", values, unit, ("datum",))
    writer.analysis("both", "pareto front", [("evaluation", np.arange(6.0), "1")])
    for name, factor, unit in (("mass", 1, "kg"), ("push", 1e-3, "m")):
        at = np.array([NAN, *(FIRST if name == "mass" else SECOND)])
        writer.field(f"objective/{name}", factor * at, unit)
        row = np.full((6, 3), NAN)
        row[0] = factor * at[[1, 3, 5]]
        writer.field(f"front/objective/{name}", row, unit, ("member",))
    row = np.full((6, 3), NAN)
    row[0] = [0.1, 0.2, 0.3]
    writer.field("front/key/x", row, "1", ("member",))
    writer.field("excess/force", np.array([NAN, -1, -1, -1, 1, -1]), "1")
    writer.analysis("shares", "sensitivity", [("evaluation", np.arange(3.0), "1")])
    for kind, values in (("first_order", (0.5, 0.2)), ("first_order_error", (0.03, 0.02)),
                         ("total", (0.8, 0.4)), ("total_error", (0.05, 0.04))):
        for key, value in zip("xy", values):
            writer.field(f"{kind}/peak/{key}", np.array([value, NAN, NAN]), "1")
    writer.analysis("orbit", "periodic orbit", [])
    for path, value, unit in (("contact/stop/peak_force/maximum", 4.0, "N"),
                              ("contact/stop/impulse/mean", NAN, "N s"),
                              ("derivative/stiffness/value", 10.0, "N/m"),
                              ("derivative/stiffness/smooth", 1.0, "1"),
                              ("derivative/stiffness/contact/stop/peak_force/maximum", 0.2, "N/(N/m)"),
                              ("derivative/stiffness/contact/stop/impulse/mean", 0.1, "N s/(N/m)")):
        writer.field(path, np.array(value), unit)
    writer.file.close()


class SearchFigures(unittest.TestCase):
    def draw(self, sign=1):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder, sign)
        results = self.enterContext(Results(folder))
        self.enterContext(plt.rc_context(style.SETTINGS))
        self.addCleanup(plt.close, "all")
        return {name: draw() for analysis in results.analyses()
                for name, draw in figures(results, analysis)}

    def test_an_objective_goes_by_its_symbol(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder, 1)
        analysis = self.enterContext(Results(folder)).analysis("search")
        analysis.attributes = lambda _: {"description": "eta_peak, smallest"}
        self.assertEqual(searches.objective_name(analysis), "eta peak")
        analysis.parameters = {"Derived eta_peak": {"Symbol": r"$\eta^*$"}}
        self.assertEqual(searches.objective_name(analysis), r"$\eta^*$")

    def test_names(self):
        self.assertEqual(set(self.draw()), {"search-history", "search-plane", "fit-fit-sweep", "fit-history",
                                            "fit-residuals", "fit-ellipses",
                                            "both-front", "both-keys", "shares-shares", "orbit-derivatives"})

    def test_the_best_so_far_never_gets_worse_and_meets_the_constraint(self):
        for sign in (1, -1):
            axes = self.draw(sign)["search-history"].axes[0]
            steps = [line.get_ydata() for line in axes.get_lines()
                     if line.get_drawstyle() == "steps-post"]
            np.testing.assert_allclose(steps[0], sign * np.array([4, 4, 4, 2]))
            np.testing.assert_allclose(steps[1], sign * np.array([5, 3, 3, 3, 3]))

    def test_every_evaluation_is_marked(self):
        axes = self.draw()["search-history"].axes
        marks = {(line.get_marker(), line.get_markerfacecolor() == "none"): line.get_xdata()
                 for line in axes[0].get_lines()[:4] if line.get_drawstyle() == "default"}
        np.testing.assert_array_equal(marks[".", False], [1, 4])
        np.testing.assert_array_equal(marks["x", False], [2])
        np.testing.assert_array_equal(marks[".", True][np.isin(marks[".", True], [3])], [3])
        texts = [text.get_text() for text in axes[0].get_legend().get_texts()]
        self.assertEqual(texts, ["start 1", "start 2", "misses a constraint", "failed"])
        self.assertEqual(len(axes), 3)
        self.assertEqual(axes[2].get_ylabel(), "$y$ (µm)")

    def test_the_plane_marks_the_best_of_all_starts(self):
        axes = self.draw()["search-plane"].axes[0]
        star = next(line for line in axes.get_lines() if line.get_marker() == "*")
        np.testing.assert_allclose(star.get_xydata(), [[0.4, 400]])
        colours = axes.collections[0].get_array()
        np.testing.assert_allclose(sorted(colours), [2, 3, 4, 4, 5, 6, 7])

    def test_a_fit_shows_data_model_and_residuals_of_the_best_start(self):
        above, below = self.draw()["fit-fit-sweep"].axes
        measured, start, model = above.get_lines()  # the model lies on top
        np.testing.assert_allclose(start.get_xydata(), model.get_xydata())
        np.testing.assert_allclose(model.get_xydata(), [[1, 2], [2, 3], [4, 5]])
        np.testing.assert_allclose(measured.get_xydata(), [[1, 1], [2, 2], [4, 4]])
        np.testing.assert_allclose(below.get_lines()[1].get_xydata(), [[1, 2], [2, 3], [4, 5]])
        self.assertEqual((above.get_ylabel(), below.get_xlabel()), ("sweep (mm)", "Frequency (Hz)"))

    def test_residuals_beside_a_normal_distribution(self):
        over, against = self.draw()["fit-residuals"].axes
        np.testing.assert_allclose(over.get_lines()[0].get_xydata(), [[0.4, 2], [0.6, 3], [1, 5]])
        np.testing.assert_allclose(against.get_lines()[0].get_xydata(),
                                   [[-0.967422, 2], [0, 3], [0.967422, 5]], rtol=1e-6)

    def test_an_ellipse_is_where_the_quadratic_form_of_both_keys_is_twice_the_quantile_of_f(self):
        axes = self.draw()["fit-ellipses"].axes[0]
        points, best = (line.get_xydata() for line in axes.get_lines())
        np.testing.assert_allclose(best, [[0.6, 6]])
        covariance = np.array([[0.01, 0.6 * 0.05], [0.6 * 0.05, 0.25]])
        away = points - best
        form = np.einsum("ki,ij,kj->k", away, np.linalg.inv(covariance), away)
        # 199.5 is the quantile of 95 % with 2 and 1 degrees of freedom: three data, two keys.
        np.testing.assert_allclose(form, 2 * 199.5, rtol=1e-4)
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("$x$", "$y$ (m)"))

    def test_a_front_among_the_evaluations_that_meet_the_constraint(self):
        axes = self.draw()["both-front"].axes[0]
        evaluations, front = axes.get_lines()
        np.testing.assert_allclose(front.get_xydata(), [[1, 3], [2, 2], [3, 1]])
        seen = evaluations.get_xydata()
        np.testing.assert_allclose(seen[np.isfinite(seen[:, 0])], [[1, 3], [2.5, 3.5], [2, 2], [3, 1]])
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("mass (kg)", "push (mm)"))
        self.assertLess(axes.get_xlim()[0], 1)
        self.assertGreater(axes.get_xlim()[1], 3)
        (keys,) = self.draw()["both-keys"].axes
        np.testing.assert_allclose(keys.get_lines()[0].get_xydata(), [[1, 0.1], [2, 0.2], [3, 0.3]])

    def test_bars_of_the_shares_have_two_standard_errors(self):
        axes = self.draw()["shares-shares"].axes[0]
        heights = [bar.get_height() for bar in axes.patches]
        np.testing.assert_allclose(heights, [0.5, 0.2, 0.8, 0.4])
        first = axes.containers[0] if hasattr(axes.containers[0], "lines") else axes.containers[1]
        low, high = first.lines[2][0].get_segments()[0][:, 1]
        np.testing.assert_allclose((low, high), (0.44, 0.56))

    def test_derivatives_are_relative(self):
        (axes,) = self.draw()["orbit-derivatives"].axes
        np.testing.assert_allclose([bar.get_width() for bar in axes.patches], [10 * 0.2 / 4])
        self.assertEqual([label.get_text() for label in axes.get_yticklabels()],
                         ["peak force, maximum\nstop"])


if __name__ == "__main__":
    unittest.main()
