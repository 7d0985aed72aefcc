"""Draws figures into files, as many at a time as there are processors."""

from __future__ import annotations

import argparse
import gc
import multiprocessing
import os
import sys
import zlib
from collections import Counter
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from PIL import Image

from . import table_points
from .results import Results

# Runs of one colour are most of a line drawing; zlib's own search finds little more and takes twice as long.
PNG = dict(compress_type=zlib.Z_RLE)


class Drawing:
    """`wanted`: name of each figure and what draws it."""

    def __init__(self, results: Results, wanted, tables, options: argparse.Namespace):
        self.wanted, self.tables, self.options = wanted, tables, options
        self.folder = options.output or results.folder / "figures"

    def file(self, number: int) -> Path:
        return self.folder / f"{self.wanted[number][0]}.{self.options.format}"

    def draw(self, number: int) -> tuple[int, Counter, str]:
        """Number of the figure, how many rows of each table are in it, and what went wrong. One figure must
        not take the others with it."""
        name, function = self.wanted[number]
        rows = Counter()
        try:
            figure = function()
            for table in self.tables:
                rows[table.file] += table_points.draw(figure, name, table)
            save(figure, self.file(number), self.options.dpi, self.options.size)
        except Exception as error:
            return number, rows, f"{name} cannot be drawn: {type(error).__name__}: {error}"
        finally:
            plt.close("all")
            gc.collect()
        return number, rows, ""


def save(figure, file: Path, dpi: float, size=None) -> None:
    """The layout is made here, and a picture of points is drawn here: savefig would draw all once more for either."""
    if size:
        figure.set_size_inches(*size)
    figure.set_dpi(dpi)
    figure.get_layout_engine().execute(figure)
    figure.set_layout_engine("none")
    if file.suffix != ".png":
        figure.savefig(file, dpi=dpi)
        return
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB").save(file, dpi=(dpi, dpi), **PNG)


def draw_all(results: Results, wanted, tables, options: argparse.Namespace) -> int:
    """Code 1 when a figure could not be drawn or a table fits none; the others are drawn all the same."""
    drawing = Drawing(results, wanted, tables, options)
    drawing.folder.mkdir(parents=True, exist_ok=True)
    code, rows = 0, Counter()
    for number, found, error in drawn(drawing, options.jobs or processors()):
        rows += found
        if error:
            code = 1
            print(f"vibroimpact-plot: {error}", file=sys.stderr)
        else:
            enter_in_list(results.folder, drawing.file(number))
            print(drawing.file(number), flush=True)
    for table in tables:
        if not rows[table.file]:
            code = 1
            print(f"vibroimpact-plot: --overlay {table.file}: no figure has axes of two of its "
                  f"columns, which are {', '.join(table.columns)}", file=sys.stderr)
    return code


def processors() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1


def drawn(drawing: Drawing, jobs: int):
    """Results of Drawing.draw in the order of the figures. What is there already is never collected; the circles of
    each figure are, once when it is done."""
    gc.freeze()
    gc.disable()
    count = len(drawing.wanted)
    if min(jobs, count) <= 1:
        yield from map(drawing.draw, range(count))
        return
    # Forked processes have the open results and the functions of the figures without a copy.
    with multiprocessing.get_context("fork").Pool(min(jobs, count), begin, (drawing,)) as workers:
        yield from workers.imap(draw_one, range(count))


def begin(drawing: Drawing) -> None:
    """In a worker."""
    draw_one.drawing = drawing


def draw_one(number: int):
    return draw_one.drawing.draw(number)


def enter_in_list(folder: Path, file: Path) -> None:
    """A run that overwrites the results removes their figures too: see src/output/written_files.h."""
    written = folder / "journal" / "written_files.txt"
    if not written.parent.is_dir() or folder.resolve() not in file.resolve().parents:
        return
    entry = str(file.resolve().relative_to(folder.resolve()))
    known = written.read_text().splitlines() if written.is_file() else []
    if entry not in known:
        with written.open("a") as stream:
            stream.write(entry + "\n")
