"""Runs of the shipped systems against independent reference figures, and the tables of both.

Every check makes a Table, fills it from runs of the program, and calls finish(): the table is
printed, written into a page of the gallery if one is named, and decides about the exit code.
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

import h5py

BEGIN, END = "<!-- table made by {} -->", "<!-- end of table -->"


class Table:
    """Rows of quantity, paper, reference, result, relative difference."""

    def __init__(self, script):
        parser = argparse.ArgumentParser()
        parser.add_argument("program", help="the vibroimpact program")
        parser.add_argument("source", type=pathlib.Path, help="folder of the source")
        parser.add_argument("--page", type=pathlib.Path, help="page that takes up the table")
        parser.add_argument("--keep", type=pathlib.Path, help="folder that keeps the results")
        parser.add_argument("--ranks", type=int, default=1, help="ranks of the runs")
        self.arguments = parser.parse_args()
        self.script = pathlib.Path(script).name
        self.rows, self.failed = [], 0

    def run(self, file, name, *overrides):
        """The opened results of a run of params/FILE, with the overrides KEY=VALUE."""
        folder = pathlib.Path(self.arguments.keep or tempfile.mkdtemp()) / name
        command = [self.arguments.program, str(self.arguments.source / "params" / file), "--output",
                   str(folder), "--overwrite"]
        for override in overrides:
            command += ["--set", override]
        if self.arguments.ranks > 1:
            command = ["mpirun", "-np", str(self.arguments.ranks)] + command
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return h5py.File(folder / "results.h5")

    def reference(self, name):
        """Rows of a reference table as dictionaries of numbers."""
        path = pathlib.Path(__file__).parent / "reference" / name
        with open(path, encoding="utf-8") as file:
            return [{key: float(value) for key, value in row.items() if "j" not in value}
                    for row in csv.DictReader(file)]

    def add(self, quantity, reference, value, tolerance, paper=None, absolute=False):
        """A figure that must lie within `tolerance`, relative unless `absolute`."""
        difference = value - reference if absolute else value / reference - 1
        good = abs(difference) <= tolerance
        self.failed += not good
        shown = f"{difference:+.1e}" + (" (absolute)" if absolute else "")
        self.rows.append((quantity, "" if paper is None else f"{paper:g}", f"{reference:.7g}",
                          f"{value:.7g}", shown + ("" if good else " **beyond tolerance**")))

    def add_digits(self, quantity, reference, value, paper=None):
        """A figure that must agree in every digit of the reference, given as text."""
        decimals = len(reference.split(".")[1]) if "." in reference else 0
        tolerance = 0.6 * 10.0**-decimals / abs(float(reference))
        self.add(quantity, float(reference), value, tolerance, paper)

    def markdown(self):
        head = ("quantity", "paper", "reference", "vibroimpact", "relative difference")
        lines = [head, ("---",) * len(head), *self.rows]
        return "".join("| " + " | ".join(line) + " |\n" for line in lines)

    def finish(self):
        text = self.markdown()
        print(text)
        if self.arguments.page:
            page = self.arguments.page.read_text(encoding="utf-8")
            begin = BEGIN.format(self.script)
            first, last = page.index(begin) + len(begin), page.index(END, page.index(begin))
            self.arguments.page.write_text(page[:first] + "\n" + text + page[last:],
                                           encoding="utf-8")
        print(f"{len(self.rows) - self.failed} of {len(self.rows)} within their tolerances")
        sys.exit(1 if self.failed else 0)


def nearest(values, wanted):
    """Position of the value closest to the wanted one."""
    return int(min(range(len(values)), key=lambda i: abs(values[i] - wanted)))
