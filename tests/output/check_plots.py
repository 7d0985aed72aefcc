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
sys.path.insert(0, str(PROGRAM.parent))

from vibroimpact_plots import cases, labels, style  # noqa: E402
from vibroimpact_plots.figure_list import FIGURES  # noqa: E402
from vibroimpact_plots.labelled import open_analysis  # noqa: E402
from vibroimpact_plots.results import Results  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402  (after style has chosen the backend)

FIGURE_NAMES = {
    "modes-left", "modes-right", "release-contact-heads", "release-first-impact-heads",
    "release-motion-left.head", "release-phase-left.head-x", "release-motion-right.head",
    "release-phase-right.head-x", "response-displacement-x", "response-acceleration-x",
    "response-contact-heads", "map-displacement-x-left.head", "map-displacement-x-right.head",
    "map-acceleration-x-left.head", "map-acceleration-x-right.head", "map-contact-heads",
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


class Program(unittest.TestCase):
    def test_draws_every_figure(self):
        run = plot(FOLDER)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        files = {path.stem: path for path in (FOLDER / "figures").glob("*.png")}
        self.assertEqual(set(files), FIGURE_NAMES)
        for path in files.values():
            self.assertGreater(path.stat().st_size, 10000, path)
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
    def check_all(self):
        with Results(FOLDER) as results, plt.rc_context(style.SETTINGS):
            for analysis in results.analyses():
                for name, figure in FIGURES[analysis.type](results, analysis):
                    with self.subTest(name):
                        self.check(figure)
                    plt.close(figure)

    def check(self, figure):
        found = boxes(figure)
        self.assertGreater(len(found), 8)
        for text, box in found:
            inside = box.x0 >= 0 and box.y0 >= 0 and (
                box.x1 <= figure.bbox.x1 and box.y1 <= figure.bbox.y1)
            self.assertTrue(inside, f"{text!r} leaves the figure")
        for (one, a), (other, b) in itertools.combinations(found, 2):
            self.assertFalse(a.overlaps(b), f"{one!r} overlaps {other!r}")

    def test_no_text_overlaps_or_is_cut(self):
        self.check_all()

    def test_large_families_get_a_colour_bar(self):
        self.addCleanup(setattr, cases, "LARGEST_LEGEND", cases.LARGEST_LEGEND)
        cases.LARGEST_LEGEND = 2
        self.check_all()


class Labels(unittest.TestCase):
    def test_prefix_suits_the_values(self):
        for unit, value, factor, text in [
            ("m", 0.012, 1e-3, "mm"), ("m", 2.0, 1.0, "m"), ("N", 4500, 1e3, "kN"),
            ("m", 3e-6, 1e-6, "µm"), ("Hz", 3e-3, 1.0, "Hz"), ("1", 1e-9, 1.0, ""),
            ("m/s^2", 4e3, 1.0, "m/s²"), ("N", 0.0, 1.0, "N"),
        ]:
            scale = labels.scale_for(unit, [value, float("nan")])
            self.assertEqual((scale.factor, scale.unit), (factor, text))

    def test_words(self):
        self.assertEqual(labels.quantity_label("displacement_x"), "Displacement $x$")
        self.assertEqual(labels.value_text(0.003, "m"), "3 mm")


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
