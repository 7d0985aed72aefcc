"""Curves over the swept axis, both directions, as families over the other axes of a grid."""

from __future__ import annotations

import re

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .labels import scale_for
from .layout import Layout, axis_name
from .results import Analysis, Array

LARGEST_LEGEND = 8
LINES = {"forward": dict(linestyle="-", marker=">"), "backward": dict(linestyle="--", marker="<"),
         "initial conditions": dict(linestyle=":", marker="o"), "": dict(linestyle="-")}
FEW_POINTS = 60  # a curve without direction shows every point up to this number


def field_of(analysis: Analysis, path: str) -> Array:
    """A field; `path[k]` is component k of its last dimension."""
    match = re.fullmatch(r"(.*)\[(\d+)\]", path)
    if not match:
        return analysis.read(path)
    whole = analysis.read(match[1])
    number = int(match[2])
    missing = number >= whole.values.shape[-1]
    values = np.full(whole.values.shape[:-1], np.nan) if missing else whole.values[..., number]
    return Array(values, whole.unit)


def draw(axes, layout: Layout, path: str, colours, scale) -> None:
    """One field; `colours` gives that of each case. Points that did not settle are hollow, curves
    are interrupted at jumps."""
    analysis = layout.analysis
    x = layout.coordinates() / layout.scale.factor
    field = field_of(analysis, path).values
    steady = analysis.read("steady").values if analysis.has("steady") else None
    for case, colour in zip(layout.cases(), colours):
        for number, direction in enumerate(layout.directions):
            y = layout.pick(field, case, direction) / scale.factor
            draw_curve(axes, layout, case, direction, x, y, colour, number)
            if steady is not None:
                unsettled = layout.pick(steady, case, direction) == 0
                axes.plot(x[unsettled], y[unsettled], "o", color=colour, fillstyle="none")


def draw_curve(axes, layout: Layout, case, direction: str, x, y, colour, number: int) -> None:
    """A line with some markers, without a piece where a jump lies; a dotted line joins the ends."""
    jump = jumps(layout, case, direction, x, y)
    breaks = np.flatnonzero(np.isfinite(jump)) if jump is not None else np.array([], int)
    before = breaks + (1 if direction == "backward" else 0)
    alone = len(layout.directions) == 1
    look = dict(LINES[""] if alone else LINES.get(direction, LINES[""]))
    if alone and len(x) <= FEW_POINTS:
        look["marker"] = "o"
    axes.plot(np.insert(x, before, np.nan), np.insert(y, before, np.nan), color=colour,
              markevery=None if alone else marked(len(x), number), **look)
    step = -1 if direction == "backward" else 1
    for place in breaks:
        at = jump[place]
        axes.plot([x[place - step], at, at, x[place]],
                  [y[place - step], y[place - step], y[place], y[place]],
                  color=colour, linestyle=":", linewidth=0.9, zorder=1.5, label="_jump")


def jumps(layout: Layout, case, direction: str, x, y):
    """Where a jump between a point and the one before it in the direction lies, else NaN."""
    analysis = layout.analysis
    if not analysis.has("jump_from") or layout.along in analysis.grid_axes:
        return None
    factor = layout.scale.factor
    ends = [layout.pick(analysis.read(name).values, case, direction) / factor
            for name in ("jump_from", "jump_to")]
    return np.where(np.isfinite(y), sum(ends) / 2, np.nan)


def marked(count: int, number: int):
    """First and step of the points with a marker: about ten along a curve, the two directions
    in turn, so that both are seen where they agree."""
    step = max(1, count // 10)
    return number * (step // 2), step


def direction_handles(layout: Layout) -> list[Line2D]:
    """Legend entries of the directions, of unsettled points and of jumps if there are any."""
    analysis = layout.analysis
    handles = [Line2D([], [], color=style.GREY, label=direction, **LINES.get(direction, LINES[""]))
               for direction in layout.directions if len(layout.directions) > 1]
    if analysis.has("steady") and np.any(analysis.read("steady").values == 0):
        handles.append(Line2D([], [], color=style.GREY, marker="o", fillstyle="none", linestyle="",
                              label="not settled"))
    if analysis.has("jump_from") and np.any(np.isfinite(analysis.read("jump_from").values)):
        handles.append(Line2D([], [], color=style.GREY, linestyle=":", linewidth=0.9, label="jump"))
    return handles


def finish(figure, panels, layout: Layout, handles) -> None:
    """Name of the axis below, explanation of the family and of the lines on the right."""
    analysis = layout.analysis
    panels[-1].set_xlabel(layout.scale.label(axis_name(analysis, layout.along)))
    if style.is_logarithmic(layout.coordinates()):
        panels[-1].set_xscale("log")
    explain(figure, panels, layout, handles)


def explain(figure, panels, layout: Layout, handles) -> None:
    """Legend of a family, or a colour bar when it is large, with further entries."""
    family = layout.cases() if layout.family else []
    if len(family) <= LARGEST_LEGEND:
        handles = [Line2D([], [], color=case.colour, label=case.text) for case in family] + handles
    listed = layout.family and len(family) <= LARGEST_LEGEND
    style.legend_beside(panels[0], handles, layout.family_name if listed else None)
    if len(family) > LARGEST_LEGEND:
        colour_bar(figure, panels, layout, family)


def colour_bar(figure, panels, layout: Layout, family) -> None:
    first = layout.analysis.read(layout.family[0])
    if len(layout.family) == 1 and first.values.dtype.kind == "f":
        values = first.values[[case.index[layout.family[0]] for case in family]]
        scale = scale_for(first.unit, values)
        style.colour_bar(figure, panels, values / scale.factor, scale.label(layout.family_name))
    else:
        style.colour_bar(figure, panels, range(1, len(family) + 1), "Number of the grid point")
