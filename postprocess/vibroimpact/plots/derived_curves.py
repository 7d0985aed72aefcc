"""Derived quantities over one axis: several of the same unit in one figure."""

from __future__ import annotations

import functools
import re

from matplotlib.lines import Line2D

from . import style
from .axis_meaning import Meaning, Panel, note
from .derived import Derived, coordinates, derived_of, pair_of
from .labels import scale_for
from .layout import axis_name, axis_scale
from .maps import LINES
from .results import Analysis, Results


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    together: dict[tuple[str, str], list[Derived]] = {}
    for entry in derived_of(analysis):
        numerical = len(entry.dimensions) == 1 and coordinates(
            analysis, entry.dimensions[0]).dtype.kind == "f"
        if numerical and len(entry.values) > 1 and not pair_of(entry):
            together.setdefault((entry.dimensions[0], entry.unit), []).append(entry)
    for (axis, unit), entries in together.items():
        what = entries[0].name if len(entries) == 1 else re.sub(r"[^A-Za-z0-9]+", "-", unit)
        yield (f"{analysis.name}-derived-{what}-over-{axis.rsplit('.', 1)[-1]}",
               functools.partial(curves, analysis, axis, entries))


def curves(analysis: Analysis, axis: str, entries: list[Derived]):
    figure, (axes,) = style.panels(1, height=2.6)
    where = coordinates(analysis, axis)
    scale = scale_for(entries[0].unit, *[entry.values for entry in entries])
    handles = []
    for number, entry in enumerate(entries):
        colour = style.COLOURS[number % len(style.COLOURS)]
        for direction, line in zip(entry.directions, LINES):
            for values in entry.of_direction(direction).reshape(len(where), -1).T:
                axes.plot(where / axis_scale(analysis, axis).factor, values / scale.factor, line,
                          marker="o", color=colour)
            text = ", ".join(filter(None, [entry.text, direction]))
            handles.append(Line2D([], [], linestyle=line, marker="o", color=colour, label=text))
    axes.set_xlabel(axis_scale(analysis, axis).label(axis_name(analysis, axis)))
    axes.set_ylabel(scale.label(entries[0].text if len(entries) == 1 else "Derived quantity"))
    note(axes, Panel(
        Meaning((axis,), analysis.read(axis).unit, axis_scale(analysis, axis)),
        Meaning(tuple(f"derived/{entry.name}" for entry in entries), entries[0].unit, scale)))
    if style.is_logarithmic(where):
        axes.set_xscale("log")
    style.legend_beside(axes, handles if len(handles) > 1 else [])
    return figure
