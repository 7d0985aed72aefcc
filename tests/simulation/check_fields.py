"""Fields of a motion in the files for ParaView against relations between them: check_fields.py PROGRAM SOURCE

A cantilever on a shaken base is bent, released and strikes a stop that is fixed in space.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

PROGRAM, SOURCE = (pathlib.Path(value).resolve() for value in sys.argv[1:3])
del sys.argv[1:]
sys.path.insert(0, str(SOURCE / "tests" / "support"))
from vtu_arrays import vtu_arrays  # noqa: E402

LENGTH, THICKNESS, YOUNG = 0.5, 2e-3, 210e9
BENT, CLEARANCE = 8e-3, 5e-3
FRAMES, FIRST, LAST = 201, 0.08, 0.1
MODEL = f"""
subsection Body beam
  subsection Geometry
    set Line = 0 m, 0 m, 0 m -> 0 m, 0 m, {LENGTH} m
  end
  subsection Section
    set Width     = 20 mm
    set Thickness = {THICKNESS} m
  end
  subsection Material
    set Young modulus = {YOUNG} Pa
    set Poisson ratio = 0.3
    set Density       = 7850 kg/m^3
  end
  subsection Support foot
    set At  = start
    set Fix = all
  end
  subsection Support plane
    set At  = all
    set Fix = y, rx, rz
  end
  subsection Point tip
    set At   = end
    set Mass = 50 g
  end
  subsection Modes
    set Number        = 12
    set Damping ratio = 0.02
  end
end
subsection Contact stop
  set Between   = beam.tip, stop
  set Direction = -x
  set Clearance = {CLEARANCE} m
  set Law       = kelvin-voigt
  subsection Kelvin-Voigt
    set Stiffness        = 50 kN/m
    set Damping constant = 5 N s/m
  end
end
subsection Excitation ground
  set Type      = base displacement
  set Direction = x
  set Amplitude = 0.5 mm
  set Frequency = 10 Hz
end
subsection Initial condition pulled
  set At           = beam.tip
  set Direction    = x
  set Shape        = static
  set Displacement = {BENT} m
end
subsection Analysis start
  set Type        = transient
  set Excitations = none
  subsection Transient
    set Duration          = 1 ms
    set Sampling interval = 1 ms
    set Frames            = 2
  end
end
subsection Analysis impact
  set Type = transient
  subsection Transient
    set Duration          = 0.1 s
    set Sampling interval = 1 ms
    set Frames            = {FRAMES}
    set First frame       = {FIRST} s
    set Last frame        = {LAST} s
  end
end
"""


class Fields(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        model = cls.folder / "model.prm"
        model.write_text(MODEL, encoding="utf-8")
        done = subprocess.run([PROGRAM, model, "--output", cls.folder / "out"], capture_output=True, text=True,
                              check=False, stdin=subprocess.DEVNULL)
        if done.returncode:
            raise AssertionError(done.stderr)
        cls.frames = [cls.part("impact", "frame", number) for number in range(1, FRAMES + 1)]

    @classmethod
    def part(cls, analysis, name, number):
        return vtu_arrays(cls.folder / "out" / analysis / f"{name}-{number:05d}.vtu")

    def test_velocity_is_the_rate_of_the_displacement(self):
        interval = (LAST - FIRST) / (FRAMES - 1)
        moved = np.array([frame["displacement"] for frame in self.frames])
        velocity = np.array([frame["velocity"] for frame in self.frames])
        differences = (moved[2:] - moved[:-2]) / (2 * interval)
        # h^2 / 6 of the third derivative, and displacements in single precision over 2 h.
        error = np.abs(differences - velocity[1:-1]).max()
        self.assertLess(error, 0.02 * np.abs(velocity).max())
        ground = self.frames[0]["Points"][:, 2] == 0
        times = FIRST + interval * np.arange(FRAMES)
        omega = 2 * np.pi * 10
        np.testing.assert_allclose(velocity[:, ground, 0].mean(axis=1), 0.5e-3 * omega * np.cos(omega * times),
                                   rtol=1e-5, atol=1e-7)

    def test_a_stop_that_is_fixed_in_space_does_not_move(self):
        for number in range(1, FRAMES + 1):
            stop = self.part("impact", "stops", number)
            np.testing.assert_allclose(stop["Points"].mean(axis=0), [0, 0, LENGTH], atol=1e-7)
            np.testing.assert_allclose(stop["displacement"], [[-CLEARANCE, 0, 0]] * 4, atol=1e-9)

    def test_the_ground_moves_with_the_base(self):
        for number in (1, 50):
            support = self.part("impact", "supports", number)
            np.testing.assert_array_equal(support["Points"], [[0, 0, 0]])
            ground = self.frames[number - 1]["Points"][:, 2] == 0
            np.testing.assert_array_equal(support["displacement"][0],
                                          self.frames[number - 1]["displacement"][ground][0])

    def test_the_state_of_the_contact_says_whether_a_force_acts(self):
        states = set()
        for frame in self.frames:
            tip = np.isclose(frame["Points"][:, 2], LENGTH)
            self.assertTrue((frame["contact_state"][~tip] == 0).all())
            force = np.linalg.norm(frame["contact_force"][tip], axis=1)
            np.testing.assert_array_equal(frame["contact_state"][tip], np.where(force > 0, 2, 1))
            states |= set(frame["contact_state"][tip])
        self.assertEqual(states, {1, 2})

    def test_stress_of_the_static_shape(self):
        # M c / I with M = 3 EI w (L - z) / L^3. Twelve modes have the moment but near the tip, where all of them
        # end with that of their tip mass.
        frame = self.part("start", "frame", 1)
        z = frame["Points"][:, 2]
        expected = 3 * YOUNG * (THICKNESS / 2) * BENT * (LENGTH - z) / LENGTH ** 3
        error = np.abs(frame["von_mises_stress"] - expected).max()
        self.assertLess(error, 0.03 * expected.max())


if __name__ == "__main__":
    unittest.main()
