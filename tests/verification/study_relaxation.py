#!/usr/bin/python3
"""The stiffness of the bumpers with the lowest peak of the acceleration, and its relaxation time.

For every gap and pair of dampings a search changes the stiffness from 0.1 to 30 until the peak of the
upward response curve is lowest; the curve covers β = 0.5 to 4 in steps of 0.005. A minimum at an end of
the stiffnesses is none.
"""
from studies import Study

CURVE, KEY = "Analysis/curve/Stepped sweep", "Analysis/best/Optimise/Key stiffness"
OVERRIDES = [f"{CURVE}/First frequency=0.5*natural", f"{CURVE}/Last frequency=4*natural",
             f"{CURVE}/Points=701", f"{KEY}/Lower=0.1", f"{KEY}/Upper=30"]
# Gaps of the reference table, at the paper's dampings, beside the grid over dampings.
PAPER = ["Analysis/rule/Parameter grid/Key gap/Values=0, 0.0657506, 0.1989975, 0.4, 0.7",
         "Analysis/rule/Parameter grid/Key xi/Values=0.1",
         "Analysis/rule/Parameter grid/Key gamma/Values=5"]


def rows(study, name, *overrides):
    results = study.run("bumper-design.prm", name, "Analyses=rule", *OVERRIDES,
                        *overrides)["analysis/rule"]
    peak, stiffness = (results[f"derived/best_{what}"][:] for what in ("objective", "stiffness"))
    for i, gap in enumerate(results["Variables.delta0"][:]):
        for j, xi in enumerate(results["Variables.xi"][:]):
            for k, gamma in enumerate(results["Variables.gamma"][:]):
                best = stiffness[i, j, k]
                inside = 0.101 < best < 29.9
                study.row(f"{gap:g}", f"{xi:g}", f"{gamma:g}", f"{2 * xi * gamma:g}",
                          f"{best:.2f}" if inside else "none within 0.1 … 30",
                          f"{2 * xi * gamma / best:.2f}" if inside else "", f"{peak[i, j, k]:.4f}")


def main():
    study = Study(__file__, "δ0", "ξ", "γ", "2ξγ", "λ_opt", "τ_r = 2ξγ/λ_opt", "least η_a*")
    rows(study, "paper", *PAPER)
    rows(study, "rule")
    study.finish()


if __name__ == "__main__":
    main()
