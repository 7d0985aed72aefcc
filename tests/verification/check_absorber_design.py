#!/usr/bin/python3
"""Searches for the best vibro-impact damper of 25 kg at most, every optimum from 50 starts and after 3000
periods.

References: A1 of the paper's best damper by an independent event-located solver, and of the best light
damper that was found with it by hand.

usage: check_absorber_design.py PROGRAM SOURCE [--page FILE] [--keep FOLDER] [--ranks N]
"""
import numpy

from systems import Table

FILE = "absorber-design.prm"
PAPER = (25, 1568, 0.0753)

table = Table(__file__)


def best(analysis):
    """A1, m2, k2, C."""
    search = table.run(FILE, analysis, f"Analyses={analysis}")[f"analysis/{analysis}/derived"]
    return [float(search[f"best_{name}"][()]) for name in ("objective", "mass", "stiffness", "clearance")]


def from_all_starts(name, damper):
    """A1 from each start."""
    values = (f"Variables/{key}={value!r}" for key, value in zip(("m2", "k2", "C"), damper))
    results = table.run(FILE, f"verified-{name}", "Analyses=verified", *values)
    return results["analysis/verified/derived/A1_of_starts"][:]


def add_verified(name, damper, found, distinct):
    """Every start leads to one of so many values, and none of these to a smaller one than `found`."""
    starts = from_all_starts(name, damper)
    values = numpy.unique(numpy.round(starts, 7))
    table.add(f"motions that 50 starts lead to, {name}", (distinct,), (len(values),), 0)
    table.add(f"A1 after 3000 periods from most starts, {name}", found, float(numpy.median(starts)), 2e-4)
    table.add(f"A1 of the worst start, {name}", float(numpy.median(starts)), float(starts.max()),
              1e-6 if distinct == 1 else 0.02)


unbounded = best("unbounded")
table.add("unbounded search goes beyond 25 kg", (1,), (int(unbounded[1] > 25),), 0)
local = best("bounded")
# The simplex collapses at the bound of the mass, short of the paper's best: one of scipy 1.10 with the same
# first points, clipped to the box, comes to rest at (25, 1668, 0.0801) with 0.05299. Where it rests in the
# valley beside the bound, which falls by a quarter of a percent from there to the paper's, depends on rounding.
table.add("mass, local search from the paper's start", 25, local[1], 0.01)
table.add("A1, local search: from a percent below to two above the paper's", 0.05286, local[0], 0.02)
add_verified("local search", local[1:], local[0], 1)
add_verified("the paper's best", PAPER, 0.05286, 2)
restarted = best("restarted")
table.add("A1, local search with a new simplex from there", 0.05286, restarted[0], 2e-4)
table.add("clearance, local search with a new simplex", PAPER[2], restarted[3], 0.01)
everywhere, refined = best("everywhere"), best("refined")
table.add("A1, population in the whole box", 0.0466, everywhere[0], 2e-3)
table.add("mass, population in the whole box", 25, everywhere[1], 1e-3)
table.add("A1, refined by a local search", everywhere[0], refined[0], 1e-3)
add_verified("refined", refined[1:], refined[0], 1)
table.finish()
