#!/usr/bin/env python3
"""The sketches of the gallery: check_sketches.py ROOT

They are what scripts/draw-sketches.py draws, every page of a system shows its own with the sketch's words, and the
primitives are where they were asked to be.
"""

import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(ROOT / "scripts"))
from sketch_shapes import MARGIN, Sketch  # noqa: E402

PROGRAM = ROOT / "scripts" / "draw-sketches.py"
GALLERY = ROOT / "docs" / "gallery"
WITHOUT_SYSTEM = {"README", "frames"}
SVG = "{http://www.w3.org/2000/svg}"


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+\.?\d*", text)]


def paths(sketch: Sketch) -> list[list[tuple[float, float]]]:
    tree = ElementTree.fromstring(sketch.as_svg())
    found = []
    for path in tree.iter(SVG + "path"):
        values = numbers(path.get("d"))
        found.append(list(zip(values[::2], values[1::2])))
    return found


class Files(unittest.TestCase):
    def test_they_are_as_drawn(self):
        self.assertEqual(subprocess.run([sys.executable, PROGRAM, "--check"]).returncode, 0)

    def test_a_changed_a_missing_and_an_unknown_file_are_found(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            subprocess.run([sys.executable, PROGRAM, folder], check=True)
            (folder / "bumpers.svg").write_text("<svg/>")
            (folder / "rigid-stop.svg").unlink()
            (folder / "unknown.svg").write_text("<svg/>")
            check = subprocess.run([sys.executable, PROGRAM, "--check", folder], stderr=subprocess.PIPE, text=True)
        self.assertEqual(check.returncode, 1)
        self.assertEqual(sorted(re.findall(r"[\w-]+\.svg", check.stderr)),
                         ["bumpers.svg", "rigid-stop.svg", "unknown.svg"])

    def test_every_page_shows_its_sketch(self):
        for page in GALLERY.glob("*.md"):
            if page.stem not in WITHOUT_SYSTEM:
                title = ElementTree.parse(GALLERY / "sketches" / f"{page.stem}.svg").find(SVG + "title").text
                first = page.read_text(encoding="utf-8").split("![")[1]
                self.assertTrue(first.startswith(f"{title}](sketches/{page.stem}.svg)"), page.name)

    def test_everything_is_inside(self):
        for file in (GALLERY / "sketches").glob("*.svg"):
            tree = ElementTree.parse(file).getroot()
            left, top, width, height = numbers(tree.get("viewBox"))
            for text in tree.iter(SVG + "text"):
                self.assertTrue(left <= float(text.get("x")) <= left + width, file.name)
                self.assertTrue(top <= float(text.get("y")) <= top + height, file.name)


class Shapes(unittest.TestCase):
    def setUp(self):
        self.sketch = Sketch("a sketch")

    def test_a_spring_joins_its_ends_and_swings_about_the_line_between_them(self):
        self.sketch.spring((10, 20), (90, 20), coils=4, half_width=6)
        points = paths(self.sketch)[0]
        self.assertEqual((points[0], points[-1]), ((10, 20), (90, 20)))
        heights = [y - 20 for _, y in points if y != 20]
        self.assertEqual(len(heights), 8)
        self.assertEqual(set(heights), {-6, 6})
        self.assertEqual([x for x, _ in points], sorted(x for x, _ in points))

    def test_a_dashpot_joins_its_ends_and_its_piston_is_in_the_cylinder(self):
        self.sketch.dashpot((0, 0), (0, 100), half_width=8)
        rod, cylinder, piston, end = paths(self.sketch)
        self.assertEqual((rod[0], end[-1]), ((0, 0), (0, 100)))
        self.assertTrue(all(abs(x) < 8 for x, _ in piston))
        self.assertTrue(min(y for _, y in cylinder) < piston[0][1] < max(y for _, y in cylinder))

    def test_the_ground_is_hatched_on_its_right(self):
        self.sketch.ground((0, 0), (90, 0))
        line, *hatches = paths(self.sketch)
        self.assertEqual(line, [(0, 0), (90, 0)])
        self.assertTrue(all(foot[1] == 0 and tip[1] > 0 for foot, tip in hatches))

    def test_a_short_clearance_has_its_arrows_outside(self):
        for end, inside in ((80, True), (10, False)):
            sketch = Sketch("a clearance")
            sketch.clearance((0, 0), (end, 0), "c")
            shafts = [line for line in paths(sketch) if len(line) == 2]
            outside = [x for line in shafts for x, _ in line if x < 0 or x > end]
            self.assertEqual(not outside, inside)

    def test_the_picture_holds_all_shapes(self):
        self.sketch.line((-30, -40), (50, 60))
        self.sketch.circle((0, 0), 45)
        tree = ElementTree.fromstring(self.sketch.as_svg())
        self.assertEqual(numbers(tree.get("viewBox")),
                         [-45 - MARGIN, -45 - MARGIN, 95 + 2 * MARGIN, 105 + 2 * MARGIN])

    def test_symbols_have_subscripts_and_upright_functions(self):
        self.sketch.symbol((0, 0), "x_0 sin ωt < 1")
        text = ElementTree.fromstring(self.sketch.as_svg()).find(SVG + "text")
        self.assertEqual("".join(text.itertext()).replace("\u200b", ""), "x0 sin ωt < 1")
        slanted = [span.text for span in text.iter(SVG + "tspan") if span.get("font-style") == "italic"]
        self.assertEqual(slanted, ["x", "ω", "t"])


if __name__ == "__main__":
    unittest.main()
