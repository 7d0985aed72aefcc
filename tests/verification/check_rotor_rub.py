#!/usr/bin/python3
"""A rotor that rubs in its stator: the closed form of the synchronous rub, m = k = 1,

  [(1 - w^2) r + N]^2 + [c w r + mu N]^2 = (e w^2)^2,  N = k_s (r - r_0),

N = 0 where the orbit stays within the clearance; the work rate of wear is N (w r + w R).
"""
import numpy

from systems import Table

DAMPING, ECCENTRICITY, CLEARANCE, STATOR, FRICTION, DISC = 0.1, 0.05, 0.1, 0.5, 0.1, 1.0


def unbalanced(r, w):
    force = STATOR * numpy.maximum(r - CLEARANCE, 0)
    return (((1 - w * w) * r + force)**2 + (DAMPING * w * r + FRICTION * force)**2) / (ECCENTRICITY * w * w)**2 - 1


def radii(w):
    """All solutions."""
    grid = numpy.linspace(0, 1, 20001)
    values = unbalanced(grid, w)
    found = []
    for i in numpy.flatnonzero(values[:-1] * values[1:] < 0):
        low, high = grid[i], grid[i + 1]
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if unbalanced(middle, w) * values[i] > 0 else (low, middle)
        found.append((low + high) / 2)
    return numpy.array(found)


def closed_form():
    """Rows of published/rub-closed-form.csv: w, radius; there is one at each speed."""
    return [(f"{w:.4g}", f"{r:.6f}") for w in numpy.linspace(0.6, 1.5, 37) for r in radii(w)]


def check_points(table):
    file = table.arguments.source / "docs" / "gallery" / "published" / "rub-closed-form.csv"
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")][1:]
    rows = closed_form()
    table.add_whole("points of rub-closed-form.csv", [len(rows)],
                    [sum(", ".join(row) == line for row, line in zip(rows, lines))])


def check(table):
    run_up = table.run("rotor-rub.prm", "rub", "Analyses=run_up")["analysis/run_up"]
    speed = run_up["Variables.w"][:]
    found = {name: run_up[field][:].ravel() for name, field in (
        ("radius", "point/rotor.disc/displacement_x/amplitude"), ("across", "point/rotor.disc/displacement_y/amplitude"),
        ("force", "contact/stator/normal_force/maximum"), ("rate", "contact/stator/friction/work_rate"))}
    exact = numpy.array([min(radii(w), key=lambda r: abs(r - near)) for w, near in zip(speed, found["radius"])])
    force = STATOR * numpy.maximum(exact - CLEARANCE, 0)
    rubs = force > 0
    table.add_whole("speeds at which it rubs, of 37", [int(rubs.sum())], [int((found["rate"] > 0).sum())])
    table.add_curve("radius along x, relative", found["radius"] / exact - 1, 1e-8)
    table.add_curve("radius along y, relative", found["across"] / exact - 1, 1e-8)
    table.add_curve("normal force, relative", found["force"][rubs] / force[rubs] - 1, 1e-7)
    table.add_curve("work rate, relative", found["rate"][rubs] / (force * speed * (exact + DISC))[rubs] - 1, 1e-7)
    check_points(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
