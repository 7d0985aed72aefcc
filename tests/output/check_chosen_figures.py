"""Figures with chosen axes, and points of tables in them: check_chosen_figures.py PROGRAM"""

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
from plot_examples import Writer  # noqa: E402
from vibroimpact.plots import choice, chosen_figures, figure_axes, style, table_points, traces  # noqa: E402
from vibroimpact.plots.errors import ResultError  # noqa: E402
from vibroimpact.plots.results import Emphasis, Results  # noqa: E402

FREQUENCY = np.array([1.0, 2.0, 3.0, 4.0, 5.0])
LAMBDA = np.array([1.0, 2.0])
AMPLITUDE = "point/first.mass/displacement_x/amplitude"
SECTIONS = r"""
set Variables = unit = 1 rad/s, height = 2 mm, long = 1 + \
  1
subsection Derived best
  set From = sweep
  set Symbol = $\lambda_{opt}$
end
subsection Figure curve
  set From = sweep
  set Reference = free
  set Reference label = no contact
  subsection Horizontal
    set Quantity = frequency
    set Divide by = unit
    set Label = $\beta$
    set Marks = $\beta_1$ = 10, $\beta_2$ = 10 * long
  end
  subsection Vertical
    set Quantity = AMPLITUDE
    set Divide by = height
    set Label = $\eta_{d}$
    set Range = 0, 4
  end
end
subsection Figure swapped
  set From = sweep
  set Where = lambda = 2; direction = forward
  subsection Horizontal
    set Quantity = AMPLITUDE
    set Divide by largest of = free
    set Scale = logarithmic
  end
  subsection Vertical
    set Quantity = frequency
  end
end
subsection Figure plane
  set From = sweep
  set Where = direction = backward
  subsection Horizontal
    set Quantity = frequency
    set Divide by = unit
  end
  subsection Vertical
    set Quantity = lambda
    set Label = $\lambda$
  end
  subsection Colour
    set Quantity = AMPLITUDE
    set Divide by = height
    set Label = $\eta_d$
  end
end
subsection Figure best
  set From = sweep
  subsection Horizontal
    set Quantity = frequency
  end
  subsection Vertical
    set Quantity = best
  end
end
""".replace("AMPLITUDE", AMPLITUDE)
#             lambda, direction, frequency; a jump between 3 and 4 Hz upward for lambda = 1
VALUES = 1e-3 * np.array([[[1, 2, 3, 0.5, 0.4], [1, 0.9, 0.8, 0.5, 0.4]],
                          [[2, 4, 6, 8, 8], [2, 4, 6, 8, 8]]])


def write(folder):
    writer = Writer(folder)
    writer.analysis("sweep", "parameter grid",
                    [("Variables.lambda", LAMBDA, "1"),
                     ("direction", np.array(["forward", "backward"]), "1"),
                     ("frequency", FREQUENCY, "Hz")], grid=["Variables/lambda"])
    writer.field(AMPLITUDE, VALUES, "m")
    writer.field(f"{AMPLITUDE}_error", 1e-4 + 0 * VALUES, "m")
    jump = np.full(VALUES.shape, np.nan)
    jump[0, 0, 3] = 1
    for name, at in (("jump_from", 3.4), ("jump_to", 3.6)):
        writer.field(name, jump * at, "Hz")
    steady = np.ones(VALUES.shape)
    steady[1, 0, 1] = 0
    writer.field("steady", steady, "1")
    writer.field("derived/best", 1.0 / FREQUENCY, "1", dimensions=["frequency"])
    writer.analysis("free", "stepped sweep", [("direction", np.array(["forward"]), "1"),
                                              ("frequency", FREQUENCY, "Hz")])
    writer.field(AMPLITUDE, 1e-3 * np.array([[5, 4, 3, 2, 1.0]]), "m")
    writer.analysis("folds", "locus", [])
    writer.scale("locus_point", np.arange(3.0), "1")
    for name, values in (("locus", [0, 0, 1]), ("frequency", [1, 2, 3.0]), ("Variables.gap", [5, 6, 7.0])):
        writer.field(name, np.array(values, float), "1", ("locus_point",))
    writer.analysis("pairs", "parameter grid", [("Variables.gap", np.array([1, 2, 2.0]), "m")], grid=["Variables/gap"])
    writer.analysis("long", "transient", [])
    writer.scale("time", np.linspace(0, 1, 20001), "s")
    writer.field("gap", np.sin(5e3 * np.linspace(0, 1, 20001)), "m", ("time",))
    writer.file.close()
    (folder / "sections.prm").write_text(SECTIONS)


