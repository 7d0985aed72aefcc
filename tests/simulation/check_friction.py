#!/usr/bin/python3
"""Friction in the analyses of periodic motions, searches and fits, against closed forms: the
oscillator of Den Hartog (1930), m = k = P = 1, b the frequency, f the friction.

usage: check_friction.py PROGRAM MPIEXEC
"""
from math import cos, pi, sin, sqrt

import h5py
import numpy as np

from program_runs import ProgramRuns, main

OSCILLATOR = """
subsection Body mass
  set Type = lumped
  subsection Mass block
    set Mass = 1 kg
    set Axis = x
    set Stiffness = 1 N/m
  end
end
subsection Contact ground
  set Between = mass.block, stop
  set Direction = z
  set Law = constant force
  subsection Constant force
    set Force = 1 N
  end
  subsection Friction
    set Law = coulomb
    set Direction = x
    subsection Coulomb
      set Coefficient = 0.6
    end
  end
end
"""
FORCE = """
subsection Excitation force
  set Type = force
  set At = mass.block
  set Direction = x
  set Amplitude = 1 N
  set Frequency = 0.7 rad/s
  set Phase = 90 deg
end
"""
BRANCH = """
subsection Analysis branch
  set Type = branch
  set Record = extreme values, friction
  subsection Branch
    set First frequency = 0.55 rad/s
    set Last frequency = 0.75 rad/s
  end
end
"""
SWEEP = """
subsection Analysis response
  set Type = stepped sweep
  set Record = friction, lyapunov
  subsection Lyapunov
    set Exponents = 2
  end
  subsection Stepped sweep
    set First frequency = 0.5 rad/s
    set Last frequency = 0.9 rad/s
    set Points = 33
    set Direction = both
    set Settling cycles = 300
    set Recorded cycles = 20
  end
end
"""
ORBIT = """
subsection Analysis orbit
  set Type = periodic orbit
  set Record = extreme values, friction
  subsection Periodic orbit
    subsection Derivative mu
      set Path = Contact/ground/Friction/Coulomb/Coefficient
    end
  end
end
"""
DECAY = """
subsection Initial condition pulled
  set Direction = x
  set At = mass.block
  set Displacement = 10 m
end
subsection Analysis decay
  set Type = transient
  set Record = history
  subsection Transient
    set Duration = 20 s
    set Sampling interval = 0.1 s
  end
end
subsection Analysis fit
  set Type = estimate
  subsection Estimate
    subsection Key mu
      set Path = Contact/ground/Friction/Coulomb/Coefficient
      set Lower = 0.1
      set Upper = 1.5
    end
    subsection Data decay
      set Repeat = decay
      set Quantity = point/mass.block/displacement_x
      set File = data.csv
    end
  end
end
"""
BEST = """
subsection Analysis orbit
  set Type = periodic orbit
  set Record = friction
end
subsection Analysis best
  set Type = optimise
  subsection Optimise
    set Repeat = orbit
    set Objective = contact/ground/friction/work_rate
    set Sense = maximise
    subsection Key limit
      set Path = Contact/ground/Constant force/Force
      set Lower = 0.5 N
      set Upper = 1.08 N
    end
  end
end
"""
BASINS = """
subsection Initial condition start
  set Direction = x
  set At = mass.block
  set Displacement = 1 m
  set Velocity = 1 m/s
end
subsection Analysis basins
  set Type = basins
  subsection Basins
    subsection First axis
      set Parameter = Initial condition/start/Displacement
      set First = -5 m
      set Last = 5 m
      set Cells = 12
    end
    subsection Second axis
      set Parameter = Initial condition/start/Velocity
      set First = -5 m/s
      set Last = 5 m/s
      set Cells = 12
    end
  end
end
"""
BEAM = """
subsection Body beam
  set Type = beam
  subsection Geometry
    set Line = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m
    set Elements = 4
  end
  subsection Section
    set Width = 20 mm
    set Thickness = 4 mm
  end
  subsection Member all
    set Width = 20 mm
    set Thickness = 4 mm
    set Offset = 0 mm, 20 mm
  end
  subsection Material
    set Young modulus = 70 GPa
    set Density = 2700 kg/m^3
  end
  subsection Modes
    set Number = 3
    set Damping ratio = 0.01
  end
  subsection Support plane
    set At = all
    set Fix = y, rx, rz
  end
  subsection Support left
    set At = start
    set Fix = all
  end
  subsection Point one
    set Near = 0.75 m, 0 m, 0 m
  end
  subsection Point two
    set At = end
  end
  subsection Interface feet
    set Near = 0.75 m, 0 m, 0 m, 1 m, 0 m, 0 m
  end
end
subsection Excitation table
  set Type = base acceleration
  set Direction = z
  set Amplitude = 20 m/s^2
  set Frequency = 30 rad/s
end
subsection Analysis run
  set Type = transient
  set Record = history, friction
  subsection Transient
    set Duration = 0.8 s
    set Sampling interval = 2 ms
  end
end
"""
FOOT = """
  set Direction = -z
  set Clearance = 1 mm
  set Law = linear penalty
  subsection Linear penalty
    set Stiffness = 2 kN/m
  end
  subsection Friction
    set Law = coulomb
    set Direction = x
    subsection Coulomb
      set Coefficient = 0.3
    end
  end
end
"""
FREQUENCY, MULTIPLIER = "analysis/branch/frequency", "analysis/branch/multiplier_"


