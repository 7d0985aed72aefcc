#!/usr/bin/python3
"""The stress of all elements over time: a cantilever that swings in a mode, in closed form.

usage: check_stress_over_time.py PROGRAM MPIEXEC
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from vtu_arrays import vtu_arrays  # noqa: E402

PROGRAM, MPIEXEC = sys.argv[1], sys.argv[2]

LENGTH, THICKNESS, WIDTH, YOUNG, DENSITY, TIP = 0.4, 0.004, 0.02, 70e9, 2700.0, 1e-3
ROOT = 1.8751040687119611
BENDING = YOUNG * WIDTH * THICKNESS**3 / 12
PERIOD = 2 * np.pi / (ROOT**2 * np.sqrt(BENDING / (DENSITY * WIDTH * THICKNESS)) / LENGTH**2)
#: The curvature at the root is ROOT^2 / LENGTH^2 times the displacement of the tip.
STRESS = YOUNG * THICKNESS / 2 * (ROOT / LENGTH)**2 * TIP

BEAM = f"""
  subsection Geometry
    set Line = 0 m, 0 m, 0 m -> {LENGTH} m, 0 m, 0 m
    set Elements = 40
    set Orientation = 0, 1, 0
  end
  subsection Section
    set Width = {WIDTH} m
    set Thickness = {THICKNESS} m
  end
  subsection Support plane
    set At = all
    set Fix = x, y, rx, rz
  end
"""
PLATE = f"""
  set Type = shell
  subsection Geometry
    set Plate = 0 m, 0 m, 0 m -> {LENGTH} m, 0 m, 0 m -> 0 m, {WIDTH} m, 0 m
    set Divisions = 40, 2
  end
  subsection Shell plate
    set Thickness = {THICKNESS} m
  end
"""
REST = f"""
  subsection Material
    set Young modulus = {YOUNG} Pa
    set Poisson ratio = 0
    set Density = {DENSITY} kg/m^3
  end
  subsection Support root
    set At = ROOTPLACE
    set Fix = all
  end
  subsection Point tip
    set Near = {LENGTH} m, {WIDTH / 2} m, 0 m
  end
  subsection Modes
    set Number = 3
  end
end
subsection Initial condition swing
  set At = beam.tip
  set Direction = z
  set Shape = mode
  set Displacement = {TIP} m
end
subsection Analysis swing
  set Type = transient
  subsection Transient
    set Duration = {0.8 * PERIOD} s
    set Stress instants = 161
    set Frames = FRAMES
    set First frame = {0.2 * PERIOD} s
  end
