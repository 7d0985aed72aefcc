#!/usr/bin/python3
"""Least stiffness with which the isolator's resonance jumps: by the hysteresis set of the expanded equation, by
the averaged equation, and as the exact cusp of the locus of folds.
"""
import math

from studies import Study

DESIGN = "Analysis/design/Isolator design/"
FORCE = 0.52


def by_closed_form(study, force, limit):
    return study.run("isolator-design.prm", f"{limit}-{force}", DESIGN + "Repeat=",
                     DESIGN + "Stiffness key=", DESIGN + "Clearance key=", DESIGN + "Points=2",
                     DESIGN + "Jump limit=" + limit, f"Variables/clearance={FORCE / force!r}"
                     )["analysis/design/present/largest_stiffness"][()]


def beside(limit, exact):
    return f"{limit:.4f} ({limit / exact - 1:+.1%})" if math.isfinite(limit) else "none"


def main():
    study = Study(__file__, "f", "H, λ = 1 in α₁", "averaging", "exact cusp", "its λ")
    cusps = study.run("isolator-design.prm", "cusps", "Analyses=cusps")["analysis/cusps"]
    for row, force in enumerate(cusps["Variables.force"][:]):
        limits = [by_closed_form(study, force, limit)
                  for limit in ("hysteresis set", "averaged response")]
        stiffness = cusps["special/Variables.stiffness"][row, 0]
        ratio = cusps["special/frequency"][row, 0]
        study.row(f"{force:.5g}", *(beside(limit, stiffness) for limit in limits),
                  f"{stiffness:.6f}", f"{ratio:.6f}")
    study.finish()


if __name__ == "__main__":
    main()
