#!/usr/bin/python3
"""Isolator with a damped elastic stop: both stable branches, and where a sweep jumps.

The references are periodic orbits found by shooting with located contact.
"""
import math

from systems import Table, nearest

table = Table(__file__)
response = table.run("isolator-stop.prm", "isolator-stop")["analysis/response"]
frequency = response["frequency"][:] * 2 * math.pi
peak = response["point/isolator.mass/displacement_x/peak_excursion"]
up, down = peak[:, 0], peak[:, 1]

at = nearest(frequency, 1.3)
table.add("large motion at λ = 1.3, max abs y", 2.03017588, up[at], 2e-7)
table.add("small motion at λ = 1.3, max abs y", 0.75308873, down[at], 2e-7)

# The whole stable branch, where the sweep's frequencies meet those of the reference.
branch = table.reference("isolator-branch-mu2-f0.52.csv")
stable = [row for row in branch if "mult1" in row and max(abs(row["mult1"]), abs(row["mult2"])) < 1]
