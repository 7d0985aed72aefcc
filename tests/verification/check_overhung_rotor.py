#!/usr/bin/python3
"""A rotor with an overhung disc, and the rotor of Nelson and McVaugh, against finite elements of their own.

With w = y + i z and slopes likewise a round shaft has the equations M w'' - i W G w' + K w = f of Hermite's beams after Rayleigh,
M and G with the rotary and twice the rotary inertia. Frequencies: K phi = (l^2 M - W l G) phi, l > 0 forward and l < 0 backward;
synchronous motions at K phi = W^2 (M -+ G) phi. Motions keep the modes at rest that the program keeps, with its modal damping.
"""
import numpy
import scipy.integrate
import scipy.linalg
import scipy.optimize

from systems import Table

PER_MINUTE = 2 * numpy.pi / 60
KEPT, DAMPING, UNBALANCE = 4, 0.03, 0.5e-6 * 1e3


class Shaft:
    """Hermite's beams between places, with outer and inner diameters."""

    def __init__(self, places, diameters, modulus, density):
        size = 2 * len(places)
        self.places = numpy.array(places)
        self.stiffness, self.mass, self.gyroscopic = (numpy.zeros((size, size)) for _ in range(3))
        for i, (outer, inner) in enumerate(diameters):
            h = places[i + 1] - places[i]
            area, moment = numpy.pi / 4 * (outer**2 - inner**2), numpy.pi / 64 * (outer**4 - inner**4)
            bending = numpy.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h**2, -6 * h, 2 * h**2],
                                   [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h**2, -6 * h, 4 * h**2]]) / h**3
            moved = numpy.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2],
                                 [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]]) * h / 420
            turned = numpy.array([[36, 3 * h, -36, 3 * h], [3 * h, 4 * h**2, -3 * h, -h**2],
                                  [-36, -3 * h, 36, -3 * h], [3 * h, -h**2, -3 * h, 4 * h**2]]) / (30 * h)
            own = slice(2 * i, 2 * i + 4)
            self.stiffness[own, own] += modulus * moment * bending
            self.mass[own, own] += density * area * moved + density * moment * turned
            self.gyroscopic[own, own] += 2 * density * moment * turned

    def node(self, place):
        return 2 * int(numpy.argmin(abs(self.places - place)))

    def add_disc(self, place, mass, polar, diametral):
        at = self.node(place)
        self.mass[at, at] += mass
        self.mass[at + 1, at + 1] += diametral
        self.gyroscopic[at + 1, at + 1] += polar

    def add_bearing(self, place, stiffness):
        self.stiffness[self.node(place), self.node(place)] += stiffness

    def reduced(self, modes):
        """Mass 1, squared frequencies, gyroscopic matrix, rows of the nodes."""
        squared, shapes = scipy.linalg.eigh(self.stiffness, self.mass)
        shapes = shapes[:, :modes]
        return squared[:modes], shapes.T @ self.gyroscopic @ shapes, shapes

    def critical(self, direction, count):
        """Speeds of synchronous whirl, forward 1 or backward -1."""
        squared = scipy.linalg.eigvals(self.stiffness, self.mass - direction * self.gyroscopic)
        real = squared[(abs(squared.imag) < 1e-9 * abs(squared)) & (squared.real > 0)].real
        return numpy.sqrt(numpy.sort(real))[:count]


def overhung():
    places = numpy.linspace(0, 0.5, 21)
    shaft = Shaft(places, [(0.02, 0)] * 20, 210e9, 7850)
    shaft.add_disc(0.5, 4, 0.03, 0.016)
    for place in (0, 0.3):
        shaft.add_bearing(place, 20e6)
    return shaft


def generator(squared, gyroscopic, speed):
    """Of the state [p, p'], with modal damping."""
    size = len(squared)
    return numpy.block([[numpy.zeros((size, size)), numpy.eye(size)],
                        [-numpy.diag(squared), 1j * speed * gyroscopic - numpy.diag(2 * DAMPING * numpy.sqrt(squared))]])


def check_diagram(table, diagram):
    squared, gyroscopic, _ = overhung().reduced(KEPT)
    frequency, damping, whirl = (diagram[name][:] for name in ("frequency", "damping_ratio", "whirl"))
    errors, of_damping, directions = [], [], []
    for k, speed in enumerate(diagram["speed"][:]):
        values = numpy.linalg.eigvals(generator(squared, gyroscopic, speed))
        for mode in range(len(frequency)):
            found = 2 * numpy.pi * frequency[mode, k]
            nearest = values[numpy.argmin(abs(abs(values.imag) - found))]
            errors.append(found / abs(nearest.imag) - 1)
            of_damping.append(damping[mode, k] + nearest.real / abs(nearest))
            directions.append(k == 0 or numpy.sign(nearest.imag) * whirl[mode, k] > 1 - 1e-9)
    table.add_curve("Campbell diagram: frequencies, relative", numpy.array(errors), 1e-10)
    table.add_curve("damping ratios", numpy.array(of_damping), 1e-12)
    table.add_whole("whirls in their direction, in circles", [len(directions)], [sum(directions)])


