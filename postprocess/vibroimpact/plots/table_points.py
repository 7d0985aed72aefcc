"""Reference or measured points from a table, drawn over any figure whose axes have the same quantities.

    # name: Paper, Table 2
    # drawn as: points
    frequency [Hz], displacement_x/amplitude [mm], gap [mm], figure, series
    2.4,            13.4,                          2,        curve*, page 7

A column is called as a quantity of the figure's axes: by its path in the results, the last parts of it, or
its label without TeX. A column of the key of a family gives a point the colour of that member; `figure`
restricts rows to figures whose names match a pattern, `series` names rows in the legend; `marker` and `colour`, as
Matplotlib calls them, are those of a series. Other columns, such as the page, are left to the reader. Instead
of rows of its own a table may name another file, whose columns it renames, and the figures that show it:

    # rows of: ../reference.csv
    # columns: f = frequency [Hz], A1 = displacement_x/amplitude [mm]
    # figure: curve*
"""

from __future__ import annotations

import csv
import fnmatch
import math
import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from matplotlib.colors import is_color_like
from matplotlib.lines import Line2D

from . import style
from .axis_meaning import Meaning, Panel, panel_of
from .errors import ResultError
from .figure_axes import plain
from .parameters_text import UNITS, evaluate

LOOKS = {"points": dict(linestyle="", marker="o", markersize=5.0, markerfacecolor="white",
                        markeredgewidth=1.2, zorder=4),
         "line": dict(linestyle=(0, (4, 1.5, 1, 1.5)), linewidth=1.0, zorder=3),
         "bars": dict(linestyle="-", linewidth=4.0, solid_capstyle="butt", zorder=1.5)}  # each between two rows
MARKERS = "osD^v"  # of the series of points in a figure
NEAR = 1e-3  # of a member's value: a row belongs to it
SPECIAL = ("figure", "series", "marker", "colour")


@dataclass
class Table:
    """Columns of numbers in SI by their names; `texts` has those named in SPECIAL."""

    file: Path
    name: str
    look: str
    columns: dict[str, np.ndarray]
    texts: dict[str, list[str]] = field(default_factory=dict)


def read(file: Path) -> Table:
    comments, rows = split(file)
    notes = dict(note for note in map(message_of, comments) if note)
    if "rows of" in notes:
        rows = rows_of(file, notes)
    if not rows:
        raise ResultError(f"--overlay {file}: no line with the names of the columns")
    look = notes.get("drawn as", "points")
    if look not in LOOKS:
        raise ResultError(f"--overlay {file}: drawn as: {look}; it must be {' or '.join(LOOKS)}")
    head, body = rows[0], rows[1:]
    for number, row in enumerate(body, 2):
        if len(row) != len(head):
            raise ResultError(f"--overlay {file}: row {number} has {len(row)} values, "
                              f"but there are {len(head)} columns")
    table = Table(file, notes.get("name", file.stem), look, {})
    for place, title in enumerate(head):
        add_column(table, title, [row[place] for row in body])
    return table


def rows_of(file: Path, notes: dict) -> list[list[str]]:
    """Rows of another file, of the columns that are renamed."""
    other = file.parent / notes["rows of"]
    rows = split(other)[1]
    titles = [part.partition("=")[::2] for part in notes.get("columns", "").split(",")]
    wanted = [(source.strip(), title.strip()) for source, title in titles]
    missing = [source for source, _ in wanted if source not in rows[0]]
    if missing:
        raise ResultError(f"--overlay {file}: {other} has no column {missing[0]}")
    places = [rows[0].index(source) for source, _ in wanted]
    figure = notes.get("figure", "*")
    return [[title for _, title in wanted] + ["figure"]] + [
        [row[place] for place in places] + [figure] for row in rows[1:]]


def split(file: Path):
    """Comment lines, and the others as lists of texts."""
    lines = file.read_text().splitlines()
    comments = [line for line in lines if line.startswith("#")]
    others = [line for line in lines if line.strip() and not line.startswith("#")]
    return comments, [[part.strip() for part in row]
                      for row in csv.reader(others, skipinitialspace=True)]


def message_of(comment: str):
    key, colon, value = comment.lstrip("# ").partition(":")
    return (key.strip().lower(), value.strip()) if colon else None


def add_column(table: Table, title: str, values: list[str]) -> None:
    match = re.fullmatch(r"(.*?)\s*(?:\[(.*)\])?", title)
    name, unit = match[1], match[2]
    if name in SPECIAL:
        table.texts[name] = values
        allowed = {"marker": Line2D.markers.__contains__, "colour": is_color_like}.get(name, bool)
        for value in filter(None, values):
            if not allowed(value):
                raise ResultError(f"--overlay {table.file}: {value} is no {name} of Matplotlib")
        return
    factor = 1.0 if unit in (None, "", "1") else evaluate(f"1 {unit}", dict(UNITS))
    if factor is None:
        raise ResultError(f"--overlay {table.file}: the unit [{unit}] of {name} is not known")
    try:
        table.columns[name] = factor * np.array([float(value or "nan") for value in values])
    except ValueError as error:
        if unit is not None:
            raise ResultError(f"--overlay {table.file}: column {name}: {error}") from None


