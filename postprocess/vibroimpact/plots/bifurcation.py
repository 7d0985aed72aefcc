"""Bifurcation diagrams: section points over the swept axis, both directions in two colours."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .curves import finish
from .labels import quantity_label, scale_for
from .layout import Layout, layout_of
from .results import Analysis, Results
from .sections import Section, relative, sections_of

MOST_CASES = 8
LARGEST, SMALLEST = 3.0, 0.9  # sizes of the points [pt], of few and of many


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    layout = layout_of(analysis)
    if layout.along is None:
        return
    family = layout.cases() if len(layout.cases()) <= MOST_CASES else []
    for section in sections_of(analysis):
        for name, shown in diagrams(analysis, section):
            for number, case in enumerate(family, 1):
                suffix = f"-{number}" if layout.family else ""
                yield (f"{analysis.name}-bifurcation-{section.name}{name}{suffix}",
                       functools.partial(diagram, layout, section, shown, case))


def diagrams(analysis: Analysis, section: Section):
    """What is drawn of a section: displacements of each point where it is taken once a period, of
    its own point at extrema, both sides' relative displacement at extrema of a gap."""
    displacements = section.quantities(analysis, "displacement")
    if section.kind == "gap_extremum":
        sides = relative(analysis, section)
        if sides:
            return [("", sides)]
    if section.kind == "onset":
        return [(f"-{point}-{quantity[-1]}", (point, quantity, None, 1.0))
                for point, quantity in section.quantities(analysis, "velocity")]
    if section.kind == "extremum":
        displacements = [entry for entry in displacements if "/".join(entry) == section.of]
        return [("", (point, quantity, None, 1.0)) for point, quantity in displacements]
    return [(f"-{point}-{quantity[-1]}", (point, quantity, None, 1.0))
            for point, quantity in displacements]


def diagram(layout: Layout, section: Section, shown, case):
    analysis = layout.analysis
    figure, (axes,) = style.panels(1, height=3.0)
    field = section.values(analysis, *shown)
    scale = scale_for(field.unit, field.values)
    draw(axes, layout, field.values / scale.factor, case)
    axes.set_ylabel(scale.label(label_of(*shown)))
    axes.set_title(", ".join(filter(None, [section.title, case.text])))
    handles = [Line2D([], [], linestyle="", marker="o", color=colour, label=direction)
               for direction, colour in zip(layout.directions, style.COLOURS)
               if len(layout.directions) > 1]
    finish(figure, [axes], Layout(analysis, layout.along, []), handles)
    return figure


def label_of(point: str, quantity: str, other, _factor: float) -> str:
    label = quantity_label(quantity)
    return f"{label} of {point}" if other is None else f"{label},\n{point} less {other}"


def draw(axes, layout: Layout, values: np.ndarray, case) -> None:
    """Points of every direction; the later one is smaller, so that both are seen."""
    x = layout.coordinates() / layout.scale.factor
    for number, direction in enumerate(layout.directions):
        y = layout.pick(values, case, direction)
        size = point_size(distinct_count(y)) * (1.0 if number == 0 else 0.65)
        axes.plot(np.repeat(x, y.shape[-1]), y.ravel(), "o", markersize=size, markeredgewidth=0,
                  color=style.COLOURS[number], rasterized=True)


def distinct_count(y: np.ndarray) -> int:
    """Points that are distinguished in the figure; a periodic motion passes few places."""
    known = y[np.isfinite(y)]
    step = max(np.ptp(known), 1e-300) / 500 if known.size else 1.0
    return sum(np.unique(np.round(row[np.isfinite(row)] / step)).size for row in y)


def point_size(count: int) -> float:
    return float(np.clip(40 / np.sqrt(max(count, 1)), SMALLEST, LARGEST))
