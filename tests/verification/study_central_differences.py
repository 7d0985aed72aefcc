#!/usr/bin/python3
"""A mass between two bumpers by central differences, contact judged on the grid of the time steps.

A scheme of the kind the paper names: position by central differences, the bumper in contact moves
with the mass from the first grid point at which the gap is closed to the first at which the contact
force has changed its sign, the free bumper relaxes exactly. The column of errors compares the
largest acceleration excursion with the program, which locates both instants.
"""
import math

import numpy

import check_bumpers
from studies import Study

GAP, STIFFNESS, RATIO, BETA = 0.0657506, 50.0, 5.0, 0.5
PERIODS, RECORDED = 60, 8


def by_central_differences(steps_per_period):
    """eta_a over the last periods."""
    step = 2 * math.pi / BETA / steps_per_period
    bumper = 2 * check_bumpers.XI * RATIO
    relaxation = math.exp(-STIFFNESS / bumper * step)
    position, before = 0.0, 0.0
    pushed, touching = [0.0, 0.0], [False, False]  # right, left, along their own normals
    recorded = []
    for count in range(PERIODS * steps_per_period):
        ground = check_bumpers.GROUND * math.sin(BETA * count * step)
        load, damping, stiffness = -ground, 2 * check_bumpers.XI, 1.0
        for side, sign in ((0, 1), (1, -1)):
            touching[side] = touching[side] or sign * position - GAP >= pushed[side]
            if touching[side]:
                load += STIFFNESS * sign * GAP
                damping += bumper
                stiffness += STIFFNESS
        after = ((load - (stiffness - 2 / step**2) * position
                  - (1 / step**2 - damping / (2 * step)) * before)
                 / (1 / step**2 + damping / (2 * step)))
        velocity = (after - before) / (2 * step)
        recorded.append((after - 2 * position + before) / step**2 + ground)
        for side, sign in ((0, 1), (1, -1)):
            reach = sign * position - GAP
            if touching[side] and STIFFNESS * reach + bumper * sign * velocity > 0:
                pushed[side] = sign * after - GAP
            else:
                touching[side] = False
                pushed[side] *= relaxation
        position, before = after, position
    recorded = recorded[-RECORDED * steps_per_period:]
    return (max(recorded) - min(recorded)) / check_bumpers.ACCELERATION


def main():
    study = Study(__file__, "steps per period", "η_a", "relative error")
    exact = located(study)
    for steps in (100, 200, 500, 1000, 2000, 5000, 10000, 20000):
        found = by_central_differences(steps)
        study.row(str(steps), found, f"{found / exact - 1:+.1%}")
    study.row("located contact", exact, "")
    study.finish()


def located(study):
    """The same figure of the program, from rest over the same periods."""
    sweep = "Analysis/curve/Stepped sweep/"
    results = study.run("bumpers.prm", "located", "Analyses=curve", f"Variables/delta0={GAP}",
                        f"Variables/lambda={STIFFNESS}", f"{sweep}First frequency={BETA} rad/s",
                        f"{sweep}Last frequency={BETA} rad/s", f"{sweep}Points=1",
                        f"{sweep}Direction=forward", f"{sweep}Steadiness tolerance=0",
                        f"{sweep}Settling cycles={PERIODS - RECORDED}",
                        f"{sweep}Recorded cycles={RECORDED}")
    return float(numpy.squeeze(check_bumpers.measures(results["analysis/curve"])[0]))


if __name__ == "__main__":
    main()