def draw(figure, name: str, table: Table) -> int:
    """Draws the rows that belong to a figure into its panels; gives their number."""
    drawn, handles = 0, {}
    for axes in figure.axes:
        panel = panel_of(axes)
        if panel is None:
            continue
        x, y = (column(table, meaning) for meaning in (panel.x, panel.y))
        if x is None or y is None:
            continue
        for number, (text, rows) in enumerate(series(table, name)):
            look = look_of(table, number, rows)
            rows = rows & at_place(table, panel) & np.isfinite(x) & np.isfinite(y)
            for colour, part in members(table, panel, rows):
                line = axes.plot(*shown(table, x[part], y[part]), label="_points", **dict(color=colour) | look)[0]
                line.own_colour = "color" in look
                handles.setdefault(text, line)
                drawn += int(part.sum())
    if handles:
        explain(figure, handles)
    return drawn


def shown(table: Table, *values):
    """Bars apart from each other."""
    return [np.insert(part, np.arange(2, len(part), 2), np.nan) for part in values] if table.look == "bars" else values


def look_of(table: Table, number: int, rows) -> dict:
    """Of the series with these rows: its own marker and colour, else a marker by its number."""
    def own(name):
        return next((text for text, chosen in zip(table.texts.get(name, []), rows) if chosen and text), "")

    look = dict(LOOKS[table.look])
    if look["linestyle"] != "":
        return look | (dict(color=own("colour")) if own("colour") else {})
    look["marker"] = own("marker") or MARKERS[number % len(MARKERS)]
    return look | (dict(markerfacecolor=own("colour"), color="black", markeredgewidth=0.8) if own("colour") else {})


def column(table: Table, meaning: Meaning):
    """In the numbers at the axis, or None."""
    labelled = [name for name in table.columns
                if meaning.label and plain(name).lower() == meaning.label.lower()]
    if labelled:
        return table.columns[labelled[0]]
    found = [name for name in table.columns if meaning.is_called(name)]
    if not found:
        return None
    return (table.columns[found[0]] / hertz(meaning) - meaning.start) / meaning.scale.factor


def at_place(table: Table, panel: Panel) -> np.ndarray:
    """Rows that belong to the values of the axes for which a panel stands."""
    chosen = np.ones(len(next(iter(table.columns.values()))), bool)
    for meaning, value in panel.place:
        values = column(table, meaning)
        if values is not None:
            chosen &= np.abs(values - value) <= NEAR * abs(value) + 1e-12
    return chosen


def hertz(meaning: Meaning) -> float:
    """Frequencies are read in rad/s, and in Hz in results."""
    return 2 * math.pi if meaning.unit == "Hz" else 1.0


def series(table: Table, figure: str):
    """Texts of the legend and their rows, of those that belong to the figure."""
    count = len(next(iter(table.columns.values()), []))
    own = np.ones(count, bool)
    if "figure" in table.texts:
        own = np.array([any(fnmatch.fnmatch(figure, part) for part in text.split())
                        if text else True for text in table.texts["figure"]], bool)
    names = table.texts.get("series", [""] * count)
    for text in dict.fromkeys(names):
        rows = own & (np.array(names) == text)
        if rows.any():
            yield ", ".join(filter(None, [table.name, text])), rows


def members(table: Table, panel: Panel, rows):
    """Rows of each member of a family with its colour; without a column for it all in black."""
    for meaning, colours in panel.members:
        values = column(table, Meaning(meaning.names, meaning.unit, type(meaning.scale)(1.0, "")))
        if values is None:
            continue
        for value, colour in colours.items():
            part = rows & (np.abs(values - value) <= NEAR * abs(value) + 1e-12)
            if part.any():
                yield colour, part
        return
    if rows.any():
        yield "black", rows


def explain(figure, handles: dict) -> None:
    """Further entries of the legend, or one beside the first row of panels."""
    panels = [axes for axes in figure.axes if panel_of(axes)]
    axes = next((axes for axes in panels if axes.get_legend()), style.upper_right(panels))
    legend = axes.get_legend()
    entries = [*(legend.legendHandles if legend else [])]
    for entry, text in zip(entries, legend.get_texts() if legend else []):
        entry.set_label(text.get_text())
    entries += [entry_of(line, text) for text, line in handles.items()]
    title = legend.get_title().get_text() if legend else None
    if len(figure.axes) > 1 and figure.axes[-1].get_label() == "<colorbar>":
        style.legend_below(axes, entries)
    else:
        style.legend_beside(axes, entries, title or None)


def entry_of(line, text: str):
    """In grey where the colour is that of a member of a family."""
    copy = Line2D([], [])
    copy.update_from(line)
    copy.set_label(text)
    if not getattr(line, "own_colour", False):
        copy.set_color(style.GREY)
    return copy