def gain(b):
    return 1 / (1 - b * b)


def loss(b):
    return sin(pi / b) / (b * (1 + cos(pi / b)))


def amplitude(b, f):
    """Without stops."""
    return sqrt(gain(b)**2 - loss(b)**2 * f * f)


def multipliers(b, f):
    """Without stops: two turns per period."""
    turn = amplitude(b, f) * b * b
    s, c = (turn - f) / (turn + f), cos(pi / b)
    root = np.sqrt(complex(c * c * (1 + s)**2 / 4 - s))
    return np.array([(c * (1 + s) / 2 + root)**2, (c * (1 + s) / 2 - root)**2])


def limit(b):
    """Friction beyond which the mass stops, for b > 1/2."""
    return abs(gain(b)) / sqrt(loss(b)**2 + b**-4)


def decaying(t, start, lost):
    """A free mass before it comes to rest, from start; lost: friction over stiffness."""
    turns = int(t // pi)
    return (-1)**turns * ((start - lost * (2 * turns + 1)) * cos(t - turns * pi) + lost)


class Friction(ProgramRuns):
    def results(self, text, *arguments):
        self.file.write_text(text, encoding="utf-8")
        out = self.folder / "out"
        done = self.run_program(self.file, "--output", out, "--overwrite", *arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return h5py.File(out / "results.h5")

    def test_a_branch_through_the_first_stop(self):
        for mu in (0.55, 0.6, 0.65):
            found = self.results(OSCILLATOR + FORCE + BRANCH, "--set",
                                 f"Contact/ground/Friction/Coulomb/Coefficient={mu}")
            b = 2 * pi * found[FREQUENCY][:]
            largest = found["analysis/branch/point/mass.block/displacement_x/amplitude"][:]
            stops = found["analysis/branch/contact/ground/friction/sticks"][:]
            self.assertEqual({*stops}, {0, 2})
            for place, value, count in zip(b, largest, stops):
                if count == 0:
                    self.assertAlmostEqual(value, amplitude(place, mu), delta=1e-12)
            # A stop forgets the speed.
            both = found[MULTIPLIER + "real"][:] + 1j * found[MULTIPLIER + "imaginary"][:]
            self.assertLess(np.abs(both[stops == 2]).min(axis=1).max(), 1e-12)
            for place, pair in zip(b[stops == 0], both[stops == 0]):
                expected = multipliers(place, mu)
                self.assertAlmostEqual(pair.prod(), expected.prod(), delta=1e-12)
                self.assertAlmostEqual(pair.sum(), expected.sum(), delta=1e-12)
            # The first stop: crossing-sliding.
            self.assertEqual(list(found["analysis/branch/special/kind"]), [9])
            first = 2 * pi * found["analysis/branch/special/frequency"][0]
            self.assertAlmostEqual(limit(first), mu, delta=1e-11)

    def test_exponents_and_same_bytes_of_a_sweep(self):
        self.file.write_text(OSCILLATOR + FORCE + SWEEP, encoding="utf-8")
        self.expect_same_bytes()
        found = h5py.File(self.folder / "ranks1" / "results.h5")["analysis/response"]
        stops = found["contact/ground/friction/sticks"][:]
        self.assertEqual({*stops.flat}, {0, 40})
        b = np.linspace(0.5, 0.9, 33)
        for i, j in zip(*np.nonzero(stops == 0)):
            expected = np.log(np.abs(multipliers(b[i], 0.6)).max())
            exponent = found["lyapunov/exponent_per_period"][i, j]
            self.assertAlmostEqual(exponent, expected, delta=0.1 * abs(expected))

    def test_derivatives_of_an_orbit_by_the_coefficient(self):
        found = self.results(OSCILLATOR + FORCE + ORBIT)["analysis/orbit"]
        b, f = 0.7, 0.6
        by_mu = -loss(b)**2 * f / amplitude(b, f)
        maximum = found["derivative/mu/point/mass.block/displacement_x/maximum"][()]
        self.assertAlmostEqual(maximum, by_mu, delta=1e-8)

    def test_the_coefficient_of_a_decaying_motion(self):
        rows = [f"{t},{decaying(t, 10, 0.7):.15g}" for t in 0.1 * np.arange(201)]
        (self.folder / "data.csv").write_text("\n".join(["t,x", *rows]), encoding="utf-8")
        found = self.results(OSCILLATOR + DECAY)
        self.assertAlmostEqual(found["analysis/fit/derived/best_mu"][()], 0.7, delta=1e-9)

    def test_the_friction_that_takes_most(self):
        """4 f a per period is largest at f = V / (sqrt(2) U)."""
        found = self.results(OSCILLATOR + FORCE + BEST, "--set",
                             "Excitation/force/Frequency=1.2 rad/s")
        best = abs(gain(1.2)) / sqrt(2) / abs(loss(1.2))
        self.assertAlmostEqual(0.6 * found["analysis/best/derived/best_limit"][()], best, delta=1e-3)

    def test_all_starts_lead_to_the_same_motion(self):
        for frequency in ("0.7 rad/s", "0.55 rad/s"):
            found = self.results(OSCILLATOR + FORCE + BASINS, "--set",
                                 f"Excitation/force/Frequency={frequency}")["analysis/basins"]
            self.assertEqual(list(found["attractor"]), [1])
            for share in ("undecided_share", "no_motion_share", "other_share"):
                self.assertTrue((found[share][()] == 0).all())

    def test_a_mass_that_decays_askew(self):
        """Along two directions; at each turn it stops, and goes back at once."""
        plane = OSCILLATOR.replace("Axis = x", "Axis = x, y").replace(
            "Direction = x", "Direction = x\n    set Directions = two")
        text = plane + DECAY[:DECAY.index("subsection Analysis fit")].replace(
            "Direction = x", "Direction = 0.6, 0.8, 0")
        found = self.results(text.replace("Record = history", "Record = history, friction"))
        found = found["analysis/decay"]
        t = found["recorded/history/history_time"][:]
        expected = np.array([decaying(time, 10, 0.6) for time in t])
        for axis, part in (("x", 0.6), ("y", 0.8)):
            place = found[f"recorded/history/point/mass.block/displacement_{axis}"][:]
            self.assertLess(np.abs(place - part * expected).max(), 1e-7)
            slip = found[f"recorded/history/contact/ground/slip_{1 if axis == 'x' else 2}"][:]
            self.assertLess(np.abs(slip + part * expected).max(), 1e-7)
        way = 6 * 20 - 1.2 * 6 * 6 + abs(expected[-1] - decaying(6 * pi, 10, 0.6))
        found = found["recorded/contact/ground/friction"]
        self.assertAlmostEqual(found["sliding_way"][()], way, delta=1e-6)
        self.assertAlmostEqual(found["energy"][()], 0.6 * way, delta=1e-6)

    def test_pairs_of_an_interface_rub_as_single_contacts_do(self):
        paired = self.results(BEAM + """
subsection Contact feet
  set Between = beam.feet, stop
  set Pairing = stops""" + FOOT)["analysis/run/recorded/contact"]
        taken = {name: [paired[f"feet.{i}/friction/{name}"][()] for i in (1, 2)]
                 for name in ("energy", "sliding_way", "slips")}
        single = self.results(BEAM + "".join(
            f"subsection Contact {name}\n  set Between = beam.{name}, stop" + FOOT
            for name in ("one", "two")))["analysis/run/recorded/contact"]
        for name, values in taken.items():
            for value, point in zip(values, ("one", "two")):
                expected = single[f"{point}/friction/{name}"][()]
                self.assertGreater(expected, 0)
                self.assertAlmostEqual(value, expected, delta=1e-9 * expected)


if __name__ == "__main__":
    main()
