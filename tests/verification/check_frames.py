#!/usr/bin/python3
"""Beams of public benchmarks, and a turning beam on an elastic stop, against closed forms.

The references are worked out here, from the differential equations; published figures stand beside them.
"""
import numpy
from numpy import cos, exp, pi, sin, sqrt
from scipy.linalg import expm
from scipy.optimize import brentq

from systems import Table

BENCHMARKS = "verification/beam-benchmarks.prm"
OFF_CENTRE = (1.723, 1.727, 7.413, 9.972, 18.155, 26.957)  # Hz, NAFEMS FV4
IMPACT = "verification/hinged-beam-impact.prm"


class ShortBeam:
    """SDLL01: a Timoshenko beam of 1 m x 0.2 m x 0.1 m, its supports `lever` below the axis."""

    length, area, inertia, modulus, density = 1, 0.02, 0.1 * 0.2**3 / 12, 2e11, 7800
    shear = 10 * 1.3 / (12 + 11 * 0.3) * 2e11 / 2.6 * 0.02  # kappa G A, Cowper's for a rectangle

    def __init__(self, lever):
        self.lever = lever

    def transfer(self, omega):
        """Of u, N, v, r, M, V along the beam; forces in units that keep the exponential small."""
        rate = numpy.zeros((6, 6))
        mass, scale = self.density * self.area * omega**2, self.modulus * self.inertia
        rate[0, 1] = scale / (self.modulus * self.area)
        rate[1, 0] = rate[5, 2] = -mass / scale
        rate[2, 3], rate[2, 5] = 1, scale / self.shear
        rate[3, 4] = 1
        rate[4, 5], rate[4, 3] = -1, -self.density * self.inertia * omega**2 / scale
        return expm(rate * self.length)

    def determinant(self, omega):
        """Free at the start: the turn, N and V; at the end N, v and M are zero."""
        start = numpy.zeros((6, 3))
        start[0, 0], start[3, 0] = -self.lever, 1
        start[1, 1], start[4, 1] = 1, self.lever
        start[5, 2] = 1
        return numpy.linalg.det((self.transfer(omega) @ start)[[1, 2, 4]])

    def frequencies(self, count):
        grid = 2 * pi * numpy.arange(50, 5000, 5.0)
        values = [self.determinant(omega) for omega in grid]
        found = [brentq(self.determinant, grid[i], grid[i + 1], rtol=1e-13)
                 for i in range(len(grid) - 1) if values[i] * values[i + 1] < 0]
        return numpy.array(found[:count]) / (2 * pi)


class TurningBeam:
    """SDNL32: a hinged beam whose free end meets a spring while it turns as a rigid body."""

    length, side, modulus, density, speed = 0.783, 0.014, 60.7e9, 2400, 3.8

    def __init__(self, stiffness):
        self.stiffness = stiffness
        self.bending = self.modulus * self.side**4 / 12
        self.numbers = self.wave_numbers(60)
        self.omega = ((self.numbers / self.length) ** 2
                      * sqrt(self.bending / (self.density * self.side**2)))
        self.amplitude = numpy.array([self.share(z) for z in self.numbers]) * 2 * sin(self.numbers)

    def condition(self, z):
        """Shear force and spring at the end; the shape is sin(z s) + sin z sinh(z s) / sinh z."""
        shear = self.bending * (z / self.length) ** 3 * (sin(z) - numpy.tanh(z) * cos(z))
        return shear - 2 * self.stiffness * sin(z) * numpy.tanh(z)

    def wave_numbers(self, count):
        grid = numpy.arange(0.05, pi * (count + 2), 0.01)
        values = self.condition(grid)
        places = numpy.flatnonzero(values[:-1] * values[1:] < 0)[:count]
        return numpy.array([brentq(self.condition, grid[i], grid[i + 1], rtol=1e-14) for i in places])

    def share(self, z):
        """Part of the mode in the initial velocities."""
        s, weights = numpy.polynomial.legendre.leggauss(600)
        s, weights = (s + 1) / 2, weights / 2
        grown = (exp(z * (s - 1)) - exp(-z * (s + 1))) / (1 - exp(-2 * z))
        shape = sin(z * s) + sin(z) * grown
        return self.speed * self.length * (weights * s * shape).sum() / (weights * shape**2).sum()

    def end(self, time):
        return (self.amplitude / self.omega) @ sin(self.omega * time)

    def contact(self):
        """Duration [s], largest force [N] and speed at the end [m/s]."""
        times = numpy.linspace(0, 0.015, 30001)
        motion = (self.amplitude / self.omega) @ sin(numpy.outer(self.omega, times))
        left = int(numpy.argmax(motion[1:] < 0))
        duration = brentq(self.end, times[left], times[left + 1], xtol=1e-15)
        peak = int(numpy.argmax(motion[: left + 1]))
        around = numpy.linspace(times[peak - 1], times[peak + 1], 2001)
        force = self.stiffness * max(self.end(time) for time in around)
        return duration, force, -self.amplitude @ cos(self.omega * duration)


def off_centre(table, bodies):
    for number, published in enumerate(OFF_CENTRE):
        table.add(f"mass beside the axis, by links, frequency {number + 1}, Hz",
                  bodies["off_centre/frequency"][number], bodies["linked/frequency"][number], 1e-9,
                  published)


def short(table, bodies):
    for name, lever in (("short", 0), ("short_below", 0.1)):
        for number, wanted in enumerate(ShortBeam(lever).frequencies(5)):
            table.add(f"{name}, frequency {number + 1}, Hz", wanted,
                      bodies[f"{name}/frequency"][number], 5e-4)


def folded(table, bodies):
    unit = sqrt(2.1e11 * 0.005**2 / 12 / 7800) / 0.5**2 / (2 * pi)
    for number in range(8):
        table.add(f"folded, frequency {number + 1}, Hz", ((2 * (number // 2) + 1) * pi / 2) ** 2 * unit,
                  bodies["folded/frequency"][number], 1e-4)


def turning(table, stiffness):
    analysis = table.run(IMPACT, f"turning-{stiffness}", f"Variables/K={stiffness} kN/m")["analysis/strike"]
    found = analysis["contact/spring/impact"]
    keys = {"duration": "duration, s", "peak_force": "largest force, N",
            "separation_speed": "speed at the end, m/s"}
    for (key, words), wanted in zip(keys.items(), TurningBeam(stiffness * 1e3).contact()):
        table.add(f"turning beam, {stiffness} kN/m: {words}", wanted, found[key][0], 5e-4)


def check(table):
    bodies = table.run(BENCHMARKS, "benchmarks")["body"]
    off_centre(table, bodies)
    short(table, bodies)
    folded(table, bodies)
    for stiffness in (18, 45):
        turning(table, stiffness)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
