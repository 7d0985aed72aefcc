#!/usr/bin/python3
"""Writes the ground motion of params/frame-pounding.prm, time [s] and acceleration [m/s^2].

    scripts/make-ground-motion.py > params/frame-pounding-ground.csv

The ground is displaced by d(t) = c W(t) sum over k = 1 ... 60 of d_k sin(w_k t + p_k), with

    W(t) = sin(pi t / T)^2                    a window of T = 12 s: begins and ends at rest
    w_k  = 2 pi (0.2 k) / s                   0.2 Hz ... 12 Hz
    p_k  = 2 pi frac(k^2 (sqrt(5) - 1) / 2)   phases without pattern, but without chance
    d_k  = sqrt(S(w_k)) / w_k^2               spectrum of stiff soil (Kanai and Tajimi) with
    S(w) = (1 + 4 z^2 r^2) / ((1 - r^2)^2 + 4 z^2 r^2),  r = w / w_g,  w_g = 2 pi 2.5 / s,  z = 0.6

The acceleration is the exact second derivative, and c makes its peak 4 m/s^2.
"""

import numpy as np

DURATION, STEP, PEAK = 12.0, 0.01, 4.0


def ground_acceleration(time):
    """Second derivative of the displacement, not yet scaled."""
    k = np.arange(1, 61)
    omega = 2 * np.pi * 0.2 * k
    phase = 2 * np.pi * ((k**2 * (np.sqrt(5) - 1) / 2) % 1)
    ratio = omega / (2 * np.pi * 2.5)
    filtered = 1 + 4 * 0.6**2 * ratio**2
    amplitude = np.sqrt(filtered / ((1 - ratio**2)**2 + 4 * 0.6**2 * ratio**2)) / omega**2
    angle = np.outer(time, omega) + phase
    value = np.sin(angle) @ amplitude
    rate = np.cos(angle) @ (amplitude * omega)
    acceleration = -np.sin(angle) @ (amplitude * omega**2)
    turn = 2 * np.pi / DURATION
    window = (1 - np.cos(turn * time)) / 2
    window_rate = turn / 2 * np.sin(turn * time)
    window_acceleration = turn**2 / 2 * np.cos(turn * time)
    return window_acceleration * value + 2 * window_rate * rate + window * acceleration


def main():
    time = np.linspace(0, DURATION, round(DURATION / STEP) + 1)
    acceleration = ground_acceleration(time)
    acceleration *= PEAK / np.abs(acceleration).max()
    print("# Made by scripts/make-ground-motion.py, where the formula stands.")
    print("time,acceleration")
    for t, a in zip(time, acceleration):
        print(f"{t:.2f},{a:.9g}")


if __name__ == "__main__":
    main()
