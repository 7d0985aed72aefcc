#!/usr/bin/python3
"""Random vibration against stops beside the stationary density exp(-(v^2/2 + x^2/2 + U(x))/T) / Z, by quadrature; a sum of
independent means of which each may differ by chance.

With the density of x alone, p(x): mean force, share in contact and parts of the time above a level are its integrals; the
displacement rises through the level a at the rate p(a) sqrt(T/(2 pi)) (Rice), as impacts come at that of a = 1, and their
mean speed is sqrt(pi T/2).
"""
import numpy
import scipy.integrate

from systems import Table, arguments_of_checks

T, GAP, STIFFNESS = 1.0, 1.0, 10.0
LAWS = {"linear": (lambda d: STIFFNESS * d, lambda d: STIFFNESS * d**2 / 2),
        "hertz": (lambda d: STIFFNESS * d**1.5, lambda d: STIFFNESS * d**2.5 / 2.5),
        "rigid": (None, None)}
LEVELS = (-2.0, -1.0, 0.0, 0.5)
ALLOWED = 4.0  # standard errors of a mean


def integral(function, upper):
    return scipy.integrate.quad(function, -12, upper, points=[0, GAP] if upper > GAP else [0], epsabs=1e-12, limit=400)[0]


def density_of(law):
    """Of the displacement, times its integral, and this."""
    force, energy = LAWS[law]

    def density(x):
        inside = max(x - GAP, 0.0)
        return numpy.exp(-(x * x / 2 + (energy(inside) if energy else 0.0)) / T)

    return density, integral(density, GAP if force is None else 8.0)


def exact(law):
    force = LAWS[law][0]
    upper = GAP if force is None else 8.0
    density, whole = density_of(law)
    values = {"mean displacement": integral(lambda x: x * density(x), upper) / whole,
              "mean square of the displacement": integral(lambda x: x * x * density(x), upper) / whole,
              "mean square of the velocity": T,
              "impacts per unit of time": density(GAP) / whole * numpy.sqrt(T / (2 * numpy.pi)),
              "mean speed of impacts": numpy.sqrt(numpy.pi * T / 2)}
    for level in LEVELS:
        values[f"rises through {level:g} per unit of time"] = density(level) / whole * numpy.sqrt(T / (2 * numpy.pi))
        values[f"share of time above {level:g}"] = 1 - integral(density, level) / whole
    if force:
        values["mean force"] = scipy.integrate.quad(lambda x: force(x - GAP) * density(x), GAP, 8, epsabs=1e-12)[0] / whole
        values["share of time in contact"] = scipy.integrate.quad(density, GAP, 8, epsabs=1e-12)[0] / whole
    return values


def rates():
    """Rows of published/random-stop-rates.csv: level, rate at which the displacement rises through it."""
    density, whole = density_of("linear")
    return [f"{level:.2f}, {density(level) / whole * numpy.sqrt(T / (2 * numpy.pi)):.6f}" for level in numpy.linspace(-3.5, 2, 111)]


def members(analysis, law, window):
    """Of each member; speeds and rates are weighted sums over impacts, so that their means are not biased by the number."""
    stop = f"contact/{law}_stop/"
    found = {"mean displacement": analysis["point/oscillator.mass/displacement_x/mean"][:],
             "mean square of the displacement": analysis["point/oscillator.mass/displacement_x/rms"][:] ** 2,
             "mean square of the velocity": analysis["point/oscillator.mass/velocity_x/rms"][:] ** 2,
             "impacts per unit of time": analysis[stop + "impacts"][:] / window,
             "mean speed of impacts": analysis[stop + "approach_speed/mean"][:]}
    levels = list(analysis["crossing_level"][:])
    for i, level in ((levels.index(level), level) for level in LEVELS):
        found[f"rises through {level:g} per unit of time"] = analysis["point/oscillator.mass/displacement_x/up_crossing_rate"][:, i]
        found[f"share of time above {level:g}"] = analysis["point/oscillator.mass/displacement_x/fraction_above"][:, i]
    if law != "rigid":
        found["mean force"] = analysis[stop + "normal_force/mean"][:]
        found["share of time in contact"] = analysis[stop + "contact_fraction"][:]
    return found


def check_laws(table, results):
    distances = []
    for law in LAWS:
        found = members(results[f"analysis/{law}"], law, 700.0)
        for quantity, value in exact(law).items():
            error = found[quantity].std(ddof=1) / numpy.sqrt(len(found[quantity]))
            distances.append((found[quantity].mean() - value) / error)
            table.add(f"{law}: {quantity} (standard error {error:.1e})", value, found[quantity].mean(), ALLOWED * error, absolute=True)
    table.add("mean of the squared distances in standard errors is about 1", 1, numpy.mean(numpy.square(distances)), 1.0, absolute=True)
    force = results["analysis/linear/contact/linear_stop/normal_force/mean"][:]
    derived = results["analysis/linear/derived"]
    table.add("derived mean force", force.mean(), derived["force"][()], 1e-14)
    table.add("its derived standard error", force.std(ddof=1) / numpy.sqrt(len(force)), derived["force_error"][()], 1e-13)
    table.add("and the quantile of 0.9", numpy.quantile(force, 0.9), derived["force_high"][()], 1e-14)


def check_rates(table):
    file = table.arguments.source / "docs" / "gallery" / "published" / "random-stop-rates.csv"
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")][1:]
    table.add_whole("points of random-stop-rates.csv", [111], [sum(row == line for row, line in zip(rates(), lines))])


def check_coverage(table):
    """The interval of Student's distribution for ten members holds the exact value in 95 of 100 cases."""
    student = 2.262  # nine degrees of freedom, 97.5 percent
    free = table.run("random-stop.prm", "coverage", "Analyses=coverage")["analysis/coverage"]
    for name, field in (("displacement", "displacement_x"), ("velocity", "velocity_x")):
        squares = free[f"point/oscillator.mass/{field}/rms"][:] ** 2
        error = squares.std(axis=1, ddof=1) / numpy.sqrt(squares.shape[1])
        held = abs(squares.mean(axis=1) - T) <= student * error
        # Of 100 cases 95 +- 2.2; four standard errors.
        table.add(f"100 ensembles of ten: intervals of 95 % that hold the mean square of the {name}", 95, held.sum(), 8.8, absolute=True)
        table.add(f"all 1000: mean square of the {name} (standard error {squares.std(ddof=1) / numpy.sqrt(squares.size):.1e})", T,
                  squares.mean(), ALLOWED * squares.std(ddof=1) / numpy.sqrt(squares.size), absolute=True)


def check(table):
    check_laws(table, table.run("random-stop.prm", "shipped"))
    check_rates(table)
    if table.arguments.all:
        check_coverage(table)


if __name__ == "__main__":
    parser = arguments_of_checks()
    parser.add_argument("--all", action="store_true", help="the coverage of intervals too, half a minute")
    main = Table(__file__, parser.parse_args())
    check(main)
    main.finish()
