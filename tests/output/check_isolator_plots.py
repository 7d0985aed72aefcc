"""Figures of isolator designs show the sets, the limits with what lies between them, and each kind of stop:
check_isolator_plots.py PROGRAM
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

NAN = np.nan
# The chosen stop, a corner, an example of each region, one of the file.
KIND = np.array([1.0, 2, 5, 6, 7, 8, 9])
SCALARS = {"damping_ratio": 0.01, "working_ratio": 3.0, "transmissibility": 0.125,
           "largest_force": 8.0, "present/force": 0.5}
CORNERS = {"resonance_and_jump": 0.5, "linear_and_resonance": 0.8, "linear_and_jump": 0.2}
ROWS = np.arange(7.0)


def write(folder, exact, possible):
    writer = Writer(folder)
    writer.analysis("design", "isolator design", [])
    for name, value in SCALARS.items():
        writer.field(name, np.array(value), "1")
    for name, value in CORNERS.items():
        writer.field(f"corner/{name}/alpha_1", np.array(value if possible else NAN), "1")
    first = np.linspace(0, 1, 3)
    for name, values in (("alpha_1", first), ("b2", first**2), ("b3_plus", first**2 - 0.1),
                         ("b3_minus", first**2 - 0.3), ("largest_force", -2 * first**2)):
        writer.field(f"set/{name}", values, "1", ["set_point"])
    for name, values in (("z", first), ("alpha_1", first), ("alpha_2", first - 1)):
        writer.field(f"hysteresis/{name}", values, "1", ["hysteresis_point"])
    force = np.array([1.0, 2, 4, 8])
    for name, values in (("force", force), ("least_stiffness", 4 / force),
                         ("largest_stiffness", force if possible else 0 * force),
                         ("first_jump_stiffness", 1.1 * force),
                         ("least_stiffness_alpha_1", force / 10),
                         ("least_stiffness_alpha_2", -force / 8)):
        writer.field(f"limit/{name}", values, "1", ["limit_point"])
    for name, values in (("kind", KIND), ("alpha_1", ROWS / 10), ("alpha_2", -ROWS / 10),
                         ("force", 1 + ROWS), ("stiffness", 2 + ROWS)):
        writer.field(f"stop/{name}", values[0 if possible else 1:], "1", ["design"])
    write_curves(writer, exact, possible)
    writer.file.close()


def write_curves(writer, exact, possible):
    ratio = 1 + np.array([0, 0.2, 0.1]) + ROWS[0 if possible else 1:, None]
    for group, dimension in (("averaged", "averaged_point"), ("expansion", "expansion_point")):
        writer.field(f"stop/{group}/frequency_ratio", ratio, "1", ["design", dimension])
    writer.field("stop/averaged/amplitude", 2 * ratio, "1", ["design", "averaged_point"])
    writer.field("stop/expansion/z", 1 / (4 * ratio), "1", ["design", "expansion_point"])
    if exact:
        for name, values in (("frequency_ratio", ratio), ("amplitude", 3 * ratio),
                             ("stable", np.broadcast_to([1.0, 0, 1], ratio.shape))):
            writer.field(f"stop/exact/{name}", values, "1", ["design", "exact_point"])


class IsolatorFigures(unittest.TestCase):
    def draw(self, exact=True, possible=True):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(folder, exact, possible)
        results = self.enterContext(Results(folder))
        self.enterContext(plt.rc_context(style.SETTINGS))
        self.addCleanup(plt.close, "all")
        return {name: draw() for analysis in results.analyses()
                for name, draw in figures(results, analysis)}

    def test_names(self):
        self.assertEqual(set(self.draw()), {"design-transmissibility", "design-sets",
                                            "design-region", "design-plane", "design-responses"})

    def test_the_plane_shades_where_the_limits_leave_something(self):
        axes = self.draw()["design-plane"].axes[0]
        corners = axes.collections[0].get_paths()[0].vertices
        self.assertEqual((corners[:, 0].min(), corners[:, 0].max()), (2, 8))
        star = next(line for line in axes.get_lines() if line.get_marker() == "*")
        np.testing.assert_allclose(star.get_xydata(), [[1, 2]])
        square = next(line for line in axes.get_lines() if line.get_marker() == "s")
        np.testing.assert_allclose(square.get_xydata(), [[7, 8]])

    def test_the_region_is_bounded_by_its_three_limits(self):
        axes = self.draw()["design-region"].axes[0]
        corners = axes.patches[0].get_xy()
        self.assertGreaterEqual(corners[:, 0].min(), 0.2)
        self.assertLessEqual(corners[:, 0].max(), 0.8)
        on_parabola = np.isclose(corners[:, 1], -2 * corners[:, 0] ** 2)
        self.assertGreater(on_parabola.sum(), 50)

    def test_without_possible_stops_nothing_is_shaded_and_none_chosen(self):
        drawn = self.draw(possible=False)
        self.assertEqual(len(drawn["design-region"].axes[0].patches), 0)
        markers = [line.get_marker() for line in drawn["design-plane"].axes[0].get_lines()]
        self.assertNotIn("*", markers)

    def test_the_sets_name_the_regions(self):
        axes = self.draw()["design-sets"].axes[0]
        self.assertEqual([text.get_text() for text in axes.texts], ["I", "II", "III", "IV"])
        np.testing.assert_allclose([text.xy[0] for text in axes.texts], [0.2, 0.3, 0.4, 0.5])

    def test_responses_show_all_three_curves_of_each_region(self):
        for exact in (True, False):
            figure = self.draw(exact)["design-responses"]
            self.assertEqual(len(figure.axes), 4)
            lines = figure.axes[1].get_lines()  # of region II, the fourth stop
            averaged, expansion = lines[-2], lines[-1]
            ratio = 4 + np.array([0, 0.2, 0.1])
            np.testing.assert_allclose(averaged.get_xydata().T, [ratio, 2 * ratio])
            np.testing.assert_allclose(expansion.get_xydata().T, [ratio, 4 * ratio])
            self.assertEqual(len(lines), 4 if exact else 2)
            if exact:
                np.testing.assert_allclose(lines[0].get_ydata(), [3 * ratio[0], NAN, 3 * ratio[2]])
                np.testing.assert_allclose(lines[1].get_ydata(), [NAN, 3 * ratio[1], NAN])


if __name__ == "__main__":
    unittest.main()
