#!/usr/bin/python3
"""What changes in the figures of the vibro-impact damper when settling, window or step control are
changed, for rows of the tables whose motion repeats.

The cells are the largest relative changes against the shipped file. Takes about two minutes.
usage: study_absorber.py PROGRAM SOURCE [--page FILE] [--keep FOLDER]
"""
from studies import Study

SWEEP = "Analysis/motion/Stepped sweep/"
CHANGES = [("settling time and window doubled", [f"{SWEEP}Settling cycles=3000",
                                                 f"{SWEEP}Recorded cycles=920"]),
           ("all tolerances 100 times tighter", ["Integration/Relative tolerance=1e-11",
                                                 "Integration/Absolute tolerance=1e-14 m"]),
           ("method rk throughout", ["Integration/Method=rk"])]
HEAVY = {"m2": 37.88, "k2": 414.6, "C": 0.0747}
ROWS = {"Table 1, row 2": {"m2": 20, "k2": 3190, "C": 0.06},
        "Table 1, row 3": {},
        "Table 1, row 5": {"m2": 19.85, "k2": 3190, "C": 0.0564},
        "Table 2, row 2": {"E4": 2.1e7},
        "Table 5, row 1": HEAVY | {"E2": 2.1e7, "nu2": 0.49},
        "Table 5, row 3": HEAVY | {"E2": 2.1e7, "nu2": 0.49, "E4": 2.1e7, "nu4": 0.49}}
EXCURSIONS = [f"point/{point}/{quantity}_x/peak_to_peak"
              for point in ("structure.floor", "damper.ball")
              for quantity in ("displacement", "velocity")]
FORCES = [f"contact/{side}/normal_force/maximum" for side in ("left", "right")]


def figures(study, name, values, overrides):
    motion = study.run("vibro-impact-absorber.prm", name, "Analyses=motion",
                       "Analysis/motion/Record=extreme values",
                       *(f"Variables/{key}={value}" for key, value in values.items()),
                       *overrides)["analysis/motion"]
    return [[motion[path][0, 0] for path in group] for group in (EXCURSIONS, FORCES)]


def largest(before, after):
    return max(abs(b / a - 1) for a, b in zip(before, after) if a > 0)


def main():
    study = Study(__file__, "row", *(f"{what}, {change}" for change, _ in CHANGES
                                     for what in ("A and V", "forces")))
    for number, (row, values) in enumerate(ROWS.items()):
        shipped = figures(study, f"study-{number}", values, [])
        cells = []
        for change, (_, overrides) in enumerate(CHANGES):
            changed = figures(study, f"study-{number}-{change}", values, overrides)
            cells += [f"{largest(*pair):.1e}" for pair in zip(shipped, changed)]
        study.row(row, *cells)
    study.finish()


if __name__ == "__main__":
    main()
