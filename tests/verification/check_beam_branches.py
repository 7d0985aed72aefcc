#!/usr/bin/python3
"""Periodic motions of two impacting beams: where the free vibration first touches, in closed form; one
beam against a stop, whose motions are those of the pair taken relative to one another; stepped sweeps
and settled motions on the stable parts; with --all-modes the special points with more modes.
"""
import math
import pathlib

import numpy
import scipy.interpolate
import scipy.optimize

from systems import Table, arguments_of_checks

FOLD, DOUBLING, NEIMARK_SACKER, GRAZE, GRAZING_FOLD = 1, 3, 5, 6, 7
NAMES = {FOLD: "fold", DOUBLING: "period doubling", NEIMARK_SACKER: "Neimark–Sacker"}
PEAK = "point/left.head/displacement_x/largest"
STOP = pathlib.Path("verification") / "beam-on-stop.prm"
#        beam and head, base acceleration, damping ratio, clearance
LENGTH, BENDING, MASS, HEAD = .3, 206e9 * .03 * .00075 ** 3 / 12, 7850 * .03 * .00075, .0577114
PUSH, DAMPING, CLEARANCE = .5, .02, 5e-3


def check(table, all_modes):
    pair = table.run("impacting-beams-branches.prm", "pair", "Analyses=branch,sweep,orbits")["analysis"]
    critical_multipliers(table, pair["branch"])
    first_touch(table, pair["branch"], 3)
    one_beam(table, pair["branch"])
    settled(table, pair)
    swept(table, "pair", pair)
    for law in ("linear penalty", "newton restitution"):
        run = table.run(STOP, law, f"Contact/heads/Law={law}",
                        "Analysis branch/Branch/Longest step=.03",
                        "Contact/heads/Linear penalty/Stiffness=2 N/mm",
                        "Contact/heads/Newton restitution/Restitution coefficient=.7")["analysis"]
        first_touch(table, run["branch"], 3, f", {law}")
        swept(table, law, run)
    if all_modes:
        modes(table)


def special(branch, *kinds):
    """Frequencies [Hz] of the special points of some kinds."""
    return numpy.sort(branch["special/frequency"][numpy.isin(branch["special/kind"][:], kinds)])


def apart(branch, kind):
    """Those that are not beside the first touch: where an elastic contact becomes stiff within a
    shallow touch, the grazing fold of a rigid one is a fold behind the graze."""
    touch = special(branch, GRAZE, GRAZING_FOLD)[-1]
    places = special(branch, kind)
    return places[numpy.abs(places - touch) > 1e-4]


def critical_multipliers(table, branch):
    """1 at folds, -1 at period doublings, of modulus 1 at Neimark-Sacker points."""
    multipliers = branch["special/multiplier_real"][:] + 1j * branch["special/multiplier_imaginary"][:]
    for kind, place, found in zip(branch["special/kind"][:], branch["special/frequency"][:],
                                  multipliers):
        if kind not in NAMES:
            continue
        missing = {FOLD: abs(found - 1), DOUBLING: abs(found + 1),
                   NEIMARK_SACKER: abs(abs(found[found.imag != 0]) - 1)}[kind].min()
        table.add(f"critical multiplier at the {NAMES[kind]} at {place:.4f} Hz, off by", 0, missing,
                  1e-6, absolute=True)


def beam_modes(count):
    """Angular frequency, and deflection of the tip over acceleration of the base at frequency zero
    times the square of the former, of a clamped beam with a head."""
    ratio = HEAD / (MASS * LENGTH)
    nodes, weights = numpy.polynomial.legendre.leggauss(200)
    nodes, weights = (nodes + 1) / 2, weights / 2

    def characteristic(z):
        return ((1 + math.cos(z) * math.cosh(z) + ratio * z * (
            math.cos(z) * math.sinh(z) - math.sin(z) * math.cosh(z))) / math.cosh(z))

    for j in range(count):
        bounds = (.5, 1.8) if j == 0 else (j * math.pi + .3, (j + .5) * math.pi + .3)
        z = scipy.optimize.brentq(characteristic, *bounds, xtol=1e-14)
        s = (math.cosh(z) + math.cos(z)) / (math.sinh(z) + math.sin(z))

        def shape(x, z=z, s=s):
            return numpy.cosh(z * x) - numpy.cos(z * x) - s * (numpy.sinh(z * x) - numpy.sin(z * x))

        mass = MASS * LENGTH * weights @ shape(nodes) ** 2 + HEAD * shape(1) ** 2
        participation = MASS * LENGTH * weights @ shape(nodes) + HEAD * shape(1)
        yield z ** 2 * math.sqrt(BENDING / (MASS * LENGTH ** 4)), shape(1) * participation / mass


def first_touch(table, branch, count, name=""):
    """Where the amplitude of the head, base and all, is the clearance."""
    own = list(beam_modes(count))

    def above(frequency):
        w = 2 * math.pi * frequency
        return abs(-PUSH / w ** 2 - PUSH * sum(
            share / (o * o - w * w + 2j * DAMPING * o * w) for o, share in own)) - CLEARANCE

    wanted = scipy.optimize.brentq(above, 3.1, 3.6, xtol=1e-14)
    found = special(branch, GRAZE, GRAZING_FOLD)
    table.add(f"first touch, Hz, {count} modes{name}", wanted, found[-1], 1e-7)