class Drawn(unittest.TestCase):
    def setUp(self):
        self.addCleanup(plt.close, "all")
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(self.folder)
        self.results = self.enterContext(Results(self.folder))
        self.results.take_figures(self.folder / "sections.prm")

    def figure(self, name):
        known = dict(chosen_figures.figures(self.results, self.results.analysis("sweep")))
        return known[name]()

    def lines(self, figure):
        """Solid and dashed curves, without marks and jumps."""
        return [line for line in figure.axes[0].get_lines() if len(line.get_xdata()) > 4]


class Figures(Drawn):
    def test_curves_are_divided_by_a_variable_and_carry_their_symbols(self):
        figure = self.figure("curve")
        axes = figure.axes[0]
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), (r"$\beta$", r"$\eta_{d}$"))
        self.assertEqual(axes.get_ylim(), (0, 4))
        free = self.lines(figure)[0]
        np.testing.assert_allclose(free.get_xdata(), 2 * np.pi * FREQUENCY)
        np.testing.assert_allclose(free.get_ydata(), [2.5, 2, 1.5, 1, 0.5])
        self.assertEqual(free.get_color(), "black")
        texts = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertIn("no contact", texts)

    def test_marks_stand_where_they_belong(self):
        axes = self.figure("curve").axes[0]
        places = {text.get_text(): text.get_position()[0] for text in axes.texts}
        self.assertEqual(places, {r"$\beta_1$": 10, r"$\beta_2$": 20})

    def test_a_jump_is_a_gap_with_a_dotted_line_in_its_bracket(self):
        axes = self.figure("curve").axes[0]
        dotted = [line for line in axes.get_lines() if line.get_linestyle() == ":"]
        self.assertEqual(len(dotted), 1)
        np.testing.assert_allclose(dotted[0].get_xdata(),
                                   2 * np.pi * np.array([3, 3.5, 3.5, 4]))
        solid = self.lines(self.figure("curve"))[1]
        self.assertTrue(np.isnan(solid.get_ydata()[3]))

    def test_unsettled_points_are_not_joined(self):
        axes = self.figure("curve").axes[0]
        hollow = [line for line in axes.get_lines() if line.get_fillstyle() == "none"]
        self.assertEqual([list(line.get_ydata()) for line in hollow], [[2.0]])

    def test_points_that_are_not_to_be_joined_stand_alone(self):
        self.results.parameters["Figure curve"]["Joined"] = "false"
        axes = self.figure("curve").axes[0]
        own = [line for line in axes.get_lines() if line.get_color() != "black"]
        self.assertNotIn("-", [line.get_linestyle() for line in own])
        self.assertNotIn(":", [line.get_linestyle() for line in own])

    def test_bars_are_two_standard_errors(self):
        bars = [segment for lines in self.figure("curve").axes[0].collections for segment in lines.get_segments()]
        self.assertEqual(len(bars), VALUES.size)
        for (low, high) in bars:
            self.assertAlmostEqual(high[1] - low[1], 4 * 1e-4 / 2e-3)

    def test_a_reference_that_was_not_run_is_left_out(self):
        self.results.parameters["Figure curve"]["Reference"] = "other"
        axes = self.figure("curve").axes[0]
        self.assertNotIn("black", [line.get_color() for line in axes.get_lines()])

    def test_several_quantities_are_curves_with_names(self):
        section = self.results.parameters["Figure curve"]
        section["Vertical"]["Quantity"] = f"{AMPLITUDE}, - {AMPLITUDE}"
        section["Names"] = "up, down"
        section["Where"] = "lambda = 2; direction = backward"
        axes = self.figure("curve").axes[0]
        texts = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(texts, ["no contact", "up", "down"])
        up, down = (line.get_ydata() for line in self.lines(self.figure("curve"))[1:3])
        np.testing.assert_allclose(up, [1, 2, 3, 4, 4])
        np.testing.assert_allclose(down, -up)

    def test_a_figure_by_its_own_largest_values(self):
        section = self.results.parameters["Figure swapped"]
        section["Horizontal"]["Divide by largest of"] = "sweep"
        section["Where"] = "direction = backward"
        for line in self.lines(self.figure("swapped")):
            self.assertEqual(np.nanmax(line.get_xdata()), 1.0)

    def test_axes_are_swapped_and_divided_by_another_analysis(self):
        axes = self.figure("swapped").axes[0]
        self.assertEqual(axes.get_ylabel(), "Frequency (Hz)")
        self.assertEqual(axes.get_xscale(), "log")
        line = self.lines(self.figure("swapped"))[0]
        np.testing.assert_allclose(line.get_ydata(), FREQUENCY)
        np.testing.assert_allclose(line.get_xdata(), [0.4, np.nan, 1.2, 1.6, 1.6])

    def test_a_map_has_its_axes_as_asked(self):
        axes = self.figure("plane").axes
        self.assertEqual(axes[0].get_ylabel(), r"$\lambda$")
        np.testing.assert_allclose(axes[0].get_xlim(), 2 * np.pi * np.array([1, 5]))
        np.testing.assert_allclose(axes[0].get_ylim(), [1, 2])
        self.assertEqual(axes[1].get_ylabel(), r"$\eta_d$")

    def test_a_derived_quantity_goes_by_its_symbol(self):
        self.assertEqual(self.figure("best").axes[0].get_ylabel(), r"$\lambda_{opt}$")

    def test_a_term_over_fewer_axes_is_the_same_along_the_others(self):
        sweep = self.results.analysis("sweep")
        both = figure_axes.find(sweep, f"lambda - {AMPLITUDE}")
        self.assertEqual(both.dimensions, sweep.dimensions(AMPLITUDE))
        np.testing.assert_allclose(both.values, LAMBDA[:, None, None] - VALUES)

    def test_without_a_judgement_no_point_counts_as_not_settled(self):
        self.results.parameters |= {"Analysis sweep": {"Type": "parameter grid", "Parameter grid": {"Repeat": "one"}},
                                    "Analysis one": {"Type": "stepped sweep",
                                                     "Stepped sweep": {"Steadiness tolerance": "0"}}}
        axes = self.figure("curve").axes[0]
        self.assertFalse([line for line in axes.get_lines() if line.get_fillstyle() == "none"])
        self.assertNotIn("not settled", [text.get_text() for text in axes.get_legend().get_texts()])

    def test_loci_are_curves_of_their_own(self):
        section = {"From": "folds", "Horizontal": {"Quantity": "frequency"}, "Vertical": {"Quantity": "Variables.gap"}}
        axes = chosen_figures.figure(self.results, "loci", section).axes[0]
        np.testing.assert_allclose(axes.get_lines()[0].get_xydata(), [[1, 5], [2, 6]])
        np.testing.assert_allclose(axes.get_lines()[1].get_xydata(), [[3, 7]])

    def test_a_value_that_occurs_twice_is_chosen_twice(self):
        folds = self.results.analysis("pairs")
        choice.choose(folds, ["gap = 2"])
        self.assertEqual(folds.chosen, {"Variables.gap": [1, 2]})

    def test_a_history_that_would_be_a_block_is_a_band(self):
        section = {"From": "long", "Horizontal": {"Quantity": "time"}, "Vertical": {"Quantity": "gap"}}
        self.assertEqual(len(chosen_figures.figure(self.results, "long", section).axes[0].collections), 1)

    def test_what_is_not_there_is_named(self):
        section = self.results.parameters["Figure swapped"]
        section["Where"] = "gap = 2"
        with self.assertRaisesRegex(ResultError, "Figure swapped: Where: gap = 2"):
            self.figure("swapped")
        section["Where"] = ""
        section["Vertical"]["Quantity"] = "speed"
        with self.assertRaisesRegex(ResultError, "sweep has no quantity speed"):
            self.figure("swapped")


