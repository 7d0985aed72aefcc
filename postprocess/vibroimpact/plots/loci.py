"""Loci of special points in the plane of two keys, with what lies on either side of them."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .branches import key_name, pick
from .curves import explain
from .labels import scale_for
from .layout import LARGEST_FAMILY, Layout, kept
from .results import Analysis, Results

TYPE = "locus"
#        of `kind`: name, line, what there is on the side that `side` names
KINDS = {1: ("fold", "-", "three solutions"), 3: ("period doubling", "--", "period doubled"),
         4: ("loss of symmetry", ":", "not symmetric"),
         5: ("Neimark–Sacker", "-.", "quasi-periodic"), 6: ("grazing", (0, (1, 1)), "contact")}
#        of `special/kind`
SPECIAL = {1: ("cusp", "*"), 2: ("end on a grazing curve", "D")}
TICKS = 24  # along a locus, towards its side
TICK_LENGTH = 0.012  # of the width


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if analysis.type != TYPE or not analysis.has("arclength"):
        return
    layout = Layout(analysis, None, [name for name in analysis.axes
                                     if len(kept(analysis, name)) > 1])
    if len(layout.cases()) <= LARGEST_FAMILY:
        yield f"{analysis.name}-plane", functools.partial(plane_figure, layout)


def keys_of(analysis: Analysis) -> list[str]:
    """The first and the second key."""
    names = [name for name in analysis.members("end") if name not in ("locus", "reason")
             and not analysis.is_coordinate(f"end/{name}")]
    return sorted(names, key=lambda name: not str(
        analysis.attributes(name).get("description", "")).startswith("first key"))


def plane_figure(layout: Layout):
    analysis = layout.analysis
    keys = keys_of(analysis)
    scales = [scale_for(analysis.read(key).unit, analysis.read(key).values) for key in keys]
    figure, (axes,) = style.panels(1, height=3.6)
    for put, key, scale in zip((axes.set_xlabel, axes.set_ylabel), keys, scales):
        put(scale.label(key_name(key)))
    loci = [locus for case in layout.cases() for locus in loci_of(layout, case, keys, scales)]
    width = np.ptp(np.concatenate([locus["x"] for locus in loci])) if loci else 1
    for locus in loci:
        draw(axes, layout, locus, width or 1)
    found: set[int] = set()
    for case in layout.cases():
        found |= mark(axes, layout, case, keys, scales)
    explain(figure, [axes], layout,
            kind_handles(layout, {locus["kind"] for locus in loci}) + special_handles(found))
    return figure


def loci_of(layout: Layout, case, keys, scales) -> list[dict]:
    """Each locus of a case with its points in order."""
    number, kind, side = (pick(layout, layout.analysis.read(name).values, case)
                          for name in ("locus", "kind", "side"))
    x, y = (pick(layout, layout.analysis.read(key).values, case) / scale.factor
            for key, scale in zip(keys, scales))
    return [{"case": case, "kind": int(kind[number == n][0]), "x": x[number == n],
             "y": y[number == n], "side": side[number == n]}
            for n in np.unique(number[np.isfinite(number)])]


def draw(axes, layout: Layout, locus: dict, width: float) -> None:
    x, y, kind = locus["x"], locus["y"], locus["kind"]
    place = sorted(KINDS).index(kind)
    colour = locus["case"].colour if layout.family else style.COLOURS[place]
    axes.plot(x, y, linestyle=KINDS[kind][1], color=colour)
    # Ticks point to the side, evenly along the curve as it is drawn.
    way = np.concatenate([[0], np.cumsum(np.hypot(np.diff(x) / width,
                                                  np.diff(y) / (np.ptp(y) or 1)))])
    for along in (np.arange(TICKS) + 0.5) / TICKS * way[-1]:
        i = int(np.clip(np.searchsorted(way, along) - 1, 0, len(x) - 2))
        share = (along - way[i]) / (way[i + 1] - way[i]) if way[i + 1] > way[i] else 0
        at = x[i] + share * (x[i + 1] - x[i]), y[i] + share * (y[i + 1] - y[i])
        side = locus["side"][i if share < 0.5 else i + 1]
        axes.plot([at[0], at[0] + side * TICK_LENGTH * width], [at[1], at[1]], color=colour,
                  linewidth=0.6, gid="side")
    if not layout.family:
        if kind == 1 and y[0] == y[-1]:  # comes back to where a key ends
            axes.fill(x, y, color=colour, alpha=0.12, linewidth=0)


def mark(axes, layout: Layout, case, keys, scales) -> set[int]:
    """Special points of a case; returns their kinds."""
    analysis = layout.analysis
    if not analysis.has("special/kind"):
        return set()
    kinds = pick(layout, analysis.read("special/kind").values, case)
    x, y = (pick(layout, analysis.read(f"special/{key}").values, case) / scale.factor
            for key, scale in zip(keys, scales))
    colour = case.colour if layout.family else "black"
    for kind, (_, marker) in SPECIAL.items():
        here = kinds == kind
        axes.plot(x[here], y[here], linestyle="", marker=marker, markersize=6, color=colour,
                  markerfacecolor="white", zorder=3)
    return {int(kind) for kind in kinds[np.isfinite(kinds)]}


def kind_handles(layout: Layout, found: set[int]) -> list[Line2D]:
    """What the ticks point at stands in the legend, where it hides no curve."""
    colours = {kind: style.GREY if layout.family else style.COLOURS[place]
               for place, kind in enumerate(sorted(KINDS))}
    return [Line2D([], [], color=colours[kind], linestyle=line, label=f"{label};\nticks: {side}")
            for kind, (label, line, side) in KINDS.items() if kind in found]


def special_handles(found: set[int]) -> list[Line2D]:
    return [Line2D([], [], color=style.GREY, linestyle="", marker=marker, markersize=6,
                   markerfacecolor="white", label=label)
            for kind, (label, marker) in SPECIAL.items() if kind in found]
