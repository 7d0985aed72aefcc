#!/usr/bin/python3
"""The bolted joint's sliders (Jenkins elements) against what follows from their slip alone.

A cycle between -X and X takes 4 F (X - F/kt), F = mu N, and nothing below F/kt, whatever its course, as long as it turns only at its ends or
turns within it without yielding. The force is the return mapping of the slip, which is tried on a path printed with tmdsimpy's
test_jenkins_hysteretic_aft: kt 2, F 3.
"""
import numpy

from systems import Table

LIMIT, STIFFNESS = 200.0, 20e6
PATH = [0, 5, 3.5, 2, -5, -3.5, -2, 0, 5]
PUBLISHED = [0, 3, 0, -3, -3, 0, 3, 3, 3]


def return_mapping(slip, stiffness, limit, force):
    forces = [force]
    for step in numpy.diff(slip):
        forces.append(float(numpy.clip(forces[-1] + stiffness * step, -limit, limit)))
    return numpy.array(forces)


def loss(yielding):
    """Energy of a cycle over pi kt X^2 for the amplitude over F/kt."""
    return numpy.where(yielding > 1, 4 / numpy.pi * (yielding - 1) / yielding**2, 0)


def curve():
    """Rows of published/joint-loss.csv."""
    return [(f"{s:.4g}", f"{loss(s):.6f}") for s in numpy.concatenate([[0.1], numpy.geomspace(1, 25, 60)])]


def check(table):
    table.add_whole("return mapping of the published path", PUBLISHED, return_mapping(PATH, 2, 3, 0))
    results = table.run("bolted-joint.prm", "joint", "Analyses=response, loops")
    response, loops = results["analysis/response"], results["analysis/loops"]
    for slider in (1, 2, 4, 5):
        contact = response[f"contact/slider{slider}"]
        yielding = STIFFNESS * contact["slip/amplitude"][:] / LIMIT
        energy = contact["friction/energy"][:] / 2
        slips = yielding > 1
        expected = numpy.pi * STIFFNESS * contact["slip/amplitude"][:] ** 2 * loss(yielding)
        table.add_curve(f"slider {slider}: energy of a cycle in slip, relative",
                        numpy.where(slips, energy / numpy.where(slips, expected, 1) - 1, numpy.nan), 1e-4)
        table.add(f"slider {slider}: largest energy of a cycle in stick, J", 0, energy[~slips].max(), 1e-7, absolute=True)
        history = loops[f"history/contact/slider{slider}"]
        for load, slip, force in zip(loops["Variables.load"][:], history["slip"][:], -history["friction_force"][:]):
            known = numpy.isfinite(slip)
            mapped = return_mapping(slip[known], STIFFNESS, LIMIT, force[known][0])
            # A turn between samples lies beyond them by up to an eighth of the second difference; two turns may follow each other.
            missed = STIFFNESS * numpy.abs(numpy.diff(slip[known], 2)).max() / 4
            table.add(f"slider {slider}, {load:g} N: force by the slip, difference over that of the samples", 0,
                      numpy.abs(mapped - force[known]).max() / missed, 1, absolute=True)
    file = table.arguments.source / "docs" / "gallery" / "published" / "joint-loss.csv"
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")][1:]
    table.add_whole("points of joint-loss.csv", [61], [sum(", ".join(row) == line for row, line in zip(curve(), lines))])


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
