#!/usr/bin/env python3
"""The tables of docs/verification.md.

    verification_matrix.py ROOT            checks that every test that the page names exists; exit code 1 where one does not
    verification_matrix.py ROOT --update   makes the table of whole systems anew from the tables of the gallery
    verification_matrix.py --self-test
"""

import csv
import re
import sys
import tempfile
from pathlib import Path

BEGIN, END = "<!-- table made by verification_matrix.py -->", "<!-- end of table -->"
TABLE = re.compile(r"<!-- table made by check_(\w+)\.py(?:, (\w+))? -->\n(.*?)<!-- end of table -->", re.DOTALL)
HEAD = ("quantity", "paper", "reference", "vibroimpact", "relative difference")
GTEST = re.compile(r"^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", re.MULTILINE)
NAMED = re.compile(r"`([A-Za-z_]+\.\w+(?:\.\w+)*)`(?= *\|$)", re.MULTILINE)


def cells(line):
    return tuple(cell.strip() for cell in line.strip("|").split("|"))


def rows_of(page, text):
    """All rows of a table of the gallery; of a long one those of its CSV."""
    link = re.search(r"\((tables/[\w-]+\.csv)\)", text)
    if link:
        with open(page.parent / link.group(1), encoding="utf-8", newline="") as stream:
            return [tuple(row) for row in csv.reader(stream)]
    lines = [cells(line) for line in text.splitlines() if line.startswith("|")]
    return lines[:1] + lines[2:]


def largest(rows):
    """The largest difference relative to a reference, and of which quantity."""
    found = [(0.0, "")]
    for row in rows:
        number = re.fullmatch(r"[+-]?[\d.]+(?:e[+-]?\d+)?", row[4])
        if number and row[2]:
            found.append((abs(float(number.group())), row[0]))
    return max(found)


def line_of(page, check, system, rows):
    test = f"verification.{check}.{system}" if system else f"verification.{check}"
    printed = sum(bool(row[1]) for row in rows)
    error, quantity = largest(rows)
    values = (f"[{page.stem}](gallery/{page.name})", str(len(rows)), str(printed),
              f"{error:.0e}" if quantity else "", quantity, f"`{test}`")
    return "| " + " | ".join(values) + " |"


def systems(root):
    lines = ["| system | values | printed in the paper | largest relative difference | of which quantity | test |",
             "|---|---|---|---|---|---|"]
    for page in sorted((root / "docs" / "gallery").glob("*.md")):
        for check, system, text in TABLE.findall(page.read_text(encoding="utf-8")):
            rows = rows_of(page, text)
            if rows and rows[0] == HEAD:
                lines.append(line_of(page, check, system, rows[1:]))
    return "\n".join(lines)


def known_tests(root):
    """Tests of GoogleTest, and those that CMake makes of tests/verification/check_*.py."""
    names = {".".join(found) for file in root.glob("tests/**/*.cc")
             for found in GTEST.findall(file.read_text(encoding="utf-8"))}
    names |= {f"verification.{file.stem.removeprefix('check_')}" for file in root.glob("tests/verification/check_*.py")}
    listed = (root / "tests" / "verification" / "CMakeLists.txt").read_text(encoding="utf-8")
    names |= set(re.findall(r"NAME (verification[\w.]+)", listed))
    return names | set(re.findall(r"vibroimpact_test\((verification_\w+)", listed))


def missing(root):
    page = (root / "docs" / "verification.md").read_text(encoding="utf-8")
    known = known_tests(root)
    for name in NAMED.findall(page):
        family = name.rsplit(".", 1)[0]
        if name not in known and (family == "verification" or family not in known):
            yield f"docs/verification.md: there is no test {name}"


def update(root):
    page = root / "docs" / "verification.md"
    text = page.read_text(encoding="utf-8")
    first = text.index(BEGIN) + len(BEGIN)
    page.write_text(f"{text[:first]}\n{systems(root)}\n{text[text.index(END, first):]}", encoding="utf-8")


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for part in ("docs/gallery", "tests/verification"):
            (root / part).mkdir(parents=True)
        (root / "tests/a.cc").write_text("TEST(Good, One) {\nTEST_P(Good,\n       Two) {\n")
        (root / "tests/verification/check_it.py").write_text("")
        (root / "tests/verification/CMakeLists.txt").write_text("add_test(NAME verification.more\n")
        (root / "docs/verification.md").write_text("".join(f"| `{name}` |\n" for name in (
            "Good.One", "Good.Two", "Good.Three", "verification.it", "verification.more", "verification.none")))
        found = [line.split()[-1] for line in missing(root)]
        rows = [("a", "1", "2", "2", "+3e-7"), ("b", "", "0", "0", "-2e-3 (absolute)"), ("c", "", "1", "1", "same")]
    good = found == ["Good.Three", "verification.none"] and largest(rows) == (3e-7, "a")
    print(f"{len(found)} tests are missing, as they should" if good else f"self-test: {found}, {largest(rows)}")
    return 0 if good else 1


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    root = Path(sys.argv[1]).resolve()
    if "--update" in sys.argv[2:]:
        update(root)
    found = list(missing(root))
    print("\n".join(found) or "every test exists")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
