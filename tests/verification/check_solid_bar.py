#!/usr/bin/python3
"""Solid bars that collide end to end and on a stop, against waves in a rod.

Z = S sqrt(E rho) is the impedance of a bar, T = 2 L / c the time of a wave to its end and back. Two
equal bars with the spring k between them, the approach speed v, and a = 2 k / Z, F0 = Z v / 2: the force
is F0 (1 - exp(-a t)) up to T, and behind it, with x = a (t - T),
F0 ((2 x + 2 - exp(-a T)) exp(-x) - 1). A bar on a stop across 2 k has the same a, and F0 = Z v. The end of a bar
moves by its impulse I and that of the wave that comes back, (I(t) + 2 I(t - T)) / Z.
"""
import pathlib
import sys

import h5py
import numpy

from systems import Table

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from vtu_arrays import vtu_arrays  # noqa: E402

FILE = "verification/solid-bar.prm"
LENGTH, SIDE, YOUNG, DENSITY, STIFFNESS, SPEED = 1.0, 0.02, 2e11, 7800.0, 2e8, 1.0
IMPEDANCE = SIDE**2 * numpy.sqrt(YOUNG * DENSITY)
WAVE = 2 * LENGTH / numpy.sqrt(YOUNG / DENSITY)
RATE = 2 * STIFFNESS / IMPEDANCE
LATE = numpy.exp(-RATE * WAVE)


def end_of_contact():
    """a (t - T) at the end: (2 x + 2 - LATE) exp(-x) = 1."""
    x = 1.5
    for _ in range(100):
        x = numpy.log(2 * x + 2 - LATE)
    return x


def force(time, plateau):
    x = RATE * (time - WAVE)
    behind = plateau * ((2 * x + 2 - LATE) * numpy.exp(-x) - 1)
    return numpy.where(time <= WAVE, plateau * (1 - numpy.exp(-RATE * time)), numpy.where(x < end_of_contact(), behind, 0))


def impulse(time, plateau):
    """Integral of the force from 0 on."""
    first = numpy.clip(time, 0, WAVE)
    x = numpy.clip(RATE * (time - WAVE), 0, end_of_contact())
    behind = 2 * (1 - (1 + x) * numpy.exp(-x)) + (2 - LATE) * (1 - numpy.exp(-x)) - x
    return plateau * (first - (1 - numpy.exp(-RATE * first)) / RATE + behind / RATE)


def displacement(time, plateau):
    """By which the end of a bar is pushed back within 2 T."""
    return (impulse(time, plateau) + 2 * impulse(time - WAVE, plateau)) / IMPEDANCE


def check_pictures(table, folder):
    """Hexahedra of the striker, and its stress -F / S while the wave passes."""
    frame = vtu_arrays(folder / "impact" / "frame-00002.vtu")
    table.add("cells of a frame", 3 * 160, len(frame["types"]), 0)
    table.add("their VTK type", 12, frame["types"].max(), 0)
    # Free of stress at the contact, as every mode is at a free end, within half a wave of the last one.
    place = frame["Points"][:, 0]
    passed = (frame["body"] == 1) & (place > -0.5) & (place < -0.1)
    since = 0.2e-3 + place[passed] * WAVE / (2 * LENGTH)
    expected = -IMPEDANCE * SPEED / 2 / SIDE**2 * (1 - numpy.exp(-RATE * since))
    table.add("mean stress from 0.1 to 0.5 m behind the contact, Pa", expected.mean(),
              frame["stress_xx"][passed].mean(), 1e-2)


def check(table):
    folder = table.folder_of_run(FILE, "solid-bar")
    analysis = h5py.File(folder / "results.h5")["analysis/impact"]
    duration = WAVE + end_of_contact() / RATE
    for name, plateau in (("bars", IMPEDANCE * SPEED / 2), ("stop", IMPEDANCE * SPEED)):
        impact = {key: values[:] for key, values in analysis[f"contact/{name}/impact"].items()}
        table.add(f"{name}: contacts", 1, len(impact["time"]), 0)
        table.add(f"{name}: duration, s", duration, impact["duration"][0], 1e-2)
        table.add(f"{name}: impulse, N s", impulse(2 * WAVE, plateau), impact["impulse"][0], 1e-3)
        table.add(f"{name}: peak force, N", plateau, impact["peak_force"][0], 4e-2)
        time = analysis["time"][:]
        within = (time > 0.1e-3) & (time < 0.35e-3)
        table.add(f"{name}: mean force from 0.1 to 0.35 ms, N", force(time[within], plateau).mean(),
                  analysis[f"contact/{name}/normal_force"][:][within].mean(), 5e-3)
    check_displacements(table, analysis)
    check_curves(table)
    check_pictures(table, folder)


def check_displacements(table, analysis):
    """Of the ends that meet. The end of the contact is sharper than 20 modes are: behind it 2.4 um remain, 3.2 um with 12 modes and
    1.6 um with 36."""
    time = analysis["time"][:]
    for at in (0.2e-3, 0.4e-3, 0.6e-3):
        sample = numpy.argmin(numpy.abs(time - at))
        pushed = displacement(at, IMPEDANCE * SPEED / 2)
        for body, expected in (("striker", SPEED * at - pushed), ("target", pushed)):
            table.add(f"{body}: displacement at {1e3 * at:g} ms, m", expected,
                      analysis[f"point/{body}.head/displacement_x"][sample], 1e-3 if at < 0.5e-3 else 1.2e-2)


def check_curves(table):
    """Those of the closed form that the page's figures show."""
    rows = wave_curves()
    file = table.arguments.source / "docs" / "gallery" / "published" / "solids-wave.csv"
    shown = [line.split(", ") for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")][1:]
    table.add("points of the figures, of 124", len(rows), sum(row == tuple(line) for row, line in zip(rows, shown)), 0)


def wave_curves():
    """Time, force and displacement in units of the wave, and the figure."""
    time = numpy.linspace(0, 1.5, 31) * WAVE
    pushed = displacement(time, IMPEDANCE * SPEED / 2) / (SPEED * WAVE)
    curves = [("F", force(time, IMPEDANCE * SPEED / 2) / (IMPEDANCE * SPEED)),
              ("F", force(time, IMPEDANCE * SPEED) / (IMPEDANCE * SPEED)),
              ("u", time / WAVE - pushed), ("u", pushed)]
    return [(f"{t:.2f}", f"{value:.6f}", "", "solids-force") if kind == "F" else
            (f"{t:.2f}", "", f"{value:.6f}", "solids-displacement")
            for kind, values in curves for t, value in zip(time / WAVE, values)]


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
