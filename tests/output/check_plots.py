"""vibroimpact-plot draws what it should: check_plots.py PROGRAM FOLDER"""

import itertools
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
FOLDER = Path(sys.argv[2])
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

from vibroimpact.plots import cases, choice, curves, labels, parameters_text, style  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.labelled import open_analysis  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402

import h5py  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from plot_examples import Writer, write_all  # noqa: E402
from shell_plot_examples import pipe_nodes, plate_nodes, write_shells  # noqa: E402

FIGURE_NAMES = {
    "modes-left", "modes-right", "release-contact-heads", "release-first-impact-heads",
    "release-motion-left.head", "release-phase-left.head-x", "release-motion-right.head",
    "release-phase-right.head-x", "response-displacement-x", "response-displacement-x-peaks",
    "response-acceleration-x", "response-contact-heads", "map-displacement-x-left.head",
    "map-displacement-x-right.head", "map-displacement-x-peaks-left.head",
    "map-displacement-x-peaks-right.head", "map-acceleration-x-left.head",
    "map-acceleration-x-right.head", "map-contact-heads",
}


def plot(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)


def shown_texts(figure):
    """Every text that is drawn; tick labels beyond the limits are not."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            for tick in axis.get_major_ticks():
                if low <= tick.get_loc() <= high:
                    yield from (tick.label1, tick.label2)
            yield axis.label
        yield from (axes.title, axes._left_title, axes._right_title)
        if axes.get_legend():
            yield from axes.get_legend().findobj(plt.Text)


def boxes(figure):
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    return [
        (text.get_text(), text.get_window_extent(renderer))
        for text in shown_texts(figure)
        if text.get_visible() and text.get_text().strip()
    ]


def check_layout(test, figure):
    found = boxes(figure)
    test.assertGreater(len(found), 8)
    for text, box in found:
        inside = box.x0 >= 0 and box.y0 >= 0 and (
            box.x1 <= figure.bbox.x1 and box.y1 <= figure.bbox.y1)
        test.assertTrue(inside, f"{text!r} leaves the figure")
    for (one, a), (other, b) in itertools.combinations(found, 2):
        test.assertFalse(a.overlaps(b), f"{one!r} overlaps {other!r}")


class Program(unittest.TestCase):
    def test_draws_every_figure(self):
        run = plot(FOLDER, "--dpi", "80")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        files = {path.stem: path for path in (FOLDER / "figures").glob("*.png")}
        self.assertEqual(set(files), FIGURE_NAMES)
        for path in files.values():
            self.assertGreater(path.stat().st_size, 5000, path)
        written = (FOLDER / "journal" / "written_files.txt").read_text().splitlines()
        self.assertIn("figures/modes-left.png", written)

    def test_one_analysis_as_pdf_elsewhere(self):
        with tempfile.TemporaryDirectory() as folder:
            run = plot(FOLDER, "--analysis", "modes", "--format", "pdf", "--output", folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(sorted(p.name for p in Path(folder).iterdir()),
                             ["modes-left.pdf", "modes-right.pdf"])

    def test_wrong_folder_file_and_name(self):
        with tempfile.TemporaryDirectory() as folder:
            text = Path(folder) / "results.txt"
            text.write_text("no results")
            for arguments, message in [
                ([f"{folder}/missing"], "no such result folder"),
                ([folder], "no results.h5 in it"),
                ([text], "not a result file"),
                ([FOLDER, "--analysis", "other"], "there are: modes, release, response, map"),
            ]:
                run = plot(*arguments)
                self.assertEqual(run.returncode, 1)
                self.assertIn(message, run.stderr)
                self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)


class Figures(unittest.TestCase):
    def check_all(self, types):
        with Results(FOLDER) as results, plt.rc_context(style.SETTINGS):
            for analysis in (a for a in results.analyses() if a.type in types):
                for name, draw in figures(results, analysis):
                    figure = draw()
                    with self.subTest(name):
                        check_layout(self, figure)
                    plt.close(figure)

    def test_no_text_overlaps_or_is_cut(self):
        self.check_all(["modal", "transient", "stepped sweep"])

    def test_peaks_stand_where_the_force_is_largest(self):
        """Not where the impact begins."""
        with Results(FOLDER) as results, plt.rc_context(style.SETTINGS):
            for analysis in (a for a in results.analyses() if a.name == "release"):
                figure = dict(figures(results, analysis))["release-contact-heads"]()
                lines = figure.axes[0].get_lines()
                marks = [line for line in lines if line.get_marker() == "o"]
                time, force = np.hstack([line.get_xydata().T for line in lines
                                         if line not in marks])
                instants, peaks = marks[0].get_xydata().T
                beginnings = analysis.read("contact/heads/impact/time").values
                durations = analysis.read("contact/heads/impact/duration").values
                self.assertGreater(len(instants), 0)
                unit = instants[0] / analysis.read("contact/heads/impact/peak_time").values[0]
                for instant, start, duration in zip(instants, unit * beginnings, unit * durations):
                    inside = (time >= start) & (time <= start + duration)
                    largest = time[inside][np.argmax(force[inside])]
                    self.assertLess(abs(instant - largest), 0.2 * duration)
                plt.close(figure)

    def test_large_families_get_a_colour_bar(self):
        for module in (cases, curves):
            self.addCleanup(setattr, module, "LARGEST_LEGEND", module.LARGEST_LEGEND)
            module.LARGEST_LEGEND = 2
        self.check_all(["stepped sweep"])


class Kinds(unittest.TestCase):
    """What is in figures of motions and measures that are known."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        write_all(cls.folder)
        cls.results = cls.enterClassContext(Results(cls.folder))
        cls.enterClassContext(plt.rc_context(style.SETTINGS))
        cls.addClassCleanup(plt.close, "all")
        cls.known = {name: draw for analysis in cls.results.analyses()
                     for name, draw in figures(cls.results, analysis)}

    def axes(self, name):
        figure = self.known[name]()
        plt.close(figure)
        return figure.axes

    def lines(self, axes, **properties):
        return [line for line in axes.get_lines()
                if all(getattr(line, f"get_{key}")() == value for key, value in properties.items())]

    def legend(self, axes):
        return [text.get_text() for text in axes.get_legend().get_texts()]

    def xy(self, line):
        return np.column_stack([line.get_xdata(), line.get_ydata()])

    def test_jumps_interrupt_a_curve_and_failed_and_unsettled_points_show(self):
        axes, = self.axes("sweep-displacement-x")
        forward, = self.lines(axes, marker=">")
        np.testing.assert_array_equal(forward.get_ydata(), [1, 2, 9, np.nan, 2, np.nan])
        jump, = self.lines(axes, linestyle=":")
        np.testing.assert_array_equal(self.xy(jump), [[3, 9], [3.5, 9], [3.5, 2], [4, 2]])
        hollow = [line for line in self.lines(axes, fillstyle="none") if len(line.get_xdata())]
        self.assertEqual([self.xy(line).tolist() for line in hollow], [[[2, 2]]])
        self.assertEqual(self.legend(axes),
                         ["first.mass", "forward", "backward", "not settled", "jump"])

    def test_keys_that_follow_tell_the_cases_of_a_family_apart(self):
        axes, = self.axes("family-displacement-x-first.mass")
        self.assertEqual(self.legend(axes), ["1 mm, 5 mm", "2 mm, 5 mm", "2 mm, 6 mm"])
        self.assertEqual(axes.get_legend().get_title().get_text(), "gap, base")

    def test_frequency_responses_are_a_family_over_a_grid(self):
        amplitude, phase = self.axes("receptance-displacement-x-response-first.mass")
        self.assertEqual(self.legend(amplitude), ["1 mm", "2 mm"])
        for axes, sign in [(amplitude, 1e3), (phase, -1)]:
            curves = [line.get_ydata() for line in axes.get_lines()]
            np.testing.assert_allclose(curves, sign * np.outer([1e-3, 2e-3], np.arange(1, 6)))

    def test_bifurcation_diagram_has_all_section_points_of_both_directions(self):
        axes, = self.axes("sweep-bifurcation-period-first.mass-x")
        forward, backward = axes.get_lines()
        known = np.isfinite(forward.get_ydata())
        np.testing.assert_array_equal(self.xy(forward)[known], [
            [f, k * f] for f in (1, 2, 3, 4) for k in (1, 2)])
        self.assertEqual(len(backward.get_xdata()), 10)
        self.assertNotEqual(forward.get_color(), backward.get_color())

    def test_extrema_of_a_gap_show_the_second_side_less_the_first(self):
        axes, = self.axes("sweep-bifurcation-gap-extremum-stop")
        np.testing.assert_array_equal(self.xy(axes.get_lines()[1])[:2], [[1, 2], [1, 4]])
        self.assertIn("second.mass less first.mass", axes.get_ylabel())

    def test_history_shades_the_contacts(self):
        axes = self.axes("orbits-history-contacts-1")
        self.assertEqual([a.get_ylabel() for a in axes], ["Contact force (mN)", "Gap (m)"])
        spans = [patch.get_extents().transformed(axes[0].transData.inverted())
                 for patch in axes[0].patches]
        np.testing.assert_allclose([[span.x0, span.x1] for span in spans],
                                   [[1 / 12, 5 / 12], [13 / 12, 17 / 12]], atol=0.005)

    def test_cycles_and_portraits_have_a_panel_for_each_motion(self):
        for name in ("orbits-cycle-stop", "orbits-force-displacement-first.mass-x",
                     "orbits-portrait-first.mass-x", "orbits-poincare-period-first.mass-x"):
            self.assertEqual([a.get_title("left").replace("\xa0", " ") for a in self.axes(name)],
                             [f"$\\lambda$ = {n}" for n in (1, 2, 3, 4)], name)
        force, = self.axes("orbits-force-displacement-first.mass-x")[3].get_lines()
        np.testing.assert_allclose(force.get_ydata(), np.maximum(force.get_xdata() - 2, 0),
                                   atol=1e-12)
        orbit, dots = self.axes("orbits-portrait-first.mass-x")[1].get_lines()
        np.testing.assert_allclose(np.hypot(orbit.get_xdata(), orbit.get_ydata() / (2 * np.pi)), 2)
        np.testing.assert_array_equal(self.xy(dots), [[2, 0]] * 3)

    def test_spectrum_marks_the_orders(self):
        first = self.axes("sweep-spectrum-first.mass-displacement-x")[1]
        orders = self.lines(first, linestyle=":")
        self.assertEqual([line.get_xdata()[0] for line in orders], [2, 4, 6])
        self.assertEqual([text.get_text() for text in first.texts if text.get_text()],
                         ["1", "2", "3"])
        self.assertEqual(first.get_yscale(), "log")

    def test_scalogram_shows_the_excitation_and_the_edges(self):
        axes, _ = self.axes("run-wavelet-first.mass-displacement-x")
        line, = axes.get_lines()
        np.testing.assert_allclose(np.interp([0, 2, 4, 5], *self.xy(line).T), [2, 6, 10, 10])
        self.assertEqual(self.legend(axes),
                         ["edge effects", "excitation frequency (table)"])

    def test_map_has_derived_curves_bands_and_level_lines_on_top(self):
        axes, bar = self.axes("plane-map-largest")
        self.assertEqual(bar.get_ylabel(), "largest (m)")
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("$\\lambda$", "$\\delta_{0}$ (m)"))
        self.assertEqual(sorted(self.legend(axes)), ["best", "level", "useful"])
        best, = self.lines(axes, marker="o")
        np.testing.assert_array_equal(self.xy(best), [[2, 0], [3, 0.5], [4, 1]])
        levels = [self.xy(line) for line in self.lines(axes, marker="None")]
        self.assertEqual([np.isfinite(xy[:, 0]).sum() for xy in levels], [2, 2])
        band = axes.collections[-1].get_paths()[0].get_extents()
        self.assertEqual((band.x0, band.x1), (1, 3))

    def test_derived_quantities_of_one_unit_share_a_figure(self):
        axes, = self.axes("plane-derived-m-over-delta0")
        self.assertEqual(sorted(self.legend(axes)), ["mean", "smallest"])
        loci, = self.axes("plane-loci-delta0-lambda")
        self.assertEqual(len(self.legend(loci)), 3)

    def test_level_lines_of_many_levels_have_their_own_figure(self):
        axes, = self.axes("plane-levels-many")
        self.assertEqual(self.legend(axes), ["1", "2", "3"])
        np.testing.assert_array_equal(self.xy(axes.get_lines()[1]), [[1, 0.5], [4, 0.5]])

    def test_no_text_overlaps_or_is_cut(self):
        for name in ("sweep-contact-stop", "orbits-poincare-period-first.mass-x",
                     "plane-map-displacement-x-first.mass", "sweep-spectrum-first.mass-displacement-x"):
            with self.subTest(name):
                check_layout(self, self.known[name]())


