#!/usr/bin/python3
"""Branches of periodic motions of the bumpers, of the bilinear oscillator and of one with a rigid stop:
first touches and motions with one impact in closed form, and special points by an independent shooting
method, whose motions are matrix exponentials between contact changes, and its saltation matrices.
"""
import cmath
import math

import numpy
import scipy.linalg
import scipy.optimize

from systems import Table

# By the independent shooting method, like all special points without a closed form below.
FORWARD_JUMP = 1.8145189659217
# stiffness, gap, loss of symmetry, kind of the loss of stability behind it, its place
CELLS = [(30, .02, 2.0711195301855545, 3, 1.55842703394111),
         (30, .05, 1.5596413455664755, 3, 1.3199861406613655),
         (30, .2, .402847384451892, 6, .3991936),
         (30, .4, .819764713624812, 6, .8155643),
         (100, .05, 1.8630046630958559, 3, 1.5605046100519648),
         (100, .1, 1.3063126737037138, 3, 1.1362841075038996),
         (100, .4, .8861633860032103, 3, .8738751443016682)]
FOLD, DOUBLING, LOSS_OF_SYMMETRY, GRAZE, GRAZING_FOLD = 1, 3, 4, 6, 7


def check(table):
    bumpers(table, table.run("bumpers.prm", "bumpers", "Analyses=branches")["analysis/branches"])
    cells(table, table.run("bumpers.prm", "cells", "Analyses=cells")["analysis/cells"])
    bilinear(table, table.run("bilinear-oscillator.prm", "bilinear",
                              "Analyses=branches")["analysis/branches"])
    rigid(table, table.run("verification/rigid-branches.prm", "rigid")["analysis/branches"])


def special(analysis, case, branch, *kinds, key="frequency"):
    """Keys, such as frequencies [Hz], of the special points of some kinds on a branch."""
    chosen = (numpy.isin(analysis["special/kind"][case], kinds)
              & (analysis["special/branch"][case] == branch))
    return numpy.sort(analysis["special/" + key][case][chosen])


def bumpers(table, branches):
    gap, damping = .4, .1
    #    the response without bumpers reaches them: |q| = delta0
    spread = 2 * damping / gap * math.sqrt((1 - gap ** 2) * (1 - damping ** 2))
    touches = [math.sqrt(1 - 2 * damping ** 2 + sign * spread) for sign in (-1, 1)]
    for case, stiffness in enumerate((1, 100)):
        found = 2 * math.pi * special(branches, case, 0, GRAZE, GRAZING_FOLD)
        for wanted in touches:
            table.add(f"bumpers, λ {stiffness}: β of a first touch", wanted,
                      found[numpy.abs(found - wanted).argmin()], 1e-12, absolute=True)
    table.add("bumpers, λ 100: the upper touch is a grazing fold", 1,
              len(special(branches, 1, 0, GRAZING_FOLD)), 0, absolute=True)
    for kind, branch, wanted, tolerance, name in [
            (LOSS_OF_SYMMETRY, 0, .886163386003, 1e-11, "loss of symmetry"),
            (FOLD, 1, .8863594151, 1e-10, "fold of the asymmetric motion"),
            (DOUBLING, 1, .8738751443, 1e-10, "period doubling of the asymmetric motion")]:
        found = 2 * math.pi * special(branches, 1, branch, kind)
        table.add(f"bumpers, λ 100: β of the {name}", wanted, found[-1], tolerance, absolute=True)
    unstable_between_the_jumps(table, branches)


def unstable_between_the_jumps(table, branches):
    """From the fold where sweeps jump down to the touch where they jump up."""
    fold = 2 * math.pi * special(branches, 1, 0, FOLD)[-1]
    table.add("bumpers, λ 100: β of the fold, the forward jump", FORWARD_JUMP, fold, 1e-10,
              absolute=True)
    main = branches["branch"][1] == 0
    way = [branches["special/arclength"][1][(branches["special/kind"][1] == kind)
                                            & (branches["special/branch"][1] == 0)][0]
           for kind in (FOLD, GRAZING_FOLD)]
    length = branches["arclength"][1]
    between = main & (length > min(way)) & (length < max(way))
    size = numpy.hypot(branches["multiplier_real"][1], branches["multiplier_imaginary"][1])
    table.add("bumpers, λ 100: points between both jumps with one unstable multiplier",
              between.sum(), ((size[between] > 1).sum(axis=1) == 1).sum(), 0, absolute=True)
    table.add("bumpers, λ 100: there are such points", 1, int(between.sum() > 5), 0, absolute=True)


