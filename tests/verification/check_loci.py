#!/usr/bin/python3
"""Loci of special points in two keys: closed forms, and values of an independent continuation.

usage: check_loci.py PROGRAM SOURCE [--all] [--page FILE] [--keep FOLDER] [--ranks N]

--all: also the gap of the bumpers at which hysteresis no longer begins at a cusp.
"""
import math

import numpy

from systems import Table, arguments_of_checks

CUSP, END_AT_GRAZE = 1, 2
DOUBLING = 3


def check(table):
    for part in (isolator, bumpers, bilinear, rigid, tori):
        part(table)
    if table.arguments.all:
        change_of_kind(table)


def isolator(table):
    """The cusp of the folds, from each of them; the grazing curve in closed form."""
    swap = ["Analyses=stiffness", "Analysis stiffness/Locus/Kinds=fold"]
    for key, first, last in (("First key", .5, 5), ("Second key", None, None)):
        path = f"Analysis stiffness/Locus/{key}/"
        swap += ([path + "Parameter=Variables/mu", path + f"First={first}", path + f"Last={last}",
                  path + "First frequency=", path + "Last frequency="] if first else
                 [path + "Parameter=", path + "First=", path + "Last=",
                  path + "First frequency=0.5", path + "Last frequency=2"])
    for name, values in (("both folds", ["Analyses=stiffness"]),
                         ("the upper fold", swap + ["Variables/lambda=1.3"]),
                         ("the lower fold", swap + ["Variables/lambda=1.231"])):
        locus = table.run("isolator-loci.prm", "isolator-loci", *values)["analysis/stiffness"]
        cusps = numpy.flatnonzero(locus["special/kind"][()] == CUSP)
        table.add_whole(f"isolator, cusps from {name}", [1], [len(cusps)])
        for symbol, key, wanted in (("λ", "frequency", 1.220670223706),
                                    ("μ", "Variables.mu", .782854460508)):
            table.add(f"isolator, cusp from {name}, {symbol}", wanted,
                      locus["special/" + key][cusps[0]], 1e-9, absolute=True)
    force = table.run("isolator-loci.prm", "isolator-force", "Analyses=force")["analysis/force"]
    touch = force["kind"][()] == 6
    omega = force["frequency"][touch]
    table.add("isolator, first touches against |1 − λ² + 2 i ζ₀ λ|, largest difference", 0,
              numpy.abs(force["Variables.f"][touch] - numpy.abs(1 - omega**2 + .02j * omega)).max(),
              1e-12, absolute=True)


def gap_run(table, name, gaps, analysis="loci"):
    """Folds of the bumpers for some gaps, in one run."""
    return table.run("bumpers.prm", name, f"Analyses={analysis}",
                     f"Analysis {analysis}/Parameter grid/Cases=Variables/delta0; "
                     + "; ".join(map(repr, gaps)))["analysis/loci"]


def lowest(loci, case, kind):
    """λ of the lowest special point of a kind; NaN where there is none."""
    here = loci["special/kind"][case] == kind
    return loci["special/Variables.lambda"][case][here].min(initial=numpy.inf)


def bumpers(table):
    """The stiffness from which on there is hysteresis."""
    own = table.run("bumpers.prm", "bumpers-loci", "Analyses=loci")["analysis/loci"]
    for case, gap, kind, wanted in ((0, .0657506, CUSP, 4.097080389485),
                                    (1, .198997, CUSP, 1.281140758158),
                                    (4, .4, END_AT_GRAZE, .216515125750),
                                    (5, .7, END_AT_GRAZE, .151813560040)):
        word = "a cusp" if kind == CUSP else "the end on the grazing curve"
        table.add(f"bumpers, δ0 = {gap}: λ_H, {word}", wanted, lowest(own, case, kind), 1e-8,
                  absolute=True)
        table.add_whole(f"bumpers, δ0 = {gap}: lowest point of the locus", [kind],
                        [CUSP if lowest(own, case, CUSP) < lowest(own, case, END_AT_GRAZE)
                         else END_AT_GRAZE])


