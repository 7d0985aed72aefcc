#!/usr/bin/python3
"""Random stops in the plane of the unfolding parameters: folds of the response by averaging and by its
expansion beside those of the exact branch, as confusion tables.

The points are drawn evenly from 0.05 < alpha_1 < 1, -1 < alpha_2 < (rho alpha_1/2)^2; each stop is followed by
the analysis `branch` of params/isolator-design.prm from the frequency ratio 0.9 on, where the folds are
those of the primary resonance.
"""
import math
import resource

import numpy

from studies import Study

POINTS, SEED, RHO = 200, 1, 8 / (math.pi * 1.05)
FOLD, GRAZING_FOLD = 1, 7
EXACT = (0, 1, 2, 3, 4)  # numbers of folds
DESIGN = "Analysis/design/Isolator design/"
GRID = "Analysis/branches/Parameter grid/"


def random_points():
    generator = numpy.random.default_rng(SEED)
    points = []
    while len(points) < POINTS:
        first, second = generator.uniform(0.05, 1), generator.uniform(-1, 1.5)
        if second < (RHO * first / 2) ** 2:
            points.append((first, second))
    return numpy.array(points)


def processor_time():
    """Of the runs so far [s]."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def listed(values):
    return ", ".join(repr(float(value)) for value in values)


def by_averaging(study, points):
    """Stops, and their folds by averaging and by its expansion."""
    analysis = study.run(
        "isolator-design.prm", "predicted", DESIGN + "Repeat=", DESIGN + "Stiffness key=",
        DESIGN + "Clearance key=", DESIGN + "First unfolding parameters=" + listed(points[:, 0]),
        DESIGN + "Second unfolding parameters=" + listed(points[:, 1]))["analysis/design/stop"]
    own = analysis["kind"][:] == 9
    return {name: analysis[name][:][own] for name in
            ("stiffness", "clearance", "region", "averaged/folds", "averaged/fold_ratio")}


def exact(study, stops):
    """The number of folds of each branch, and their frequency ratios."""
    branches = study.run("isolator-design.prm", "exact", "Analyses=branches",
                         GRID + "Cases=Variables/stiffness, Variables/clearance; "
                         + "; ".join(map(listed, zip(stops["stiffness"], stops["clearance"]))))
    branches = branches["analysis/branches"]
    if not numpy.isin(branches["end/reason"][:], (0, 1)).all() or branches["status"][:].any():
        raise SystemExit("a branch ends before it has reached its range")
    turns = numpy.isin(branches["special/kind"][:], (FOLD, GRAZING_FOLD))
    ratios = [sorted(row[turn])
              for row, turn in zip(branches["special/frequency"][:], turns)]
    return ratios


def confusion(study, name, predicted, found):
    for number in sorted(set(predicted)):
        study.row(f"{name}: {number}", *(str(sum((predicted == number) & (found == exact_number)))
                                         for exact_number in EXACT))


def main():
    study = Study(__file__, "folds predicted by", *(f"{number} exact" for number in EXACT))
    points = random_points()
    stops = by_averaging(study, points)
    began = processor_time()
    ratios = exact(study, stops)
    duration = processor_time() - began
    found = numpy.array([len(row) for row in ratios])
    averaged = stops["averaged/folds"].astype(int)
    confusion(study, "averaging", averaged, found)
    regions = numpy.array(["", "region I", "region II", "region III", "region IV"])
    confusion(study, "expansion", regions[stops["region"].astype(int)], found)
    study.finish()
    for point, guess, row in zip(points, averaged, ratios):
        if guess != len(row):
            print("differs:", point, guess, row)
    both = (averaged == 2) & (found == 2)
    errors = numpy.array([numpy.abs(guess / numpy.array(row) - 1) for guess, row, same in
                          zip(stops["averaged/fold_ratio"], ratios, both) if same])
    print("largest relative error of the lower and the upper fold:", errors.max(axis=0))
    print(f"{POINTS} branches took {duration:.0f} s of processor time")


if __name__ == "__main__":
    main()