class Emphasised(Drawn):
    def curve(self, **wanted):
        self.results.emphasis = Emphasis(**wanted)
        return self.figure("curve").axes[0]

    def test_a_highlighted_member_is_red_and_named(self):
        axes = self.curve(highlight=("lambda=2:best",))
        texts = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(texts[:2], ["1", "2, best"])
        red = [line for line in axes.get_lines() if line.get_color() == style.HIGHLIGHT and len(line.get_xdata()) > 4]
        self.assertEqual(np.nanmax(red[0].get_ydata()), 4)
        with self.assertRaisesRegex(ResultError, "--highlight lambda: AXIS=VALUE"):
            self.curve(highlight=("lambda",))

    def test_peaks_are_those_of_motions_that_repeat(self):
        axes = self.curve(peaks=True)
        points = [tuple(line.get_xydata()[0]) for line in axes.get_lines() if len(line.get_xdata()) == 1
                  and line.get_color() == "black"]
        np.testing.assert_allclose(points, 2 * np.pi * np.array([[3, 1.5 / 2 / np.pi], [4, 4 / 2 / np.pi],
                                                                 [1, 2.5 / 2 / np.pi]]))

    def test_shades_where_the_highlighted_curve_is_below_the_reference(self):
        patch = self.curve(highlight=("lambda=1",), below=True).patches[0]
        ends = patch.get_xy()[:, 0] if hasattr(patch, "get_xy") and np.ndim(patch.get_xy()) == 2 else \
            [patch.get_x(), patch.get_x() + patch.get_width()]
        np.testing.assert_allclose([min(ends), max(ends)], 2 * np.pi * np.array([1, 3]), rtol=2e-3)

    def test_another_analysis_with_the_quantities_lies_over_it(self):
        self.results.overlays = [self.results.analysis("free")]
        del self.results.parameters["Figure curve"]["Reference"]
        axes = self.figure("curve").axes[0]
        self.assertIn("free", [text.get_text() for text in axes.get_legend().get_texts()])
        line = self.lines(self.figure("curve"))[-1]
        np.testing.assert_allclose(line.get_ydata(), [2.5, 2, 1.5, 1, 0.5])
        self.assertEqual(line.get_linestyle(), "-.")
        section = self.results.parameters["Figure curve"]
        self.assertFalse(figure_axes.has_axes(self.results.analysis("free"), section | {"Vertical": {"Quantity": "u"}}))


