#!/usr/bin/env python3
"""Motions with friction, integrated independently of the program, whose figures stand in
tests/motion/friction_references.cc:

    python3 tests/support/friction_reference.py [CASE ...]

A law has modes; each is a smooth system y' = f(t, y) with guards, functions that are positive while
it holds. Steps are taken with the explicit method of order 8 of SciPy (DOP853, tolerance 1e-13). The
instant at which a guard falls is found by integrating anew from the last step to the zero itself,
never from dense output.
"""
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def go(f, t0, y0, t1):
    if t1 <= t0:
        return np.array(y0, dtype=float)
    done = solve_ivp(f, (t0, t1), y0, method="DOP853", rtol=1e-13, atol=1e-16, max_step=go.longest)
    assert done.success, done.message
    return done.y[:, -1]


go.longest = 1e-3


def run(modes, mode, y, end, step, t=0.0):
    """modes: name -> (f, [(guard, target, reset)]), targets may be functions of (t, y)."""
    events = []
    fresh = True
    while t < end:
        f, guards = modes[mode]
        to = min(t + (step * 1e-3 if fresh else step), end)
        ahead = go(f, t, y, to)
        falls = []
        for guard, target, reset in guards:
            if guard(to, ahead) >= 0:
                continue
            start = guard(t, y)
            if start <= 1e-13 and fresh:
                falls.append((t, target, reset))
                continue
            falls.append((brentq(lambda s: guard(s, go(f, t, y, s)), t, to, xtol=1e-16, rtol=1e-15),
                          target, reset))
        if not falls:
            t, y, fresh = to, ahead, False
            continue
        instant, target, reset = min(falls, key=lambda fall: fall[0])
        y = go(f, t, y, instant)
        t = instant
        if reset:
            y = reset(t, y)
        mode = target(t, y) if callable(target) else target
        events.append((t, mode, y.copy()))
        fresh = True
    return y, mode, events


def show(title, y, mode, events):
    print(f"== {title}")
    for t, target, state in events:
        print(f"   {t:.15g} -> {target}: " + ", ".join(f"{v:.15g}" for v in state))
    print(f"   end in {mode}: " + ", ".join(f"{v:.15g}" for v in y))


class Particle:
    """Mass m with springs kx, ky that flies along y against a side at a distance; friction along
    x. State x, y, x', y', z."""

    def __init__(self, mass, kx, ky, gap, force, mu, slope):
        self.mass, self.kx, self.ky, self.gap = mass, kx, ky, gap
        self.force, self.mu = force, mu  # of penetration and its rate
        self.slope = slope               # partial derivatives of it

    def normal(self, y):
        return self.force(y[1] - self.gap, y[3])

    def rates(self, y, pull, z_rate):
        """pull: of the contact, towards -x; z_rate: function of y''."""
        acceleration = (-self.ky * y[1] - self.normal(y)) / self.mass
        return np.array([y[2], y[3], (-self.kx * y[0] - pull) / self.mass, acceleration,
                         z_rate(acceleration)])

    def normal_rate(self, y):
        acceleration = (-self.ky * y[1] - self.normal(y)) / self.mass
        by_u, by_rate = self.slope(y[1] - self.gap, y[3])
        return by_u * y[3] + by_rate * acceleration

    def free(self):
        return lambda t, y: np.array([y[2], y[3], -self.kx * y[0] / self.mass,
                                      -self.ky * y[1] / self.mass, 0.0])

    def parting(self, push):
        """The contact ends with the overlap, or where the force falls to zero before."""
        guards = [(lambda t, y: y[1] - self.gap, "open", None)]
        if push:
            guards.append((lambda t, y: push(y[1] - self.gap, y[3]), "separating", None))
        return guards

    def coulomb(self, push):
        def slip(sigma):
            return (lambda t, y: self.rates(y, sigma * self.mu * self.normal(y), lambda a: 0.0),
                    self.parting(push) + [(lambda t, y: sigma * y[2], self.halt, still)])

        def still(t, y):
            y = y.copy()
            y[2] = 0.0
            return y

        return {"open": (self.free(), [(lambda t, y: self.gap - y[1], self.by_speed, None)]),
                "separating": (self.free(), [(lambda t, y: y[1] - self.gap, "open", None)]),
                "stick": (lambda t, y: self.rates(y, -self.kx * y[0], lambda a: 0.0),
                          self.parting(push) + [
                              (lambda t, y: self.mu * self.normal(y) - self.kx * y[0], "slip -", None),
                              (lambda t, y: self.mu * self.normal(y) + self.kx * y[0], "slip +", None)]),
                "slip +": slip(1), "slip -": slip(-1)}

    def by_speed(self, t, y):
        return "slip +" if y[2] > 0 else "slip -"

    def halt(self, t, y):
        """Does friction hold the spring?"""
        most = self.mu * self.normal(y)
        return "slip -" if self.kx * y[0] > most else "slip +" if -self.kx * y[0] > most else "stick"

    def slider(self, kt, push):
        def slip(sigma):
            def slaved(t, y):
                y = y.copy()
                y[4] = sigma * self.mu * self.normal(y) / kt
                return y

            def speed(t, y):
                return sigma * y[2] - self.mu / kt * self.normal_rate(y)

            def f(t, y):
                rate = sigma * self.mu / kt * self.normal_rate(y)
                return self.rates(y, sigma * self.mu * self.normal(y), lambda a: rate)

            return (f, self.parting(push) + [(speed, "stick", slaved)])

        return {"open": (self.free(), [(lambda t, y: self.gap - y[1], "stick", relaxed)]),
                "separating": (self.free(), [(lambda t, y: y[1] - self.gap, "open", None)]),
                "stick": (lambda t, y: self.rates(y, kt * y[4], lambda a: y[2]),
                          self.parting(push) + [
                              (lambda t, y: self.mu * self.normal(y) - kt * y[4], "slip +", None),
                              (lambda t, y: self.mu * self.normal(y) + kt * y[4], "slip -", None)]),
                "slip +": slip(1), "slip -": slip(-1)}


