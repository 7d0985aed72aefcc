#!/usr/bin/python3
"""The heavy vibro-impact damper at forces slightly above the calibrated one: where its chaotic motion begins to burst.

Rows 1 to 6 of Table 3 and row 1 of Table 5 with contacts located, from rest; largest force at the barrier and A1 over
20 000 periods after 1500. Takes about two minutes.
usage: study_intermittency.py PROGRAM SOURCE [--page FILE] [--keep FOLDER]
"""
from studies import Study

FORCES = (800, 804, 805, 806, 807, 808, 812, 820)
STEEL = "2.1e11, 0.3"
#         left wall; both surfaces of the barrier: Young's modulus and Poisson's ratio of each
ROWS = {"3, 1": (STEEL, STEEL, STEEL), "3, 2": (STEEL, STEEL, "2.1e7, 0.3"), "3, 3": (STEEL, STEEL, "2.1e7, 0.4"),
        "3, 4": (STEEL, STEEL, "2.1e7, 0.49"), "3, 5": (STEEL, "2.1e7, 0.4", "2.1e7, 0.4"),
        "3, 6": (STEEL, "2.1e7, 0.49", "2.1e7, 0.49"), "5, 1": ("2.1e7, 0.49", STEEL, STEEL)}
KEYS = ("m2", "k2", "C", "E2", "nu2", "E3", "nu3", "E4", "nu4")
A1, FORCE = "point/structure.floor/displacement_x/amplitude", "contact/right/normal_force/maximum"


def cases():
    keys = ", ".join(f"Variables/{key}" for key in KEYS)
    return "; ".join([keys, *(", ".join(["37.88, 414.6, 0.0747", *sides]) for sides in ROWS.values())])


def main():
    study = Study(__file__, "P, N", *[f"Table {row}: A1, m; F right, N" for row in ROWS])
    for force in FORCES:
        run = study.run("vibro-impact-absorber.prm", f"force-{force}", "Analyses=rows",
                        f"Excitation/wind/Amplitude={force} N", f"Analysis rows/Parameter grid/Cases={cases()}",
                        "Analysis motion/Record=extreme values, impacts",
                        "Analysis motion/Stepped sweep/Recorded cycles=20000")["analysis/rows"]
        study.row(f"{force}", *[f"{run[A1][i].item():.4f}; {run[FORCE][i].item():.0f}" for i in range(len(ROWS))])
    study.finish()


if __name__ == "__main__":
    main()
