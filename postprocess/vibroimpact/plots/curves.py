"""Curves over the swept axis, both directions, as families over the other axes of a grid."""

from __future__ import annotations

import numpy as np
from matplotlib.lines import Line2D

from . import style, traces
from .labels import scale_for
from .layout import Layout, axis_name
from .measures import field_of
from .results import Analysis

LARGEST_LEGEND = 8
LINES = {"forward": dict(linestyle="-", marker=">"), "backward": dict(linestyle="--", marker="<"),
         "initial conditions": dict(linestyle=":", marker="o"), "": dict(linestyle="-")}
FEW_POINTS = 60  # a curve without direction shows every point up to this number


def draw(axes, layout: Layout, path: str, colours, scale) -> None:
    """One field; `colours` gives that of each case."""
    analysis = layout.analysis
    x = layout.coordinates() / layout.scale.factor
    field = field_of(analysis, path).values
    for case, colour in zip(layout.cases(), colours):
        for number, direction in enumerate(layout.directions):
            def pick(name, case=case, direction=direction):
                return layout.pick(analysis.read(name).values, case, direction)

            y = layout.pick(field, case, direction) / scale.factor
            shown = traces.plain(x, y) if layout.along not in analysis.axes else traces.trace(
                x, y, loose_of(analysis, pick), bracket(layout, pick), direction == "backward")
            traces.draw(axes, shown, colour, **look_of(layout, direction, number, len(x)))


def look_of(layout: Layout, direction: str, number: int, count: int) -> dict:
    """Line and about ten markers of a direction."""
    alone = len(layout.directions) == 1
    look = dict(LINES[""] if alone else LINES.get(direction, LINES[""]))
    if alone and count <= FEW_POINTS:
        look["marker"] = "o"
    return dict(look, markevery=None if alone else marked(count, number))


def loose_of(analysis: Analysis, pick) -> np.ndarray:
    """Points that are not joined: motions that have not settled, or do not repeat themselves. `pick`
    gives the values of a field of all outer axes along the curve."""
    loose = np.zeros(pick("status").shape, bool)
    if analysis.judges_steadiness:
        loose |= pick("steady") == 0
    if analysis.has("regime/class"):
        loose |= np.isin(pick("regime/class"), traces.CHAOTIC)
    return loose


def bracket(layout: Layout, pick):
    """Both ends of each located jump along the axis; None where jumps are not located."""
    analysis = layout.analysis
    if not analysis.has("jump_from") or layout.along in analysis.grid_axes:
        return None
    return [pick(name) / layout.scale.factor for name in ("jump_from", "jump_to")]


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
    if analysis.judges_steadiness and np.any(analysis.read("steady").values == 0):
        handles.append(Line2D([], [], color=style.GREY, linestyle="", label="not settled",
                              **traces.UNSETTLED))
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