def change_of_kind(table):
    """The gap of the bumpers at which the lowest point of the locus is no longer a cusp."""
    # Between both, the locus has a cusp and ends above it; where both meet the cusp goes. Their
    # distance falls as the square of the gap's, whose root is extrapolated to zero.
    gaps = [.2150, .2154]
    for _ in range(2):
        loci = gap_run(table, "bumpers-change", gaps)
        roots = [math.sqrt(lowest(loci, case, END_AT_GRAZE) - lowest(loci, case, CUSP))
                 for case in (0, 1)]
        change = gaps[1] + roots[1] * (gaps[1] - gaps[0]) / (roots[0] - roots[1])
        gaps = [change - .3 * (change - gaps[0]), change - .3 * (change - gaps[1])]
    loci = gap_run(table, "bumpers-sides", [change - 1e-5, change + 1e-5])
    table.add_whole("bumpers: cusps just below and above the change", [1, 0],
                    [numpy.isfinite(lowest(loci, case, CUSP)) for case in (0, 1)])
    # It falls by 40 for each unit of the gap.
    table.add("bumpers: λ_H goes on where it changes", lowest(loci, 0, CUSP),
              lowest(loci, 1, END_AT_GRAZE), 1e-3)
    print(f"bumpers: λ_H changes from a cusp to the grazing curve at δ0 = {change:.8f}")


def bilinear(table):
    """The first period doubling over the gap passes those of single gaps."""
    locus = table.run("bilinear-oscillator.prm", "bilinear-loci",
                      "Analyses=doublings_over_gap")["analysis/doublings_over_gap"]
    table.add("bilinear: gap where the locus begins, m", 0, locus["end/Variables.gap"][()].min(),
              1e-15, absolute=True)
    start = locus["arclength"][()] == 0
    table.add("bilinear: first period doubling, gap 2 mm, Hz", 5.119443,
              locus["frequency"][start][0], 5e-7, absolute=True)
    table.add("bilinear: first period doubling, gap 0, Hz", 5.719355,
              locus["frequency"][locus["Variables.gap"][()].argmin()], 5e-7, absolute=True)
    multipliers = locus["multiplier_real"][()]
    table.add("bilinear: largest distance of a multiplier from −1", 0,
              numpy.abs(multipliers + 1).min(axis=1).max(), 1e-8, absolute=True)
    for place in (len(multipliers) // 4, 3 * len(multipliers) // 4):
        gap = float(locus["Variables.gap"][place])
        branch = table.run("bilinear-oscillator.prm", "bilinear-branch", "Analyses=branch",
                           f"Variables/gap={gap!r} m", "Analysis branch/Branch/Switching levels=0")
        branch = branch["analysis/branch"]
        flips = branch["special/frequency"][()][branch["special/kind"][()] == DOUBLING]
        table.add(f"bilinear: first period doubling of the branch at {1e3 * gap:.3f} mm, Hz",
                  flips.min(), locus["frequency"][place], 1e-9, absolute=True)


def rigid(table):
    grazes = table.run("verification/rigid-grazes.prm", "rigid-grazes")["analysis/grazes"]
    first = grazes["locus"][()] == 0  # others begin behind it, where the motion already impacts
    omega = grazes["frequency"][first]
    table.add("rigid: lowest frequency", .29, omega.min(), 1e-15)
    table.add("rigid: highest frequency", 3, omega.max(), 1e-15)
    exact = numpy.sqrt((1 - omega**2)**2 + .01 * omega**2)
    table.add("rigid: grazing curve, largest difference from the closed form", 0,
              numpy.abs(grazes["Variables.A"][first] - exact).max(), 1e-12, absolute=True)


def tori(table):
    """|μ| = 1 by the periodic orbit of single points of the locus."""
    locus = table.run("verification/two-masses-tori.prm", "tori")["analysis/tori"]
    damping, frequency = locus["Variables.c"][()], locus["frequency"][()]
    table.add_whole("tori: the locus turns in the damping", [1],
                    [int(damping[0] < damping.max() > damping[-1])])
    for place in numpy.linspace(1, len(damping) - 2, 5).astype(int):
        state = ", ".join(map(repr, locus["state"][place].tolist()))
        orbit = table.run("verification/two-masses-tori.prm", "torus", "Analyses=orbit",
                          f"Variables/c={float(damping[place])!r}",
                          f"Variables/w={float(frequency[place])!r}",
                          f"Analysis orbit/Periodic orbit/State={state}")["analysis/orbit"]
        real, imaginary = (orbit[f"multiplier_{part}"][0] for part in ("real", "imaginary"))
        table.add(f"tori, c = {damping[place]:.4f}: modulus of the multiplier", 1,
                  math.hypot(real, imaginary), 1e-10)
        table.add(f"tori, c = {damping[place]:.4f}: its angle, rad",
                  float(locus["multiplier_angle"][place]), math.atan2(imaginary, real), 1e-8)


if __name__ == "__main__":
    options = arguments_of_checks()
    options.add_argument("--all", action="store_true", help="the change of kind as well")
    main = Table(__file__, options.parse_args())
    check(main)
    main.finish()
