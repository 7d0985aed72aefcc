#!/usr/bin/python3
"""Bursts of the vibro-impact damper: what stiff solvers show as their tolerance is tightened.

The equations of motion are integrated from rest by a stiff solver of scipy that knows nothing of
the contacts (VODE's backward differentiation; the light dampers only), and by methods of vibroimpact, which ends a step at
each change of a contact. Over 400 periods after 150 the table tells the excursion of the floor, the
largest right contact force, its median over the periods, and in how many of them it is more than
1.2 times this median: the bursts. In the rows chosen the motion repeats, so that an exact solution
has none. Takes about five minutes.
usage: study_bursts.py PROGRAM SOURCE [--page FILE] [--keep FOLDER]
"""
import math

import numpy
from scipy.integrate import ode

import study_figures
from studies import Study

FLOOR = (1000.0, 3.95e4, 452.0)  # mass, stiffness, damping
FORCE, OMEGA = 800.0, 7.23
DAMPING, DISTANCE = 40.65, 0.05
KAPPA = 1.336224
STEEL = (2.1e11, 0.3)
PERIOD = 2 * math.pi / OMEGA
SETTLING, RECORDED = 150, 400
#       name, m2, k2, C, (E2, nu2) of the left wall, (E4, nu4) of the right one
ROWS = (("Table 1, row 2", 20.0, 3190.0, 0.06, STEEL, STEEL),
        ("Table 2, row 1", 22.67, 2481.1, 0.0683, STEEL, STEEL),
        ("Table 5, row 1", 37.88, 414.6, 0.0747, (2.1e7, 0.49), STEEL))
WITH_VODE = ROWS[:2]  # for the heavy damper it takes very many steps at 1e-3
VODE = (1e-3, 1e-4, 1e-5)
METHODS = {"bdf": (1e-3, 1e-4, 1e-5), "rk": (1e-3, 1e-4, 1e-6, 1e-9)}


def hertz(side):
    return KAPPA / ((1 - STEEL[1]**2) / STEEL[0] + (1 - side[1]**2) / side[0])


class Absorber:
    """Right side and Jacobian of the four first-order equations."""

    def __init__(self, _, m2, k2, clearance, left, right):
        self.mass, self.stiffness, self.clearance = m2, k2, clearance
        self.left, self.right = hertz(left), hertz(right)

    def rates(self, t, y):
        m1, k1, c1 = FLOOR
        x1, x2, v1, v2 = y
        relative = x2 - x1
        link = (DAMPING * (v2 - v1) + self.stiffness * (relative - DISTANCE)
                - self.left * max(-relative, 0.0)**1.5 + self.force_right(relative))
        return [v1, v2, (FORCE * math.cos(OMEGA * t) - c1 * v1 - k1 * x1 + link) / m1,
                -link / self.mass]

    def jacobian(self, _, y):
        m1, k1, c1 = FLOOR
        relative = y[1] - y[0]
        slope = (self.stiffness + 1.5 * self.left * max(-relative, 0.0)**0.5
                 + 1.5 * self.right * max(relative - self.clearance, 0.0)**0.5)
        m2 = self.mass
        return numpy.array([[0, 0, 1, 0], [0, 0, 0, 1],
                            [-(k1 + slope) / m1, slope / m1, -(c1 + DAMPING) / m1, DAMPING / m1],
                            [slope / m2, -slope / m2, DAMPING / m2, -DAMPING / m2]])

    def force_right(self, relative):
        return self.right * max(relative - self.clearance, 0.0)**1.5


def states(absorber, tolerance):
    """Time and state after each step of the solver, up to the end."""
    end = (SETTLING + RECORDED) * PERIOD
    vode = ode(absorber.rates, absorber.jacobian)
    vode.set_integrator("vode", method="bdf", with_jacobian=True, rtol=tolerance,
                        atol=1e-3 * tolerance)
    vode.set_initial_value([0.0, DISTANCE, 0.0, 0.0])
    while vode.t < end and vode.successful():
        vode.integrate(end, step=True)
        yield vode.t, vode.y


