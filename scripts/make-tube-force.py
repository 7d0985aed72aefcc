#!/usr/bin/python3
"""Writes the forces of params/steam-generator-tube.prm: time [s], lift and drag [N].

    scripts/make-tube-force.py > params/steam-generator-tube-force.csv

Each is W(t) c sum over k = 1 ... 60 of a_k sin(2 pi f_k t + p_k), with

    f_k = k Hz                               1 Hz ... 60 Hz
    a_k = (1 + (f_k / 25 Hz)^4)^(-1/2)       flat at first, then falling, as forces of turbulence do
    p_k = 2 pi frac(k^2 g)                   phases without pattern, but without chance: g = (sqrt(5) - 1) / 2 for the
                                             lift, sqrt(2) - 1 for the drag
    W(t) = sin(pi t / (2 T))^2               until T = 0.1 s, then 1: begins at rest

and c gives the sum over all k the root mean square of 3 N for the lift, 2 N for the drag.
"""

import numpy as np

DURATION, STEP, RAMP = 2.0, 0.002, 0.1


def force(time, golden, rms):
    k = np.arange(1, 61)
    amplitude = (1 + (k / 25)**4)**-0.5
    phase = 2 * np.pi * ((k**2 * golden) % 1)
    scale = rms / np.sqrt(np.sum(amplitude**2) / 2)
    window = np.where(time < RAMP, np.sin(np.pi * time / (2 * RAMP))**2, 1)
    return window * scale * (np.sin(np.outer(time, 2 * np.pi * k) + phase) @ amplitude)


def main():
    time = np.linspace(0, DURATION, round(DURATION / STEP) + 1)
    print("# Made by scripts/make-tube-force.py, where the formula stands.")
    print("time,lift,drag")
    for row in zip(time, force(time, (np.sqrt(5) - 1) / 2, 3), force(time, np.sqrt(2) - 1, 2)):
        print("{:.3f},{:.6g},{:.6g}".format(*row))


if __name__ == "__main__":
    main()
