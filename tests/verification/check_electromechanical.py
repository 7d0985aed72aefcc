#!/usr/bin/python3
"""Electromechanical system with an impact element: clearances, free response, start-up.

The references were integrated with located contact; peak-to-peak displacements of the casing in
space, in millimetres, from rest.
"""
import math

from systems import Table

table = Table(__file__)
FILE = "electromechanical.prm"
CASING = "point/machine.casing/absolute_displacement_y/peak_to_peak_excursion"

clearances = table.run(FILE, "clearances", "Analyses=clearances")["analysis/clearances"]
travel = clearances[CASING][:, 0, 0] * 1e3
PAPER = {5: 2.1}
for c, wanted in zip(range(1, 7), (3.0884, 3.0698, 2.8802, 2.7477, 2.6821, 2.6997)):
    table.add(f"peak-to-peak of the casing, c = {c} mm", wanted, travel[c - 1], 3e-5,
              paper=PAPER.get(c))
table.add("c = 12 mm (weak chaos)", 6.80, travel[11], 0.1, absolute=True)
for c in (16, 20, 24):
    table.add(f"c = {c} mm (chaos, 14.13 to 14.74)", 14.435, travel[c - 1], 0.32, absolute=True)
for c in (38, 39, 40):
    table.add(f"c = {c} mm (no impacts)", 14.9346, travel[c - 1], 1e-5)
table.add("clearance of the smallest motion, mm", 5, 1 + int(travel.argmin()), 0, paper=5,
          absolute=True)
lower = clearances["contact/lower"]
upper = clearances["contact/upper"]
table.add("lower impacts per period, c = 5 mm", 1, lower["impacts_per_period"][4, 0, 0], 0,
          absolute=True)
table.add("upper impacts per period, c = 5 mm", 0, upper["impacts_per_period"][4, 0, 0], 0, paper=1,
          absolute=True)
table.add("largest contact force, c = 5 mm, N", 71307, lower["normal_force/maximum"][4, 0, 0], 3e-5)
table.add("deepest penetration, c = 5 mm, µm", 58.1, -lower["gap/minimum"][4, 0, 0] * 1e6, 1e-3)
table.add("largest Y_t − Y, c = 5 mm, mm", 4.607, 5 - upper["gap/minimum"][4, 0, 0] * 1e3, 2e-4)
table.add("smallest Y_t − Y, c = 5 mm, mm", -5.058, lower["gap/minimum"][4, 0, 0] * 1e3 - 5, 2e-4)

reference = {round(row["omega"]): row for row in table.reference("electromechanical-frc-linear.csv")}


def free(omega, cubic):
    overrides = ("Analyses=free", f"Variables/omega={omega} rad/s", f"Variables/cubic={cubic} N/m^3")
    return table.run(FILE, f"free-{omega}-{cubic}", *overrides)["analysis/free"][CASING][0, 0] * 1e3


for omega in (30, 60, 78, 102, 150):
    table.add(f"without impacts, linear spring, {omega} rad/s", reference[omega]["p2pY_mm"],
              free(omega, "0"), 3e-4)
for omega, wanted in [(69, 12.918), (102, 14.9345), (103, 4.8338), (137, 20.697), (138, 5.538)]:
    table.add(f"without impacts, cubic spring, {omega} rad/s", wanted, free(omega, "6e10"), 1e-4)
table.finish()
