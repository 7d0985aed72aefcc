#!/usr/bin/python3
"""Dry friction against closed forms, an event-located integration by other means, and values of Siconos.

Den Hartog's motion without a stop under P cos(b t + phase), for m = k = P = 1 and the friction f, with V = 1/(1 - b^2) and
U = sin(pi/b) / (b (1 + cos(pi/b))): amplitude sqrt(V^2 - U^2 f^2), as long as f <= |V| / sqrt(U^2 + S^2), where S is the largest of
(sin(s/b) + b U (cos s - cos(s/b))) / (b sin s) between 0 and pi. Free decay loses 2 f in each half cycle.
"""
import numpy
import scipy.optimize

from systems import Table

# With a stop in each half cycle, by integration with located events: b, f, amplitude.
STOPS = [(0.6, 0.6, 1.4432241317), (2.0, 0.6, 0.1453942681)]
# Time, x of siconos-tutorials, FrictionOscillator.ref, by steps of 0.01 of first order.
SICONOS = [(0.49, 13.29768), (0.99, 11.45467), (2.49, -4.75775), (4.99, -2.60395), (9.99, -7.26479), (14.74, 0.28445)]


def u_of(b):
    return numpy.sin(numpy.pi / b) / (b * (1 + numpy.cos(numpy.pi / b)))


def amplitude(b, f):
    return numpy.sqrt((1 - b * b) ** -2 - (u_of(b) * f) ** 2)


def largest_friction(b):
    """Of a motion that does not stop."""
    s = numpy.linspace(0, numpy.pi, 20002)[1:-1]
    most = ((numpy.sin(s / b) + b * u_of(b) * (numpy.cos(s) - numpy.cos(s / b))) / (b * numpy.sin(s))).max()
    return abs(1 / (1 - b * b)) / numpy.hypot(u_of(b), most)


def decay(time):
    """x'' + x = -sign(x') from x = 12, x' = 6 on; at rest when a turn lies within 1 of 0."""
    radius, start = numpy.hypot(12 + 1, 6), numpy.arctan2(6, 12 + 1)  # of the first turn
    if time <= start:
        return radius * numpy.cos(time - start) - 1
    place = radius - 1
    while abs(place) > 1:
        centre = numpy.sign(place)
        if time <= start + numpy.pi:
            return centre + (place - centre) * numpy.cos(time - start)
        place, start = 2 * centre - place, start + numpy.pi
    return place


def check_response(table, results):
    response = results["analysis/response"]
    b = 2 * numpy.pi * response["frequency"][:]
    limit = numpy.array([largest_friction(value) for value in b])
    for number, f in enumerate(response["Variables.mu"][:]):
        moves = limit > f
        found = response["point/mass.block/displacement_x/amplitude"][number, :, 0]
        exact = numpy.where(moves, amplitude(b, numpy.where(moves, f, 0)), numpy.nan)
        table.add_curve(f"f = {f:g}: amplitude without stops, relative", found / exact - 1, 1e-7)
        stops = response["contact/ground/friction/stick_fraction"][number, :, 0] > 0
        table.add_whole(f"f = {f:g}: frequencies with stops, of 57", [(~moves).sum()], [(stops & ~moves).sum()])
        table.add_whole(f"f = {f:g}: and without, of 57", [moves.sum()], [(~stops & moves).sum()])
    for b, f, reference in STOPS:
        run = table.run("friction-oscillator.prm", "stop", "Analyses=motion", f"Variables/mu={f}",
                        f"Excitation/force/Frequency={b} rad/s", "Analysis/motion/Record=extreme values",
                        "Analysis/motion/Steady state/Steadiness tolerance=1e-11")
        table.add(f"amplitude with stops, b = {b:g}, f = {f:g}", reference,
                  run["analysis/motion/point/mass.block/displacement_x/amplitude"][()], 1e-9)


def check_border(table):
    """A branch along the friction: crossing-sliding (9) at the turns, below b = 1/2 grazing-sliding (10) between them."""
    for b, start, kind in ((0.4, 0.1, 10), (0.6, 0.4, 9), (0.8, 0.4, 9), (1.2, 0.4, 9), (2, 0.4, 9)):
        special = table.run("friction-oscillator.prm", f"border-{b:g}", "Analyses=border", f"Variables/mu={start}",
                            f"Excitation/force/Frequency={b} rad/s")["analysis/border/special"]
        between = scipy.optimize.minimize_scalar(
            lambda s: -(numpy.sin(s / b) + b * u_of(b) * (numpy.cos(s) - numpy.cos(s / b))) / (b * numpy.sin(s)),
            bounds=(0.2, 1.2), method="bounded", options={"xatol": 1e-9})
        border = abs(1 / (1 - b * b)) / numpy.hypot(u_of(b), max(1 / b**2, -between.fun))
        table.add(f"b = {b:g}: largest friction without stops, by a branch", border, special["Variables.mu"][0], 1e-11)
        table.add_whole(f"b = {b:g}: kind of that point", [kind], [int(special["kind"][0])])


