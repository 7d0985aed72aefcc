#!/usr/bin/python3
"""Folds of the averaged response of the isolator beside the jumps of the sweeps.

Averaging: equations (7) and (8) of the paper, which for an amplitude a > 1 are a quadratic equation
for the square of the frequency; its folds are where that root has an extremum over a.
"""
import math

import numpy
from scipy.optimize import minimize_scalar

import check_isolator
from studies import Study

ZETA0, ZETA1 = 0.01, 0.2


def squared_frequencies(a, mu, f):
    """Both roots of (8), nan where there are none."""
    angle = numpy.arccos(1 / a)
    share = 2 * angle - numpy.sin(2 * angle)
    p = mu * a / (2 * math.pi) * share
    q = a / math.pi * (ZETA0 * math.pi + ZETA1 * share)
    # (p + a/2 - a s/2)^2 + s q^2 - f^2/4 = 0
    square, linear, constant = a**2 / 4, q**2 - a * (p + a / 2), (p + a / 2)**2 - f**2 / 4
    with numpy.errstate(invalid="ignore"):
        root = numpy.sqrt(linear**2 - 4 * square * constant)
        return (-linear - root) / (2 * square), (-linear + root) / (2 * square)


def folds(mu, f):
    """Frequencies at which the upper root has an extremum, none if it is monotone."""
    a = numpy.linspace(1 + 1e-9, 8, 200001)
    upper = squared_frequencies(a, mu, f)[1]
    inside = numpy.isfinite(upper[:-2]) & numpy.isfinite(upper[1:-1]) & numpy.isfinite(upper[2:])
    turn = numpy.sign(numpy.diff(upper[:-1])) * numpy.sign(numpy.diff(upper[1:])) < 0
    found = []
    for i in numpy.flatnonzero(inside & turn) + 1:
        sign = 1 if upper[i] < upper[i - 1] else -1
        best = minimize_scalar(lambda x: sign * squared_frequencies(x, mu, f)[1],
                               bounds=(a[i - 1], a[i + 1]), method="bounded",
                               options={"xatol": 1e-12})
        found.append(math.sqrt(sign * best.fun))
    return sorted(found)


def main():
    study = Study(__file__, "μ", "f", "folds by averaging", "jumps of the sweeps")
    analyses = study.run("isolator-stop.prm", "folds", "Analyses=folds, designs")["analysis"]
    for name, stops in (("folds", check_isolator.STOPS), ("designs", check_isolator.DESIGNS)):
        ends = [analyses[name]["jump_" + end][:] for end in ("from", "to")]
        places = (ends[0] + ends[1]) / 2
        for case, (mu, f, _) in enumerate(stops):
            jumps = sorted(place for place in places[case].ravel() if math.isfinite(place))
            study.row(f"{mu:g}", f"{f:g}", listed(folds(mu, f)), listed(jumps))
    study.finish()


def listed(frequencies):
    return ", ".join(f"{frequency:.6f}" for frequency in frequencies) or "none"


if __name__ == "__main__":
    main()
