#!/usr/bin/python3
"""Error against tolerance of random contacts of four laws, as a table and a figure.

Given the program study_contact_errors in place of vibroimpact."""
import csv
import subprocess

import study_figures
from studies import Study


def measured(program):
    """{law: [(tolerance, median, largest)]}"""
    text = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    curves = {}
    for line in csv.DictReader(text.splitlines()):
        curves.setdefault(line["law"], []).append([float(line[key]) for key in ("tolerance", "median", "largest")])
    return curves


def draw(study, curves):
    figure, axes, colours = study_figures.panels(study, 1)
    panel = axes[0]
    for colour, (law, rows) in zip(colours, curves.items()):
        tolerances, medians, largest = zip(*rows)
        panel.loglog(tolerances, largest, "o-", color=colour, label=law)
        panel.loglog(tolerances, medians, ":", color=colour)
    panel.loglog(tolerances, [10 * tolerance for tolerance in tolerances], "k--", label="10 times the tolerance")
    panel.set_xlabel("relative tolerance")
    panel.set_ylabel("relative error, largest and median")
    panel.legend()
    study_figures.save(study, figure, "contact-errors.png")


def main():
    study = Study(__file__)
    curves = measured(study.arguments.program)
    study.head = ("tolerance", *curves)
    for at in zip(*curves.values()):
        study.row(f"{at[0][0]:.0e}", *(f"{largest:.1e}" for _, _, largest in at))
    draw(study, curves)
    study.finish()


if __name__ == "__main__":
    main()
