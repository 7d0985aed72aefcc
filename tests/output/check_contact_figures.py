"""Contacts in figures of motions: check_contact_figures.py PROGRAM FOLDER"""

import sys
import tempfile
import unittest
import unittest.mock
import warnings
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
FOLDER = Path(sys.argv[2])
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(PROGRAM.parent), str(Path(__file__).resolve().parent)]

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402
from plot_examples import Writer, write_all  # noqa: E402
from vibroimpact.plots import style, transient  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.labels import Scale  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402


class Contacts(unittest.TestCase):
    def setUp(self):
        self.addCleanup(plt.close, "all")

    def test_impacts_are_stems_where_samples_miss_them(self):
        with Results(FOLDER) as results:
            release = next(a for a in results.analyses() if a.name == "release")
            peaks = release.read("contact/heads/impact/peak_force").values.ravel()
            draw = dict(figures(results, release))["release-contact-heads"]
            samples = len(release.read("time").values)
            longest = {}
            for fine in (True, False):
                with unittest.mock.patch.object(transient, "shows_contacts", lambda *_: fine):
                    axes = draw().axes[0]
                stems = axes.collections[0].get_segments()
                np.testing.assert_allclose([stem[0][1] for stem in stems], 0)
                heights = np.array([stem[1][1] for stem in stems])
                np.testing.assert_allclose(heights / heights[0], peaks / peaks[0])
                longest[fine] = max(len(line.get_xdata()) for line in axes.get_lines())
            self.assertGreaterEqual(longest[True], samples)
            self.assertLess(longest[False], samples)

    def test_a_contact_that_is_never_reached_has_no_force_to_show(self):
        self.expect_gap_alone(1e-3, "Contact stop, never reached")

    def test_a_contact_that_cannot_close_shows_how_far_it_would(self):
        self.expect_gap_alone(-1e-3, "Contact stop, which cannot close here")

    def expect_gap_alone(self, distance, title):
        with tempfile.TemporaryDirectory() as folder:
            writer = Writer(Path(folder))
            writer.analysis("run", "transient", [])
            writer.scale("time", np.arange(5.0), "s")
            for quantity, unit, value in (("normal_force", "N", 0.0), ("gap", "m", distance)):
                writer.field(f"contact/stop/{quantity}", np.full(5, value), unit, ["time"])
            writer.file.close()
            with Results(Path(folder)) as results:
                figure = transient.contact_history(results.analysis("run"), "stop")
        self.assertEqual([axes.get_ylabel() for axes in figure.axes], ["Gap (mm)"])
        self.assertEqual(figure.axes[0].get_title(), title)
        self.assertIsNone(figure.axes[0].get_legend())

    def test_a_case_with_fewer_impacts_than_another_has_as_many_stems(self):
        times = np.array([[0.1, 0.2, 0.3], [0.1, np.nan, np.nan]])
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("error")
            writer = Writer(Path(folder))
            writer.analysis("grid", "transient", [("Variables.gap", np.arange(2.0), "m")], ["Variables/gap"])
            for name, unit, factor in (("peak_time", "s", 1), ("peak_force", "N", 10)):
                writer.field(f"contact/stop/impact/{name}", factor * times, unit, ["impact"])
            writer.file.close()
            axes = plt.figure().subplots()
            with Results(Path(folder)) as results:
                grid = results.analysis("grid")
                transient.draw_peaks(axes, grid, transient.impact_peaks(grid, "stop"), Scale(1.0, "s"), Scale(1.0, "N"))
        self.assertEqual([len(stems.get_segments()) for stems in axes.collections], [3, 1])

    def test_a_contact_without_any_impact_has_no_figure_of_the_first_one(self):
        for impacts in (0, 1):
            with tempfile.TemporaryDirectory() as folder:
                writer = Writer(Path(folder))
                writer.analysis("grid", "transient", [("Variables.gap", np.arange(3.0), "m")], ["Variables/gap"])
                for name, unit in (("peak_force", "N"), ("duration", "s"), ("restitution_coefficient", "1")):
                    writer.field(f"contact/stop/impact/{name}", np.ones((3, impacts)), unit, ["impact"])
                writer.file.close()
                with Results(Path(folder)) as results:
                    found = transient.swept_key(results.analysis("grid"), "stop")
            self.assertEqual(found, 0 if impacts else None)

    def test_a_contact_has_one_colour_and_points_have_others(self):
        with tempfile.TemporaryDirectory() as folder:
            write_all(Path(folder))
            with Results(Path(folder)) as results:
                known = dict(figures(results, results.analysis("orbits")))
                force, motion = (known[f"orbits-history-{name}-1"]().axes[0]
                                 for name in ("contacts", "motion"))
        self.assertEqual(to_rgb(force.get_lines()[0].get_color()),
                         tuple(force.patches[0].get_facecolor()[:3]))
        self.assertEqual(tuple(motion.patches[0].get_facecolor()[:3]),
                         to_rgb(force.get_lines()[0].get_color()))
        self.assertNotIn(to_rgb(force.get_lines()[0].get_color()),
                         [to_rgb(line.get_color()) for line in motion.get_lines()])


class LogarithmicAxes(unittest.TestCase):
    def test_a_narrow_axis_has_more_than_one_label(self):
        self.addCleanup(plt.close, "all")
        for ends, wanted in (((0.17, 1.7), ["0.2", "0.5"]), ((0.17, 17), []), ((0.6, 6), ["2", "5"]),
                             ((6e-5, 6e-4), ["2\\cdot10^{-4}", "5\\cdot10^{-4}"])):
            axes = plt.figure().subplots()
            axes.set(yscale="log", ylim=ends)
            style.label_between_decades(axes.yaxis)
            axes.figure.canvas.draw()
            found = [tick.label1.get_text().strip("$") for tick in axes.yaxis.get_minor_ticks()
                     if ends[0] <= tick.get_loc() <= ends[1]]
            self.assertEqual([text for text in found if text], wanted, ends)
            powers = [tick.label1.get_text().strip("$") for tick in axes.yaxis.get_major_ticks()
                      if ends[0] <= tick.get_loc() <= ends[1]]
            self.assertEqual(powers, {0.17: ["1"], 0.6: ["1"], 6e-5: ["10^{-4}"]}[ends[0]] if wanted
                             else ["10^{0}", "10^{1}"], ends)


class Stresses(unittest.TestCase):
    def test_the_yield_stress_is_a_line_across_the_stresses(self):
        self.addCleanup(plt.close, "all")
        stress = "point/beam.root/von_mises_stress/maximum"
        with tempfile.TemporaryDirectory() as folder:
            writer = Writer(Path(folder))
            for body in ("beam", "other"):
                writer.file.create_dataset(f"body/{body}/yield_stress", data=240e6)
            writer.analysis("grid", "steady state", [("Variables.gap", np.arange(3.0), "m")], ["Variables/gap"])
            writer.field(stress, np.array([1e8, 2e8, 3e8]), "Pa")
            writer.field("point/beam.root/displacement_x/maximum", np.ones(3), "m")
            writer.file.close()
            with Results(Path(folder)) as results:
                known = dict(figures(results, results.analysis("grid")))
                drawn = {name: [[line.get_ydata()[0] for line in axes.get_lines() if line.get_linestyle() == ":"]
                                for axes in draw().axes] for name, draw in known.items()}
        lines = {name: marked for name, marked in drawn.items() if any(marked)}
        self.assertEqual(list(lines.values()), [[[240]]], drawn)


if __name__ == "__main__":
    unittest.main()