class Tables(unittest.TestCase):
    def setUp(self):
        self.addCleanup(plt.close, "all")
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(self.folder)
        self.table = self.folder / "paper.csv"

    def plot(self, text, *options):
        self.table.write_text(text)
        return subprocess.run([PROGRAM, self.folder, "--sections", self.folder / "sections.prm",
                               "--overlay", self.table, "--dpi", "40", *options],
                              capture_output=True, text=True, check=False)

    def points(self, text, name="curve"):
        self.table.write_text(text)
        with Results(self.folder) as results:
            results.take_figures(self.folder / "sections.prm")
            known = dict(chosen_figures.figures(results, results.analysis("sweep")))
            figure = known[name]()
            table_points.draw(figure, name, table_points.read(self.table))
            return [line for line in figure.axes[0].get_lines() if line.get_label() == "_points"]

    def test_columns_go_by_quantity_and_unit_or_by_label(self):
        by_path = self.points("frequency [Hz], displacement_x/amplitude [mm]\n2, 3\n")
        by_label = self.points("beta [1], eta_d [1]\n12.566370614359172, 1.5\n")
        for lines in (by_path, by_label):
            np.testing.assert_allclose(lines[0].get_xydata(), [[4 * np.pi, 1.5]])

    def test_a_point_has_the_colour_of_its_member(self):
        lines = self.points("beta, eta_d, lambda\n12, 1, 2\n")
        colours = {line.get_color() for line in self.points("beta, eta_d\n12, 1\n")}
        self.assertEqual(len(lines), 1)
        self.assertNotIn(lines[0].get_color(), colours)

    def test_rows_of_other_figures_are_left_out(self):
        self.assertEqual(self.points("beta, eta_d, figure\n12, 1, other*\n"), [])
        self.assertEqual(len(self.points("beta, eta_d, figure\n12, 1, other* cur*\n")), 1)

    def test_lines_are_drawn_as_lines(self):
        line = self.points("# drawn as: line\nbeta, eta_d\n12, 1\n13, 2\n")[0]
        self.assertIn(line.get_marker(), ("", "None"))

    def test_a_series_has_its_own_marker_and_colour(self):
        line = self.points("beta, eta_d, marker, colour\n12, 1, D, cyan\n")[0]
        self.assertEqual((line.get_marker(), line.get_markerfacecolor()), ("D", "cyan"))

    def test_bars_stand_apart(self):
        line = self.points("# drawn as: bars\nbeta, eta_d\n7, 1\n8, 1\n9, 2\n10, 2\n")[0]
        np.testing.assert_allclose(line.get_xdata(), [7, 8, np.nan, 9, 10])

    def test_rows_of_another_file_under_other_names(self):
        (self.folder / "other.csv").write_text("f,A,B\n2,3,9\n4,1,9\n")
        head = "# rows of: other.csv\n# columns: f = frequency [Hz], A = amplitude [mm]\n"
        line = self.points(head + "# figure: cur*\n")[0]
        np.testing.assert_allclose(line.get_xydata(), [[4 * np.pi, 1.5], [8 * np.pi, 0.5]])
        self.assertEqual(self.points(head + "# figure: other\n"), [])
        done = self.plot(head.replace("A =", "C ="))
        self.assertIn("other.csv has no column C", done.stderr)

    def test_a_table_that_fits_nothing_is_an_error(self):
        done = self.plot("speed [m/s], eta_d\n1, 2\n", "--figure", "curve")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no figure has axes of two of its columns, which are speed, eta_d",
                      done.stderr)

    def test_tables_that_cannot_be_read(self):
        for text, message in [("", "no line with the names of the columns"),
                              ("beta, eta_d\n1\n", "row 2 has 1 values, but there are 2 columns"),
                              ("beta [furlong], eta_d\n1, 2\n", "unit [furlong] of beta"),
                              ("# drawn as: stars\nbeta, eta_d\n1, 2\n", "points or line or bars"),
                              ("beta, eta_d, marker\n1, 2, q\n", "q is no marker"),
                              ("beta [1], eta_d [1]\n1, x\n", "column eta_d")]:
            done = self.plot(text)
            self.assertEqual(done.returncode, 1, text)
            self.assertIn(message, done.stderr)


class Traces(unittest.TestCase):
    def test_a_single_large_step_is_a_jump(self):
        along = np.arange(8.0)
        steep = np.array([0, 1, 2, 3, 0.1, 0.1, 0.1, 0.1])
        self.assertEqual(traces.abrupt(along, steep), [])  # a peak between points is none
        self.assertEqual(traces.abrupt(along, np.array([0, 0.1, 0.2, 0.3, 3, 3.1, 3.2, 3.3])),
                         [(3, 4, 3.5)])


if __name__ == "__main__":
    unittest.main()