def relaxed(t, y):
    y = y.copy()
    y[4] = 0.0
    return y


def positive(u):
    return max(u, 0.0)


def kelvin_voigt(k, c):
    return lambda u, v: k * u + c * v, lambda u, v: (k, c)


def hertz(k):
    return lambda u, v: k * positive(u) ** 1.5, lambda u, v: (1.5 * k * positive(u) ** 0.5, 0.0)


def hunt_crossley(k, d):
    return (lambda u, v: k * positive(u) ** 1.5 * (1 + d * v),
            lambda u, v: (1.5 * k * positive(u) ** 0.5 * (1 + d * v), d * k * positive(u) ** 1.5))


def oblique(title, law, kx, mu, start, end, make, push=None):
    force, slope = law
    particle = Particle(2.0, kx, 0.0, 0.1, force, mu, slope)
    show(title, *run(make(particle), "open", np.array(start + [0.0]), end, 1e-4))


class Belt:
    """A mass 1 on a spring 1 and on a belt of speed 0.2, pressed on it by 1. State x, x'."""

    speed = 0.2

    def __init__(self, coefficient, static_coefficient, damping):
        self.coefficient, self.static, self.damping = coefficient, static_coefficient, damping

    def modes(self):
        def slip(sigma):  # of the belt on the mass
            def f(t, y):
                v = self.speed - y[1]
                return np.array([y[1], -y[0] + sigma * self.coefficient(abs(v)) + self.damping * v])

            def still(t, y):
                return np.array([y[0], self.speed])

            return f, [(lambda t, y: sigma * (self.speed - y[1]), "stick", still)]

        return {"stick": (lambda t, y: np.array([self.speed, 0.0]),
                          [(lambda t, y: self.static - y[0], "slip +", None),
                           (lambda t, y: self.static + y[0], "slip -", None)]),
                "slip +": slip(1), "slip -": slip(-1)}


def belt(title, end, *constants):
    go.longest = 0.05
    show(title, *run(Belt(*constants).modes(), "stick", np.array([0.0, Belt.speed]), end, 0.01))
    go.longest = 1e-3


