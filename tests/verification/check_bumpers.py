#!/usr/bin/python3
"""A mass between two bumpers: steady points and whole response curves.

The references were computed with an exact event-located solver. The normalisation is that of the
paper: accelerations and forces by the largest free acceleration, displacements by the largest free
displacement, which is 1 m in the parameter file.
"""
import math

import numpy

from systems import Table, nearest

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


def measures(analysis):
    """eta_a, eta_d, eta_F, eta_B over all points of an analysis."""
    mass = analysis["point/oscillator.mass"]
    sides = [analysis["contact/" + side] for side in ("left", "right")]
    force = sum(side["normal_force/maximum"][:] for side in sides)
    pushed = sum(numpy.maximum(0, -side["gap/minimum"][:]) for side in sides)
    return (mass["acceleration_x/peak_to_peak_excursion"][:] / ACCELERATION,
            mass["displacement_x/peak_to_peak_excursion"][:] / 2, force / ACCELERATION, pushed / 2)


def points(table):
    analysis = table.run("bumpers.prm", "bumper-points", "Analyses=points")["analysis/points"]
    found = measures(analysis)
    middle = found[0].shape[1] // 2
    for case, (gap, stiffness, beta, forward, backward) in enumerate(POINTS):
        for name, values, wanted in zip(NAMES, found, forward):
            table.add(f"{name}, δ0 {gap}, λ {stiffness}, β {beta}, upward", wanted,
                      values[case, middle, 0], 1e-6, absolute=True)
        for name, values, wanted in zip(NAMES, found, backward or ()):
            table.add(f"{name}, δ0 {gap}, λ {stiffness}, β {beta}, downward", wanted,
                      values[case, middle, 1], 1e-6, absolute=True)


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
            difference = numpy.abs(values[:, direction] - wanted)[settled]
            table.add(f"{symbol}, δ0 {gap}, λ {stiffness}, {name}: 99 % of {settled.sum()} points "
                      "differ by less than", 0, numpy.quantile(difference, 0.99), 2e-5,
                      absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    points(main)
    for delta0, ratio in [("0.4", "1"), ("0.7", "2"), ("0.0657506", "5")]:
        curve(main, delta0, ratio)
    main.finish()
