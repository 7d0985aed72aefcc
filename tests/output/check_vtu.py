"""What ParaView sees of a result folder: check_vtu.py FOLDER

The bodies of the example are clamped-free beams of 0.3 m along z with the bending shapes of the closed
form, 4 at the end, and a lumped mass; in frame 1 the first coordinate of each is 1 mm, and the base
stands at y = 0.5 m.
"""

import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from vtu_arrays import vtu_arrays  # noqa: E402

FOLDER = pathlib.Path(sys.argv.pop(1))
LENGTH = 0.3
ELEMENTS = 12
ROOTS = (1.8751040687, 4.6940911330, 7.8547574382)


def shape(root, s):
    """Bending shape of a clamped-free beam, 1 at the end, and its slope, at s in 0..1."""
    ratio = (np.cosh(root) + np.cos(root)) / (np.sinh(root) + np.sin(root))
    def value(x):
        return np.cosh(x) - np.cos(x) - ratio * (np.sinh(x) - np.sin(x))
    x = root * s
    slope = np.sinh(x) + np.sin(x) - ratio * (np.cosh(x) - np.cos(x))
    return value(x) / value(root), root * slope / value(root)


def tolerance(root, height):
    """Between nodes the cubic is off by (beta h)^4 / 384, and a value is single precision."""
    return height * ((root / ELEMENTS) ** 4 / 384 + 1e-6)


class Vtu(unittest.TestCase):
    def test_a_motion_moves_beams_and_base(self):
        arrays = vtu_arrays(FOLDER / "release" / "frame-00002.vtu")
        z = arrays["Points"][:, 2]
        self.assertEqual((z.min(), z.max()), (0, np.float32(LENGTH)))
        value, slope = shape(ROOTS[0], z / LENGTH)
        moved = arrays["displacement"]
        np.testing.assert_allclose(moved[:, 0], 4e-3 * value, atol=tolerance(ROOTS[0], 4e-3))
        np.testing.assert_array_equal(moved[:, 1], 0.5)
        np.testing.assert_array_equal(moved[:, 2], 0)
        turned = arrays["rotation"]
        np.testing.assert_allclose(turned[:, 1], 4e-3 * slope / LENGTH, atol=1e-5)
        np.testing.assert_array_equal(turned[:, [0, 2]], 0)

    def test_bodies_have_their_places_and_numbers(self):
        arrays = vtu_arrays(FOLDER / "release" / "frame-00001.vtu")
        right = arrays["Points"][:, 0] > 0.01
        np.testing.assert_allclose(arrays["Points"][:, 0], np.where(right, 0.02, 0), rtol=1e-6)
        np.testing.assert_array_equal(arrays["body"], np.where(right, 2, 1))
        self.assertEqual(right.sum() * 2, right.size)
        np.testing.assert_array_equal(arrays["displacement"], 0)

    def test_lumped_masses_are_points(self):
        arrays = vtu_arrays(FOLDER / "release" / "lumped-00003.vtu")
        np.testing.assert_allclose(arrays["Points"], [[0.05, 0, 0.1]], rtol=1e-6)
        np.testing.assert_allclose(arrays["displacement"], [[2e-3, 1, 0]], rtol=1e-6)
        np.testing.assert_array_equal(arrays["body"], 3)

    def test_modes_are_a_tenth_of_the_body_high(self):
        for number, root in enumerate(ROOTS, 1):
            arrays = vtu_arrays(FOLDER / "modes" / f"left-mode-{number:03d}.vtu")
            value, _ = shape(root, arrays["Points"][:, 2] / LENGTH)
            height = 0.1 * LENGTH
            np.testing.assert_allclose(arrays["displacement"][:, 0], height * value,
                                       atol=tolerance(root, height))


if __name__ == "__main__":
    unittest.main()
