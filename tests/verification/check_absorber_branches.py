#!/usr/bin/python3
"""Motions of the vibro-impact damper with one impact on the left and two on the right in each period,
and where they lose their stability, against an independent shooting method: Runge-Kutta steps of order 8
with located contact changes, and the derivative of the map by differences.
"""
import math

import numpy

from systems import Table

DOUBLING, NEIMARK_SACKER = 3, 5
#   case, where the multiplier passes -1 [rad/s], which of the places of that kind
FREQUENCIES = [(0, "best damper", 7.23060497, 0), (1, "Table 3, row 1", 7.54189287, -1),
               (1, "Table 3, row 1", 7.35273556, 1)]


def check(table):
    results = table.run("vibro-impact-absorber.prm", "absorber", "Analyses=frequencies,chambers")
    frequencies, chambers = (results["analysis"][name] for name in ("frequencies", "chambers"))
    for case, name, wanted, place in FREQUENCIES:
        found = numpy.sort(2 * math.pi * places(frequencies, case, DOUBLING, "frequency"))
        table.add(f"{name}: frequency of a period doubling, rad/s", wanted, found[place], 2e-7,
                  absolute=True)
    table.add("best damper: chamber at which the period doubles, m", .0753113282,
              places(chambers, 0, DOUBLING, "Variables.C").min(), 2e-9, absolute=True)
    #   at the paper's chamber the chaotic motion has an unstable one beside it
    for case, name in ((1, "Table 3, row 1"), (2, "Table 3, row 2")):
        below = places(frequencies, case, DOUBLING, "frequency").max()
        table.add(f"{name}: 7.23 rad/s lies below the doubling", 1,
                  int(2 * math.pi * below > 7.23), 0, absolute=True)
        table.add(f"{name}: Neimark-Sacker points above it", 2,
                  len(places(frequencies, case, NEIMARK_SACKER, "frequency")), 0, absolute=True)
    largest = chambers["multiplier_real"][1][:, 0]
    largest = largest[numpy.isfinite(largest)]
    table.add("Table 3, row 1: multipliers below -1 at all chambers from 60 to 90 mm", len(largest),
              int((largest < -1.5).sum()), 0, absolute=True)
    table.add("Table 3, row 1: doublings over the chamber", 0,
              len(places(chambers, 1, DOUBLING, "Variables.C")), 0, absolute=True)
    for case in range(2):
        contact = chambers["contact"]
        here = numpy.nanargmin(numpy.abs(chambers["Variables.C"][case] - (.0753, .0747)[case]))
        table.add(f"{('best damper', 'Table 3, row 1')[case]}: impacts per period", (1, 2),
                  tuple(int(contact[side]["impacts"][case][here]) for side in ("left", "right")), 0)


def places(analysis, case, kind, key):
    return analysis["special/" + key][case][analysis["special/kind"][case] == kind]


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
