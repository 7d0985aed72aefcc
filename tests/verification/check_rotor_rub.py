#!/usr/bin/python3
"""A rotor that rubs in its stator: the closed form of the synchronous rub, m = k = 1,

  [(1 - w^2) r + N]^2 + [c w r + mu N]^2 = (e w^2)^2,  N = k_s (r - r_0),

N = 0 where the orbit stays within the clearance; the work rate of wear is N (w r + w R).
"""
import numpy

from systems import Table

STEP = 1e-4  # of differences of the closed form
STEPS = STEP, -STEP, 2 * STEP, -2 * STEP
DAMPING, ECCENTRICITY, CLEARANCE, STATOR, FRICTION, DISC = 0.1, 0.05, 0.1, 0.5, 0.1, 1.0


def unbalanced(r, w, stator=STATOR, friction=FRICTION):
    force = stator * numpy.maximum(r - CLEARANCE, 0)
    return (((1 - w * w) * r + force)**2 + (DAMPING * w * r + friction * force)**2) / (ECCENTRICITY * w * w)**2 - 1


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


def fold(stator, friction):
    """The highest speed at which the disc rubs: there the least value over the radius is zero."""
    def least(w):
        low, high = CLEARANCE, 2.0
        for _ in range(200):
            thirds = low + (high - low) / 3, high - (high - low) / 3
            low, high = (low, thirds[1]) if unbalanced(thirds[0], w, stator, friction) < unbalanced(thirds[1], w, stator, friction) else \
                (thirds[0], high)
        return unbalanced(low, w, stator, friction)

    low, high = 1.0, 3.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if least(middle) < 0 else (low, middle)
    return low


def check_branch(table):
    branch = table.run("rotor-rub.prm", "branch", "Analyses=branch")["analysis/branch"]
    speed, radius, stable = (branch[name][:] for name in ("Variables.w", "point/rotor.disc/displacement_x/amplitude", "stable"))
    stator, friction = 2.0, 0.02
    slope = 1e-6 * radius
    gradient = (unbalanced(radius + slope, speed, stator, friction) - unbalanced(radius - slope, speed, stator, friction)) / 2e-6
    # A relative error of the radius, or near the fold, where the radius has a steep slope, of what it should balance.
    table.add_curve("branch: radius, relative", unbalanced(radius, speed, stator, friction) / numpy.maximum(abs(gradient), 1), 1e-8)
    turn = numpy.argmax(speed)
    table.add("branch: speed at the fold", fold(stator, friction), branch["special/Variables.w"][0], 1e-8)
    table.add_whole("branch: stable points from the start to the fold, and behind it", [1, 0],
                    [int(stable[1:turn - 1].min()), int(stable[turn + 1:].max())])
    table.add("branch: radius at its end, where the disc only touches", CLEARANCE, radius[-1], 1e-3)


def check_derivatives(table):
    """Of the rub at w = 1 by speed and friction: as dr of the closed form, and of the force that is a multiple of r."""
    derivatives = table.run("rotor-rub.prm", "orbit", "Analyses=orbit")["analysis/orbit/derivative"]
    radius = min(radii(1.0), key=lambda r: -r)
    by_radius, by_speed, by_friction = (
        sum(weight * unbalanced(*at) for weight, at in ((8, up), (-8, down), (-1, up_2), (1, down_2))) / (12 * STEP)
        for up, down, up_2, down_2 in (
            [(radius + h, 1.0) for h in STEPS], [(radius, 1 + h) for h in STEPS],
            [(radius, 1.0, STATOR, FRICTION + h) for h in STEPS]))
    for key, slope in (("w", -by_speed / by_radius), ("mu", -by_friction / by_radius)):
        found = derivatives[key]
        table.add(f"d radius/d {key} at w = 1", slope, found["point/rotor.disc/displacement_x/amplitude"][()], 1e-7)
        table.add(f"d normal force/d {key} at w = 1", STATOR * slope, found["contact/stator/normal_force/maximum"][()], 1e-6)


def whirl(friction):
    """Speed and radius of dry backward whirl, k_s = 30: (1 - W^2) r + N = 0, c W r = mu N."""
    ratio, stator = DAMPING / friction, 30.0
    speed = (ratio + numpy.sqrt(ratio**2 + 4)) / 2
    return speed, stator * CLEARANCE / (stator - ratio * speed)


def check_whirl(table):
    """With q = (r + a + i b) exp(-i W t): a'' = -2 W b' - c a' + (W^2 - 1 - k_s) a, b'' = 2 W a' - c b' + (c W - mu k_s) a."""
    results = table.run("verification/dry-whirl.prm", "whirl")
    found, branch = results["analysis/whirl"], results["analysis/branch"]
    speed, _ = whirl(0.2)
    generator = numpy.array([[0, 0, 1, 0], [0, 0, 0, 1], [speed**2 - 31, 0, -DAMPING, -2 * speed],
                             [DAMPING * speed - 6, 0, 2 * speed, -DAMPING]])
    growths = numpy.exp(numpy.sort(numpy.linalg.eigvals(generator).real) * 2 * numpy.pi / speed)
    sizes = numpy.sort(numpy.hypot(found["multiplier_real"][:], found["multiplier_imaginary"][:]))
    table.add("dry whirl: period", 2 * numpy.pi / speed, found["period"][()], 1e-10)
    table.add("dry whirl: multiplier that makes it a saddle", growths[-1], sizes[-1], 1e-8)
    table.add("dry whirl: size of the pair of multipliers", growths[0], sizes[-2], 1e-8)
    speeds, radii_of_whirl = whirl(branch["Variables.mu"][:])
    table.add_curve("dry whirl, friction from 0.1 to 0.4: radius, relative",
                    branch["point/rotor.disc/displacement_x/amplitude"][:] / radii_of_whirl - 1, 1e-9)
    table.add_curve("dry whirl: period, relative", branch["period"][:] * speeds / (2 * numpy.pi) - 1, 1e-10)


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
    check_branch(table)
    check_derivatives(table)
    check_whirl(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
