#!/usr/bin/python3
"""What changes in the figures of the electromechanical system when dwell, window, step control or
the time constant of the motor are changed.

Every column is a run of the shipped file with one of them changed; the cells are relative changes.
Takes about three minutes.
usage: study_electromechanical.py PROGRAM SOURCE [--page FILE] [--keep FOLDER]
"""
from studies import Study

SWEEP = "Analysis/motion/Stepped sweep/"
CHANGES = [("settling time and window doubled", [f"{SWEEP}Settling cycles=1948",
                                                 f"{SWEEP}Recorded cycles=3896"]),
           ("all tolerances 100 times tighter", ["Integration/Relative tolerance=1e-11",
                                                 "Integration/Absolute tolerance=1e-14 m"]),
           ("τ = 1 s instead of 0.1 s", ["Body/rotor/Motor/Time constant=1 s"])]
CASING = "point/machine.casing/absolute_displacement_y/peak_to_peak"
CONTACT = {"largest contact force, N": ("contact/lower/normal_force/maximum", 1),
           "deepest penetration, µm": ("contact/lower/gap/minimum", -1e6),
           "smallest gap above, mm": ("contact/upper/gap/minimum", 1e3)}


def figures(study, clearance, name, overrides):
    """Name and value of what the page reports at one clearance in mm."""
    motion = study.run("electromechanical.prm", f"study-{clearance}-{name}", "Analyses=motion",
                       f"Variables/c={clearance} mm", *overrides)["analysis/motion"]
    found = {"peak-to-peak of the casing, mm": motion[CASING][0, 0] * 1e3}
    if clearance == 5:
        found |= {label: motion[path][0, 0] * factor for label, (path, factor) in CONTACT.items()}
    return found


def main():
    study = Study(__file__, "quantity", "as shipped", *(name for name, _ in CHANGES))
    for clearance in (2, 5):
        shipped = figures(study, clearance, "shipped", [])
        changed = [figures(study, clearance, str(number), overrides)
                   for number, (_, overrides) in enumerate(CHANGES)]
        for name, value in shipped.items():
            study.row(f"{name}, c = {clearance} mm", value,
                      *(f"{other[name] / value - 1:+.1e}" for other in changed))
    study.finish()


if __name__ == "__main__":
    main()
