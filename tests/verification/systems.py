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
import typing

import h5py
import numpy

from page_tables import markdown, table_in, write_into


class Row(typing.NamedTuple):
    """One figure beside its reference; several whole numbers that belong together are a tuple."""

    quantity: str
    paper: object
    reference: object
    value: object
    tolerance: float
    absolute: bool
    differences: object = None  # from the reference, point by point, where the figure sums them up

    def difference(self):
        """From the reference, relative unless `absolute`; None between tuples."""
        if isinstance(self.value, tuple):
            return None
        return self.value - self.reference if self.absolute else self.value / self.reference - 1

    def good(self):
        difference = self.difference()
        return (self.value == self.reference if difference is None
                else abs(difference) <= self.tolerance)

    def cells(self):
        difference = self.difference()
        if difference is None:
            last = "same" if self.good() else "**different**"
        else:
            last = signed(difference, self.absolute)
            last += "" if self.good() else " **beyond tolerance**"
        return (self.quantity, shown(self.paper, "g"), shown(self.reference), shown(self.value),
                last)

    def agrees_with(self, cells):
        """Does a line of a page have this quantity, the same references, and a figure within the
        tolerance of the new one?"""
        if tuple(cells[:3]) != tuple(text.strip() for text in self.cells()[:3]):
            return False
        if isinstance(self.value, tuple):
            return cells[3] == shown(self.value)
        allowed = self.tolerance * (1 if self.absolute else abs(self.value)) + 1e-6 * abs(self.value)
        return abs(self.value - float(cells[3])) <= allowed


def shown(value, precision=".7g"):
    """A number, a tuple of whole numbers or nothing as the text of a cell."""
    if isinstance(value, tuple):
        return ", ".join(f"{number:g}" for number in value)
    return "" if value is None else format(value, precision)


def signed(difference, absolute):
    return f"{difference:+.1e}" + (" (absolute)" if absolute else "")


def arguments_of_checks():
    """The parser of what every check is given."""
    parser = argparse.ArgumentParser()
    parser.add_argument("program", help="the vibroimpact program")
    parser.add_argument("source", type=pathlib.Path, help="folder of the source")
    parser.add_argument("--page", type=pathlib.Path, help="page that takes up the table")
    parser.add_argument("--compare", type=pathlib.Path,
                        help="page whose table must have these figures")
    parser.add_argument("--keep", type=pathlib.Path, help="folder that keeps the results")
    parser.add_argument("--ranks", type=int, default=1, help="ranks of the runs")
    return parser


class Table:
    """Rows of quantity, paper, reference, result, relative difference."""

    def __init__(self, script, arguments=None):
        self.arguments = arguments or arguments_of_checks().parse_args()
        self.script = pathlib.Path(script).name
        self.rows = []

    def run(self, file, name, *overrides):
        """The opened results of a run of params/FILE, with the overrides KEY=VALUE."""
        return h5py.File(self.folder_of_run(file, name, *overrides) / "results.h5")

    def folder_of_run(self, file, name, *overrides):
        folder = pathlib.Path(self.arguments.keep or tempfile.mkdtemp()) / name
        command = [self.arguments.program, str(self.arguments.source / "params" / file), "--output",
                   str(folder), "--overwrite"]
        for override in overrides:
            command += ["--set", override]
        if self.arguments.ranks > 1:
            command = ["mpirun", "-np", str(self.arguments.ranks)] + command
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return folder

    def reference(self, name):
        """Rows of a reference table as dictionaries of numbers."""
        path = pathlib.Path(__file__).parent / "reference" / name
        with open(path, encoding="utf-8") as file:
            return [{key: float(value) for key, value in row.items() if "j" not in value}
                    for row in csv.DictReader(file)]

    def texts(self, name):
        """The same with all cells as they are written."""
        path = pathlib.Path(__file__).parent / "reference" / name
        with open(path, encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def add(self, quantity, reference, value, tolerance, paper=None, absolute=False):
        """A figure that must lie within `tolerance`, relative unless `absolute`."""
        self.rows.append(Row(quantity, paper, reference, value, tolerance, absolute))

    def add_curve(self, quantity, differences, tolerance):
        """Differences from a reference curve, of which 99 % must lie within `tolerance`; NaN where
        the curve is not compared."""
        worst = numpy.nanquantile(numpy.abs(differences), 0.99)
        self.rows.append(Row(f"{quantity}: 99 % of {numpy.isfinite(differences).sum()} points differ "
                             "by less than", None, 0, worst, tolerance, True, differences))

    def add_whole(self, quantity, reference, value, paper=None):
        """Several whole numbers that must be the same."""
        self.rows.append(Row(quantity, paper, tuple(reference), tuple(value), 0, True))

    def add_digits(self, quantity, reference, value, paper=None):
        """A figure that must agree in every digit of the reference, given as text."""
        decimals = len(reference.split(".")[1]) if "." in reference else 0
        tolerance = 0.6 * 10.0**-decimals / abs(float(reference))
        self.add(quantity, float(reference), value, tolerance, paper)

    def markdown(self):
        return markdown([("quantity", "paper", "reference", "vibroimpact", "relative difference"),
                         *(row.cells() for row in self.rows)])

    def finish(self):
        text = self.markdown()
        print(text)
        if self.arguments.page:
            write_into(self.arguments.page, self.script, text)
        good = sum(row.good() for row in self.rows)
        print(f"{good} of {len(self.rows)} within their tolerances")
        stale = self.stale_rows() if self.arguments.compare else []
        for quantity in stale:
            print(f"{self.arguments.compare}: not what was computed now: {quantity}")
        sys.exit(0 if good == len(self.rows) and not stale else 1)

    def stale_rows(self):
        """Quantities that the page to compare does not have, or with other figures. It may have more
        of them: not every run computes all."""
        lines = table_in(self.arguments.compare, self.script)
        return [row.quantity for row in self.rows if not any(map(row.agrees_with, lines))]


def nearest(values, wanted):
    """Position of the value closest to the wanted one."""
    return int(min(range(len(values)), key=lambda i: abs(values[i] - wanted)))
