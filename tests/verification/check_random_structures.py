#!/usr/bin/python3
"""Variances of linear structures under band-limited noise, and two masses between stops at one temperature.

A member of the noise is a sum of lines at k dw with variances G dw, and a cubic spline between its samples, which multiplies
line k by (sin(x/2) / (x/2))^4 3 / (2 + cos x), x = k dw times the interval. In the stationary window the mean square of a response
H(w) is therefore on average the sum over the lines of |H|^2 G dw. The cantilever's H is that of its first three modes of
Euler and Bernoulli's beam.

Where every damping c_i has white noise of the density 2 c_i T / pi beside it, displacements and velocities of any elastic system
have the density exp(-H / T) / Z, H the energy (Gibbs): variances, forces and shares in contact are integrals over the plane of the
two displacements, and a gap with the reduced mass m closes at its own density at zero times sqrt(T / (2 pi m)).
"""
import numpy

from systems import Table, arguments_of_checks

G, LOWEST, HIGHEST, DURATION, RATIO = 0.1, 0.2, 8.0, 150.0, 0.1
ROOTS = numpy.array([1.8751040687119611, 4.694091132974174, 7.854757438237613])
ALLOWED = 4.0  # standard errors of a mean


def lines():
    """Angular frequencies of the noise and the variance of each line behind the spline."""
    interval = 2 * numpy.pi / (8 * HIGHEST)
    count = int(numpy.ceil(DURATION / interval * (1 - 1e-12)) + 1)
    count += count % 2
    while not is_fast(count):
        count += 2
    spacing = 2 * numpy.pi / (interval * count)
    omega = spacing * numpy.arange(1, count // 2)
    omega = omega[(omega >= LOWEST) & (omega <= HIGHEST)]
    x = omega * interval
    factor = numpy.sinc(x / (2 * numpy.pi))**4 * 3 / (2 + numpy.cos(x))
    return omega, factor**2 * G * spacing


def is_fast(count):
    for factor in (2, 3, 5):
        while count % factor == 0:
            count //= factor
    return count == 1


def shape(place):
    """The first three modes of a cantilever of length 1, whose modal masses are those of the beam."""
    ratio = (numpy.sinh(ROOTS) - numpy.sin(ROOTS)) / (numpy.cosh(ROOTS) + numpy.cos(ROOTS))
    x = ROOTS * place
    return numpy.cosh(x) - numpy.cos(x) - ratio * (numpy.sinh(x) - numpy.sin(x)), 2 * ratio / ROOTS


def modal(frequencies, numerators):
    """Sum over the modes of numerator / (w_i^2 - w^2 + 2 i zeta w_i w)."""
    return lambda w: sum(b / (f * f - w * w + 2j * RATIO * f * w) for f, b in zip(frequencies, numerators))


def responses():
    frequencies = (ROOTS / ROOTS[0])**2
    tip, share = shape(1.0)
    middle, _ = shape(0.5)
    return {"driven.mass/displacement_x": modal([1], [1]), "carried.mass/displacement_x": modal([1], [-1]),
            "pushed.tip/displacement_z": modal(frequencies, tip * tip), "pushed.middle/displacement_z": modal(frequencies, tip * middle),
            "shaken.tip/displacement_z": modal(frequencies, -share * tip),
            "shaken.middle/displacement_z": modal(frequencies, -share * middle)}


def exact_squares():
    omega, variance = lines()
    squares = {}
    for name, response in responses().items():
        power = numpy.abs(response(omega))**2 * variance
        squares[name] = power.sum()
        squares[name.replace("displacement", "velocity")] = (omega**2 * power).sum()
    return squares


def add_mean(table, quantity, reference, values):
    """The mean of independent values, within the allowed standard errors."""
    error = values.std(ddof=1) / numpy.sqrt(values.size)
    table.add(f"{quantity} (standard error {error:.1e})", reference, values.mean(), ALLOWED * error, absolute=True)


def check_structures(table):
    found = table.run("verification/random-structures.prm", "structures")["analysis/members/point"]
    for name, square in exact_squares().items():
        add_mean(table, f"mean square of {name.replace('/', ', ')}", square, found[f"{name}/rms"][:] ** 2)


# Displacements of the two masses, gap of the stop and the energy it stores by its indentation.
MASSES, TEMPERATURE = (1.0, 2.0), 1.0
STOPS = {"elastic": {"middle": (0.5, lambda d: 10 * d**1.5, lambda d: 4 * d**2.5), "wall": (1.0, lambda d: 8 * d, lambda d: 4 * d**2)},
         "rigid": {"rigid_middle": (0.5, None, None)}}
LEVEL = 1.0


class Plane:
    """The density of the two displacements by the rule of the middle, whose error is far below the standard errors."""

    def __init__(self, stops):
        axis = (numpy.arange(1600) + 0.5) / 1600 * 14 - 8
        self.first, self.second = numpy.meshgrid(axis, axis, indexing="ij")
        self.energy = self.first**2 / 2 + (self.second - self.first)**2 / 2 + self.second**2
        self.indentation = {"middle": self.first - self.second, "rigid_middle": self.first - self.second, "wall": self.second}
        density = numpy.exp(-self.energy / TEMPERATURE)
        for name, (gap, force, energy) in stops.items():
            self.indentation[name] = self.indentation[name] - gap
            inside = numpy.maximum(self.indentation[name], 0)
            density = density * (numpy.exp(-energy(inside) / TEMPERATURE) if energy else inside <= 0)
        self.density = density / density.sum()

    def mean(self, values):
        return (values * self.density).sum()

    def density_at(self, values, level, width=0.07):
        """Of a displacement or a gap, by the slope of its distribution over a width around the level."""
        share = [self.mean(values < level + side * width / 2) for side in (-1, 1)]
        return (share[1] - share[0]) / width


def exact_pair(stops):
    plane = Plane(stops)
    values = {"mean displacement of the first": plane.mean(plane.first), "mean displacement of the second": plane.mean(plane.second),
              "mean square of the first": plane.mean(plane.first**2), "mean square of the second": plane.mean(plane.second**2),
              "mean square of the velocity of the first": TEMPERATURE / MASSES[0],
              "mean square of the velocity of the second": TEMPERATURE / MASSES[1],
              "rises of the first through 1 per unit of time":
                  plane.density_at(plane.first, LEVEL) * numpy.sqrt(TEMPERATURE / (2 * numpy.pi * MASSES[0]))}
    for name, (gap, force, _) in stops.items():
        if force:
            mass = MASSES[1] if name == "wall" else 1 / (1 / MASSES[0] + 1 / MASSES[1])
            inside = numpy.maximum(plane.indentation[name], 0)
            values[f"mean force of {name}"] = plane.mean(force(inside))
            values[f"share of time in contact of {name}"] = plane.mean(inside > 0)
            values[f"impacts per unit of time of {name}"] = (plane.density_at(plane.indentation[name], 0)
                                                             * numpy.sqrt(TEMPERATURE / (2 * numpy.pi * mass)))
    return values


def pair_members(analysis, stops, window):
    point = analysis["point"]
    found = {}
    for name in ("first", "second"):
        found[f"mean displacement of the {name}"] = point[f"pair.{name}/displacement_x/mean"][:]
        found[f"mean square of the {name}"] = point[f"pair.{name}/displacement_x/rms"][:] ** 2
        found[f"mean square of the velocity of the {name}"] = point[f"pair.{name}/velocity_x/rms"][:] ** 2
    found["rises of the first through 1 per unit of time"] = point["pair.first/displacement_x/up_crossing_rate"][:, 0]
    for name in stops:
        contact = analysis[f"contact/{name}"]
        if "contact_fraction" in contact:
            found[f"mean force of {name}"] = contact["normal_force/mean"][:]
            found[f"share of time in contact of {name}"] = contact["contact_fraction"][:]
        found[f"impacts per unit of time of {name}"] = contact["impacts"][:] / window
    return found


def check_pair(table):
    results = table.run("verification/random-pair.prm", "pair")
    for case, stops in STOPS.items():
        found = pair_members(results[f"analysis/{case}"], stops, 240.0)
        for quantity, reference in exact_pair(stops).items():
            add_mean(table, f"{case}: {quantity}", reference, found[quantity])


def check_coverage(table):
    """Student's interval for ten members holds the exact value in 95 of 100 cases: of 600 independent ones 570 +- 5.3."""
    student = 2.262  # nine degrees of freedom, 97.5 percent
    found = table.run("verification/random-structures.prm", "coverage", "Analyses=coverage")["analysis/coverage/point"]
    exact = exact_squares()
    for quantity in ("displacement", "velocity"):
        held = []
        for name in (f"driven.mass/{quantity}_x", f"carried.mass/{quantity}_x", f"pushed.tip/{quantity}_z", f"shaken.tip/{quantity}_z"):
            squares = found[f"{name}/rms"][:] ** 2
            error = squares.std(axis=1, ddof=1) / numpy.sqrt(squares.shape[1])
            held.append(numpy.abs(squares.mean(axis=1) - exact[name]) <= student * error)
        cases = numpy.concatenate(held)
        table.add(f"per cent of {cases.size} intervals of 95 % that hold the mean square of the {quantity}", 95, 100 * cases.mean(), 2,
                  absolute=True)


def check(table):
    check_structures(table)
    check_pair(table)
    if table.arguments.all:
        check_coverage(table)


if __name__ == "__main__":
    parser = arguments_of_checks()
    parser.add_argument("--all", action="store_true", help="the coverage of intervals too")
    main = Table(__file__, parser.parse_args())
    check(main)
    main.finish()
