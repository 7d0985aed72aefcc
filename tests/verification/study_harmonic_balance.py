#!/usr/bin/python3
"""Folds of the isolator by averaging, by harmonic balance with more and more harmonics, and exact, with the
order at which they converge.
"""
import math

from check_harmonic_balance import DESIGNS, HARMONICS, QUICKLY, found_folds
from check_isolator_branches import FOLDS
from studies import Study
from study_averaging import folds, listed


def main():
    study = Study(__file__, "μ", "f", "averaging", *(f"H = {h}" for h in HARMONICS), "exact", "order")
    analyses = study.run("isolator-branches.prm", "balances", "Analyses=averages, designs",
                         *QUICKLY)["analysis"]
    stops = {"averages": [(mu, .52, exact) for mu, exact in FOLDS.items()],
             "designs": [(*stop, exact) for stop, (_, exact) in DESIGNS.items()]}
    for name, cases in stops.items():
        for case, (mu, force, exact) in enumerate(cases):
            found = found_folds(analyses[name], case)
            study.row(f"{mu:g}", f"{force:g}", listed(folds(mu, force)), *columns(found),
                      listed(exact), order(found, exact))
    study.finish()


def columns(found):
    """The last number of harmonics is not computed for all."""
    return [listed(places) for places in found] + [""] * (len(HARMONICS) - len(found))


def order(found, exact):
    """Slope of the errors between 9 harmonics and the most, where the reference has the digits."""
    orders = []
    last = HARMONICS[len(found) - 1]
    for number, place in enumerate(exact):
        digits = 1e-13 if round(place, 9) != place else 6e-7
        errors = [abs(places[number] - place) for places in (found[HARMONICS.index(9)], found[-1])]
        if errors[1] > 2 * digits:
            orders.append(f"{math.log(errors[0] / errors[1]) / math.log(last / 9):.1f}")
    return ", ".join(orders)


if __name__ == "__main__":
    main()
