#!/usr/bin/python3
"""Electromechanical system with an impact element: clearances, response without impacts, start-up.

The references were integrated with located contact; peak-to-peak displacements of the casing in
space, in millimetres, from rest. Takes about a quarter of an hour.
"""
import numpy

from systems import Table, nearest

FILE = "electromechanical.prm"
CASING = "point/machine.casing/absolute_displacement_y/peak_to_peak"
SIDES = ("lower", "upper")
RECORDED = ("rotor/rotor/speed/mean", *(f"contact/{side}/{name}" for side in SIDES for name in
                                        ("impacts_per_period", "normal_force/maximum",
                                         "gap/minimum")))

# Clearance in mm, peak-to-peak of the casing, what it may differ by: in mm where the motion is
# chaotic, relative elsewhere.
TRAVEL = [*((c, wanted, 3e-5, "") for c, wanted in
            zip(range(1, 7), (3.0884, 3.0698, 2.8802, 2.7477, 2.6821, 2.6997))),
          (12, 6.80, 0.1, " (weak chaos)"),
          *((c, 14.435, 0.32, " (chaos, 14.13 to 14.74)") for c in range(16, 25)),
          (37, 15.095, 1e-3, ""),
          *((c, 14.9346, 1e-5, " (no impacts)") for c in (38, 39, 40))]


def clearances(table, grids=((1, 40, 40),)):
    """Over the clearance; `grids`: first, last and number of those that are run, in mm; 5 and 40
    must be among them."""
    keys = "Analysis/clearances/Parameter grid/Key clearance/"
    travel, struck, motions = {}, {}, {}
    for first, last, points in grids:
        sweep = table.run(FILE, f"clearances-{first}", "Analyses=clearances",
                          f"{keys}First={first} mm", f"{keys}Last={last} mm",
                          f"{keys}Points={points}")["analysis/clearances"]
        for i, c in enumerate(round(c * 1e3) for c in sweep["Variables.c"][:]):
            travel[c] = sweep[CASING][i, 0, 0] * 1e3
            struck[c] = any(sweep[f"contact/{side}/impacts"][i, 0, 0] for side in SIDES)
            motions[c] = {name: sweep[name][i, 0, 0] for name in RECORDED}
    for c, wanted, tolerance, name in TRAVEL:
        if c in travel:
            table.add(f"peak-to-peak of the casing, c = {c} mm{name}", wanted, travel[c], tolerance,
                      paper=2.1 if c == 5 else None, absolute=tolerance >= 0.1)
    table.add("clearance of the smallest motion, mm", 5, min(travel, key=travel.get), 0, paper=5,
              absolute=True)
    table.add("smallest clearance without impacts, mm", 38, min(c for c in struck if not struck[c]),
              0, paper=36, absolute=True)
    contacts(table, motions)


def contacts(table, motions):
    motion = motions[5]
    for side, wanted in [("lower", 1), ("upper", 0)]:
        table.add(f"{side} impacts per period, c = 5 mm", wanted,
                  motion[f"contact/{side}/impacts_per_period"], 0, absolute=True)
    table.add("largest contact force, c = 5 mm, N", 71307,
              motion["contact/lower/normal_force/maximum"], 3e-5)
    table.add("deepest penetration, c = 5 mm, µm", 58.1, -motion["contact/lower/gap/minimum"] * 1e6,
              1e-3)
    ranges = [(5, 4.607, -5.058, 2e-4), (40, 29.406, -36.210, 1e-4)]
    for c, largest, smallest, tolerance in (row for row in ranges if row[0] in motions):
        upper, lower = (motions[c][f"contact/{side}/gap/minimum"] * 1e3
                        for side in ("upper", "lower"))
        table.add(f"largest Y_t − Y, c = {c} mm, mm", largest, c - upper, tolerance)
        table.add(f"smallest Y_t − Y, c = {c} mm, mm", smallest, lower - c, tolerance)
    table.add("mean speed of the rotor, c = 5 mm, rad/s", 12.5, motion["rotor/rotor/speed/mean"],
              1e-5)


