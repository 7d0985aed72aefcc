#!/usr/bin/python3
"""Solid bars that collide end to end and on a stop, against waves in a rod.

Z = S sqrt(E rho) is the impedance of a bar, T = 2 L / c the time of a wave to its end and back. Two
equal bars with the spring k between them, the approach speed v, and a = 2 k / Z, F0 = Z v / 2: the force
is F0 (1 - exp(-a t)) up to T, and behind it, with x = a (t - T),
F0 ((2 x + 2 - exp(-a T)) exp(-x) - 1). A bar on a stop across 2 k has the same a, and F0 = Z v.
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


def impulse(plateau):
    x = end_of_contact()
    before = WAVE - (1 - LATE) / RATE
    behind = 2 * (1 - (1 + x) * numpy.exp(-x)) + (2 - LATE) * (1 - numpy.exp(-x)) - x
    return plateau * (before + behind / RATE)


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
        table.add(f"{name}: impulse, N s", impulse(plateau), impact["impulse"][0], 1e-3)
        table.add(f"{name}: peak force, N", plateau, impact["peak_force"][0], 4e-2)
        time = analysis["time"][:]
        within = (time > 0.1e-3) & (time < 0.35e-3)
        table.add(f"{name}: mean force from 0.1 to 0.35 ms, N",
                  plateau * (1 - numpy.exp(-RATE * time[within])).mean(),
                  analysis[f"contact/{name}/normal_force"][:][within].mean(), 5e-3)
    check_pictures(table, folder)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
