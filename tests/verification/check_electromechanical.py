#!/usr/bin/python3
"""Electromechanical system with an impact element: clearances, response without impacts, start-up.

The references were integrated with located contact; peak-to-peak displacements of the casing in
space, in millimetres, from rest. Takes about a quarter of an hour.
"""
import numpy

from systems import Table, nearest

table = Table(__file__)
FILE = "electromechanical.prm"
CASING = "point/machine.casing/absolute_displacement_y/peak_to_peak_excursion"


def clearances():
    sweep = table.run(FILE, "clearances", "Analyses=clearances")["analysis/clearances"]
    travel = sweep[CASING][:, 0, 0] * 1e3
    lower, upper = sweep["contact/lower"], sweep["contact/upper"]
    for c, wanted in zip(range(1, 7), (3.0884, 3.0698, 2.8802, 2.7477, 2.6821, 2.6997)):
        table.add(f"peak-to-peak of the casing, c = {c} mm", wanted, travel[c - 1], 3e-5,
                  paper=2.1 if c == 5 else None)
    table.add("c = 12 mm (weak chaos)", 6.80, travel[11], 0.1, absolute=True)
    for c in range(16, 25):
        table.add(f"c = {c} mm (chaos, 14.13 to 14.74)", 14.435, travel[c - 1], 0.32,
                  absolute=True)
    table.add("c = 37 mm", 15.095, travel[36], 1e-3)
    for c in (38, 39, 40):
        table.add(f"c = {c} mm (no impacts)", 14.9346, travel[c - 1], 1e-5)
    table.add("clearance of the smallest motion, mm", 5, 1 + int(travel.argmin()), 0, paper=5,
              absolute=True)
    hits = lower["impacts"][:, 0, 0] + upper["impacts"][:, 0, 0]
    table.add("smallest clearance without impacts, mm", 38, 1 + int(numpy.argmin(hits > 0)), 0,
              paper=36, absolute=True)
    table.add("lower impacts per period, c = 5 mm", 1, lower["impacts_per_period"][4, 0, 0], 0,
              absolute=True)
    table.add("upper impacts per period, c = 5 mm", 0, upper["impacts_per_period"][4, 0, 0], 0,
              paper=1, absolute=True)
    table.add("largest contact force, c = 5 mm, N", 71307, lower["normal_force/maximum"][4, 0, 0],
              3e-5)
    table.add("deepest penetration, c = 5 mm, µm", 58.1, -lower["gap/minimum"][4, 0, 0] * 1e6, 1e-3)
    table.add("largest Y_t − Y, c = 5 mm, mm", 4.607, 5 - upper["gap/minimum"][4, 0, 0] * 1e3, 2e-4)
    table.add("smallest Y_t − Y, c = 5 mm, mm", -5.058, lower["gap/minimum"][4, 0, 0] * 1e3 - 5,
              2e-4)
    table.add("largest Y_t − Y, c = 40 mm, mm", 29.406, 40 - upper["gap/minimum"][39, 0, 0] * 1e3,
              1e-4)
    table.add("smallest Y_t − Y, c = 40 mm, mm", -36.210, lower["gap/minimum"][39, 0, 0] * 1e3 - 40,
              1e-4)
    table.add("mean speed of the rotor, c = 5 mm, rad/s", 12.5,
              sweep["rotor/rotor/speed/mean"][4, 0, 0], 1e-5)


def other_frequency():
    for c, wanted in [(2, 5.153), (3, 5.284), (6, 6.268)]:
        motion = table.run(FILE, f"137-{c}", "Analyses=motion", f"Variables/c={c} mm",
                           "Variables/omega=137 rad/s")["analysis/motion"]
        table.add(f"peak-to-peak of the casing, 137 rad/s, c = {c} mm", wanted,
                  motion[CASING][0, 0] * 1e3, 2e-4)


def without_impacts():
    grid = table.run(FILE, "free", "Analyses=free_frequencies",
                     "Integration/Relative tolerance=1e-7")["analysis/free_frequencies"]
    omega = grid["Variables.omega"][:]
    linear, cubic = grid[CASING][:] * 1e3
    reference = {row["omega"]: row["p2pY_mm"]
                 for row in table.reference("electromechanical-frc-linear.csv")}
    both = [i for i, frequency in enumerate(omega) if round(frequency) in reference]
    difference = [abs(linear[i] / reference[round(omega[i])] - 1) for i in both]
    table.add(f"k3 = 0, {len(both)} frequencies: largest difference", 0, max(difference), 2e-4,
              absolute=True)
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


def start_up():
    history = table.run(FILE, "history", "Analyses=history")["analysis/history"]
    table.add("largest torque of the motor while it starts, N m", 78.75,
              history["recorded/rotor/rotor/torque/maximum"][()], 1e-4)


def time_under_force():
    """Of the last impact within 40 s: from the first sample of its pulse to the first one without
    force. The sides stay overlapped for longer, because the stop does not pull."""
    history = table.run(FILE, "pulses", "Analyses=history",
                        "Analysis/history/Transient/Duration=40 s",
                        "Analysis/history/Transient/Recorded pulses=1000")["analysis/history"]
    pulse = history["contact/lower/pulse"]
    time, force = pulse["time"][:], pulse["normal_force"][:]
    ends = numpy.flatnonzero(numpy.isnan(time))
    last = slice(ends[-2] + 1, ends[-1])
    released = numpy.flatnonzero(force[last][1:] <= 0)[0] + 1
    table.add("time under force, c = 5 mm, ms", 0.379,
              (time[last][released] - time[last][0]) * 1e3, 2e-3)


if __name__ == "__main__":
    clearances()
    other_frequency()
    without_impacts()
    start_up()
    time_under_force()
    table.finish()
