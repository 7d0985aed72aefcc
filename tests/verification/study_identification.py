#!/usr/bin/python3
"""What three sets of formulas make of the pulses between two beams, by approach speed."""
import numpy

from studies import Study

CLASSES = (("above 0.3", 0.3, numpy.inf), ("0.1–0.3", 0.1, 0.3), ("0.03–0.1", 0.03, 0.1),
           ("below 0.03", 0, 0.03))


class Impacts:
    """All impacts of all releases."""

    def __init__(self, analysis):
        self.group = analysis["contact/heads"]
        self.present = ~numpy.isnan(self.group["impact/approach_speed"][:])

    def of(self, path):
        return self.group[path][:][self.present]


def percent(value):
    return f"{100 * value:.2g} %"


def fit(speed, restitution):
    """a, b of e = a v^b by least squares in ln e."""
    exponent, logarithm = numpy.polyfit(numpy.log(speed), numpy.log(restitution), 1)
    return numpy.exp(logarithm), exponent


def main():
    study = Study(__file__, "approach speed, m/s", "impacts", "e of the motion", "e by `exact`",
                  "without", "largest error of v_c by `exact`",
                  "median e by `corrected`, `printed`", "v_c too high by `corrected`, `printed`")
    impacts = Impacts(study.run("impact-identification.prm", "speeds",
                                "Analyses=speeds")["analysis/speeds"])
    speed = impacts.of("impact/approach_speed")
    motion = impacts.of("impact/restitution_coefficient")
    found = {(name, key): impacts.of(f"identification/{name}/{key}")
             for name in ("exact", "corrected", "printed")
             for key in ("restitution_coefficient", "approach_speed")}
    exact = found["exact", "restitution_coefficient"]
    for name, low, high in CLASSES:
        chosen = (speed >= low) & (speed < high)
        known = chosen & ~numpy.isnan(exact)
        error = numpy.abs(found["exact", "approach_speed"][known] / speed[known] - 1).max()
        medians, factors = [], []
        for other in ("corrected", "printed"):
            medians.append(numpy.nanmedian(found[other, "restitution_coefficient"][chosen]))
            factors.append(numpy.nanmedian(found[other, "approach_speed"][chosen] / speed[chosen]))
        study.row(name, str(chosen.sum()), f"{motion[chosen].min():.3f}–{motion[chosen].max():.3f}",
                  f"{exact[known].min():.3f}–{exact[known].max():.3f}",
                  str(chosen.sum() - known.sum()), percent(error),
                  ", ".join(f"{value:.3f}" for value in medians),
                  ", ".join(f"{value:.2f}" for value in factors))
    fast = (speed >= 0.1) & (exact > 0)
    coefficient, exponent = fit(speed[fast], exact[fast])
    study.row("fit above 0.1", str(fast.sum()), "", f"{coefficient:.4f} v_c^{exponent:.5f}", "", "",
              "", "")
    study.finish()


if __name__ == "__main__":
    main()