class Shells(unittest.TestCase):
    """Modes of shells that are known."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        writer = Writer(cls.folder)
        write_shells(writer)
        writer.file.close()
        cls.results = cls.enterClassContext(Results(cls.folder))
        cls.enterClassContext(plt.rc_context(style.SETTINGS))
        cls.addClassCleanup(plt.close, "all")
        analysis, = cls.results.analyses()
        cls.known = dict(figures(cls.results, analysis))

    def panels(self, name):
        figure = self.known[name]()
        return [axes for axes in figure.axes if axes.get_label() != "<colorbar>"]

    def test_the_program_draws_them(self):
        run = plot(self.folder, "--dpi", "50")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual({path.stem for path in (self.folder / "figures").iterdir()},
                         {"shapes-plate", "shapes-tilted", "shapes-pipe"})

    def test_each_mode_has_a_panel_with_its_number_and_frequency(self):
        panels = self.panels("shapes-plate")
        self.assertEqual([axes.get_title("left") for axes in panels],
                         [f"Mode {n}: {1.5 * n:g} Hz" for n in range(1, 10)])
        self.assertEqual(panels[0].figure._suptitle.get_text(),
                         "Body plate, the first 9 of 11 modes")
        self.assertEqual(self.panels("shapes-pipe")[0].get_title(), "Mode 1: 1.5 Hz")

    def test_colours_of_flat_shells_are_the_displacement_across_them(self):
        axes = self.panels("shapes-plate")[0]
        mesh, = [c for c in axes.collections if c.get_array() is not None]
        np.testing.assert_allclose(mesh.get_array(), plate_nodes()[:, 0] / 4)
        self.assertEqual(mesh.get_clim(), (-1, 1))
        np.testing.assert_allclose(mesh._triangulation.x, plate_nodes()[:, 0])
        self.assertEqual(axes.get_aspect(), 1)
        self.assertEqual((axes.get_xlabel(), self.panels("shapes-plate")[6].get_xlabel()),
                         ("", "x (m)"))
        stiffeners = axes.collections[-1].get_segments()
        np.testing.assert_allclose(stiffeners, [[[0, 0], [1, 0]], [[1, 0], [2, 0]]])

    def test_modes_within_the_plane_are_drawn_deformed(self):
        axes = self.panels("shapes-plate")[1]
        self.assertFalse([c for c in axes.collections if c.get_array() is not None])
        corners = np.concatenate([path.vertices for c in axes.collections[1:2]
                                  for path in c.get_paths()])
        np.testing.assert_allclose(corners.max(axis=0), [4 + 0.1 * np.hypot(4, 2), 2])

    def test_a_plate_may_lie_anywhere(self):
        axes = self.panels("shapes-tilted")[0]
        mesh, = [c for c in axes.collections if c.get_array() is not None]
        np.testing.assert_allclose(np.abs(mesh.get_array()), plate_nodes()[:, 0] / 4, atol=1e-12)
        xy = np.column_stack([mesh._triangulation.x, mesh._triangulation.y])
        found = np.linalg.norm(xy[:, None] - xy, axis=2)
        expected = np.linalg.norm(plate_nodes()[:, None] - plate_nodes(), axis=2)
        np.testing.assert_allclose(found, expected, atol=1e-12)

    def test_curved_shells_are_drawn_in_space_with_equal_scales(self):
        axes, = self.panels("shapes-pipe")
        ranges = [np.ptp(limits()) for limits in (axes.get_xlim, axes.get_ylim, axes.get_zlim)]
        shape = axes._box_aspect / axes._box_aspect[0]
        np.testing.assert_allclose(ranges / ranges[0], shape)
        faces = axes.collections[0]
        extent = np.linalg.norm(np.ptp(pipe_nodes(), axis=0))
        axes.figure.canvas.draw()
        radius = np.hypot(faces._vec[0], faces._vec[2])
        self.assertAlmostEqual(radius.max(), 1 + 0.1 * extent)
        self.assertAlmostEqual(radius.min(), 1)

    def test_no_text_overlaps_or_is_cut(self):
        for name in ("shapes-plate", "shapes-tilted"):
            with self.subTest(name):
                check_layout(self, self.known[name]())


class Options(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        write_all(self.folder)

    def test_patterns_size_and_format(self):
        run = plot(self.folder, "--figure", "sweep-contact-*", "--format", "svg", "--size", "4x3",
                   "--angular")
        self.assertEqual(run.returncode, 0, run.stderr)
        file, = (self.folder / "figures").iterdir()
        self.assertEqual(file.name, "sweep-contact-stop.svg")
        self.assertIn('width="288pt" height="216pt"', file.read_text())

    def test_a_figure_that_fails_does_not_stop_the_others(self):
        with h5py.File(self.folder / "results.h5", "a") as file:
            del file["analysis/sweep/steady"]
            file["analysis/sweep/steady"] = np.ones(3)
        run = plot(self.folder, "--figure", "sweep-[db]*", "--figure", "*portrait*", "--dpi", "50")
        self.assertEqual(run.returncode, 1)
        self.assertIn("sweep-displacement-x cannot be drawn", run.stderr)
        names = {path.stem for path in (self.folder / "figures").iterdir()}
        self.assertIn("orbits-portrait-first.mass-x", names)
        self.assertNotIn("sweep-displacement-x", names)

    def test_messages(self):
        for arguments, message in [
            (["--figure", "none-*"], "no figure is called none-*"),
            (["--at", "frequency"], "AXIS=VALUES is wanted"),
            (["--at", "direction=up"], "direction=up: there are forward"),
            (["--at", "frequency=much"], "not a number"),
            (["--at", "gap=1 mm", "--at", "base=6 mm"], "no such point of those chosen before"),
            (["--size", "4"], "two numbers are wanted"),
        ]:
            run = plot(self.folder, *arguments)
            self.assertNotEqual(run.returncode, 0)
            self.assertIn(message, run.stderr)

    def test_points_are_chosen(self):
        with Results(self.folder) as results:
            family = next(a for a in results.analyses() if a.name == "family")
            choice.choose(family, ["gap=2 mm", "base=6 mm", "frequency=2.2, 4.9 Hz, 18.9 rad/s"])
            self.assertEqual(family.chosen, {"Variables.gap": [2], "frequency": [1, 2, 4]})


class Expressions(unittest.TestCase):
    def test_numbers_of_parameter_files(self):
        parameters = parameters_text.sections("set Variables = a = 2, b = 3 * a mm # twice\n")
        for text, value in [("b", 6e-3), ("4 N s/m", 4), ("1e-3", 1e-3), ("12mm", 0.012),
                            ("2 (a + 1)", 6), ("a^2", 4), ("30 rpm", np.pi), ("sqrt(a + 2)", 2)]:
            self.assertAlmostEqual(parameters_text.number(text, parameters), value, msg=text)
        self.assertIsNone(parameters_text.number("base force", parameters))


class Labels(unittest.TestCase):
    def test_prefix_suits_the_values(self):
        for unit, value, factor, text in [
            ("m", 0.012, 1e-3, "mm"), ("m", 2.0, 1.0, "m"), ("N", 4500, 1e3, "kN"),
            ("m", 3e-6, 1e-6, "µm"), ("Hz", 3e-3, 1.0, "Hz"), ("1", 1e-9, 1.0, ""),
            ("m/s^2", 4e3, 1.0, "m/s²"), ("N", 0.0, 1.0, "N"), ("s", 1700, 1.0, "s"),
        ]:
            scale = labels.scale_for(unit, [value, float("nan")])
            self.assertEqual((scale.factor, scale.unit), (factor, text))

    def test_words(self):
        self.assertEqual(labels.quantity_label("displacement_x"), "Displacement $x$")
        self.assertEqual(labels.value_text(0.003, "m"), "3 mm")
        self.assertEqual(labels.value_text(2.1e11, "1"), "2.1·10$^{11}$")
        self.assertEqual(labels.powers_of_ten("2.1e-07, 0.3"), "2.1·10$^{-7}$, 0.3")


class Labelled(unittest.TestCase):
    def test_analysis_as_one_dataset(self):
        data = open_analysis(FOLDER / "results.h5", "release")
        self.assertEqual(data["contact/heads/normal_force"].dims, ("time",))
        self.assertEqual(data["contact/heads/pulse/gap"].dims, ("pulse_heads",))
        self.assertEqual(data["fit/exact/restitution"].dims, ("fit_ratio_axis",))
        self.assertEqual(data["contact/heads/gap"].attrs["unit"], "m")
        self.assertAlmostEqual(float(data["contact/heads/gap"].sel(time=0, method="nearest")),
                               0.025, places=6)


if __name__ == "__main__":
    unittest.main()