def check_critical(table, diagram):
    """The line of the speed; damped and of six modes each plane, so that the speeds are not those without both."""
    squared, gyroscopic, _ = overhung().reduced(KEPT)
    speed, multiple, whirl, mode = (diagram[f"critical/{name}"][:] for name in ("speed", "multiple", "whirl", "mode"))
    errors = []
    for found, factor, direction in zip(speed, multiple, whirl):
        values = numpy.linalg.eigvals(generator(squared, gyroscopic, found))
        errors.append(min(abs(values.imag - numpy.sign(direction) * factor * found)) / found)
    table.add_curve("critical speeds: frequency less multiple of the speed, relative", numpy.array(errors), 1e-10)
    table.add_whole("critical speeds on the line of the speed", [3], [int((multiple == 1).sum())])
    forward = speed[(multiple == 1) & (whirl > 0)]
    table.add("first forward critical speed [rpm], whole shaft without damping", overhung().critical(1, 1)[0] / PER_MINUTE,
              forward.min() / PER_MINUTE, 1e-3)


def check_run_up(table, run_up):
    """The unbalance force U (W^2 - i W') exp(i phi), from rest."""
    squared, gyroscopic, shapes = overhung().reduced(KEPT)
    row, size, rate = shapes[-2], KEPT, 6000 * PER_MINUTE
    start = run_up["time"][0]

    def derivative(time, state):
        speed = rate * time
        force = UNBALANCE * (speed**2 - 1j * rate) * numpy.exp(0.5j * rate * time**2)
        return generator(squared, gyroscopic, speed) @ state + numpy.concatenate([numpy.zeros(size), row * force])

    time = run_up["time"][:]
    solution = scipy.integrate.solve_ivp(derivative, (start, time[-1]), numpy.zeros(2 * size, complex), "DOP853",
                                         t_eval=time, rtol=1e-11, atol=1e-14)
    motion = row @ solution.y[:size]
    largest = abs(motion).max()
    for axis, part in (("y", motion.real), ("z", motion.imag)):
        table.add_curve(f"run-up: displacement {axis} over the largest",
                        (run_up[f"point/rotor.disc/displacement_{axis}"][:] - part) / largest, 1e-9)
    table.add("run-up: largest deflection [mm]", 1e3 * largest,
              1e3 * numpy.hypot(*(run_up[f"point/rotor.disc/displacement_{axis}"][:] for axis in "yz")).max(), 1e-10)
    table.add("run-up: residual of the energy balance", 0, run_up["energy_residual"][()], 1e-13, absolute=True)


def check_rub(table, rub, clearance, stator, friction):
    """Synchronous: r = H (U W^2 - (1 + i mu) k_s (|r| - c) r/|r|), H the compliance at the disc."""
    squared, gyroscopic, shapes = overhung().reduced(KEPT)
    speed = 2500 * PER_MINUTE
    dynamic = numpy.diag(squared - speed**2 + 2j * DAMPING * numpy.sqrt(squared) * speed) + speed**2 * gyroscopic
    compliance = shapes[-2] @ numpy.linalg.solve(dynamic, shapes[-2])
    free = abs(compliance) * UNBALANCE * speed**2

    def excess(radius):
        return abs(radius + compliance * (1 + 1j * friction) * stator * max(radius - clearance, 0)) - free

    radius = scipy.optimize.brentq(excess, 0, 10 * free, xtol=1e-15)
    found = rub
    table.add("rub: radius of the orbit [mm]", 1e3 * radius,
              1e3 * found["point/rotor.disc/displacement_y/amplitude"][()], 1e-9)
    table.add("rub: normal force [N]", stator * (radius - clearance),
              found["contact/ring/normal_force/maximum"][()], 1e-9)


def nelson():
    """Distances, outer and inner radii in cm of the rotor of Nelson and McVaugh, from its 18 stations to its end."""
    stations = [(0, .51, 0), (1.27, 1.02, 0), (5.08, .76, 0), (7.62, 2.03, 0), (8.89, 2.03, 0), (10.16, 3.30, 0),
                (10.67, 3.30, 1.52), (11.43, 2.54, 1.78), (12.70, 2.54, 0), (13.46, 1.27, 0), (16.51, 1.27, 0), (19.05, 1.52, 0),
                (22.86, 1.52, 0), (26.67, 1.27, 0), (28.70, 1.27, 0), (30.48, 3.81, 0), (31.50, 2.03, 0), (34.54, 2.03, 1.52)]
    places = [place / 100 for place, _, _ in stations] + [0.355]
    shaft = Shaft(places, [(outer / 50, inner / 50) for _, outer, inner in stations], 2.078e11, 7806)
    shaft.add_disc(0.0889, 1.401, 0.0020, 0.00136)
    for place in (0.1651, 0.2870):
        shaft.add_bearing(place, 4.378e7)
    return shaft


def check_nelson(table):
    """Synchronous whirl speeds, of dimensions that are rounded to 0.1 mm."""
    found = table.run("verification/nelson-rotor.prm", "nelson")["analysis/diagram"]
    speed, whirl = (found[f"critical/{name}"][:] for name in ("speed", "whirl"))
    paper = {-1: (15470, 46612, 64752), 1: (17159, 49983, 96457)}
    for direction, name in ((-1, "backward"), (1, "forward")):
        expected = nelson().critical(direction, 3) / PER_MINUTE
        values = numpy.sort(speed[whirl * direction > 0.5])[:3] / PER_MINUTE
        for j in range(3):
            table.add(f"Nelson and McVaugh: {name} whirl {j + 1} [rpm]", expected[j], values[j], 1e-8, paper[direction][j])


def check(table):
    results = table.run("overhung-rotor.prm", "overhung")
    check_diagram(table, results["analysis/diagram"])
    check_critical(table, results["analysis/diagram"])
    check_run_up(table, results["analysis/run_up"])
    check_rub(table, results["analysis/rub"], 0.3e-3, 1e5, 0.05)
    check_nelson(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
