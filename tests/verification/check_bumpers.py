#!/usr/bin/python3
"""A mass between two bumpers: steady points and whole response curves.

The references were computed with an exact event-located solver. The normalisation is that of the
paper: accelerations and forces by the largest free acceleration, displacements by the largest free
displacement, which is 1 m in the parameter file.
"""
import math

import numpy

from systems import Table

XI = 0.1
GROUND = 2 * XI * math.sqrt(1 - XI**2)
LARGEST = math.sqrt(-1 - 4 * XI**2 + 8 * XI**4 + math.sqrt(1 + 8 * XI**2))
ACCELERATION = 2 * GROUND * 2 * math.sqrt(2) * XI**2 / LARGEST

#         delta0, lambda, beta, eta_a, eta_d, eta_F, eta_B forward; backward where it differs
POINTS = [(.7, 2, 1.05, (1.2355375, .7971071, .4572763, .0971071), None),
          (.7, .1, 1.02, (1.3055934, .8882803, .4308399, .1882803), None),
          (.7, 100, 1.2, (3.4893496, .7280440, 2.7679431, .0280440), (.4005399, .3970432, 0, 0)),
          (.4, 1, .9, (.7525876, .4879760, .3000629, .0879760), None),
          (.4, 1, 1.1268, (1.0023835, .5559541, .5075283, .1559541), None),
          (.4, 100, 1.5, (3.7297681, .4334266, 3.2969419, .0334266), None),
          (.1989975, 1, 1.2142, (.7428957, .3685975, .4429727, .1696000), None),
          (.0657506, .1, 1.1, (.9864602, .5289223, .5416541, .4631717), None),
          (.0657506, 1, 1.32, (.5313850, .2317530, .3443299, .1660024), None),
          (.0657506, 5, 2.01, (.5742276, .1396801, .4247745, .0739295),
           (.0686076, .0648927, 0, 0)),
          (0, 1, 1.4188, (.4075957, .1573106, .2768695, .1573106), None)]
NAMES = ("η_a", "η_d", "η_F", "η_B")

# delta0, the stiffness with the lowest peak of the acceleration, and the largest values of the
# upward curve there: beta of the acceleration, eta_a, eta_d, eta_F, eta_B; the paper's beta and
# values, where its text gives them.
BEST = [(.7, 2.177, (1.0625, 1.23832, .7960, .4587, .0960), (1.05, None, None, None, None)),
        (.4, 1.282, (1.1359, .99739, .5513, .5015, .1513), (1.12, 1, None, None, None)),
        (.1989975, .987, (1.2133, .74288, .3712, .4438, .1722), (1.22, None, None, None, None)),
        (.0657506, .965, (1.3189, .53132, .2354, .3473, .1697), (1.32, None, None, None, None)),
        (0, 1.150, (1.4577, .40652, .1505, .2783, .1505), (1.47, .41, .15, .28, .15))]

CURVES = [("0.4", "1"), ("0.7", "2"), ("0.0657506", "5")]


def measures(analysis):
    """eta_a, eta_d, eta_F, eta_B over all points of an analysis."""
    mass = analysis["point/oscillator.mass"]
    sides = [analysis["contact/" + side] for side in ("left", "right")]
    force = sum(side["normal_force/maximum"][:] for side in sides)
    pushed = sum(numpy.maximum(0, -side["gap/minimum"][:]) for side in sides)
    return (mass["acceleration_x/peak_to_peak"][:] / ACCELERATION,
            mass["displacement_x/peak_to_peak"][:] / 2, force / ACCELERATION, pushed / 2)


def points(table, *overrides):
    analysis = table.run("bumpers.prm", "bumper-points", "Analyses=points",
                         *overrides)["analysis/points"]
    found = measures(analysis)
    middle = found[0].shape[1] // 2
    for case, (gap, stiffness, beta, forward, backward) in enumerate(POINTS):
        for name, values, wanted in zip(NAMES, found, forward):
            table.add(f"{name}, δ0 {gap}, λ {stiffness}, β {beta}, upward", wanted,
                      values[case, middle, 0], 1e-6, absolute=True)
        for name, values, wanted in zip(NAMES, found, backward or ()):
            table.add(f"{name}, δ0 {gap}, λ {stiffness}, β {beta}, downward", wanted,
                      values[case, middle, 1], 1e-6, absolute=True)


