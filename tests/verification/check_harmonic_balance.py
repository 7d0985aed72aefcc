#!/usr/bin/python3
"""Harmonic balance: folds of the isolator with one harmonic are those of averaging, with many those of the
exact motions, with the order that the jump of the stop's force gives; and a beam before an elastic stop,
whose force has a kink, against its periodic orbit.
"""
import math

import numpy

from check_isolator_branches import FOLDS
from study_averaging import folds as averaged
from systems import Table

HARMONICS = (1, 3, 5, 9, 19, 39)
#         by the averaged equations, as published with the system
AVERAGED = {.5: (), 1: (1.226135, 1.244841), 2: (1.231127, 1.371611), 5: (1.232408, 1.681482)}
#         stiffness and force: folds by averaging and by shooting
DESIGNS = {(.471239, .509296): ((), ()), (.824668, 1.068355): ((), ()),
           (1.099557, .807083): ((1.324645, 1.328215), (1.324758, 1.326452)),
           (3.298672, 1.422456): (None, (1.548395, 1.755699))}
FOLD = 1
PEAK = "point/beam.head/displacement_x/largest"
BEAM_HARMONICS = (3, 9, 27)


# The folds lie in this range; longer steps do for them.
QUICKLY = ("Analysis/balance/Harmonic balance/First frequency=1.1",
           "Analysis/balance/Harmonic balance/Longest step=0.2")


def check(table):
    isolator = table.run("isolator-branches.prm", "isolator-balances",
                         "Analyses=averages, designs", *QUICKLY)["analysis"]
    for case, mu in enumerate(FOLDS):
        found = found_folds(isolator["averages"], case)
        averaging(table, f"μ {mu}", found[0], AVERAGED[mu], averaged(mu, .52))
        exact(table, f"μ {mu}", found, FOLDS[mu], 1e-10 if mu == 2 else 6e-7)
    for case, ((mu, force), (one, many)) in enumerate(DESIGNS.items()):
        found = found_folds(isolator["designs"], case)
        averaging(table, f"μ {mu}, f {force}", found[0], one, averaged(mu, force))
        exact(table, f"μ {mu}, f {force}", found, many, 6e-7)
    beam(table)


def found_folds(analysis, case):
    """λ of the folds for each number of harmonics."""
    places = analysis["special/frequency"][case]
    folds = analysis["special/kind"][case] == FOLD
    return [numpy.sort(places[row][folds[row]]) for row in range(len(places))]


def averaging(table, name, found, published, computed):
    table.add(f"{name}: folds, H = 1", len(computed), len(found), 0, absolute=True)
    for wanted, value in zip(computed, found):
        table.add(f"{name}: λ of a fold, H = 1, equations (7) and (8)", wanted, value, 1e-8,
                  absolute=True)
    for wanted, value in zip(published or (), found):
        table.add(f"{name}: λ of a fold, H = 1, as published", wanted, value, 1e-6, absolute=True)


def exact(table, name, found, wanted, digits):
    """The errors lie below an envelope H^-2.5 of the larger one of 3 and 5 harmonics until the digits of
    the reference end: they fall like H^-3, with a beat of the instants at which the stop is reached and
    left."""
    for harmonics, places in zip(HARMONICS[1:], found[1:]):
        table.add(f"{name}: folds, H = {harmonics}", len(wanted), len(places), 0, absolute=True)
    for number, reference in enumerate(wanted):
        first = max(abs(places[number] - reference) for places in found[1:3])
        for harmonics, places in zip(HARMONICS[3:], found[3:]):
            table.add(f"{name}: λ of fold {number + 1}, H = {harmonics}", reference,
                      places[number], first * (HARMONICS[2] / harmonics) ** 2.5 + digits,
                      absolute=True)


def beam(table):
    """At one frequency, where the force of the stop has a kink: what is left out of the displacement
    falls like H^-3, and the error of the largest one stays below it."""
    orbit = table.run("beam-harmonics.prm", "beam-orbit", "Analyses=orbit")["analysis/orbit"]
    wanted, estimates = orbit[PEAK][()], []
    table.add("beam: the orbit touches the stop", 1, float(orbit["contact/stop/gap/minimum"][()] < 0),
              0, absolute=True)
    balances = table.run(
        "beam-harmonics.prm", "beam-balances", "Analyses=balances",
        "Analysis/balance/Harmonic balance/First frequency=2.799 Hz",
        "Analysis/balance/Harmonic balance/Last frequency=2.801 Hz",
        "Analysis/balance/Harmonic balance/Most points=2",
        "Analysis/balances/Parameter grid/Key harmonics/Values="
        + ", ".join(map(str, BEAM_HARMONICS)))["analysis/balances"]
    for case, harmonics in enumerate(BEAM_HARMONICS):
        row = int(numpy.nanargmin(numpy.abs(balances["arclength"][case])))
        estimates.append(balances["point/beam.head/displacement_x/left_out"][case][row])
        table.add(f"beam: largest displacement in m, H = {harmonics}", wanted,
                  balances[PEAK][case][row], 2 * estimates[-1], absolute=True)
        if case:
            table.add(f"beam: order of what is left out, up to H = {harmonics}", 3,
                      math.log(estimates[-2] / estimates[-1]) / math.log(3), .7, absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
