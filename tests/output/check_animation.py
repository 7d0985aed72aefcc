"""Motions as animated pictures: check_animation.py PLOT FOLDER

FOLDER is the example that write_examples makes, PLOT the command vibroimpact-plot.
"""

import base64
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
PLOT, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
del sys.argv[1:]
sys.path.insert(0, str(PLOT.parent))

import matplotlib  # noqa: E402

matplotlib.use("Agg")
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from vibroimpact.plots import animation, command_line, vtu  # noqa: E402


def run(*arguments):
    return subprocess.run([PLOT, FOLDER, *arguments], capture_output=True, text=True, check=False)


def packed(values, kind):
    data = np.asarray(values).astype(kind).tobytes()
    block = zlib.compress(data)
    header = struct.pack("<4I", 1, len(data), len(data), len(block))
    return base64.b64encode(header).decode() + base64.b64encode(block).decode()


def array(name, values, kind, label, components=1):
    return (f'<DataArray type="{label}" Name="{name}" NumberOfComponents="{components}" '
            f'format="binary">{packed(values, kind)}</DataArray>')


def write_vtu(file, points, cells, displacement, kind=9, **scalars):
    """Quadrilaterals with their corners around them, or cells of another kind."""
    ends = np.cumsum([len(cell) for cell in cells])
    data = array("displacement", displacement, "<f4", "Float32", 3)
    data += "".join(array(name, values, "<f4", "Float32") for name, values in scalars.items())
    file.write_text(
        '<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece>'
        f'<Points>{array("", points, "<f4", "Float32", 3)}</Points><Cells>'
        + array("connectivity", np.concatenate(cells), "<i4", "Int32")
        + array("offsets", ends, "<i4", "Int32") + array("types", [kind] * len(cells), "u1", "UInt8")
        + f"</Cells><PointData>{data}</PointData></Piece></UnstructuredGrid></VTKFile>")


SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