def best(table):
    """The peaks of the upward curve at the best stiffness, the one of eta_a between frequencies."""
    section = "Analysis/upward/Stepped sweep/"
    for gap, stiffness, wanted, paper in BEST:
        analysis = table.run("bumpers.prm", f"bumper-best-{gap}", "Analyses=upward",
                             f"Variables/delta0={gap}", f"Variables/lambda={stiffness}",
                             "Analysis/upward/Extreme values/Quantities="
                             "displacement, acceleration, gap, normal_force",
                             f"{section}First frequency={wanted[0] - 0.1} rad/s",
                             f"{section}Last frequency={wanted[0] + 0.1} rad/s",
                             f"{section}Points=101")["analysis/upward"]
        frequency = analysis["frequency"][:] * 2 * math.pi
        found = [values[:, 0] for values in measures(analysis)]
        top = int(found[0].argmax())
        place = f"δ0 {gap}, λ {stiffness}, upward"
        table.add(f"β of the largest η_a, {place}", wanted[0], frequency[top], 0.003,
                  paper=paper[0], absolute=True)
        for name, values, reference, printed in zip(NAMES, found, wanted[1:], paper[1:]):
            table.add(f"largest {name}, {place}", reference, values.max(), 1e-4, paper=printed,
                      absolute=True)


def coexisting(table, *overrides):
    """Two motions at the stiffness below which the paper sees none, and the opened gap."""
    around = table.run("bumpers.prm", "bumper-coexisting", "Analyses=around",
                       "Variables/delta0=0.4", "Variables/lambda=1.2",
                       "Variables/centre=1.2 rad/s", *overrides)["analysis/around"]
    acceleration = measures(around)[0]
    middle = len(acceleration) // 2
    for direction, name, wanted in [(0, "upward", .8863), (1, "downward", .4005)]:
        table.add(f"η_a, δ0 0.4, λ 1.2, β 1.2, {name}", wanted, acceleration[middle, direction],
                  6e-5, absolute=True)
    cycles = table.run("bumpers.prm", "bumper-cycles", "Analyses=cycles")["analysis/cycles"]
    table.add("gap at which the mass meets the bumper, δ0 0.0657506, λ 0.1, β 1.1, steady", .349,
              cycles["contact/right/stop_position/minimum"][0], 6e-4, paper=.34, absolute=True)


def curve(table, gap, stiffness):
    """Largest differences along a curve of 300 frequencies, the neighbours of jumps left out."""
    rows = table.reference(f"bumper-prc-delta{gap}-lambda{stiffness}.csv")
    section = "Analysis/curve/Stepped sweep/"
    analysis = table.run("bumpers.prm", f"bumper-curve-{gap}-{stiffness}", "Analyses=curve",
                         f"Variables/delta0={gap}", f"Variables/lambda={stiffness}",
                         f"{section}First frequency={rows[0]['beta']} rad/s",
                         f"{section}Last frequency={rows[-1]['beta']} rad/s",
                         f"{section}Points={len(rows)}")["analysis/curve"]
    found = measures(analysis)
    for direction, (prefix, name) in enumerate([("f", "upward"), ("b", "downward")]):
        for symbol, values, key in zip(NAMES, found, "adFB"):
            wanted = numpy.array([row[prefix + key] for row in rows])
            jump = numpy.abs(numpy.diff(wanted)) > 0.05
            near = numpy.convolve(numpy.append(jump, False) | numpy.insert(jump, 0, False),
                                  numpy.ones(5), "same") > 0
            settled = (analysis["steady"][:, direction] == 1) & ~near
            table.add_curve(f"{symbol}, δ0 {gap}, λ {stiffness}, {name}",
                            numpy.where(settled, values[:, direction] - wanted, numpy.nan), 2e-5)


def check(table):
    points(table)
    best(table)
    coexisting(table)
    for gap, stiffness in CURVES:
        curve(table, gap, stiffness)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
