#!/usr/bin/python3
"""Isolator with a damped elastic stop: both stable motions, and where sweeps jump.

The references are periodic orbits found by shooting with located contact, and their folds. The
paper prints no figures of its own to compare with.
"""

import numpy

from systems import Table, nearest

#        mu, f, exact folds: where an upward and a downward sweep jump; none
STOPS = [(.5, .52, None), (1, .52, (1.242077, 1.226409)), (2, .52, (1.362748253, 1.231279272)),
         (5, .52, (1.651114, 1.232439))]
#          the same for points in the plane of the unfolding parameters
DESIGNS = [(.471239, .509296, None), (.824668, 1.068355, None),
           (1.099557, .807083, (1.326452, 1.324758)), (3.298672, 1.422456, (1.755699, 1.548395))]

ENDS = ("from", "to")
STOPS_OF_ANALYSIS = {"folds": STOPS, "designs": DESIGNS}


def check(table):
    analyses = table.run("isolator-stop.prm", "isolator-stop",
                         "Analyses=response, motions, folds, designs")["analysis"]
    motions(table, analyses["response"], analyses["motions"])
    for name, stops in STOPS_OF_ANALYSIS.items():
        for case, (stiffness, force, folds) in enumerate(stops):
            ends = [analyses[name]["jump_" + end][case] for end in ENDS]
            jumps(table, ends, f"μ {stiffness}, f {force}", folds)


def motions(table, response, chosen):
    """The small and the large motion, by the sweep and from two initial conditions."""
    peak = "point/isolator.mass/displacement_x/largest"
    at = nearest(response["frequency"][:], 1.3)
    for name, wanted, direction in [("large", 2.03017588, 0), ("small", .75308873, 1)]:
        table.add(f"max abs y at λ = 1.3, {name} motion, sweep", wanted,
                  response[peak][at, direction], 1e-7)
        table.add(f"max abs y at λ = 1.3, {name} motion, from its initial condition", wanted,
                  chosen[peak][direction], 1e-7)


def jumps(table, brackets, name, folds):
    """`brackets`: lower and upper ends of the jumps over frequency and direction. A jump is bracketed
    to 2e-6; close to a fold the motion needs its time to leave it."""
    found = {}
    for direction, word in enumerate(("upward", "downward")):
        ends = [end[:, direction] for end in brackets]
        places = numpy.flatnonzero(numpy.isfinite(ends[0]))
        table.add(f"jumps {word}, {name}", 0 if folds is None else 1, len(places), 0, absolute=True)
        found[word] = [(ends[0][i] + ends[1][i]) / 2 for i in places]
    for fold, (word, places) in zip(folds or (), found.items()):
        for place in places:
            table.add(f"λ of the jump {word}, {name}", fold, place, 4e-6, absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
