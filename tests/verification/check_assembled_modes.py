#!/usr/bin/python3
"""Modes of a system of two beams against those of the one beam that they make up, tied at their contact.

The halves keep 30 modes with a fixed interface each, so that their frequencies lie above those of the one beam, by less than
3e-7. A spring of stiffness k in place of the tie comes as near to it as 1 / k.
"""
import numpy

from systems import Table


def of_halves(system):
    """Frequencies of the modes in which the halves move."""
    names = ("left", "right", "pier")
    share = sum(system[f"body/{name}/kinetic_energy_share"][:] for name in names)
    pier = system["body/pier/kinetic_energy_share"][:]
    return system["frequency"][:][(share > 0.5) & (pier < 0.5)]


def check_ties(table, results):
    tied = results["analysis/tied"]
    one = tied["body/whole/frequency"][:8]
    for j, frequency in enumerate(one):
        table.add(f"mode {j + 1}, tied halves [Hz]", frequency, of_halves(tied["system"])[j], 3e-7)
    table.add_whole("tied halves lie above the one beam", [1], [int((of_halves(tied["system"])[:8] >= one * (1 - 1e-12)).all())])
    second = of_halves(tied["system"])[1]
    sprung = results["analysis/sprung/system/frequency"]
    softer = [second - max(f for f in sprung[k] if f < second * (1 - 1e-7)) for k in range(3)]
    table.add("ten times the spring, part of the distance from the tie", 0.1, softer[1] / softer[0], 0.02)
    table.add("hundred times", 0.01, softer[2] / softer[0], 0.02)


def check_open(table, results):
    system = results["analysis/open/system"]
    table.add_whole("rigid-body modes of the open system (right half)", [1], [int(system["rigid_modes"][()])])
    shares = ("left", "right", "pier", "whole")
    for kind in ("kinetic", "strain"):
        total = sum(system[f"body/{name}/{kind}_energy_share"][:] for name in shares)
        table.add_curve(f"sum of the {kind} energy shares of the bodies less 1", total[1:] - 1, 1e-9)
    tied = results["analysis/tied/system"]
    table.add_curve("and of the strain, tied", sum(tied[f"body/{name}/strain_energy_share"][:] for name in shares) - 1, 1e-9)


def check_responses(table, results):
    halves = results["analysis/response/point/left.joint/displacement_z/amplitude"][:]
    one = results["analysis/response_of_one/point/whole.middle/displacement_z/amplitude"][:]
    table.add_curve("response to a force at the joint, tied halves over one beam less 1", halves / one - 1, 1e-6)
    right = results["analysis/response/point/right.joint/displacement_z/amplitude"][:]
    table.add_curve("right half over left half less 1", right / halves - 1, 1e-12)


def check_damped(table, results):
    """The eigenvalues add up to the trace of the damping."""
    system = results["analysis/damped/system"]
    table.add_whole("damping couples the modes", [0], [int(system["modal_damping"][()])])
    damped = system["damped"]
    pairs = damped["frequency"][:] > 0
    trace = (2 * damped["decay_rate"][:][pairs]).sum() + damped["decay_rate"][:][~pairs].sum()
    table.add("sum of the decay rates [1/s]", (2 * system["damping_ratio"][:] * 2 * numpy.pi * system["frequency"][:]).sum(), trace, 1e-9)


def check(table):
    results = table.run("verification/assembled-modes.prm", "shipped")
    check_ties(table, results)
    check_open(table, results)
    check_responses(table, results)
    check_damped(table, results)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
