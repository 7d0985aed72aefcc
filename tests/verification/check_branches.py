#!/usr/bin/python3
"""Branches of periodic motions of the bumpers and of the bilinear oscillator: closed forms of the first
touches, and special points by an independent continuation.
"""
import cmath
import math

import numpy
import scipy.optimize

from systems import Table

FOLD, DOUBLING, LOSS_OF_SYMMETRY, GRAZE, GRAZING_FOLD = 1, 3, 4, 6, 7


def check(table):
    bumpers(table, table.run("bumpers.prm", "bumpers", "Analyses=branches")["analysis/branches"])
    bilinear(table, table.run("bilinear-oscillator.prm", "bilinear",
                              "Analyses=branches")["analysis/branches"])


def special(analysis, case, branch, *kinds):
    """Frequencies [Hz] of the special points of some kinds on a branch."""
    chosen = (numpy.isin(analysis["special/kind"][case], kinds)
              & (analysis["special/branch"][case] == branch))
    return numpy.sort(analysis["special/frequency"][case][chosen])


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
    for case, gap, wanted, tolerance in [(1, "2 mm", 5.1175, .0025), (0, "0", 5.72, .005)]:
        table.add(f"bilinear, gap {gap}: first period doubling, Hz", wanted,
                  special(branches, case, 0, DOUBLING)[0], tolerance, absolute=True)
    for kind, wanted, name in [(DOUBLING, 5.3693483281, "flip where period 4 ends"),
                               (GRAZE, 5.3698106043, "graze of period 2 above it")]:
        table.add(f"bilinear, gap 2 mm: {name}, Hz", wanted, special(branches, 1, 1, kind)[-1],
                  1e-10, absolute=True)
    quarter = branches["period_multiple"][1] == 4
    table.add("bilinear, gap 2 mm: period 4 from 5.27 Hz", 5.27,
              branches["frequency"][1][quarter].min(), .005, absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
