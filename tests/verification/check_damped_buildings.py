#!/usr/bin/python3
"""The buildings with friction dampers against a step-by-step integration of its own: central differences of second order, sliders by
return mapping, without contacts between the floors, which do not meet at this slip load.
"""
import numpy

from systems import Table

STEP, LOAD, BRACE = 5e-5, 400e3, 120e6
MASS = numpy.repeat([100e3, 80e3], 3)
STOREY = numpy.repeat([60e6, 140e6], 3)
DASHPOT = numpy.repeat([330e3, 450e3], 3)
# Drift of each storey from the displacements of the floors, both buildings below each other.
DRIFT = numpy.kron(numpy.eye(2), numpy.eye(3) - numpy.eye(3, k=-1))


def integrate(ground):
    """Largest drifts, and the energy of the sliders, under accelerations that are linear between samples."""
    place, rate, slider = numpy.zeros(6), numpy.zeros(6), numpy.zeros(6)
    largest, energy, drift = numpy.zeros(6), 0.0, numpy.zeros(6)
    times = numpy.arange(round(ground[-1, 0] / STEP)) * STEP
    pushes = numpy.interp(times, ground[:, 0], ground[:, 1])
    spring, dashpot = STOREY[:, None] * DRIFT, DASHPOT[:, None] * DRIFT
    held = LOAD / BRACE
    for push in pushes:
        force = spring @ place + dashpot @ rate + BRACE * (drift - slider)
        rate = rate - STEP * (push + DRIFT.T @ force / MASS)
        place = place + STEP * rate
        drift = DRIFT @ place
        beyond = drift - slider
        slip = beyond - numpy.clip(beyond, -held, held)
        slider += slip
        energy += LOAD * numpy.abs(slip).sum()
        largest = numpy.maximum(largest, numpy.abs(drift))
    return largest, energy


def check(table):
    recorded = table.run("damped-buildings.prm", "buildings", "Analyses=motion",
                         "Analysis/motion/Record=extreme values, friction")["analysis/motion/recorded"]
    file = table.arguments.source / "params" / "frame-pounding-ground.csv"
    largest, energy = integrate(numpy.loadtxt(file, delimiter=",", skiprows=2))
    names = [f"{building}_brace{storey}" for building in ("left", "right") for storey in (1, 2, 3)]
    for name, drift in zip(names, largest):
        table.add(f"{name}: largest drift, m", drift, recorded[f"contact/{name}/slip/largest"][()], 2e-3)
    table.add("energy of the dampers, J", energy, sum(recorded[f"contact/{name}/friction/energy"][()] for name in names), 2e-3)
    for floor in (1, 2, 3):
        table.add_whole(f"contacts of floors {floor}", [0], [int(recorded[f"contact/floors{floor}/normal_force/maximum"][()] > 0)])


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
