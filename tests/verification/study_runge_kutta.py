#!/usr/bin/python3
"""The two masses by classical Runge-Kutta with a fixed step, as in the paper, without located contact.

The program has no such scheme; this one is written here for the comparison. All frequencies start
from rest and are integrated at once; amplitudes are read at the time steps of the last cycles. The
errors are those against the reference table, over the frequencies up to 4.8 Hz, where the motion
repeats after one period.
"""
import math

import numpy

from studies import Study

MASS, DAMPING = numpy.array([1.80, 2.46]), numpy.array([31.14, 19.13])
STIFFNESS, PENALTY, BASE, GAP = numpy.array([430.00, 417.78]), 1e5, 0.010, 0.002
DURATION, RECORDED = 60.0, 4.0  # seconds; the recorded part holds four periods of 1 Hz


def slope(time, state, omega):
    """state: displacements and velocities in space, (4, frequencies)."""
    base, speed = BASE * numpy.sin(omega * time), BASE * omega * numpy.cos(omega * time)
    gap = GAP + state[1] - state[0]
    force = numpy.where(gap <= 0, PENALTY * gap, 0.0)
    pull = (STIFFNESS[:, None] * (base - state[:2]) + DAMPING[:, None] * (speed - state[2:])
            + numpy.stack([force, -force]))
    return numpy.concatenate([state[2:], pull / MASS[:, None]])


def amplitudes(omega, step):
    """Half the peak-to-peak excursions in mm, (2, frequencies)."""
    state = numpy.zeros((4, len(omega)))
    highest = numpy.full((2, len(omega)), -math.inf)
    lowest = -highest
    for count in range(round(DURATION / step)):
        time = count * step
        first = slope(time, state, omega)
        second = slope(time + step / 2, state + step / 2 * first, omega)
        third = slope(time + step / 2, state + step / 2 * second, omega)
        fourth = slope(time + step, state + step * third, omega)
        state = state + step / 6 * (first + 2 * second + 2 * third + fourth)
        if time > DURATION - RECORDED:
            highest, lowest = numpy.maximum(highest, state[:2]), numpy.minimum(lowest, state[:2])
    return (highest - lowest) * 500


def main():
    study = Study(__file__, "step, ms", "largest error of A1", "at, Hz", "largest error of A2",
                  "at, Hz")
    rows = [row for row in study.reference("bilinear-g2.csv") if row["f"] <= 4.8]
    frequency = numpy.array([row["f"] for row in rows])
    wanted = numpy.array([[row[key] for row in rows] for key in ("A1f", "A2f")])
    for step in (2e-3, 1e-3, 5e-4, 2.5e-4):
        error = numpy.abs(amplitudes(2 * math.pi * frequency, step) / wanted - 1)
        worst = error.argmax(axis=1)
        study.row(f"{step * 1e3:g}", f"{error[0, worst[0]]:.2%}", f"{frequency[worst[0]]:.2f}",
                  f"{error[1, worst[1]]:.2%}", f"{frequency[worst[1]]:.2f}")
    study.finish()


if __name__ == "__main__":
    main()
