"""Figures of what kind of motion it is: check_regime_plots.py PROGRAM"""

import sys
import types
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path.insert(0, str(PROGRAM.parent))

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from vibroimpact.plots import measures, response_curves  # noqa: E402


class Regimes(unittest.TestCase):
    def rows(self, multiples):
        analysis = types.SimpleNamespace(has=lambda _: True,
                                         read=lambda _: types.SimpleNamespace(values=np.array(multiples)))
        return [path for path, _ in measures.regime_rows(analysis, "")]

    def test_periods_are_shown_where_a_motion_repeats_itself(self):
        self.assertIn("regime/period_multiple", self.rows([0, 2, np.nan]))
        self.assertNotIn("regime/period_multiple", self.rows([0, 0, np.nan]))

    def test_classes_are_points(self):
        self.addCleanup(plt.close, "all")
        _, axes = plt.subplots()
        axes.plot([1, 2], [3, 4], "-")
        response_curves.adapt_axis(axes, "regime/class", 4)
        line = axes.get_lines()[0]
        self.assertEqual((line.get_linestyle(), line.get_marker()), ("None", "o"))


if __name__ == "__main__":
    unittest.main()
