"""Response curves of a stepped sweep, up and down: excursions, contact force, impacts."""

from __future__ import annotations

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .cases import Case, cases, explain
from .labels import quantity_label, scale_for, words
from .results import Analysis, Results

MEASURES = ["peak_to_peak_excursion", "peak_excursion"]  # the first that is there is drawn
CONTACT_ROWS = [
    ("normal_force/maximum", "Largest contact force"),
    ("gap/minimum", "Smallest gap"),
    ("impacts_per_period", "Impacts per period"),
]
LINES = {"forward": dict(linestyle="-", marker=">"), "backward": dict(linestyle="--", marker="<"),
         "initial conditions": dict(linestyle=":", marker="o")}


def figures(results: Results, analysis: Analysis):
    """Name and figure, one after the other."""
    for quantity in observed_quantities(analysis):
        for points in points_together(analysis, quantity):
            name = f"{analysis.name}-{quantity.replace('_', '-')}"
            yield (name + "-" + points[0] if analysis.grid else name,
                   excursions(analysis, quantity, points))
    for contact in analysis.members("contact"):
        rows = [row for row in CONTACT_ROWS if analysis.has(f"contact/{contact}/{row[0]}")]
        if rows:
            yield f"{analysis.name}-contact-{contact}", contact_curves(analysis, contact, rows)


def measure_of(analysis: Analysis, point: str, quantity: str):
    """Path of the measure that is drawn, or None."""
    for measure in MEASURES:
        if analysis.has(f"point/{point}/{quantity}/{measure}"):
            return f"point/{point}/{quantity}/{measure}"
    return None


def observed_quantities(analysis: Analysis) -> list[str]:
    found: list[str] = []
    for point in analysis.members("point"):
        for quantity in analysis.members(f"point/{point}"):
            if quantity not in found and measure_of(analysis, point, quantity):
                found.append(quantity)
    return found


def points_together(analysis: Analysis, quantity: str) -> list[list[str]]:
    """Points that share a figure: all of them, or each by itself when colours mean the grid."""
    points = [p for p in analysis.members("point") if measure_of(analysis, p, quantity)]
    return [[point] for point in points] if analysis.grid else [points]


def swept_axis(analysis: Analysis) -> str:
    """The first axis of the sweep itself: frequency, or the key that was swept."""
    return analysis.axes[len(analysis.grid)]


def draw(axes, analysis: Analysis, path: str, case: Case, colour, scale) -> None:
    """Both directions of one field of one case; points that did not settle are hollow."""
    frequency = analysis.read(swept_axis(analysis)).values
    field = analysis.read(path).values[case.index]
    steady = analysis.read("steady").values[case.index] if analysis.has("steady") else None
    for d, direction in enumerate(analysis.read("direction").values):
        y = field[:, d] / scale.factor
        axes.plot(frequency, y, color=colour, markevery=marked(len(frequency), d),
                  **LINES[direction])
        if steady is not None:
            unsettled = steady[:, d] == 0
            axes.plot(frequency[unsettled], y[unsettled], "o", color=colour, fillstyle="none")


def marked(count: int, direction: int) -> tuple[int, int]:
    """First and step of the points with a marker: about ten along a curve, the two directions
    in turn, so that both are seen where they agree."""
    step = max(1, count // 10)
    return direction * (step // 2), step


def further_handles(analysis: Analysis) -> list[Line2D]:
    """Legend entries of the directions, and of unsettled points if there are any."""
    directions = analysis.read("direction").values
    handles = [Line2D([], [], color="#555555", label=d, **LINES[d]) for d in directions]
    if analysis.has("steady") and np.any(analysis.read("steady").values == 0):
        handles.append(Line2D([], [], color="#555555", marker="o", fillstyle="none",
                              linestyle="", label="not settled"))
    return handles


def excursions(analysis: Analysis, quantity: str, points: list[str]):
    fields = {point: measure_of(analysis, point, quantity) for point in points}
    arrays = [analysis.read(path) for path in fields.values()]
    scale = scale_for(arrays[0].unit, *[array.values for array in arrays])
    figure, (axes,) = style.panels(1, height=2.6)
    family = cases(analysis)
    handles = further_handles(analysis)
    if analysis.grid:
        axes.set_title(f"Point {points[0]}")
    for number, (point, path) in enumerate(fields.items()):
        colour = style.COLOURS[number % len(style.COLOURS)]
        for case in family:
            draw(axes, analysis, path, case, case.colour if analysis.grid else colour, scale)
        if not analysis.grid:
            handles.insert(number, Line2D([], [], color=colour, label=point))
    measure = words(next(iter(fields.values())).rsplit("/", 1)[-1])
    axes.set_ylabel(scale.label(f"{quantity_label(quantity)},\n{measure}"))
    finish(figure, [axes], analysis, family, handles)
    return figure


def contact_curves(analysis: Analysis, contact: str, rows):
    figure, panels = style.panels(len(rows))
    family = cases(analysis)
    for axes, (name, label) in zip(panels, rows):
        path = f"contact/{contact}/{name}"
        array = analysis.read(path)
        scale = scale_for(array.unit, array.values)
        for case in family:
            draw(axes, analysis, path, case, case.colour, scale)
        axes.set_ylabel(scale.label(label))
    panels[0].set_title(f"Contact {contact}")
    finish(figure, panels, analysis, family, further_handles(analysis))
    return figure


def finish(figure, panels, analysis: Analysis, family, handles) -> None:
    axis = swept_axis(analysis)
    name = "Frequency" if axis == "frequency" else axis
    panels[-1].set_xlabel(f"{name} ({analysis.read(axis).unit})")
    explain(figure, panels, analysis, family, handles)
