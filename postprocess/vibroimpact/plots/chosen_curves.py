"""Curves of figures with chosen axes: those of sweeps and grids, branches, loci and histories."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from matplotlib.lines import Line2D

from . import emphasis, envelopes, style, traces
from .branch_curves import TYPES as BRANCHES
from .branch_curves import pieces
from .branches import KINDS, kind_handles, mark_kinds
from .curves import LINES, loose_of, marked
from .errors import ResultError
from .figure_axes import Quantity, find
from .layout import DIRECTION, Layout, kept
from .loci import TYPE as LOCUS
from .results import Analysis

SPECIAL = "special/"


@dataclass(frozen=True)
class Family:
    """The curves of an analysis, and the legend entries of their lines."""

    layout: Layout
    handles: list[Line2D]
    drawn: list[emphasis.Curve]


def curves(axes, analysis: Analysis, both, colour=None, **look) -> Family:
    """All curves of an analysis."""
    quantities = [find(analysis, axis.quantity) for axis in both]
    along = along_of(analysis, quantities)
    union = list(dict.fromkeys(name for quantity in quantities for name in quantity.dimensions))
    family = [name for name in analysis.axes
              if name in union and name not in (along, DIRECTION) and len(kept(analysis, name)) > 1]
    layout = Layout(analysis, along, family)
    directions = layout.directions if DIRECTION in union else [""]
    drawn: list[emphasis.Curve] = []
    for case, (number, direction) in itertools.product(layout.cases(), enumerate(directions)):
        index = {**case.index, DIRECTION: direction_index(analysis, direction)}
        chosen = colour or (case.colour if family else style.COLOURS[0])
        values = [axis.of(pick(quantity, analysis, index, along)) for quantity, axis in zip(quantities, both)]
        if analysis.type in BRANCHES:
            draw_branches(axes, analysis, index, values, both, chosen)
            continue
        if analysis.type == LOCUS:
            draw_loci(axes, field(analysis, "locus", index, along), values, chosen, look)
            continue
        marked_look = look_of(direction, len(directions), number, len(values[0])) | emphasis.look_of(chosen) | look
        loose = draw_curve(axes, analysis, index, along, quantities, values, both, chosen, marked_look)
        drawn.append(emphasis.Curve(*values, loose, chosen))
    swept = along in analysis.axes and set(union) >= set(analysis.axes)
    return Family(layout, line_handles(analysis, directions, swept, colour), drawn)


def along_of(analysis: Analysis, quantities: list[Quantity]) -> str:
    """The dimension along which a curve runs: that of a coordinate, else the last that both have."""
    if analysis.type in BRANCHES and not quantities[0].is_coordinate:
        return quantities[0].dimensions[-1]
    for quantity in quantities:
        if quantity.is_coordinate:
            return quantity.dimensions[0]
    common = [name for name in quantities[0].dimensions
              if name in quantities[1].dimensions and name != DIRECTION]
    if not common:
        raise ResultError(f"{quantities[0].path} and {quantities[1].path} have no axis in common")
    return common[-1]


def direction_index(analysis: Analysis, direction: str) -> int:
    return list(analysis.read(DIRECTION).values).index(direction) if direction else 0


def pick(quantity: Quantity, analysis: Analysis, index: dict, along: str) -> np.ndarray:
    """Values along one dimension at an index along the others."""
    outer = set(analysis.axes)
    where = tuple(
        (kept(analysis, name) if name in outer else slice(None)) if name == along
        else index.get(name, kept(analysis, name)[0] if name in outer else 0)
        for name in quantity.dimensions)
    return np.asarray(quantity.values[where], dtype=float)


def field(analysis: Analysis, path: str, index: dict, along: str) -> np.ndarray:
    array = analysis.read(path)
    return pick(Quantity(path, analysis.dimensions(path), array.values, array.unit, ""), analysis,
                index, along)


def draw_curve(axes, analysis, index, along, quantities, values, both, colour, look) -> np.ndarray:
    """Gives which of its points are not joined."""
    swapped = quantities[1].dimensions == [along]
    coordinate, curve = reversed(values) if swapped else values
    scale = both[1 if swapped else 0].scale
    whole = any(set(quantity.dimensions) >= set(analysis.axes) for quantity in quantities)
    swept = whole and along in analysis.axes

    def values_of(name):
        return field(analysis, name, index, along)

    if not swept:
        shown = traces.plain(coordinate, curve)
        if quantities[0].path.endswith("time") and look.get("linestyle"):
            envelopes.draw(axes, *values, colour, **look)
            return shown.loose
    else:
        bracket = None
        if analysis.has("jump_from") and along not in analysis.grid_axes:
            bracket = [values_of(name) / scale.factor for name in ("jump_from", "jump_to")]
        shown = traces.trace(coordinate, curve, loose_of(analysis, values_of), bracket,
                             DIRECTION in analysis.axes and bool(index[DIRECTION]))
    traces.draw(axes, shown, colour, swapped, **look)
    error = f"{quantities[1].path}_error"
    if analysis.has(error) and analysis.dimensions(error) == quantities[1].dimensions:
        upper = both[1].of(field(analysis, quantities[1].path, index, along) + 2 * values_of(error))
        axes.errorbar(*values, np.nan_to_num(upper - values[1]), fmt="none", ecolor=colour, elinewidth=0.7)
    return shown.loose


def look_of(direction: str, count: int, number: int, points: int) -> dict:
    """Lines of both directions with about ten markers each."""
    if count == 1:
        return dict(linestyle="-")
    return dict(LINES.get(direction, LINES[""]), markevery=marked(points, number))


def draw_branches(axes, analysis: Analysis, index, values, both, colour) -> None:
    along = "branch_point"
    number = field(analysis, "branch", index, along)
    stable = np.ones(number.shape, bool)
    if analysis.has("stable"):
        stable = field(analysis, "stable", index, along) == 1
    for branch in np.unique(number[np.isfinite(number)]):
        here = number == branch
        pieces(axes, values[0][here], values[1][here], stable[here], colour)
    if analysis.has("special/kind"):
        kinds = field(analysis, "special/kind", index, "special_point")
        if all(analysis.has(SPECIAL + axis.quantity) for axis in both):
            x, y = (field(analysis, SPECIAL + axis.quantity, index, "special_point")
                    / axis.scale.factor for axis in both)
            mark_kinds(axes, kinds, x, y, colour)


def draw_loci(axes, number, values, colour, look) -> None:
    """Each locus a line; `number` counts them."""
    for locus in np.unique(number[np.isfinite(number)]):
        axes.plot(*[value[number == locus] for value in values], color=colour, **look)


def line_handles(analysis: Analysis, directions, swept: bool, colour) -> list[Line2D]:
    if colour is not None:
        return []
    if analysis.type in BRANCHES:
        found = set()
        if analysis.has("special/kind"):
            kinds = analysis.read("special/kind").values
            found = {int(kind) for kind in kinds[np.isfinite(kinds)]} & set(KINDS)
        lines = [("-", "stable"), ("--", "unstable")] if analysis.has("stable") else []
        return [Line2D([], [], color=style.GREY, linestyle=line, label=label)
                for line, label in lines] + kind_handles(found)
    handles = [Line2D([], [], color=style.GREY, label=direction, **LINES.get(direction, LINES[""]))
               for direction in directions if len(directions) > 1]
    if analysis.judges_steadiness and swept and np.any(analysis.read("steady").values == 0):
        handles.append(Line2D([], [], color=style.GREY, linestyle="", label="not settled",
                              **traces.UNSETTLED))
    return handles
