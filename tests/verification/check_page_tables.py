#!/usr/bin/python3
"""The comparison of tables in pages with what is computed, and the tables that follow from closed forms.

usage: check_page_tables.py SOURCE
"""
import math
import pathlib
import re
import sys
import tempfile
import unittest

from page_tables import table_in
from studies import same_cell
from systems import Row

SOURCE = pathlib.Path(sys.argv[1]).resolve()

PAGE = """text
<!-- table made by check_it.py -->
| quantity | paper | reference | vibroimpact | relative difference |
| --- | --- | --- | --- | --- |
| force, N |  | 2783.769 | 2783.77 | +4e-07 |
| impacts |  | 2, 1 | 2, 1 | same |
| drift |  | 0 | 1.8e-09 | +1.8e-09 (absolute) |
<!-- end of table -->
"""


def root(function, low, high):
    """By bisection, to the last digits; the function changes its sign once between the ends."""
    rising = function(low) < 0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if (function(middle) < 0) == rising else (low, middle)
    return (low + high) / 2


def damping(e):
    """d_c of the exact relation (1 + e) d = ln((1 + d)/(1 - e d))."""
    return root(lambda d: (1 + e) * d - math.log((1 + d) / (1 - e * d)), 1e-4, (1 - 1e-15) / e)


def restitution(d):
    """e that a dissipation d_c gives: the same relation, solved for e by the energy it leaves."""
    left = d - math.log1p(d)
    return root(lambda e: left + e * d + math.log1p(-e * d), 1e-12, min(1 / d, 1) * (1 - 1e-15))


def gamma(e, n=1.5):
    """8 G(w*) (1 + d w*)^((n+1)/n) / (1 + e)^2 at the peak of the force."""
    d = damping(e)

    def work(w):  # G(w), from the integral of s/(1 + d s)
        return ((d - math.log1p(d)) - (d * w - math.log1p(d * w))) / d**2
    w = root(lambda w: d * work(w) - n / (n + 1) * w, 0, 1)
    return 8 * work(w) * (1 + d * w) ** ((n + 1) / n) / (1 + e) ** 2


def numbers_of(page, head):
    """The cells of the table below the line that begins with `head`."""
    lines = (SOURCE / "docs" / page).read_text(encoding="utf-8").splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith(head)) + 2
    last = next(i for i in range(first, len(lines)) if not lines[i].startswith("|"))
    return [[cell.strip().replace("\N{MINUS SIGN}", "-") for cell in line.strip("|").split("|")]
            for line in lines[first:last]]


class Comparison(unittest.TestCase):
    def setUp(self):
        page = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "page.md"
        page.write_text(PAGE)
        self.lines = {cells[0]: cells for cells in table_in(page, "check_it.py")}

    def test_a_figure_within_its_tolerance_agrees(self):
        self.assertEqual(set(self.lines), {"force, N", "impacts", "drift"})
        for quantity, reference, value, tolerance, absolute in (
                ("force, N", 2783.769, 2783.7692, 1e-6, False), ("impacts", (2, 1), (2, 1), 0, True),
                ("drift", 0, 2.5e-9, 1e-8, True)):
            row = Row(quantity, None, reference, value, tolerance, absolute)
            self.assertTrue(row.agrees_with(self.lines[quantity]), quantity)

    def test_another_figure_or_reference_does_not(self):
        for quantity, reference, value, tolerance, absolute in (
                ("force, N", 2783.769, 2783.9, 1e-6, False), ("force, N", 2783.8, 2783.77, 1, False),
                ("impacts", (2, 1), (2, 2), 0, True), ("drift", 0, 2.5e-8, 1e-8, True)):
            row = Row(quantity, None, reference, value, tolerance, absolute)
            self.assertFalse(row.agrees_with(self.lines[quantity]), quantity)
        self.assertFalse(Row("new", None, 0, 1.8e-9, 1, True).agrees_with(self.lines["drift"]))

    def test_a_long_table_is_that_of_its_file(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        page = folder / "page.md"
        page.write_text(PAGE)
        (folder / "tables").mkdir()
        file = folder / "tables" / "page-check-it.csv"
        rows = PAGE.splitlines()[4:7]
        body = "".join(line.strip("| ").replace(",", ";").replace(" | ", ",") + "\n" for line in rows)
        file.write_text("head\n" + body)
        with self.assertRaisesRegex(ValueError, "does not have"):
            table_in(page, "check_it.py")
        page.write_text(PAGE.replace("force, N", "force; N").replace("2, 1", "2; 1"))
        file.write_text("head\n" + body + "more,,1,1,0\n")
        self.assertEqual(len(table_in(page, "check_it.py")), 4)

    def test_cells_of_studies(self):
        for old, new, same in (("+13.4 %", "+13.3 %", True), ("+13.4 %", "+12.9 %", False),
                               ("2 mm", "2 mm", True), ("2 mm", "3 mm", False),
                               ("0.99907", "0.99906", True), ("1e+04", "1e+05", False),
                               ("", "", True), ("5.1 %", "", False)):
            self.assertEqual(same_cell(old, new), same, (old, new))


class ClosedForms(unittest.TestCase):
    def test_restitution_that_published_relations_give(self):
        relations = {
            "hunt-crossley": lambda e: 1.5 * (1 - e),
            "herbert-mcwhannell": lambda e: 6 * (1 - e) / ((2 * e - 1) ** 2 + 3),
            "lee-wang": lambda e: 0.75 * (1 - e), "lankarani-nikravesh": lambda e: 0.75 * (1 - e * e),
            "gonthier": lambda e: (1 - e * e) / e, "flores": lambda e: 1.6 * (1 - e) / e}
        lines = numbers_of("theory.md", "| relation | d_c |")
        self.assertEqual([line[0].split()[0] for line in lines], list(relations))
        for line in lines:
            formula = relations[line[0].split()[0]]
            for asked, shown in zip((0.9, 0.5, 0.2), line[2:]):
                self.assertEqual(f"{restitution(formula(asked)):.3f}", shown, line[0])

    def test_largest_errors_of_gonthier_and_flores(self):
        text = re.sub(r"\s+", " ", (SOURCE / "docs" / "theory.md").read_text(encoding="utf-8"))
        found, = re.findall(r"from 0.05 to 1 what is obtained is within ([\d.]+) and ([\d.]+) of", text)
        asked = [0.05 + 0.95 * i / 2000 for i in range(2000)]
        for formula, shown in zip((lambda e: (1 - e * e) / e, lambda e: 1.6 * (1 - e) / e), found):
            worst = max(abs(restitution(formula(e)) - e) for e in asked)
            self.assertEqual(f"{math.ceil(1000 * worst) / 1000:.3f}", shown)

    def test_ratio_of_the_identification(self):
        lines = numbers_of("identification.md", "| $e$ | $d_c$ |")
        self.assertEqual(len(lines), 6)
        for e, d, ratio, corrected, printed in (map(float, line) for line in lines):
            exact = gamma(e)
            self.assertAlmostEqual(damping(e), d, delta=5.1e-7)
            self.assertAlmostEqual(exact, ratio, delta=5.1e-5)
            self.assertAlmostEqual(2 / (1 + math.sqrt(exact - 1)) - 1, corrected, delta=5.1e-4)
            length = 1.8
            self.assertAlmostEqual(2 / (length + math.sqrt(length**2 - 2 * length + exact)) - 1, printed,
                                   delta=5.1e-4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
