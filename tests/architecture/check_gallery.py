#!/usr/bin/python3
"""The list of the gallery's pictures agrees with its pages, files, tables and sections; its short part is run and
drawn where a folder of programs is given: check_gallery.py SOURCE [BUILD]"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv[1]).resolve()
BUILD = Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path[:0] = [str(SOURCE / place) for place in ("scripts", "postprocess", "tests/verification")]

import draw_gallery  # noqa: E402
import page_tables  # noqa: E402
from vibroimpact.plots import table_points  # noqa: E402
from vibroimpact.plots.parameters_text import sections  # noqa: E402

GALLERY = SOURCE / "docs" / "gallery"
SHORT = "bilinear-fig-8b"  # the picture that is drawn here: its run takes a second


def pictures_of_pages():
    """Names of the pictures in docs/gallery/images that pages show."""
    found = set()
    for page in SOURCE.glob("docs/**/*.md"):
        for place in re.findall(r"\]\(([^)\s]+\.png)\)", page.read_text(encoding="utf-8")):
            file = (page.parent / place).resolve()
            if file.parent == GALLERY / "images":
                found.add(file.stem)
    return found


class List(unittest.TestCase):
    def setUp(self):
        self.gallery = draw_gallery.read()
        self.drawn = [picture.name for picture in self.gallery.pictures]

    def test_no_picture_is_listed_twice(self):
        names = self.drawn + list(self.gallery.others)
        self.assertEqual(sorted(names), sorted(set(names)))

    def test_pages_show_what_is_listed(self):
        self.assertEqual(pictures_of_pages(), set(self.drawn) | set(self.gallery.others))

    def test_every_listed_picture_is_there_and_no_other(self):
        files = {file.stem for file in (GALLERY / "images").glob("*.png")}
        self.assertEqual(files, set(self.drawn) | set(self.gallery.others))

    def test_runs_are_those_of_shipped_files(self):
        for name, run in self.gallery.runs.items():
            self.assertTrue((SOURCE / run.file).is_file(), f"{name}: {run.file}")
        self.assertEqual({picture.run for picture in self.gallery.pictures},
                         set(self.gallery.runs))

    def test_a_page_gives_the_parameters_that_it_says_to_write(self):
        run = next(run for run in self.gallery.runs.values() if run.file.endswith(".md"))
        with tempfile.TemporaryDirectory() as folder:
            places = draw_gallery.Places(SOURCE, Path(folder), Path(folder))
            text = draw_gallery.parameters("fit", run, places).read_text(encoding="utf-8")
        page = (SOURCE / run.file).read_text(encoding="utf-8")
        self.assertIn(f"```prm\n{text}```", page)
        self.assertEqual(set(sections(text)) & {"Body first", "Analysis fit"}, {"Body first", "Analysis fit"})

    def test_every_section_figure_is_drawn(self):
        figures = {picture.figure for picture in self.gallery.pictures}
        for file in (SOURCE / "params" / "figures").glob("*.prm"):
            for name in sections(file.read_text(encoding="utf-8")):
                if name.startswith("Figure "):
                    self.assertIn(name.removeprefix("Figure "), figures, file.name)

    def test_every_published_table_can_be_read_and_is_shown(self):
        shown = {option for picture in self.gallery.pictures for option in picture.options}
        shown.add("absorber.csv")  # beside the program's numbers in a table of the page
        for file in (GALLERY / "published").glob("*.csv"):
            self.assertTrue(table_points.read(file).columns, file.name)
            self.assertIn(file.name, shown)

    def test_pictures_of_the_papers_say_what_they_show(self):
        for page in GALLERY.glob("*.md"):
            for text in re.findall(r"!\[([^\]]*)\]\(images/[a-z]+-fig-", page.read_text()):
                self.assertTrue(text.strip(), page.name)


class LongTables(unittest.TestCase):
    def test_a_long_table_leaves_its_first_rows_a_link_and_what_is_beyond_a_tolerance(self):
        head, shown = ("quantity", "paper", "reference"), [*range(8), 25]
        rows = [(f"|z| {i}", "7" if i == 20 else "", "1 **beyond tolerance**" if i == 25 else "1")
                for i in range(30)]
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder, "page.md")
            page.write_text("a\n<!-- table made by check_it.py -->\n<!-- end of table -->\nb\n")
            page_tables.write_into(page, "check_it.py", page_tables.markdown([head, *rows]))
            text = page.read_text()
            self.assertIn("21 more of 30 rows: [tables/page-check-it.csv](tables/page-check-it.csv)",
                          text)
            self.assertEqual([i for i in range(30) if f"| |z| {i} |" in text], shown)
            lines = Path(folder, "tables", "page-check-it.csv").read_text().splitlines()
            self.assertEqual(lines, [",".join(head), *map(",".join, rows)])

    def test_a_short_table_stands_whole(self):
        text = page_tables.markdown([("a",), ("1",)])
        self.assertEqual(page_tables.shortened(Path("page.md"), "check_it.py", text), text)


@unittest.skipUnless(BUILD, "no folder of programs")
class Drawing(unittest.TestCase):
    def test_the_short_part_is_run_and_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [SOURCE / "scripts" / "draw-gallery.sh", "--picture", SHORT, "--build", BUILD,
                 "--output", f"{folder}/runs", "--images", folder],
                capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            drawn = Path(folder, f"{SHORT}.png").read_bytes()
            self.assertEqual(drawn[:8], b"\x89PNG\r\n\x1a\n")

    def test_an_unknown_system_is_named(self):
        done = subprocess.run([SOURCE / "scripts" / "draw-gallery.sh", "bumper"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("bumper is no system; there are: bumpers", done.stderr)


if __name__ == "__main__":
    unittest.main()
