#!/usr/bin/python3
"""What few modes make of the impact of two beams with heads, and what is known of it beforehand."""
import json

from studies import Study

FILE = "verification/beam-release.prm"
MODES = (1, 2, 3, 4, 8, 12)
ALL = 60


def summary(study, modes):
    variables = f"Variables=V = 0.2 m/s, modes = {modes}, elements = 240"
    folder = study.folder_of_run(FILE, f"truncation-{modes}", variables)
    entries = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["values"]
    return {name.rsplit(".", 1)[-1]: entries[name]["value"]
            for name in ("contact.heads.flexibility_share", "contact.heads.impact_error",
                         "analysis.release.contact.heads.impact[1].peak_force")}


def main():
    study = Study(__file__, "N", "`flexibility_share`", "`impact_error`", f"peak force against {ALL} modes")
    peak = summary(study, ALL)["peak_force"]
    for modes in MODES:
        values = summary(study, modes)
        study.row(str(modes), f"{values['flexibility_share']:.6f}", f"{100 * values['impact_error']:.1f} %",
                  f"{100 * (values['peak_force'] / peak - 1):+.1f} %")
    study.finish()


if __name__ == "__main__":
    main()
