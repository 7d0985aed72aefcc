#!/usr/bin/python3
"""Rolling and bouncing bodies against closed forms.

A sphere's inertia 2/5 m R^2 makes the mass at its foot along the floor 2/7 m. Set down with the speed v_0 of its foot it
slides for t = 2 v_0/(7 mu g); pushed it then rolls with 5/7 v_0, spun with 2/7 v_0. An impact stops the foot if that needs
at most mu times the normal impulse (1 + e) m v_n, else it slides on with mu times it. A body that bounces from the approach
speed v_n on rests after 2 e v_n/(g (1 - e)). The bounces are those of the program Siconos' example of a spinning disc.
"""
import numpy

from systems import Table

GRAVITY, RADIUS, FRICTION, RESTITUTION = 9.81, 0.5, 0.1, 0.9
CENTRE, FOOT = "point/disc.centre/", "point/disc.foot/"


def check_bounce(table, bounce):
    first = numpy.sqrt(2 * 0.5 / GRAVITY)
    speed = GRAVITY * first
    impacts = {name: bounce[f"contact/floor/impact/{name}"][:] for name in ("time", "approach_speed", "impulse")}
    flights = 2 * speed / GRAVITY * RESTITUTION ** numpy.arange(1, 60)
    table.add("first impact", first, impacts["time"][0], 1e-12)
    table.add("its approach speed", speed, impacts["approach_speed"][0], 1e-12)
    table.add("its impulse", 1.9 * speed, impacts["impulse"][0], 1e-12)
    table.add_curve("60 impacts: time, relative",
                    impacts["time"][:60] / (first + numpy.concatenate([[0], numpy.cumsum(flights)])) - 1, 1e-11)
    time = bounce["time"][:]
    spin, along = bounce[CENTRE + "angular_velocity_y"][:], bounce[CENTRE + "velocity_x"][:]
    # Siconos, and the closed form: the first impact stops the foot, which spins at 1 m/s.
    table.add("spin behind the first impact", 2 - 5 / 2 * 2 / 7 / RADIUS, spin[-1], 1e-12)
    table.add("speed behind it", 2 / 7, along[-1], 1e-12)
    table.add_whole("they change once", [1], [len(numpy.unique(numpy.round(along[time > 0], 9))) - 1])
    table.add("rests from", first + 2 * RESTITUTION * speed / (GRAVITY * (1 - RESTITUTION)),
              impacts["time"][-1] + bounce["contact/floor/impact/chatter_duration"][:][-1], 1e-12)


def check_slide(table, name, motion, centre_speed):
    """From the speed 1 m/s of the foot on."""
    table.add(f"{name}: speed when it rolls", centre_speed, motion[CENTRE + "velocity_x"][-1], 1e-12)
    table.add(f"{name}: and of its surface", centre_speed, RADIUS * motion[CENTRE + "angular_velocity_y"][-1], 1e-12)
    table.add(f"{name}: the foot at rest", 0, motion[FOOT + "velocity_x"][-1], 1e-13, absolute=True)
    until = 2 / (7 * FRICTION * GRAVITY)
    friction = {field: motion[f"recorded/contact/floor/friction/{field}"][()] for field in ("slip_fraction", "energy", "sliding_way")}
    table.add(f"{name}: time until it rolls [s]", until, friction["slip_fraction"] * 0.6, 1e-12)
    table.add(f"{name}: way that the foot slides [m]", until / 2, friction["sliding_way"], 1e-11)
    table.add(f"{name}: work of friction [J]", 1 / 7, friction["energy"], 1e-11)


def check_oblique(table, speed):
    """A sphere that meets the floor at 1 m/s with this speed of its foot; e = 0.8, mu = 0.3."""
    motion = table.run("spinning-disc.prm", f"oblique-{speed}", "Analyses=bounce", f"Variables/height={0.5 / GRAVITY} m",
                       "Variables/friction=0.3", f"Initial condition/pushed/Velocity={speed} m/s",
                       "Analysis/bounce/Initial conditions=pushed", "Analysis/bounce/Transient/Duration=0.2 s",
                       "Contact/floor/Newton restitution/Restitution coefficient=0.8")["analysis/bounce"]
    impulse = min(2 / 7 * speed, 0.3 * 1.8)
    table.add(f"oblique, {speed} m/s: speed of the centre", speed - impulse, motion[CENTRE + "velocity_x"][-1], 1e-12)
    table.add(f"oblique, {speed} m/s: of the surface", 5 / 2 * impulse, RADIUS * motion[CENTRE + "angular_velocity_y"][-1], 1e-12)


def check(table):
    results = table.run("spinning-disc.prm", "shipped")
    check_bounce(table, results["analysis/bounce"])
    check_slide(table, "pushed ball", results["analysis/slide"], 5 / 7)
    check_slide(table, "spun ball", results["analysis/spin"], 2 / 7)
    for speed in (0.5, 1.5, 2.5):
        check_oblique(table, speed)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