def capsule(title, drive, mass, frequency, periods):
    """A driven mass 1 in a capsule that rubs on the ground with 1. State x1, x2, x1', x2'; the
    spring 15 acts where x1 - x2 exceeds 0.02. Ways of the capsule in the last two periods."""

    def coupling(y, touches):
        return y[1] - y[0] + 0.1 * (y[3] - y[2]) - (15 * (y[0] - y[1] - 0.02) if touches else 0.0)

    def rates(sigma, touches):
        def f(t, y):
            pull = coupling(y, touches)
            friction = 0.0 if sigma == 0 else (-pull - sigma) / mass
            return np.array([y[2], 0.0 if sigma == 0 else y[3], drive * np.cos(frequency * t) + pull,
                             friction])
        return f

    modes = {}
    for sigma, word in ((0, "stick"), (1, "slip +"), (-1, "slip -")):
        for touches in (False, True):
            side = -1 if touches else 1
            guards = [(lambda t, y, side=side: side * (0.02 - y[0] + y[1]),
                       f"{word}, {not touches}", None)]

            def still(t, y):
                return np.array([y[0], y[1], y[2], 0.0])

            def after(t, y, touches=touches):
                pull = -coupling(y, touches)
                return f"{'slip +' if pull > 1 else 'slip -' if pull < -1 else 'stick'}, {touches}"

            if sigma == 0:
                guards += [(lambda t, y, touches=touches: 1 + coupling(y, touches),
                            f"slip +, {touches}", None),
                           (lambda t, y, touches=touches: 1 - coupling(y, touches),
                            f"slip -, {touches}", None)]
            else:
                guards.append((lambda t, y, sigma=sigma: sigma * y[3], after, still))
            modes[f"{word}, {touches}"] = (rates(sigma, touches), guards)
    period = 2 * np.pi / frequency
    go.longest = 0.2
    y, mode, t, ways = np.zeros(4), "stick, False", 0.0, []
    for i in range(periods):
        before = y[1]
        y, mode, _ = run(modes, mode, y, (i + 1) * period, 0.05, t)
        t = (i + 1) * period
        ways.append(y[1] - before)
    go.longest = 1e-3
    print(f"== {title}\n   " + ", ".join(f"{way:.12g}" for way in ways[-2:]))


CASES = {
    "kelvin-voigt, spring-slider": lambda: oblique(
        "kelvin-voigt, spring-slider", kelvin_voigt(3e4, 90.0), 0.0, 0.3, [0.0, 0.099, 0.9, 1.0], 0.03,
        lambda p: p.slider(2e4, lambda u, v: 3e4 * u + 90.0 * v)),
    "kelvin-voigt, spring-slider on a spring": lambda: oblique(
        "kelvin-voigt, spring-slider on a spring", kelvin_voigt(3e4, 90.0), 4e5, 0.3,
        [0.0, 0.099, 0.25, 1.0], 0.03, lambda p: p.slider(2e5, lambda u, v: 3e4 * u + 90.0 * v)),
    "hertz, coulomb": lambda: oblique(
        "hertz, coulomb", hertz(1e5), 4e5, 0.3, [0.0, 0.099, 0.25, 1.0], 0.05,
        lambda p: p.coulomb(None)),
    "hunt-crossley, coulomb": lambda: oblique(
        "hunt-crossley, coulomb", hunt_crossley(1e5, 0.2), 4e5, 0.3, [0.0, 0.099, 0.25, 1.0], 0.05,
        lambda p: p.coulomb(lambda u, v: 1 + 0.2 * v)),
    "hertz, spring-slider": lambda: oblique(
        "hertz, spring-slider", hertz(1e5), 4e5, 0.3, [0.0, 0.099, 0.25, 1.0], 0.05,
        lambda p: p.slider(4e5, None)),
    "stribeck on a belt": lambda: belt(
        "stribeck on a belt", 30.0, lambda v: 0.5 + 0.5 * np.exp(-v / 0.3), 1.0, 0.02),
    "stribeck on a belt, exponent 2": lambda: belt(
        "stribeck on a belt, exponent 2", 30.0, lambda v: 0.5 + 0.5 * np.exp(-(v / 0.3) ** 2), 1.0,
        0.0),
    "capsule 1": lambda: capsule("capsule 1", 1.6, 5.0, 0.95, 400),
    "capsule 2": lambda: capsule("capsule 2", 1.0, 5.0, 0.95, 400),
    "capsule 3": lambda: capsule("capsule 3", 1.6, 3.0, 0.95, 400),
    "capsule 4": lambda: capsule("capsule 4", 1.6, 5.0, 1.1, 402),
}


if __name__ == "__main__":
    for case in sys.argv[1:] or CASES:
        CASES[case]()
