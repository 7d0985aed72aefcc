#!/usr/bin/python3
"""The stiffness of the bumpers with the lowest peak of the acceleration, and its relaxation time.

For every pair of dampings and gap the response curves over 15 stiffnesses are swept upward; a
parabola through the three lowest peaks over the logarithm of the stiffness finds the best one.
"""
import math

import numpy

from studies import Study

#        delta0, xi, gamma
CASES = [("0.7", "0.1", "5"), ("0.4", "0.1", "5"), ("0.1989975", "0.1", "5"),
         ("0.0657506", "0.1", "5"), ("0", "0.1", "5"), ("0.1", "0.05", "5"), ("0.1", "0.1", "2"),
         ("0.1", "0.1", "5"), ("0.1", "0.1", "10"), ("0.1", "0.2", "2"), ("0.1", "0.2", "5")]


def best_stiffness(study, gap, xi, gamma):
    analysis = study.run("bumpers.prm", f"relaxation-{gap}-{xi}-{gamma}", "Analyses=relaxation",
                         f"Variables/delta0={gap}", f"Variables/xi={xi}",
                         f"Variables/gamma={gamma}")["analysis/relaxation"]
    peak = analysis["point/oscillator.mass/acceleration_x/peak_to_peak_excursion"][:, :, 0].max(1)
    stiffness = numpy.log(analysis["Variables.lambda"][:])
    lowest = int(peak.argmin())
    if lowest in (0, len(peak) - 1):
        return None
    near = slice(lowest - 1, lowest + 2)
    fit = numpy.polyfit(stiffness[near], peak[near], 2)
    return math.exp(-fit[1] / (2 * fit[0]))


def main():
    study = Study(__file__, "δ0", "ξ", "γ", "λ_opt", "τ_r = 2ξγ/λ_opt")
    for gap, xi, gamma in CASES:
        best = best_stiffness(study, gap, xi, gamma)
        if best is None:
            study.row(gap, xi, gamma, "not within 0.2 … 5", "")
        else:
            study.row(gap, xi, gamma, f"{best:.2f}",
                      f"{2 * float(xi) * float(gamma) / best:.2f}")
    study.finish()


if __name__ == "__main__":
    main()
