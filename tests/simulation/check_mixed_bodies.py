#!/usr/bin/python3
"""Lumped bodies, rotors and stops on a finite-element beam, against what is known otherwise: the
exact dynamic stiffness of a cantilever, and the lumped model that a single mode amounts to.

usage: check_mixed_bodies.py PROGRAM [MPIEXEC]
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np
from scipy.optimize import brentq

PROGRAM = sys.argv[1]

LENGTH, WIDTH, THICKNESS, YOUNG, DENSITY = 0.5, 0.03, 0.004, 70e9, 2700.0
BENDING = YOUNG * WIDTH * THICKNESS**3 / 12
LINE_MASS = DENSITY * WIDTH * THICKNESS

BEAM = f"""
subsection Body beam
  set Type = beam
  subsection Geometry
    set Line        = 0 m, 0 m, 0 m -> 0 m, 0 m, {LENGTH} m
    set Elements    = 60
    set Orientation = 0, 1, 0
  end
  subsection Section
    set Shape     = rectangle
    set Width     = {WIDTH} m
    set Thickness = {THICKNESS} m
  end
  subsection Material
    set Young modulus = {YOUNG} Pa
    set Density       = {DENSITY} kg/m^3
  end
  subsection Support root
    set At  = start
    set Fix = all
  end
  subsection Support plane
    set At  = all
    set Fix = y, z, rx, rz
  end
  subsection Point tip
    set At = end
  end
  subsection Modes
    set Number        = MODES
    set Damping ratio = RATIO
  end
end
"""

OSCILLATOR = """
subsection Body absorber
  set Type = lumped
  subsection Mass mass
    set Mass = 0.05 kg
  end
end
subsection Connection leaf
  set Between   = absorber.mass, beam.tip
  set Stiffness = 400 N/m
end
subsection Excitation push
  set Type      = force
  set At        = absorber.mass
  set Amplitude = 1 N
  set Frequency = 10 Hz
end
subsection Analysis response
  set Type = frequency response
  subsection Frequency response
    set First frequency = 4 Hz
    set Last frequency  = 150 Hz
    set Points          = 60
  end
end
"""

ROTOR = """
subsection Body rotor
  set Type = rotor
  subsection Rotor
    set At           = POINT
    set Mass         = 0.02 kg
    set Inertia      = 1e-5 kg m^2
    set Eccentricity = 5 mm
  end
  subsection Motor
    set Starting torque = 0.02 N m
    set Slope           = 2e-4 N m s
    set Time constant   = 5 ms
  end
end
"""

STOP = """
subsection Contact stop
  set Between   = POINT, base
  set Clearance = 0.2 mm
  subsection Linear penalty
    set Stiffness = 1e5 N/m
  end
end
"""

TRANSIENT = """
subsection Integration
  set Relative tolerance = 1e-11
end
subsection Analysis start
  set Type   = transient
  set Record = extreme values
  subsection Transient
    set Duration          = 0.5 s
    set Sampling interval = 1 ms
  end