def check_belt(table, belt):
    """Period from one stick to the next, of the displacement at its turning points."""
    time, place = belt["time"][:], belt["point/carried.block/displacement_x"][:]
    top = numpy.flatnonzero((place[1:-1] > place[:-2]) & (place[1:-1] >= place[2:])) + 1
    step = time[1] - time[0]
    bend = (place[top - 1] - place[top + 1]) / (2 * (place[top - 1] - 2 * place[top] + place[top + 1]))
    table.add("belt: period", belt_period(0.2), numpy.diff(time[top] + step * bend).mean(), 1e-5)
    table.add("belt: largest displacement", 0.5 + numpy.sqrt(0.29), place.max(), 1e-4)


def regained_speed(speed, ratio):
    """Largest speed of the mass after it has slid back, less that of the belt; drop of the friction 0.5, damping ratio."""
    omega = numpy.sqrt(1 - ratio**2)
    offset = 0.5 - 2 * ratio * speed
    start = numpy.array([offset, speed])
    system = numpy.array([[0, 1], [-1, -2 * ratio]])

    def state(time):
        turn = numpy.cos(omega * time) * numpy.eye(2) + numpy.sin(omega * time) / omega * (system + ratio * numpy.eye(2))
        return numpy.exp(-ratio * time) * turn @ start

    top = scipy.optimize.brentq(lambda time: (system @ state(time))[1], numpy.pi / omega, 2 * numpy.pi / omega,
                                xtol=1e-15)
    return state(top)[1] - speed


def belt_period(speed):
    """Of stick and slip for m = k = N = 1 and a drop of the coefficient of 0.5, and no dashpot."""
    return 1 / speed + 2 * (numpy.pi - numpy.arctan(0.5 / speed))


def check_cycles(table):
    """Motions that no excitation times."""
    results = table.run("verification/belt.prm", "belt")
    table.add("limit cycle: period", belt_period(0.2), results["analysis/cycle/period"][()], 1e-12)
    table.add_whole("limit cycle: stable", [1], [int(results["analysis/cycle/stable"][()])])
    branch = results["analysis/branch"]
    speed, period = branch["Variables.speed"][:], branch["period"][:]
    closed = belt_period(speed)
    worst = numpy.argmax(abs(period / closed - 1))
    table.add("limit cycles: period, worst along the speed", closed[worst], period[worst], 1e-12)
    damped = table.run("verification/belt.prm", "damped", "Analyses=branch", "Variables/zeta=0.05")
    end = scipy.optimize.brentq(regained_speed, 0.3, 1, args=(0.05,), xtol=1e-14)
    table.add("speed at which stick ends, 5 % of critical damping", end,
              damped["analysis/branch/special/Variables.speed"][-1], 1e-12)
    table.add_whole("kind of that point, and why the branch ends", [10, 8],
                    [int(damped["analysis/branch"][name][-1]) for name in ("special/kind", "end/reason")])


def check_benchmarks(table):
    results = table.run("verification/friction-benchmarks.prm", "benchmarks")
    motion = results["analysis/decay"]
    time, place = motion["time"][:], motion["point/oscillator.block/displacement_x"][:]
    for at, siconos in SICONOS:
        table.add(f"decay: x at {at:g}", decay(at), place[numpy.argmin(abs(time - at))], 5e-11, siconos,
                  absolute=True)
    table.add("decay: x at rest", decay(100), place[-1], 5e-11, absolute=True)
    chain = results["analysis/chain"]
    time = chain["time"][:]
    for row in table.reference("friction-chain.csv"):
        sample = numpy.argmin(abs(time - row["t"]))
        for name, body in (("x1", "first"), ("x2", "second")):
            table.add(f"chain: {name} at {row['t']:g}", row[name], chain[f"point/{body}.block/displacement_x"][sample],
                      2e-9, absolute=True)
    table.add_whole("chain: stops until 500", [54], [int(chain["recorded/contact/floor/friction/sticks"][()])])


def closed_forms():
    """Rows of published/friction-closed-form.csv: b, a, mu, series."""
    frequencies = numpy.linspace(0.5875, 1.9875, 57)
    return [(f"{b:.4f}", f"{amplitude(b, f):.6f}", f"{f:g}") for f in (0.2, 0.4, 0.6, 0.7) for b in frequencies[::4]
            if largest_friction(b) > f]


def boundary():
    """Rows of published/friction-boundary.csv: the largest friction without a stop, and the amplitude there."""
    return [(f"{b:.3f}", f"{amplitude(b, largest_friction(b)):.6f}")
            for b in [*numpy.linspace(0.56, 0.92, 37), *numpy.linspace(1.08, 2, 47)]]


def belt_periods():
    """Rows of published/friction-belt-closed-form.csv: speed, period."""
    return [(f"{speed:.2f}", f"{belt_period(speed):.6f}") for speed in numpy.linspace(0.1, 2, 20)]


def check_curves(table):
    for name, rows in (("friction-closed-form", closed_forms()), ("friction-boundary", boundary()),
                       ("friction-belt-closed-form", belt_periods())):
        file = table.arguments.source / "docs" / "gallery" / "published" / f"{name}.csv"
        lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")][1:]
        table.add_whole(f"points of {name}.csv", [len(rows)],
                        [sum(", ".join(row) == line for row, line in zip(rows, lines))])


def check(table):
    results = table.run("friction-oscillator.prm", "oscillator")
    check_response(table, results)
    check_border(table)
    check_belt(table, results["analysis/belt"])
    check_cycles(table)
    check_benchmarks(table)
    check_curves(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
