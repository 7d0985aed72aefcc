#!/usr/bin/env python3
"""Motions with friction along two directions, integrated independently of the program, whose figures
stand in tests/motion/planar_friction.cc and planar_coulomb.cc:

    python3 tests/support/planar_friction_reference.py [CASE ...]

As in friction_reference.py, whose steps and events these are.
"""
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from friction_reference import go, hertz, kelvin_voigt, run, show


class Sled:
    """Mass m with springs kx, ky on a plane, pressed on it by N(t, w, w'), w the way along the
    normal; a spring-slider kt, ct acts along both directions. State x, y, w, x', y', w', z_x, z_y."""

    def __init__(self, mass, springs, load, mu, kt, ct):
        self.mass, self.springs, self.load = mass, np.array(springs), load
        self.mu, self.kt, self.ct = mu, kt, ct

    def force(self, y):
        return 0.0

    def force_rate(self, y, acceleration):
        return 0.0

    def across(self, y):
        return 0.0

    def pull(self, y):
        return self.kt * y[6:8] + self.ct * y[3:5]

    def rates(self, t, y, pull, z_rate):
        plane = (np.array(self.load(t)) - self.springs * y[0:2] - pull) / self.mass
        return np.concatenate([y[3:6], plane, [self.across(y)], z_rate])

    def along(self, y):
        p = self.pull(y) if self.ct else y[6:8]
        return p / np.hypot(*p)

    def slip_speed(self, y):
        if self.ct:
            return np.hypot(*self.pull(y)) - self.mu * self.force(y)
        return self.along(y) @ y[3:5] - self.mu / self.kt * self.force_rate(y, self.across(y))

    def slip(self, t, y):
        limit = self.mu * self.force(y) * self.along(y)
        z_rate = ((limit - self.kt * y[6:8]) / self.ct if self.ct
                  else y[3:5] - self.along(y) * self.slip_speed(y))
        return self.rates(t, y, limit, z_rate)

    def scaled(self, t, y):
        if self.ct:
            return y
        y = y.copy()
        y[6:8] = self.along(y) * self.mu * self.force(y) / self.kt
        return y

    def modes(self, parting=()):
        parting = list(parting)
        return {"stick": (lambda t, y: self.rates(t, y, self.pull(y), y[3:5]),
                          parting + [(lambda t, y: (self.mu * self.force(y)) ** 2
                                      - self.pull(y) @ self.pull(y), "slip", None)]),
                "slip": (self.slip, parting + [(lambda t, y: self.slip_speed(y), "stick",
                                                self.scaled)])}


class PressedSled(Sled):
    def force(self, y):
        return 10.0


class FlyingSled(Sled):
    """Flies along w against a side at the distance 0.1, or rests on it by its weight."""

    def __init__(self, law, push, weight, *constants):
        super().__init__(*constants)
        self.law, self.slope = law
        self.push, self.weight = push, weight

    def force(self, y):
        return self.law(y[2] - 0.1, y[5])

    def across(self, y):
        return (self.weight - self.force(y)) / self.mass

    def force_rate(self, y, acceleration):
        by_u, by_rate = self.slope(y[2] - 0.1, y[5])
        return by_u * y[5] + by_rate * acceleration

    def all_modes(self):
        def free(t, y):
            plane = (np.array(self.load(t)) - self.springs * y[0:2]) / self.mass
            return np.concatenate([y[3:6], plane, [self.weight / self.mass, 0.0, 0.0]])

        def let_go(t, y):
            y = y.copy()
            y[6:8] = 0.0
            return y

        parting = [(lambda t, y: y[2] - 0.1, "open", let_go)]
        if self.push:
            parting.append((lambda t, y: self.push(y[2] - 0.1, y[5]), "separating", let_go))
        return {"open": (free, [(lambda t, y: 0.1 - y[2], "stick", None)]),
                "separating": (free, [(lambda t, y: y[2] - 0.1, "open", None)]),
                **self.modes(parting)}


def turning(t):
    return 0.9 * np.cos(0.8 * t), 0.6 * np.cos(0.8 * t - 1.0)


def sled(title, ct):
    go.longest = 0.02
    show(title, *run(PressedSled(1.0, [1.0, 1.7], turning, 0.1, 20.0, ct).modes(), "stick",
                     np.array([1.5, 0.5, 0, 0.2, -1.0, 0, 0, 0]), 16.0, 0.01))
    go.longest = 1e-3


def planar_flight(title, law, push, ct, velocity):
    start = np.array([0.0, 0.0, 0.099, *velocity, 1.0, 0.0, 0.0])
    flying = FlyingSled(law, push, 0.0, 2.0, [4e5, 1e5], lambda t: (0.0, 0.0), 0.3, 2e5, ct)
    show(title, *run(flying.all_modes(), "open", start, 0.03, 1e-4))


def bouncing(title, law, ct):
    start = np.array([0.0, 0.0, 0.112, 0.8, -0.5, 0.0, 0.0, 0.0])
    sled = FlyingSled(law, None, 60.0, 2.0, [400.0, 100.0], lambda t: (0.0, 0.0), 0.3, 2e4, ct)
    show(title, *run(sled.all_modes(), "stick", start, 0.4, 1e-3))