def one_beam(table, pair):
    """The pair relative to one another is one beam with twice the contact force; and nearly one that
    meets a rigid stop, since contacts are short."""
    soft = table.run(STOP, "one beam", "Analyses=branch")["analysis/branch"]
    rigid = table.run(STOP, "rigid", "Analyses=branch", "Contact/heads/Law=newton restitution",
                      "Contact/heads/Newton restitution/Restitution coefficient=.7")["analysis/branch"]
    for kind, name in NAMES.items():
        places = apart(pair, kind)
        for other, tolerance, which in ((soft, 1e-7, "one beam"), (rigid, 2e-4, "rigid stop")):
            found = apart(other, kind)
            table.add_whole(f"number of points, {name}, {which}", (len(places),), (len(found),))
            for wanted, value in zip(places, found):
                table.add(f"{name}, Hz: {which} against the pair", wanted, value, tolerance)


def settled(table, analyses):
    """Newton's method from settled motions, against the sweep that holds the same motion."""
    orbits, sweep = analyses["orbits"], analyses["sweep"]
    for frequency, peak in zip(orbits["Variables.f"][:], orbits[PEAK][:]):
        row = numpy.abs(sweep["frequency"][:] - frequency).argmin()
        found = sweep[PEAK][row]
        table.add(f"peak of the left head at {frequency:g} Hz, m", peak,
                  found[numpy.abs(found - peak).argmin()], 3e-6)


def swept(table, name, analyses):
    """Steady motions of period one of both sweeps on the branch where it is stable, up to the first
    unstable point. A cubic spline over the arclength goes between the points; where another peak
    becomes the largest it has an error that falls with their distance."""
    branch, sweep = analyses["branch"], analyses["sweep"]
    arclength, stable = branch["arclength"][:], branch["stable"][:] == 1
    values = numpy.column_stack([branch["frequency"][:], branch[PEAK][:]])
    spline = scipy.interpolate.CubicSpline(arclength, values)
    fine = numpy.linspace(arclength[:-1], arclength[1:], 40, axis=1)
    line = spline(fine.ravel()).reshape(*fine.shape, 2)
    line = line[stable[:-1] | stable[1:]]
    differences = []
    for direction in (0, 1):
        for frequency, peak, multiple in zip(sweep["frequency"][:], sweep[PEAK][:, direction],
                                             sweep["period_multiple"][:, direction]):
            differences.append(distance(line, frequency, peak) if multiple == 1 else math.nan)
    table.add_curve(f"{name}: peaks of the sweeps from the branch", numpy.array(differences), 3e-3)
    table.add(f"{name}: median of these differences", 0,
              numpy.nanmedian(numpy.abs(differences)), 3e-5, absolute=True)


def distance(line, frequency, peak):
    """Relative difference from the nearest of the stable motions at a frequency."""
    x, y = line[..., 0], line[..., 1]
    left, right = (x[:, :-1], y[:, :-1]), (x[:, 1:], y[:, 1:])
    # The end of a branch is that of the sweep up to rounding.
    across = (left[0] - frequency) * (right[0] - frequency) <= 1e-15 * frequency ** 2
    share = (frequency - left[0][across]) / (right[0][across] - left[0][across])
    found = left[1][across] + share * (right[1][across] - left[1][across])
    return (found[numpy.abs(found - peak).argmin()] if len(found) else math.inf) / peak - 1


def modes(table):
    """Folds and period doublings with the number of modes; differences shrink."""
    counts = (1, 3, 10, 20)
    runs = [table.run("impacting-beams-branches.prm", f"{count} modes", "Analyses=branch",
                      f"Variables/modes={count}")["analysis/branch"] for count in counts]
    for count, run in zip(counts, runs):
        first_touch(table, run, count)
    folds = [special(run, FOLD)[-1] for run in runs]
    for count, near, far in zip(counts[1:], folds[1:], folds):
        table.add(f"upper fold, Hz, {count} modes against fewer", near, far, .06)
    steps = numpy.abs(numpy.diff(folds))
    table.add("steps of the fold from 1 to 3, 10, 20 modes fall", 1,
              float((steps[1:] < .3 * steps[:-1]).all()), 0, absolute=True)
    doublings = [special(run, DOUBLING) for run in runs[1:]]
    for ten, twenty in zip(doublings[1], doublings[2]):
        table.add("period doubling, Hz, 20 modes against 10", ten, twenty, 1e-3)


if __name__ == "__main__":
    PARSER = arguments_of_checks()
    PARSER.add_argument("--all-modes", action="store_true", help="with 1, 3, 10 and 20 modes")
    ARGUMENTS = PARSER.parse_args()
    TABLE = Table(__file__, ARGUMENTS)
    check(TABLE, ARGUMENTS.all_modes)
    TABLE.finish()
