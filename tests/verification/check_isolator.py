#!/usr/bin/python3
"""Isolator with a damped elastic stop: both stable branches, and where a sweep jumps.

The references are periodic orbits found by shooting with located contact, and their folds.
"""
import math

import numpy

from systems import Table, nearest

table = Table(__file__)
response = table.run("isolator-stop.prm", "isolator-stop")["analysis/response"]
frequency = response["frequency"][:] * 2 * math.pi
peak = response["point/isolator.mass/displacement_x/peak_excursion"]
up, down = peak[:, 0], peak[:, 1]

at = nearest(frequency, 1.3)
table.add("large motion at λ = 1.3, max abs y", 2.03017588, up[at], 1e-7)
table.add("small motion at λ = 1.3, max abs y", 0.75308873, down[at], 1e-7)

# A jump is bracketed between two frequencies; its ends must lie close to the fold of the branch.
from_, to = (response["jump_" + end][:] * 2 * math.pi for end in ("from", "to"))
for direction, name, fold in [(0, "upward", 1.362748253), (1, "downward", 1.231279272)]:
    found = numpy.flatnonzero(numpy.isfinite(from_[:, direction]))
    table.add(f"jumps {name}", 1, len(found), 0, absolute=True)
    for i in found:
        middle = (from_[i, direction] + to[i, direction]) / 2
        table.add(f"jump {name}", fold, middle, 1e-4, paper=1.3629 if direction == 0 else 1.2312)
table.finish()
