#!/usr/bin/python3
"""Isolator with a damped elastic stop: its periodic motions, stable and unstable, against an independent
shooting solver with located contact, row by row of its branch; and the folds and grazes of the branches
for four stiffnesses of the stop.
"""
import math

import numpy

from systems import Table

#          of lambda, by shooting; those for mu = 2 with all digits
FOLDS = {.5: (), 1: (1.226409, 1.242077), 2: (1.23127927195557, 1.36274825262772),
         5: (1.232439, 1.651114)}
#          where |y| = 1 without the stop, in closed form: (1 - l^2)^2 + (0.02 l)^2 = 0.52^2
GRAZES = [math.sqrt(1 - 2e-4 + sign * math.sqrt((1 - 2e-4) ** 2 - 1 + .52 ** 2))
          for sign in (-1, 1)]
FOLD, GRAZE, GRAZING_FOLD = 1, 6, 7
PEAK = "point/isolator.mass/displacement_x/largest"


def check(table):
    analyses = table.run("isolator-branches.prm", "isolator-branches")["analysis"]
    motions(table, analyses["orbits"])
    special_points(table, analyses["branches"])
    rows(table)


def motions(table, orbits):
    """At lambda = 1.3."""
    for case, (name, peak, stable) in enumerate([("small", .75308873, 1), ("middle", 1.39053298, 0),
                                                 ("large", 2.03017588, 1)]):
        table.add(f"max abs y at λ = 1.3, {name} motion", peak, orbits[PEAK][case], 1e-8)
        table.add(f"stable, {name} motion", stable, orbits["stable"][case], 0, absolute=True)
    for number, wanted in enumerate((1.72416, .21243)):
        table.add(f"multiplier {number + 1} of the middle motion", wanted,
                  orbits["multiplier_real"][1, number], 5e-6, absolute=True)


def special_points(table, branches):
    kinds = branches["special/kind"][:]
    places = branches["special/frequency"][:]
    for case, (stiffness, folds) in enumerate(FOLDS.items()):
        found = numpy.sort(places[case][kinds[case] == FOLD])
        table.add(f"folds, μ {stiffness}", len(folds), len(found), 0, absolute=True)
        tolerance = 1e-10 if stiffness == 2 else 6e-7
        for wanted, value in zip(folds, found):
            table.add(f"λ of a fold, μ {stiffness}", wanted, value, tolerance, absolute=True)
        found = numpy.sort(places[case][numpy.isin(kinds[case], (GRAZE, GRAZING_FOLD))])
        table.add(f"grazes, μ {stiffness}", 2, len(found), 0, absolute=True)
        for wanted, value in zip(GRAZES, found):
            table.add(f"λ of a graze, μ {stiffness}", wanted, value, 1e-10, absolute=True)


def multiplier(text):
    """"(0.1+0.2j)" or "1.7"."""
    return complex(text.strip("()"))


def rows(table):
    """From the state of each row, disturbed, Newton's method leads back to it."""
    reference = table.texts("isolator-branch-mu2-f0.52.csv")
    listed = {key: [float(row[key]) for row in reference] for key in ("lambda", "y0", "v0")}
    starts = [f"{y + 1e-4!r}, {v - 1e-4!r}, {at!r}"
              for y, v, at in zip(listed["y0"], listed["v0"], listed["lambda"])]
    cases = "Variables/y0, Variables/v0, Variables/lambda; " + "; ".join(starts)
    orbits = table.run("isolator-branches.prm", "isolator-rows", "Analyses=orbits",
                       f"Analysis/orbits/Parameter grid/Cases={cases}")["analysis/orbits"]
    table.add("rows that failed", 0, numpy.count_nonzero(orbits["status"][:]), 0, absolute=True)
    for name, values in [("max|y|", orbits[PEAK][:]), ("y0", orbits["state"][:, 0]),
                         ("v0", orbits["state"][:, 1])]:
        table.add(f"{name} of {len(reference)} rows, largest difference", 0,
                  numpy.abs(values - [float(row[name]) for row in reference]).max(), 1e-8,
                  absolute=True)
    found = orbits["multiplier_real"][:] + 1j * orbits["multiplier_imaginary"][:]
    wanted = numpy.array([(multiplier(row["mult1"]), multiplier(row["mult2"]))
                          for row in reference])
    apart = [numpy.abs(found - order).max(axis=1) for order in (wanted, wanted[:, ::-1])]
    table.add(f"multipliers of {len(reference)} rows, largest difference", 0,
              numpy.minimum(*apart).max(), 1e-7, absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