end
"""


def run(folder, text, analysis, **values):
    """The opened results of a parameter file."""
    for name, value in values.items():
        text = text.replace(name.upper(), str(value))
    file = pathlib.Path(folder) / "case.prm"
    file.write_text(f"set Analyses = {analysis}\n" + text, encoding="utf-8")
    done = subprocess.run([PROGRAM, str(file), "--overwrite", "--output", f"{folder}/out"],
                          capture_output=True, text=True, check=False)
    if done.returncode:
        raise AssertionError(done.stdout + done.stderr)
    return h5py.File(f"{folder}/out/results.h5")


def values(results, path, point):
    return np.atleast_1d(results["analysis/start/" + path.replace("POINT", point)][()])


def roots(count):
    """The first values of beta L of a cantilever."""
    def characteristic(b):
        return np.cos(b) + 1 / np.cosh(b)
    return np.array([brentq(characteristic, np.pi * (r + 0.5) - 1, np.pi * (r + 0.5) + 1,
                            xtol=1e-14) for r in range(count)])


def exact_receptance(omega):
    """Tip displacement per tip force of a continuous cantilever."""
    b = (LINE_MASS * omega**2 / BENDING)**0.25 * LENGTH
    return LENGTH**3 / BENDING * (np.sin(b) * np.cosh(b) - np.cos(b) * np.sinh(b)) / (
        b**3 * (1 + np.cos(b) * np.cosh(b)))


def kept_receptance(omega, count):
    """The same from the first modes; each has four times its mass-normalised mean square there."""
    squares = roots(count)**4 * BENDING / (LINE_MASS * LENGTH**4)
    return np.sum(4 / (LINE_MASS * LENGTH) / (squares - omega[:, None]**2), axis=1)


def mass_amplitude(omega, receptance, mass=0.05, stiffness=400):
    """Amplitude of a mass that hangs by a spring on a point with that receptance, per force."""
    return np.abs(1 / (1 / (1 / stiffness + receptance) - mass * omega**2))


class OscillatorOnABeam(unittest.TestCase):
    MODES = 20

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        with run(cls.folder.name, BEAM + OSCILLATOR, "response", modes=cls.MODES,
                 ratio=0) as results:
            analysis = results["analysis/response"]
            cls.omega = analysis["frequency"][:]
            if analysis["frequency"].attrs["unit"] in ("Hz", b"Hz"):
                cls.omega *= 2 * np.pi
            cls.amplitude = analysis["point/absorber.mass/displacement_x/amplitude"][:]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_response_is_that_of_the_kept_modes(self):
        expected = mass_amplitude(self.omega, kept_receptance(self.omega, self.MODES))
        np.testing.assert_allclose(self.amplitude, expected, rtol=1e-6)

    # What the dropped modes would add to the static flexibility is about 5e-6 of it.
    def test_response_is_that_of_the_continuous_beam(self):
        expected = mass_amplitude(self.omega, exact_receptance(self.omega))
        near = np.abs(expected) < 20 * np.median(expected)
        self.assertGreater(np.count_nonzero(near), 50)
        np.testing.assert_allclose(self.amplitude[near], expected[near], rtol=1e-3)


class SingleMode(unittest.TestCase):
    """A beam that keeps one mode moves like the mass and the spring of that mode at its tip."""

    def compare(self, parts, observed):
        with tempfile.TemporaryDirectory() as folder:
            with run(folder, BEAM + parts + TRANSIENT, "start", modes=1, ratio=0.02,
                     point="beam.tip") as results:
                body = results["body/beam"]
                row = body["point_rows"][0, 0, 0]
                omega = 2 * np.pi * body["frequency"][0]
                beam = {path: values(results, path, "beam.tip") for path in observed}
            mass = 1 / row**2
            lumped = f"""
subsection Body block
  set Type = lumped
  subsection Mass tip
    set Mass      = {float(mass)!r} kg
    set Stiffness = {float(mass * omega**2)!r} N/m
    set Damping   = {float(2 * 0.02 * omega * mass)!r} N s/m
  end
end
"""
            with run(folder, lumped + parts + TRANSIENT, "start", point="block.tip") as results:
                for path, found in beam.items():
                    other = values(results, path, "block.tip")
                    self.assertGreater(np.max(np.abs(other)), 0, path)
                    np.testing.assert_allclose(found, other, rtol=0, err_msg=path,
                                               atol=1e-6 * np.max(np.abs(other)))
                return beam

    def test_rotor_on_a_beam(self):
        motion = self.compare(ROTOR, ["point/POINT/displacement_x", "recorded/rotor/rotor/speed/maximum"])
        self.assertGreater(motion["recorded/rotor/rotor/speed/maximum"][-1], 20)

    def test_rotor_on_a_beam_against_a_stop(self):
        motion = self.compare(ROTOR + STOP, ["point/POINT/displacement_x",
                                             "contact/stop/normal_force", "recorded/rotor/rotor/speed/maximum"])
        self.assertGreater(np.max(motion["contact/stop/normal_force"]), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
