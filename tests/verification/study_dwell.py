#!/usr/bin/python3
"""Where an upward sweep past the bumpers jumps, by the periods it stays at each frequency.

The jump is the largest fall of the displacement between two frequencies, the lower one is given.
With a short stay the motion is carried past the end of its branch before it has had the time to
leave it. `long`: up to 2000 periods, ended when the motion is steady to 1e-8.
"""
import math

import numpy

from studies import Study

STEP = 0.005
#         delta0, lambda, frequencies from within the certain contact to beyond the jump
CASES = [("0.7", "10", 1.05, 1.25), ("0.7", "100", 1.05, 1.40), ("0.4", "10", 1.15, 1.55),
         ("0.4", "100", 1.15, 1.95), ("0.1989975", "10", 1.35, 1.90),
         ("0.0657506", "10", 1.95, 2.55)]
STAYS = [("2 periods", 2, "0"), ("5 periods", 5, "0"), ("20 periods", 20, "0"),
         ("100 periods", 100, "0"), ("long", 2000, "1e-8")]


def jump(study, gap, stiffness, first, last, stay):
    name, periods, tolerance = stay
    sweep = "Analysis/upward/Stepped sweep/"
    keys = {"First frequency": f"{first} rad/s", "Last frequency": f"{last} rad/s",
            "Points": round((last - first) / STEP) + 1, "Settling cycles": periods,
            "Minimum settling cycles": min(periods, 5), "Steadiness tolerance": tolerance,
            "Recorded cycles": 1}
    results = study.run("bumpers.prm", f"dwell-{gap}-{stiffness}-{name.replace(' ', '-')}",
                        "Analyses=upward", f"Variables/delta0={gap}", f"Variables/lambda={stiffness}",
                        *(f"{sweep}{key}={value}" for key, value in keys.items()))
    upward = results["analysis/upward"]
    frequency = upward["frequency"][:] * 2 * math.pi
    travel = upward["point/oscillator.mass/displacement_x/peak_to_peak"][:, 0]
    return f"{frequency[numpy.argmin(numpy.diff(travel))]:.3f}"


def main():
    study = Study(__file__, "δ0", "λ", *(name for name, *_ in STAYS))
    for gap, stiffness, first, last in CASES:
        study.row(gap, stiffness, *(jump(study, gap, stiffness, first, last, stay)
                                    for stay in STAYS))
    study.finish()


if __name__ == "__main__":
    main()