def with_vode(absorber, tolerance):
    """Largest right force of each recorded period, and half the excursion of the floor in m."""
    forces, lowest, highest = numpy.zeros(RECORDED), math.inf, -math.inf
    for time, (x1, x2, _, _) in states(absorber, tolerance):
        period = int(time / PERIOD) - SETTLING
        if 0 <= period < RECORDED:
            forces[period] = max(forces[period], absorber.force_right(x2 - x1))
            lowest, highest = min(lowest, x1), max(highest, x1)
    return forces, (highest - lowest) / 2


def overrides(row):
    _, m2, k2, clearance, left, right = row
    values = {"m2": m2, "k2": k2, "C": clearance, "E2": left[0], "nu2": left[1], "E4": right[0],
              "nu4": right[1]}
    return [f"Variables/{name}={value}" for name, value in values.items()]


def with_vibroimpact(study, row, method, tolerance):
    """The same by vibroimpact, from the list of all impacts and the sampled motion."""
    history = study.run("vibro-impact-absorber.prm", f"{row[0]}-{method}-{tolerance:g}",
                        "Analyses=history", f"Integration/Method={method}",
                        f"Integration/Relative tolerance={tolerance}",
                        f"Analysis/history/Transient/Duration={(SETTLING + RECORDED) * PERIOD} s",
                        *overrides(row))["analysis/history"]
    impacts = history["contact/right/impact"]
    period = (impacts["time"][:] / PERIOD).astype(int) - SETTLING
    recorded = (period >= 0) & (period < RECORDED)
    forces = numpy.zeros(RECORDED)
    numpy.maximum.at(forces, period[recorded], impacts["peak_force"][:][recorded])
    floor = history["point/structure.floor/displacement_x"][:]
    return forces, numpy.ptp(floor[history["time"][:] >= SETTLING * PERIOD]) / 2


def bursts(forces):
    return int(numpy.sum(forces > 1.2 * numpy.median(forces)))


def draw(study, shown):
    """Largest force of each period, one panel for each row of the tables."""
    rows = [row[0] for row in WITH_VODE]
    figure, panels, colours = study_figures.panels(study, len(rows))
    for axes, row in zip(panels, rows):
        for tolerance, colour in zip((1e-3, 1e-4), colours):
            axes.plot(numpy.arange(RECORDED) + SETTLING, shown[row, tolerance] / 1e3, ".",
                      color=colour, label=f"relative tolerance {tolerance:g}")
        axes.set_title(row)
        axes.set_ylabel("Right force (kN)")
        axes.set_ylim(0, 4e-3 * numpy.median(shown[row, 1e-4]))
    panels[-1].set_xlabel("Period of the force")
    study_figures.legend(panels[0])
    study_figures.save(study, figure, "vibro-impact-absorber-bursts.png")


def main():
    study = Study(__file__, "row", "solver", "relative tolerance", "A1, m", "largest F right, N",
                  "its median, N", "bursts in 400 periods")
    shown = {}

    def enter(row, solver, tolerance, forces, excursion):
        study.row(row[0], solver, f"{tolerance:g}", f"{excursion:.5f}", f"{forces.max():.5g}",
                  f"{numpy.median(forces):.5g}", str(bursts(forces)))

    for row in ROWS:
        for tolerance in VODE if row in WITH_VODE else ():
            forces, excursion = with_vode(Absorber(*row), tolerance)
            shown[row[0], tolerance] = forces
            enter(row, "scipy, VODE", tolerance, forces, excursion)
        for method, tolerances in METHODS.items():
            for tolerance in tolerances:
                enter(row, f"vibroimpact, {method}", tolerance,
                      *with_vibroimpact(study, row, method, tolerance))
    draw(study, shown)
    study.finish()


if __name__ == "__main__":
    main()