class DrySled:
    """Mass 1 with springs kx, ky on a plane under a turning load; Coulomb friction along both
    directions, N = 10. State x, y, x', y'. A slip stops, where it is slow, after the time that it
    takes with a constant acceleration a of all else and the deceleration f of friction,
    (f |v| + a . v) / (f^2 - a^2), and v times half that time further on. It begins at rest against
    what held the mass; where that is no more than what friction takes, a has no part but its rate
    (alpha along a, beta across it), and |v| = alpha s^2 / 2 along the angle beta s / f: from there
    an implicit method follows |v| and the angle."""

    slow = 1e-8

    def __init__(self, springs, coefficient, static_coefficient):
        self.springs = np.array(springs)
        self.f, self.most = 10.0 * coefficient, 10.0 * static_coefficient

    def drive(self, t, y):
        return np.array(turning(t)) - self.springs * y[0:2]

    def slip(self, t, y):
        speed = np.hypot(*y[2:4])
        along = y[2:4] / speed if speed > 0 else self.start
        return np.concatenate([y[2:4], self.drive(t, y) - self.f * along])

    def stop(self, t, y):
        a, v, f = self.drive(t, y), y[2:4], self.f
        rest = (f * np.hypot(*v) + a @ v) / (f * f - a @ a)
        return t + rest, np.concatenate([y[0:2] + 0.5 * rest * v, [0.0, 0.0]])

    def begin(self, t, y):
        small = 1e-5
        n = self.start
        across = np.array([-n[1], n[0]])
        rate = (self.drive(t + small, y) - self.drive(t - small, y)) / (2 * small)

        def polar(s, x):
            e = np.cos(x[3]) * n + np.sin(x[3]) * across
            a = self.drive(s, x)
            return [*(x[2] * e), a @ e - self.f,
                    (a @ across * np.cos(x[3]) - a @ n * np.sin(x[3])) / x[2]]

        first = [*y[0:2], rate @ n * small ** 2 / 2, rate @ across * small / self.f]
        done = solve_ivp(polar, (t + small, t + 0.05), first, method="Radau", rtol=1e-12,
                         atol=[1e-15, 1e-15, 1e-18, 1e-13])
        assert done.success, done.message
        x = done.y[:, -1]
        e = np.cos(x[3]) * n + np.sin(x[3]) * across
        return t + 0.05, np.concatenate([x[0:2], x[2] * e])

    def run(self, y, end):
        t, mode, events = 0.0, "slip", []
        while t < end:
            if mode == "stick":
                y[2:4] = 0.0
                margin = lambda s: self.most - np.hypot(*self.drive(s, y))
                grid = np.arange(t, end, 1e-3)
                falls = [s for s in grid if margin(s) < 0]
                if not falls:
                    break
                t = brentq(margin, falls[0] - 1e-3, falls[0], xtol=1e-16, rtol=1e-15)
                mode, self.start = "slip", self.drive(t, y) / self.most
                events.append((t, "slip", y.copy()))
                if self.most == self.f:
                    t, y = self.begin(t, y)
                else:
                    y = go(self.slip, t, y, t + 1e-3)
                    t += 1e-3
                continue
            slows = lambda s, x: np.hypot(*x[2:4]) - self.slow
            slows.terminal, slows.direction = True, -1
            done = solve_ivp(self.slip, (t, end), y, method="DOP853", rtol=1e-13, atol=1e-16,
                             max_step=0.02, events=slows)
            t, y = done.t[-1], done.y[:, -1]
            if t < end:
                t, y = self.stop(t, y)
                mode = "stick"
                events.append((t, mode, y.copy()))
        return y, mode, events


def dry_sled(title, coefficient, static_coefficient):
    show(title, *DrySled([1.0, 1.7], coefficient, static_coefficient).run(
        np.array([1.5, 0.5, 0.2, -1.0]), 16.0))


CASES = {
    "planar coulomb": lambda: dry_sled("planar coulomb", 0.1, 0.1),
    "planar coulomb, static coefficient": lambda: dry_sled(
        "planar coulomb, static coefficient", 0.1, 0.12),
    "planar spring-slider": lambda: sled("planar spring-slider", 0.0),
    "planar spring-slider with a dashpot": lambda: sled("planar spring-slider with a dashpot", 0.8),
    "planar flight, kelvin-voigt": lambda: planar_flight(
        "planar flight, kelvin-voigt", kelvin_voigt(3e4, 90.0), lambda u, v: 3e4 * u + 90.0 * v,
        150.0, [0.3, 0.2]),
    "planar flight, hertz": lambda: planar_flight(
        "planar flight, hertz", hertz(1e5), None, 150.0, [0.3, 0.2]),
    "planar slide, kelvin-voigt": lambda: bouncing(
        "planar slide, kelvin-voigt", kelvin_voigt(3e3, 10.0), 0.0),
    "planar slide, hertz": lambda: bouncing("planar slide, hertz", hertz(2e4), 0.0),
}


if __name__ == "__main__":
    for case in sys.argv[1:] or CASES:
        CASES[case]()
