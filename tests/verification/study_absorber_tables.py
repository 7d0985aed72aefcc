#!/usr/bin/python3
"""Tables 1 to 6 of the paper on the vibro-impact damper with its columns, each number beside the program's.

usage: study_absorber_tables.py PROGRAM SOURCE [--page FILE] [--keep FOLDER]
"""
import csv
import itertools
import math

from page_tables import markdown, write_into
from systems import Table

FILE = "vibro-impact-absorber.prm"
HEAVY = ("Variables/m2=37.88", "Variables/k2=414.6", "Variables/C=0.0747")
FORCE, STIFFNESS, MASS, DAMPING, OMEGA = 800.0, 3.95e4, 1000.0, 452.0, 7.23
FIELDS = {"A1 [m]": "point/structure.floor/displacement_x/amplitude",
          "V1 [m/s]": "point/structure.floor/velocity_x/amplitude",
          "A2 [m]": "point/damper.ball/displacement_x/amplitude",
          "V2 [m/s]": "point/damper.ball/velocity_x/amplitude",
          "F_left [N]": "contact/left/normal_force/maximum",
          "F_right [N]": "contact/right/normal_force/maximum"}
REDUCTIONS = {"reduction of A1 in %": "A1 [m]", "reduction of V1 in %": "V1 [m/s]"}


def published(source):
    file = source / "docs" / "gallery" / "published" / "absorber.csv"
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if line[0] != "#"]
    return csv.DictReader(lines, skipinitialspace=True)


def without_damper():
    """The floor alone is a linear oscillator."""
    amplitude = FORCE / math.hypot(STIFFNESS - MASS * OMEGA**2, DAMPING * OMEGA)
    return {"A1 [m]": amplitude, "V1 [m/s]": OMEGA * amplitude, "regime": "without damper"}


def figures(analysis, place):
    found = {name: analysis[path][place].item() for name, path in FIELDS.items() if path in analysis}
    return found | {"regime": regime(analysis, place)}


def regime(analysis, place):
    """(kT,n,m), or the impacts in each period of a motion that does not repeat."""
    if not any(f"contact/{side}" in analysis for side in ("left", "right")):
        return "no impacts"
    periods = int(analysis["regime/period_multiple"][place].item())
    which = "repetition" if periods else "period"
    counts = [analysis[f"regime/impacts_per_{which}/{side}"][place].item()
              if f"regime/impacts_per_{which}/{side}" in analysis else 0 for side in ("left", "right")]
    text = "({},{:g},{:g})".format("T" if periods < 2 else f"{periods}T", *counts)
    return text if periods else f"does not repeat; {text[1:-1].replace('T,', '')} impacts per T"


def runs(table):
    """What a row's place in the published table stands for."""
    rows = table.run(FILE, "rows", "Analyses=rows, linear")["analysis"]
    heavy = table.run(FILE, "left", "Analyses=left_only", "Analysis left_only/Record=extreme values, impacts, regime",
                      *HEAVY)["analysis/left_only"]
    named = {"": without_damper(), "linear": figures(rows["linear"], 0), "left": figures(heavy, 0)}
    return lambda place: named[place] if place in named else figures(rows["rows"], int(place))


def short(name, value):
    return f"{value:.0f}" if name[0] == "F" else f"{value:.4f}" if value < 1 else f"{value:.1f}"


def computed(name, found, free):
    if name == "regime":
        return found["regime"]
    if name in REDUCTIONS:
        return f"{100 * (1 - found[REDUCTIONS[name]] / free[REDUCTIONS[name]]):.1f}"
    return short(name, found[name]) if found.get(name) else "–"


def lines(rows, find):
    """Head and body of one table; columns that the paper's table does not have are left out."""
    names = [name for name in rows[0] if name not in ("table", "row", "place") and any(r[name] for r in rows)]
    yield ["row", *(f"{name}: paper / here" for name in names)]
    for row in rows:
        found = find(row["place"])
        yield [row["row"], *(f"{row[name]} / {computed(name, found, find(''))}" if row[name] else "" for name in names)]


def main():
    table = Table(__file__)
    find = runs(table)
    for number, rows in itertools.groupby(published(table.arguments.source), lambda row: row["table"]):
        text = markdown([*lines(list(rows), find)])
        name = f"{table.script}, {'Table ' + number if number != 'text' else number}"
        print(f"{name}\n{text}")
        if table.arguments.page:
            write_into(table.arguments.page, name, text)


if __name__ == "__main__":
    main()
