"""Phase portraits from recorded histories, with the points of sections on top, and sections alone."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .axis_meaning import Meaning, Panel, note
from .bifurcation import point_size
from .cycles import direction_handles
from .labels import quantity_label, scale_for
from .layout import layout_of, place_of, places
from .motions import Motion, bases
from .results import Analysis, Results
from .sections import Section, sections_of

SMALLEST_VIEW = 0.02  # of the range over all panels; a single point is not blown up to round-off


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    for base in filter(None, bases(analysis)):
        for point, axis in pairs(analysis, f"{base}point"):
            yield (f"{analysis.name}-portrait-{point}-{axis}",
                   functools.partial(portraits, analysis, base, point, axis))
    for root in ("", "recorded/"):
        for section in sections_of(analysis, root):
            if section.kind in ("period", "onset"):
                for point, axis in pairs(analysis, f"{section.path}/point"):
                    yield (f"{analysis.name}-poincare-{section.name}-{point}-{axis}",
                           functools.partial(poincare, analysis, section, point, axis))


def pairs(analysis: Analysis, group: str) -> list[tuple[str, str]]:
    """Points and axes with displacement and velocity in a group."""
    return [(point, axis) for point in analysis.members(group) for axis in "xyz"
            if all(analysis.has(f"{group}/{point}/{quantity}_{axis}")
                   for quantity in ("displacement", "velocity"))]


def portraits(analysis: Analysis, base: str, point: str, axis: str):
    """Orbits of chosen points of the analysis; dots: end of each forcing period."""
    root = base.removesuffix("history/")
    periods = [section for section in sections_of(analysis, root) if section.kind == "period"]
    figure, panels, draw = prepared(analysis, axis, [f"{base}point/{point}"])
    dots = False
    for axes, place in panels:
        for number, direction in enumerate(layout_of(analysis).directions):
            motion = Motion(analysis, base, place, direction)
            path = f"point/{point}"
            draw(axes, motion.signal(f"{path}/displacement_{axis}"),
                 motion.signal(f"{path}/velocity_{axis}"), color=style.COLOURS[number],
                 linestyle=style.DIRECTION_LINES[number], linewidth=0.7)
            for section in periods:
                dots = True
                x, y = section_points(analysis, section, point, axis, place, direction)
                draw(axes, x, y, marker="o", linestyle="", color="black" if number == 0 else "white",
                     markeredgecolor="black", markeredgewidth=0.5, markersize=2.6, zorder=4)
    return finished(figure, panels, analysis, f"Point {point}", dots)


def poincare(analysis: Analysis, section: Section, point: str, axis: str):
    """Displacement over velocity at the section, of chosen points of the analysis."""
    group = f"{section.path}/point/{point}"
    figure, panels, draw = prepared(analysis, axis, [group], share=False)
    for axes, place in panels:
        for number, direction in enumerate(layout_of(analysis).directions):
            x, y = section_points(analysis, section, point, axis, place, direction)
            size = point_size(x.size) * (1.2 if number == 0 else 0.8)
            draw(axes, x, y, marker="o", linestyle="", color=style.COLOURS[number],
                 markersize=size, markeredgewidth=0, rasterized=True)
    note_empty([axes for axes, _ in panels])
    widen([axes for axes, _ in panels if axes.get_autoscale_on()])
    return finished(figure, panels, analysis, f"{section.title}, {point}", False)


def section_points(analysis: Analysis, section: Section, point: str, axis: str, place, direction):
    x, y = (place.pick(analysis, section.values(analysis, point, f"{quantity}_{axis}"), direction)
            for quantity in ("displacement", "velocity"))
    known = np.isfinite(x)
    return x[known], y[known]


def prepared(analysis: Analysis, axis: str, groups: list[str], share: bool = True):
    """Figure, panels with their places, and a function that draws SI values into one of them. With two
    groups the motion of one against the other is shown."""
    entries = places(analysis)
    figure, panels = style.panel_grid(len(entries), share=share)
    scales, meanings = [], []
    for quantity in ("displacement", "velocity"):
        paths = [f"{group}/{quantity}_{axis}" for group in groups]
        arrays = [analysis.read(path) for path in paths]
        scales.append(scale_for(arrays[0].unit, *[array.values for array in arrays]))
        meanings.append(Meaning((paths[0],) if len(paths) == 1 else
                                (f"relative_{quantity}_{axis}",), arrays[0].unit, scales[-1]))

    def draw(axes, x, y, **look):
        axes.plot(x / scales[0].factor, y / scales[1].factor, **look)

    style.label_grid(panels, scales[0].label(quantity_label(f"displacement_{axis}")),
                     scales[1].label(quantity_label(f"velocity_{axis}")))
    for axes, place in zip(panels, entries):
        style.panel_title(axes, place.text, panels)
        note(axes, Panel(*meanings, place=place_of(analysis, place)))
    return figure, list(zip(panels, entries)), draw


def note_empty(panels) -> None:
    for axes in panels:
        if not any(len(line.get_xdata()) for line in axes.get_lines()):
            axes.text(0.5, 0.5, "none", transform=axes.transAxes, ha="center", va="center",
                      color="#555555")
            axes.set(xticks=[], yticks=[], autoscale_on=False)


def widen(panels) -> None:
    """Panels with limits of their own, none narrower than a share of the widest."""
    for get, put in [("get_xlim", "set_xlim"), ("get_ylim", "set_ylim")]:
        limits = np.array([getattr(axes, get)() for axes in panels]).reshape(-1, 2)
        if not len(limits):
            return
        least = max(SMALLEST_VIEW * (limits.max() - limits.min()), 1e-3 * np.abs(limits).max())
        for axes, (low, high) in zip(panels, limits):
            if high - low < least:
                getattr(axes, put)((low + high - least) / 2, (low + high + least) / 2)


def finished(figure, panels, analysis: Analysis, title: str, dots: bool):
    figure.suptitle(title, x=0.01, ha="left", fontsize=10)
    handles = direction_handles(analysis)
    if dots:
        handles.append(Line2D([], [], marker="o", linestyle="", color="black", markersize=2.6,
                              label="end of a period"))
    style.legend_beside(style.upper_right([axes for axes, _ in panels]), handles)
    return figure
