"""Figures of friction: check_friction_figures.py PROGRAM"""

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
from vibroimpact.plots import friction  # noqa: E402
from vibroimpact.plots.figure_list import figures  # noqa: E402
from vibroimpact.plots.results import Results  # noqa: E402

TIME = np.arange(0, 2.0005, 0.01)
TURN, HOLD, BACK = 0.513, 0.213, 1.2512  # between two samples


def slip_rate(time):
    """Slips forward until TURN, sticks for HOLD, slips back, turns at once at BACK."""
    back = np.clip(time - TURN - HOLD, 0, None)
    return np.where(time < TURN, TURN - time, np.where(time > BACK, (BACK - TURN - HOLD) * (time - BACK), -back * (BACK - time)))


def force(time):
    """Limited by 2; in stick it falls from 1 to -1."""
    stick = (time >= TURN) & (time <= TURN + HOLD)
    return np.where(stick, 1 - 2 * (time - TURN) / HOLD, -2 * np.sign(slip_rate(time)))


def write(folder, gap=0.0):
    writer = Writer(folder)
    writer.analysis("rub", "transient", [])
    writer.group.create_group("recorded/history")
    writer.scale("recorded/history/history_time", TIME, "s")
    for name, values, unit in [("slip_rate", slip_rate(TIME), "m/s"), ("friction_force", force(TIME), "N"),
                               ("slip", np.cumsum(slip_rate(TIME)) * 0.01, "m"), ("gap", gap + 0 * TIME, "m"),
                               ("normal_force", 4 + 0 * TIME, "N")]:
        writer.field(f"recorded/history/contact/floor/{name}", values, unit, ["recorded/history/history_time"])
        writer.group[f"recorded/history/contact/floor/{name}"].dims[0].label = "history_time"
    writer.file.close()


class Changes(unittest.TestCase):
    def test_instants_lie_between_the_samples(self):
        _, when = friction.changes(TIME, slip_rate(TIME))
        np.testing.assert_allclose(when, [TURN, TURN + HOLD, BACK], atol=2e-4)

    def test_a_force_that_jumps_has_both_values_at_that_instant(self):
        time, drawn, _ = friction.with_jumps(TIME, force(TIME), slip_rate(TIME), TIME)
        np.testing.assert_allclose(drawn[np.abs(time - TURN) < 1e-9], [-2, 1], atol=1e-9)
        np.testing.assert_allclose(drawn[np.abs(time - BACK) < 1e-4], [2, -2], atol=1e-9)

    def test_a_force_that_does_not_jump_is_left_alone(self):
        time, _ = friction.with_jumps(TIME, np.cos(3 * TIME), slip_rate(TIME))
        np.testing.assert_array_equal(time, TIME)

    def test_rounding_of_the_rate_is_stick(self):
        rate = np.array([1.0, 1e-17, -1e-17, 0, -1, 0, 2])
        np.testing.assert_array_equal(friction.states(rate), [1, 0, 0, 0, -1, 1, 1])


class Figures(unittest.TestCase):
    def setUp(self):
        self.addCleanup(plt.close, "all")
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def known(self, **how):
        write(self.folder, **how)
        results = self.enterContext(Results(self.folder))
        return dict(figures(results, results.analysis("rub")))

    def test_stick_is_shaded(self):
        figure = self.known()["rub-history-contacts"]()
        self.assertEqual([axes.get_ylabel().split(" (")[0] for axes in figure.axes], ["Friction force", "Slip", "Slip rate"])
        spans = [patch.get_xy() for patch in figure.axes[0].patches]
        self.assertEqual(len(spans), 1)
        self.assertAlmostEqual(spans[0][:, 0].min(), TURN, delta=2e-4)
        self.assertAlmostEqual(spans[0][:, 0].max(), TURN + HOLD, delta=2e-4)
        self.assertEqual([text.get_text() for text in figure.axes[0].get_legend().get_texts()], ["floor", "sticks, floor"])

    def test_a_contact_that_can_part_has_its_gap_and_is_shaded_too(self):
        figure = self.known(gap=-1e-4)["rub-history-contacts"]()
        self.assertEqual(len(figure.axes), 5)

    def test_loops_are_run_through_clockwise(self):
        figure = self.known()["rub-friction-loop-floor"]()
        slip, drawn = figure.axes[0].get_lines()[0].get_data()
        known = np.isfinite(slip)
        self.assertGreater(np.sum(drawn[known][:-1] * np.diff(slip[known])), 0)

    def test_classes_share_out_the_time_in_contact(self):
        figure = self.known(gap=-1e-4)["rub-friction-classes-floor"]()
        counts = figure.axes[0].collections[0].get_array()
        self.assertAlmostEqual(np.nansum(counts.filled(np.nan)), 1)
        edges = figure.axes[0].collections[0].get_coordinates()
        self.assertAlmostEqual(edges[..., 1].max(), 4)  # N

    def test_what_never_moves_along_the_normal_has_no_cycle(self):
        known = self.known()
        self.assertNotIn("rub-cycle-floor", known)
        self.assertNotIn("rub-friction-classes-floor", known)

    def test_sectors_are_bars_around_the_circle(self):
        writer = Writer(self.folder)
        writer.analysis("rub", "steady state", [])
        rates = [0.001, 0.004, 0.0, 0.002]
        writer.scale("friction_sector", np.arange(4) * np.pi / 2, "rad")
        for name, values in [("work_rate", rates), ("work_rate_error", [1e-4, 0, 0, np.nan])]:
            writer.field(f"contact/ring/friction/sector/{name}", np.array(values), "W", ["friction_sector"])
        writer.file.close()
        results = self.enterContext(Results(self.folder))
        axes = dict(figures(results, results.analysis("rub")))["rub-sectors-ring"]().axes[0]
        bars = axes.patches
        np.testing.assert_allclose([bar.get_height() for bar in bars], [1, 4, 0, 2])  # mW
        np.testing.assert_allclose([bar.get_x() + bar.get_width() / 2 for bar in bars], np.arange(4) * np.pi / 2)
        ends = axes.collections[0].get_segments()[0]
        np.testing.assert_allclose(sorted(ends[:, 1]), [0.8, 1.2])


if __name__ == "__main__":
    unittest.main()
