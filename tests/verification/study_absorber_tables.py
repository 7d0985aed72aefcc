#!/usr/bin/python3
"""Tables 3 and 5 of the paper on the vibro-impact damper, each number beside the program's.

usage: study_absorber_tables.py PROGRAM SOURCE [--page FILE] [--keep FOLDER]
"""
import csv

from studies import Study

FIELDS = {"A1 [m]": "point/structure.floor/displacement_x/amplitude",
          "V1 [m/s]": "point/structure.floor/velocity_x/amplitude",
          "A2 [m]": "point/damper.ball/displacement_x/amplitude",
          "V2 [m/s]": "point/damper.ball/velocity_x/amplitude",
          "F_left [N]": "contact/left/normal_force/maximum",
          "F_right [N]": "contact/right/normal_force/maximum"}


def published(study):
    file = study.arguments.source / "docs" / "gallery" / "published" / "absorber.csv"
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if line[0] != "#"]
    return csv.DictReader(lines, skipinitialspace=True)


def short(value):
    return f"{value:.0f}" if value > 1000 else f"{value:.4f}"


def main():
    study = Study(__file__, "table, row", *[f"{name}: paper / here" for name in FIELDS])
    rows = study.run("vibro-impact-absorber.prm", "rows", "Analyses=rows")["analysis/rows"]
    for line in published(study):
        place = int(line["place"])
        study.row(f"{line['table']}, {line['row']}",
                  *[f"{line[name] or '–'} / {short(rows[path][place].item())}"
                    for name, path in FIELDS.items()])
    study.finish()


if __name__ == "__main__":
    main()