def other_frequency(table):
    for c, wanted in [(2, 5.153), (3, 5.284), (6, 6.268)]:
        motion = table.run(FILE, f"137-{c}", "Analyses=motion", f"Variables/c={c} mm",
                           "Variables/omega=137 rad/s")["analysis/motion"]
        table.add(f"peak-to-peak of the casing, 137 rad/s, c = {c} mm", wanted,
                  motion[CASING][0, 0] * 1e3, 2e-4)


def without_impacts(table, grids=((5, 200, 196),)):
    """Over the frequency; `grids`: first, last and number of those that are run, in rad/s, with two
    neighbours of each peak among them."""
    keys = "Analysis/free_frequencies/Parameter grid/Key omega/"
    runs = [table.run(FILE, f"free-{first}", "Analyses=free_frequencies",
                      "Integration/Relative tolerance=1e-7", f"{keys}First={first} rad/s",
                      f"{keys}Last={last} rad/s", f"{keys}Points={points}")
            ["analysis/free_frequencies"] for first, last, points in grids]
    omega = numpy.concatenate([run["Variables.omega"][:] for run in runs])
    linear, cubic = numpy.concatenate([run[CASING][:] * 1e3 for run in runs], axis=1)
    reference = {row["omega"]: row["p2pY_mm"]
                 for row in table.reference("electromechanical-frc-linear.csv")}
    difference = numpy.array([linear[i] / reference.get(round(frequency), numpy.nan) - 1
                              for i, frequency in enumerate(omega)])
    table.add_curve("peak-to-peak relative to the reference, k3 = 0", difference, 2e-4)
    for frequency, wanted in [(30, 7.0535), (78, 3.1552)]:
        table.add(f"k3 = 0, peak at {frequency} rad/s", wanted, linear[nearest(omega, frequency)],
                  2e-5)
        near = numpy.abs(omega - frequency) < 10
        table.add("place of this peak, rad/s", frequency, omega[near][linear[near].argmax()], 1e-9,
                  paper=frequency, absolute=True)
    for frequency, wanted in [(69, 12.918), (102, 14.9345), (103, 4.8338), (137, 20.697),
                              (138, 5.538)]:
        table.add(f"cubic spring, {frequency} rad/s", wanted, cubic[nearest(omega, frequency)], 1e-4)
    for frequency in (102, 137):
        near = numpy.abs(omega - frequency) < 15
        table.add(f"cubic spring, place of the peak near {frequency} rad/s", frequency,
                  omega[near][cubic[near].argmax()], 1e-9, paper=frequency, absolute=True)


def start_up(table):
    history = table.run(FILE, "history", "Analyses=history")["analysis/history"]
    table.add("largest torque of the motor while it starts, N m", 78.75,
              history["recorded/rotor/rotor/torque/maximum"][()], 1e-4)


def time_under_force(table):
    """Of the last impact within 40 s: from the first sample of its pulse to where the force comes to
    nothing, by the straight line through the last two samples before. The sides stay overlapped for
    longer, because the stop does not pull."""
    history = table.run(FILE, "pulses", "Analyses=history",
                        "Analysis/history/Transient/Duration=40 s",
                        "Analysis/history/Transient/Recorded pulses=1000")["analysis/history"]
    pulse = history["contact/lower/pulse"]
    time, force = pulse["time"][:], pulse["normal_force"][:]
    ends = numpy.flatnonzero(numpy.isnan(time))
    last = slice(ends[-2] + 1, ends[-1])
    time, force = time[last], force[last]
    after = numpy.flatnonzero(force[1:] <= 0)[0] + 1
    before, end = after - 2, after - 1
    released = time[end] + force[end] * (time[end] - time[before]) / (force[before] - force[end])
    table.add("time under force, c = 5 mm, ms", 0.379, (released - time[0]) * 1e3, 2e-3)


def check(table):
    clearances(table)
    other_frequency(table)
    without_impacts(table)
    start_up(table)
    time_under_force(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
