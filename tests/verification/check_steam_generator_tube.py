#!/usr/bin/python3
"""The steam generator's tube against integration by fixed steps of the classical Runge-Kutta method from its modes; the symmetry of its
plates; and work rates by other tolerances, numbers of modes and elements against those of the file, in standard errors of both.
"""
import sys

import numpy
from scipy.interpolate import CubicSpline

from systems import Table

PLATES = ("plate1", "plate2", "plate3", "plate4")
GAP, STIFFNESS, DAMPING, FRICTION = 0.05e-3, 1e6, 100.0, 0.3
DURATION, STEP = 0.1, 4e-6
COARSE = ["Integration/Relative tolerance=1e-6", "Variables/modes=16", "Variables/elements=25"]
FINE = ["Integration/Relative tolerance=1e-10", "Variables/modes=48", "Variables/elements=100"]
SETTINGS = {"tolerance 1e-6": COARSE[:1], "16 modes": COARSE[1:2], "48 modes": FINE[1:2], "25 elements": COARSE[2:],
            "all three coarse": COARSE, "tolerance 1e-10, 48 modes, 100 elements": FINE}
PERIODS = 60
MOST = 4  # standard errors


class FixedSteps:
    """The tube from its modes, all holes at once; the friction's spring z has a dashpot beside it: T = k z + c v, |T| <= mu N,
    z' = (T - k z) / c, and the sides slide at v - z'."""

    def __init__(self, body, forces):
        self.mass, self.stiffness, self.damping = (body[name][:] for name in ("mass", "stiffness", "damping"))
        names = [name.decode().rsplit(".", 1)[-1] for name in body["point"][:]]
        rows = body["point_rows"][:]
        self.rows = numpy.stack([[rows[names.index(plate), axis] for plate in PLATES] for axis in (0, 1)])
        self.driven = numpy.stack([rows[names.index("middle"), axis] for axis in (0, 1)])
        self.forces = forces

    def rates(self, time, q, v, z):
        place, speed = self.rows @ q, self.rows @ v
        radius = numpy.maximum(numpy.hypot(*place), 1e-300)
        normal = place / radius
        tangent = numpy.stack([-normal[1], normal[0]])
        gap, gap_rate = GAP - radius, -(normal * speed).sum(axis=0)
        push = numpy.where(gap < 0, numpy.maximum(-STIFFNESS * gap - DAMPING * gap_rate, 0), 0)
        slip = -(tangent * speed).sum(axis=0)
        pull = numpy.clip(STIFFNESS * z + DAMPING * slip, -FRICTION * push, FRICTION * push)
        z_rate = (pull - STIFFNESS * z) / DAMPING
        on_tube = -push * normal + pull * tangent
        load = numpy.einsum("apn,ap->n", self.rows, on_tube) + self.forces(time) @ self.driven
        acceleration = (load - self.stiffness * q - self.damping @ v) / self.mass
        return v, acceleration, z_rate, push * numpy.abs(slip - z_rate), push

    def work(self):
        """Integrals of normal force times sliding speed at the plates."""
        n = len(self.mass)
        q, v, z, work = numpy.zeros(n), numpy.zeros(n), numpy.zeros(4), numpy.zeros(4)
        for i in range(round(DURATION / STEP)):
            time, sums = i * STEP, [0, 0, 0, 0]
            stage, ahead = (0, 0, 0, 0, 0), 0.0
            for ahead, weight in ((0.0, 1), (0.5, 2), (0.5, 2), (1.0, 1)):
                h = ahead * STEP
                stage = self.rates(time + h, q + h * stage[0], v + h * stage[1], z + h * stage[2])
                sums = [total + weight * rate for total, rate in zip(sums, stage[:4])]
            q, v, z, work = (value + STEP / 6 * total for value, total in zip((q, v, z, work), sums))
            z[stage[4] == 0] = 0  # parted sides keep no deformation
        return work


def record(source):
    columns = numpy.loadtxt(source / "params" / "steam-generator-tube-force.csv", delimiter=",", skiprows=2).T
    return CubicSpline(columns[0], columns[1:].T, bc_type="clamped")


def check_steps(table):
    results = table.run("steam-generator-tube.prm", "record", "Analyses=record", f"Variables/gap={GAP} m", "Variables/modes=16",
                        f"Analysis/record/Transient/Duration={DURATION} s")
    expected = FixedSteps(results["body/tube"], record(table.arguments.source)).work() / DURATION
    recorded = results["analysis/record/recorded/contact"]
    for plate, value in zip(PLATES, expected):
        friction = recorded[plate]["friction"]
        table.add(f"{plate}, record until {DURATION} s, gap 0.05 mm, 16 modes: work rate, W", value, friction["work_rate"][()], 1e-3)
        table.add(f"{plate}: sum of its sectors less work rate, relative", 0,
                  friction["sector/work_rate"][:].sum() / friction["work_rate"][()] - 1, 1e-13, absolute=True)


def orbit(table, overrides):
    """Work rates of the plates and their standard errors, at a clearance of 0.2 mm."""
    results = table.run("steam-generator-tube.prm", "orbit", "Analyses=orbit", "Analysis/orbit/Record=friction",
                        "Analysis/orbit/Steady state/Settling cycles=30", f"Analysis/orbit/Steady state/Recorded cycles={PERIODS}",
                        "Analysis/orbit/Steady state/Steadiness tolerance=0", *overrides)
    contacts = results["analysis/orbit/contact"]
    return {plate: tuple(contacts[plate]["friction"][name][()] for name in ("work_rate", "work_rate_error")) for plate in PLATES}


def apart(one, other):
    """Of two means, in standard errors of their difference."""
    return (one[0] - other[0]) / numpy.hypot(one[1], other[1])


def check_settings(table):
    shipped = orbit(table, [])
    for one, other in (("plate1", "plate4"), ("plate2", "plate3")):
        table.add(f"{one} less {other}, which the symmetry makes equal, in standard errors", 0, apart(shipped[one], shipped[other]), MOST,
                  absolute=True)
    for name, overrides in SETTINGS.items():
        rates = orbit(table, overrides)
        print(name, *(f"{1e3 * rate:.1f}+-{1e3 * error:.1f}" for rate, error in (*rates.values(), *shipped.values())), file=sys.stderr)
        for plate in ("plate1", "plate2"):
            table.add(f"{plate}, {name}, less that of the file: work rate, in standard errors", 0, apart(rates[plate], shipped[plate]), MOST,
                      absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    check_steps(main)
    check_settings(main)
    main.finish()