def cells(table, branches):
    """Seven cells of the map whose sweeps meet motions of two and more periods."""
    for case, (stiffness, gap, symmetry, kind, loss) in enumerate(CELLS):
        name = f"bumpers, λ {stiffness}, δ0 {gap}: β of the "
        table.add(name + "loss of symmetry", symmetry,
                  2 * math.pi * special(branches, case, 0, LOSS_OF_SYMMETRY)[-1], 1e-10,
                  absolute=True)
        found = 2 * math.pi * special(branches, case, 1, kind)
        if kind == DOUBLING:
            table.add(name + "first period doubling behind it", loss, found[-1], 1e-10,
                      absolute=True)
            continue
        # bracketed by motions with and without the touch
        table.add(name + "touch that takes the stability behind it", loss, found[-1], 1e-5,
                  absolute=True)
        at = numpy.argmax(numpy.where(branches["special/kind"][case] == GRAZE,
                                      branches["special/frequency"][case], 0)
                          * (branches["special/branch"][case] == 1))
        sides = {branches[f"special/unstable_{side}"][case][at] for side in ("before", "after")}
        table.add(name + "same: multipliers beyond 1 on both sides", (0, 1), tuple(sorted(sides)), 0)


def relative_amplitude(frequency):
    """Of the two masses of the bilinear oscillator that do not touch, for a base of 10 mm."""
    omega = 2 * math.pi * frequency
    first, second = ((k + 1j * omega * c) / (k - m * omega ** 2 + 1j * omega * c)
                     for m, c, k in ((1.80, 31.14, 430.00), (2.46, 19.13, 417.78)))
    return .01 * abs(cmath.polar(second - first)[0])


def bilinear(table, branches):
    touch = scipy.optimize.brentq(lambda f: relative_amplitude(f) - .002, 1.1, 1.3, xtol=1e-14)
    table.add("bilinear, gap 2 mm: frequency of the first touch", touch,
              special(branches, 1, 0, GRAZE)[0], 1e-11, absolute=True)
    for case, gap, branch, place, wanted, name in [
            (1, "2 mm", 0, 0, 5.119442964266017, "period 1 to 2"),
            (1, "2 mm", 1, 0, 5.272232341537864, "period 2 to 4"),
            (1, "2 mm", 1, -1, 5.369348328090338, "period 4 back to 2"),
            (0, "0", 0, 0, 5.719354811608976, "period 1 to 2"),
            (0, "0", 1, 0, 5.970787989282385, "period 2 to 4")]:
        table.add(f"bilinear, gap {gap}: doubling, {name}, Hz", wanted,
                  special(branches, case, branch, DOUBLING)[place], 1e-11, absolute=True)
    table.add("bilinear, gap 2 mm: graze of period 2 above it, Hz", 5.3698106043,
              special(branches, 1, 1, GRAZE)[-1], 1e-10, absolute=True)
    quarter = branches["period_multiple"][1] == 4
    for end, wanted in [("begins", 5.272232341537864), ("ends", 5.369348328090338)]:
        at = branches["frequency"][1][quarter]
        table.add(f"bilinear, gap 2 mm: the branch of period 4 {end}, Hz", wanted,
                  at.min() if end == "begins" else at.max(), 1e-4 if end == "begins" else 1e-10,
                  absolute=True)


def rigid(table, branches):
    """One impact of speed v in each period: free vibration, answer to the force and both together
    are affine in v at the impact, so that the square of the force is a parabola of v; the flip solves
    a linear equation.
    """
    damping, restitution = .1, .8
    for case, w in enumerate((.5, .8, 1.25, 2)):
        flow = scipy.linalg.expm(numpy.array([[0, 1], [-1, -damping]]) * 2 * math.pi / w)
        free = numpy.linalg.solve(flow - numpy.eye(2), [0, 1 + restitution])
        forced, rate = -free[0], -restitution - free[1]  # at the impact, by v; at v = 0: 1 and 0
        share = lambda v, forced=forced, rate=rate, w=w: math.hypot(1 + forced * v, rate * v / w)
        into = flow[0, 1] * (1 + restitution)
        flip = into * w ** 2 / (1 + restitution ** 2 * numpy.linalg.det(flow)
                                - restitution * numpy.trace(flow)
                                + into * ((1 - w ** 2) * forced + damping * rate))
        fold = -forced / (forced ** 2 + (rate / w) ** 2)
        kinds, wanted, name = ((GRAZING_FOLD, FOLD), fold, "fold") if fold > 0 else (
            (GRAZE, DOUBLING), flip, "period doubling")
        touches, others = (special(branches, case, 0, kind, key="Variables.share")
                           for kind in kinds)
        near = lambda found, place: found[numpy.abs(found - place).argmin()]
        table.add(f"rigid stop, ω {w}: share of the force at the graze", 1, near(touches, 1), 1e-12)
        table.add(f"rigid stop, ω {w}: share at the {name} behind it", share(wanted),
                  near(others, share(wanted)), 1e-11)
        table.add(f"rigid stop, ω {w}: branches that end at bounds of the share", (0, 1),
                  tuple(sorted(branches["end/reason"][case])), 0)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