class Command(unittest.TestCase):
    def test_it_draws_the_instants_of_a_motion(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("--animate", "release", "--output", folder, "--rate", "5")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            picture = self.enterContext(Image.open(Path(folder, "release-motion.gif")))
            self.assertEqual((picture.n_frames, picture.info["duration"]), (3, 200))
            frames = []
            for number in range(3):
                picture.seek(number)
                frames.append(np.asarray(picture.convert("RGB")))
            self.assertTrue((frames[0][0, 0] == 255).all())
            self.assertFalse((frames[0] == frames[1]).all())  # it moves

    def test_it_draws_one_instant(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("--animate", "release", "--instant", "2", "--dpi", "100", "--output", folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            picture = self.enterContext(Image.open(Path(folder, "release-2.png")))
            self.assertEqual(picture.size, (500, 360))
            done = run("--animate", "modes", "--instant", "1", "--output", folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertTrue(Path(folder, "modes-1.png").is_file())
        with mock.patch.object(animation, "still") as still:
            command_line.main([str(FOLDER), "--animate", "release", "--instant", "2", "--output", str(FOLDER)])
        self.assertEqual((still.call_args[0][4].arrows, still.call_args[0][4].modes), (True, False))
        done = run("--animate", "release", "--instant", "9")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--instant 9: release has the instants 1 to 3", done.stderr)

    def test_what_is_not_there_is_said(self):
        done = run("--animate", "modes_of_it")
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no motion modes_of_it.pvd; there are: release", done.stderr)
        done = run("--animate", "release", "--field", "colour")
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no field colour; there are: displacement", done.stderr)

    def test_wrong_numbers_are_refused(self):
        for option, value in (("--frames", "0"), ("--rate", "-1"), ("--view", "30")):
            done = run("--animate", "release", f"{option}={value}")
            self.assertEqual(done.returncode, 2, option)
            self.assertIn("wanted", done.stderr)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_points_cells_and_data(self):
        displacement = np.arange(12).reshape(4, 3)
        write_vtu(self.folder / "a.vtu", SQUARE, [[0, 1, 2, 3]], displacement, contact_gap=[1, 2, 3, 4])
        mesh = vtu.read_mesh(self.folder / "a.vtu")
        np.testing.assert_array_equal(mesh.points, SQUARE)
        np.testing.assert_array_equal(mesh.cells, [[0, 1, 2, 3]])
        np.testing.assert_array_equal(mesh.data["contact_gap"], [1, 2, 3, 4])
        np.testing.assert_array_equal(mesh.moved(10), SQUARE + 10 * displacement)

    def test_of_solids_the_surface_is_drawn(self):
        base = np.vstack([SQUARE, SQUARE + [0, 0, 1]])
        points = np.vstack([base, base + [1, 0, 0], base + [2, 0, 0]])  # the third is another body
        write_vtu(self.folder / "a.vtu", points, np.arange(24).reshape(3, 8), 0 * points, 12,
                  body=np.repeat([1, 1, 2], 8))
        faces = vtu.read_mesh(self.folder / "a.vtu").cells
        self.assertEqual([sum(face[0] // 8 == cell for face in faces) for cell in range(3)], [5, 5, 6])
        middles = {tuple(points[face].mean(axis=0)) for face in faces if face[0] < 8}
        self.assertEqual(middles, {(0, .5, .5), (.5, 0, .5), (.5, 1, .5), (.5, .5, 0), (.5, .5, 1)})

    def test_the_parts_of_an_instant_are_together(self):
        (self.folder / "m.pvd").write_text(
            '<VTKFile><Collection><DataSet timestep="0.5" part="0" file="m/frame-00001.vtu"/>'
            '<DataSet timestep="0.5" part="1" file="m/frame-00001-lines.vtu"/>'
            '<DataSet timestep="1" part="0" file="m/frame-00002.vtu"/></Collection></VTKFile>')
        (first, files), (second, _) = vtu.instants(self.folder / "m.pvd")
        self.assertEqual((first, second), (0.5, 1))
        self.assertEqual([animation.part_of(file) for file in files], ["frame", "frame lines"])


def mesh(displacement, **data):
    return vtu.Mesh(SQUARE.astype(float), [np.arange(4)],
                    {"displacement": np.array(displacement, float), **data})


class Motion(unittest.TestCase):
    def test_the_usual_factor_shows_a_tenth_of_the_size(self):
        motion = [animation.Instant(0, {"frame": mesh(np.zeros((4, 3)))}),
                  animation.Instant(1, {"frame": mesh([[0, 0, 3e-3], [0, 4e-3, 3e-3], [0] * 3, [0] * 3])})]
        self.assertAlmostEqual(animation.usual_factor(motion) * 5e-3, 0.1 * np.sqrt(2))
        self.assertEqual(animation.usual_factor(motion[:1]), 1)

    def test_stress_colours_a_motion_that_has_it(self):
        still = np.zeros((4, 3))
        plain, stressed = mesh(still), mesh(still, von_mises_stress=np.full(4, 2e6))
        self.assertEqual(animation.usual_field([animation.Instant(0, {"frame": plain})]), "displacement")
        self.assertEqual(animation.usual_field([animation.Instant(0, {"frame": plain, "frame lines": stressed})]),
                         "von_mises_stress")
        self.assertTrue(np.isnan(animation.magnitudes(plain, "von_mises_stress")).all())

    def test_beams_with_sides_are_not_drawn_as_lines_too(self):
        line = vtu.Mesh(SQUARE[:2].astype(float), [np.arange(2)], {"displacement": np.zeros((2, 3))})
        def drawn(**sides):
            instant = animation.Instant(0, {"frame": line, **sides})
            picture = animation.Picture([instant], "displacement", 1.0, animation.Style())
            picture.draw(instant)
            return [type(artist).__name__ for artist in picture.axes.collections]
        self.assertEqual(drawn(), ["Line3DCollection"])
        self.assertEqual(drawn(sections=mesh(np.zeros((4, 3)))), ["Poly3DCollection"])

    def test_stops_on_which_a_force_acts_are_red(self):
        still = np.zeros((4, 3))
        def drawn(state):
            parts = {"frame": mesh(still), "stops": mesh(still, contact_state=np.full(4, state))}
            instant = animation.Instant(0, parts)
            picture = animation.Picture([instant], "displacement", 1.0, animation.Style())
            picture.draw(instant)
            return matplotlib.colors.to_hex(picture.axes.collections[-1].get_facecolor()[0]).upper()
        self.assertEqual(drawn(2.0), animation.CONTACT)
        self.assertEqual(drawn(1.0), animation.STOP)

    def test_a_mode_has_a_frequency_and_no_unit(self):
        shape = mesh([[0, 0, 0.2], [0, 0, 0.4], [0] * 3, [0] * 3])
        picture = animation.Picture([animation.Instant(12.5, {"frame": shape})], "displacement", 1.0,
                                    animation.Style(modes=True))
        picture.draw(animation.Instant(12.5, {"frame": shape}))
        self.assertEqual(picture.figure.texts[0].get_text(), "Mode at 12.5 Hz")
        self.assertEqual(picture.colours.get_clim(), (0, 1))

    def test_more_points_with_a_force_than_can_be_told_apart_are_not_marked(self):
        body = mesh(np.zeros((4, 3)), contact_force=np.ones((4, 3)))
        instant = animation.Instant(0, {"frame": body})
        for most, marks in ((4, 1), (3, 0)):
            with mock.patch.object(animation, "MOST_MARKED", most):
                picture = animation.Picture([instant], "contact_force", 1.0, animation.Style())
                picture.draw(instant)
            drawn = [type(artist).__name__ for artist in picture.axes.collections]
            self.assertEqual(drawn.count("Path3DCollection"), marks)

    def test_the_largest_force_of_the_instant_has_the_longest_arrow(self):
        body = mesh(np.zeros((4, 3)))
        body.data["contact_force"] = np.array([[0, 0, 4.0], [0, 0, -2.0], [0] * 3, [0] * 3])
        instant = animation.Instant(0, {"frame": body})
        picture = animation.Picture([instant], "displacement", 1.0, animation.Style(arrows=True))
        with mock.patch.object(picture.axes, "quiver") as quiver:
            picture.draw(instant)
        lengths = np.array(quiver.call_args[0][3:])
        np.testing.assert_allclose(lengths[2] / picture.extent, [animation.ARROW, -animation.ARROW / 2])


if __name__ == "__main__":
    unittest.main()
