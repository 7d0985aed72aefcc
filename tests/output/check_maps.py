"""Maps of values that are all the same, up to rounding, are drawn; which measures have one: check_maps.py POSTPROCESS"""

import sys
import unittest
import warnings
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))

import matplotlib  # noqa: E402

matplotlib.use("Agg")
import numpy as np  # noqa: E402
from vibroimpact.plots import maps  # noqa: E402
from vibroimpact.plots.labels import scale_for  # noqa: E402
from vibroimpact.plots.measures import Sheet  # noqa: E402

ROUNDING = 4e-15


def drawn(values):
    """The axes of a map over a plane of four by three points."""
    shown = maps.Map(None, ("first", "second"), values, "1", "Value", "A title")
    with mock.patch.multiple(maps, coordinates=lambda _, axis: np.arange({"first": 4, "second": 3}[axis]),
                             axis_scale=lambda *_: mock.Mock(factor=1.0), label_plane=mock.DEFAULT):
        figure = maps.draw_map(shown, [], scale_for("1", values))
    figure.canvas.draw()
    return figure.axes[0]


class ConstantMaps(unittest.TestCase):
    def test_values_that_differ_by_rounding_have_one_colour_and_no_lines(self):
        values = 0.2 + ROUNDING * np.arange(12).reshape(4, 3)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            axes = drawn(values)
        self.assertEqual(len(axes.texts), 0)

    def test_zeros(self):
        drawn(np.zeros((4, 3)))
        self.assertEqual(maps.ends_of(np.zeros(3)), (-1, 1))

    def test_others_have_lines_with_their_values(self):
        axes = drawn(0.2 + np.arange(12.0).reshape(4, 3))
        self.assertGreater(len(axes.texts), 0)

    def test_ends(self):
        self.assertEqual(maps.ends_of(np.array([1.0, 3.0])), (1, 3))
        np.testing.assert_allclose(maps.ends_of(np.array([-2.0, -2.0])), (-2.1, -1.9))


class Sheets(unittest.TestCase):
    def test_a_derived_quantity_has_one_map(self):
        self.assertTrue(maps.suits_a_map(Sheet("displacement-x", "")))
        self.assertFalse(maps.suits_a_map(Sheet("derived-peak", "")))


if __name__ == "__main__":
    unittest.main()
