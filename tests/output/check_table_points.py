"""Points of a table over histories, portraits, spectra and basins: check_table_points.py PROGRAM"""

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
from vibroimpact.plots import table_points  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402

GAP = np.array([1e-3, 2e-3])
START = 60.0
TIME = START + np.linspace(0, 1, 101)
FREQUENCY = np.arange(1, 6.0)
CELLS = np.array([[0, 0, 1], [0, 1, 1.0]])


def of_both(values):
    return np.array([values, 2 * values])


def write(folder):
    writer = Writer(folder)
    writer.analysis("orbits", "steady state", [("Contact.stop.Clearance", GAP, "m")], ["Contact/stop/Clearance"])
    writer.field("history/history_time", np.array([TIME, TIME]), "s", ("sample",))
    for quantity, unit in (("displacement_x", "m"), ("velocity_x", "m/s")):
        writer.field(f"history/point/a.mass/{quantity}", of_both(np.sin(7 * TIME)) * 1e-3, unit, ("sample",))
    writer.field("spectrum/frequency", np.array([FREQUENCY, FREQUENCY]), "Hz", ("line",))
    writer.field("spectrum/order", np.array([FREQUENCY, FREQUENCY]), "1", ("line",))
    writer.field("spectrum/point/a.mass/displacement_x", of_both(1e-3 / FREQUENCY), "m", ("line",))
    writer.analysis("plane", "basins", [("Variables.w", np.array([-0.5, 0.5]), "1")])
    writer.scale("Variables.y", np.array([-1.0, 0.0, 1.0]), "1")
    writer.field("cell/attractor", CELLS, "1", ("Variables.y",))
    writer.file.close()


class Points(unittest.TestCase):
    def setUp(self):
        self.addCleanup(plt.close, "all")
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        write(self.folder)
        self.results = self.enterContext(Results(self.folder))

    def drawn(self, analysis, name, text):
        """The points in each panel of a figure."""
        table = self.folder / "points.csv"
        table.write_text(text)
        figure = dict(figures(self.results, self.results.analysis(analysis)))[name]()
        table_points.draw(figure, name, table_points.read(table))
        return [[line.get_xydata() for line in axes.get_lines() if line.get_label() == "_points"]
                for axes in figure.axes]

    def test_a_history_counts_time_from_its_beginning(self):
        panels = self.drawn("orbits", "orbits-history-motion-1", "time [ms], velocity_x [mm/s]\n60250, 0.5\n")
        self.assertEqual([len(panel) for panel in panels], [0, 1])
        np.testing.assert_allclose(panels[1][0], [[0.25, 500]])  # in s and µm/s

    def test_a_row_belongs_to_the_motion_of_its_gap(self):
        for name, axes in (("orbits-portrait-a.mass-x", "displacement_x [mm], velocity_x [mm/s]"),
                           ("orbits-spectrum-a.mass-displacement-x", "frequency [Hz], displacement_x [mm]")):
            panels = self.drawn("orbits", name, f"{axes}, Clearance [mm]\n3, 0.5, 2\n")
            self.assertEqual([len(panel) for panel in panels], [0, 1], name)
            np.testing.assert_allclose(panels[1][0], [[3, 0.5]])
            panels = self.drawn("orbits", name, f"{axes}\n3, 0.5\n")
            self.assertEqual([len(panel) for panel in panels], [1, 1], name)

    def test_points_lie_in_the_plane_of_basins(self):
        panels = self.drawn("plane", "plane-basins", "y [1], w [1]\n0.5, -0.25\n")
        np.testing.assert_allclose(panels[0][0], [[0.5, -0.25]])

    def test_the_legend_stands_beside_the_panels(self):
        table = self.folder / "points.csv"
        table.write_text("displacement_x [mm], velocity_x [mm/s]\n3, 0.5\n")
        figure = dict(figures(self.results, self.results.analysis("orbits")))["orbits-portrait-a.mass-x"]()
        table_points.draw(figure, "", table_points.read(table))
        self.assertEqual([axes.get_legend() is not None for axes in figure.axes], [False, True])


if __name__ == "__main__":
    unittest.main()