end
"""


class Stress(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def run_text(self, body, place, frames=0, ranks=1, code=0, change=("", "")):
        text = "subsection Body beam" + body + REST.replace("ROOTPLACE", place).replace("FRAMES", str(frames))
        (self.folder / "swing.prm").write_text(text.replace(*change))
        command = [PROGRAM, "swing.prm", "--output", "out", "--overwrite"]
        if ranks > 1:
            command = [MPIEXEC, "-n", str(ranks)] + command
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return self.folder / "out", done.stdout + done.stderr

    def largest(self, out):
        with h5py.File(out / "results.h5") as file:
            group = file["analysis/swing/body/beam/von_mises_stress"]
            return {name: float(group[name][()]) for name in group}

    def test_the_root_of_a_beam_bends_most_half_a_period_later(self):
        out, _ = self.run_text(BEAM, "start")
        found = self.largest(out)
        # The stress of an element is linear; at its end it is off by (ROOT / 40)^2 / 12 and less.
        self.assertAlmostEqual(found["maximum"] / STRESS, 1, delta=(ROOT / 40)**2)
        # The window begins a fifth of a period after the largest displacement; its instants contain the next one.
        self.assertAlmostEqual(found["time"], 0.5 * PERIOD, delta=1e-4 * PERIOD)
        self.assertEqual((found["x"], found["y"], found["z"]), (0, 0, 0))
        summary = (out / "summary.txt").read_text()
        self.assertIn("body.beam.von_mises_stress.maximum", summary)
        self.assertFalse((out / "swing.pvd").exists())

    def test_a_stress_beyond_the_yield_stress_is_reported(self):
        for factor, beyond in ((0.8, True), (1.25, False)):
            material = "    set Poisson ratio = 0\n"
            given = material + f"    set Yield stress = {factor * STRESS} Pa\n"
            out, printed = self.run_text(BEAM, "start", change=(material, given))
            self.assertEqual(" times the Yield stress" in printed, beyond, printed)
            name, _, value = next(line for line in (out / "summary.txt").read_text().splitlines()
                                  if "yield_ratio" in line).partition(" = ")
            self.assertEqual(name, "analysis.swing.body.beam.yield_ratio")
            self.assertAlmostEqual(float(value.split()[0]) * factor, 1, delta=(ROOT / 40)**2)
            with h5py.File(out / "results.h5") as file:
                self.assertAlmostEqual(file["body/beam/yield_stress"][()] / (factor * STRESS), 1, delta=1e-12)

    def test_the_envelope_is_the_shape_of_the_curvature(self):
        out, _ = self.run_text(BEAM, "start")
        found = self.largest(out)
        for name in ("envelope", "maximum"):
            arrays = vtu_arrays(out / f"swing/stress-{name}.vtu")
            x = ROOT * arrays["Points"][:, 0] / LENGTH
            ratio = (np.sinh(ROOT) - np.sin(ROOT)) / (np.cosh(ROOT) + np.cos(ROOT))
            curvature = (np.cosh(x) + np.cos(x) - ratio * (np.sinh(x) + np.sin(x))) / 2
            np.testing.assert_allclose(arrays["von_mises_stress"] / STRESS, np.abs(curvature), atol=2e-3)
            self.assertAlmostEqual(arrays["von_mises_stress"].max() / found["maximum"], 1, delta=1e-6)
        np.testing.assert_array_equal(
            vtu_arrays(out / "swing/stress-envelope.vtu")["displacement"], 0)
        tip = vtu_arrays(out / "swing/stress-maximum.vtu")["displacement"][:, 2]
        self.assertAlmostEqual(tip.min(), -TIP, delta=1e-3 * TIP)

    def test_both_faces_of_a_shell(self):
        out, _ = self.run_text(PLATE, "left")
        found = self.largest(out)
        # The middle of the first element: half of a 40th from the root.
        expected = 1 - ROOT * 0.7340955 / 80
        self.assertAlmostEqual(found["maximum"] / STRESS, expected, delta=0.01)
        self.assertAlmostEqual(found["x"], LENGTH / 80, delta=1e-9)
        arrays = vtu_arrays(out / "swing/stress-envelope.vtu")
        first, second = (arrays[f"von_mises_stress_{face}_face"] for face in ("first", "second"))
        np.testing.assert_allclose(first, second, rtol=1e-5)
        np.testing.assert_allclose(arrays["von_mises_stress"], np.maximum(first, second), rtol=1e-6)

    def test_any_number_of_ranks_and_pictures_besides(self):
        expected = self.largest(self.run_text(BEAM, "start")[0])
        for ranks in (2, 3):
            out, _ = self.run_text(BEAM, "start", frames=4, ranks=ranks)
            self.assertTrue((out / "swing.pvd").exists())
            self.assertTrue((out / "swing/frame-00004.vtu").exists())
            for name, value in self.largest(out).items():
                self.assertAlmostEqual(value, expected[name], delta=1e-9 * abs(expected[name]) + 1e-15)

    def test_without_known_stress_it_is_refused(self):
        unknown = ("set Width", "set Shape = given\n set Area = 8e-5 m^2\n set Second moment y = 1e-9 m^4\n"
                   " set Second moment z = 1e-9 m^4\n set Torsion constant = 1e-9 m^4\n # set Width")
        body = BEAM.replace(*unknown).replace("    set Thickness", "    # set Thickness")
        _, said = self.run_text(body, "start", code=1)
        self.assertIn("Stress instants", said)
        self.assertIn("must be 0", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
