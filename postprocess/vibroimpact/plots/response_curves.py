"""Response curves: every measure that a sweep, a response over a grid, a frequency response or a
recorded transient motion over a grid holds.
"""

from __future__ import annotations

import functools
import re

from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from . import axis_meaning, style
from .axis_meaning import Meaning, note
from .curves import direction_handles, draw, finish
from .labels import scale_for
from .layout import LARGEST_FAMILY, Layout, family_of, layout_of
from .measures import Panel, Sheet, field_of, magnitude, sheets
from .results import Analysis, Results

CHARACTERS = ["not repeating", "periodic", "settling", "quasi-periodic", "chaotic", "not decided"]
STRESS = re.compile(r"(?:^|/)point/([^./]+)\.[^/]+/von_mises_stress/")
ORDER_RANGE = 1e-5  # smallest amplitude of an order that is shown, of the largest


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    layout = layout_of(analysis)
    if layout.along is None or len(layout.cases()) > LARGEST_FAMILY:
        return
    for root in ("", "recorded/"):
        for sheet in sheets(analysis, root, separate=bool(layout.family)):
            yield f"{analysis.name}-{sheet.name}", functools.partial(curve_figure, layout, sheet)


def curve_figure(layout: Layout, sheet: Sheet):
    several = any(len(panel.curves) > 1 for panel in sheet.panels)
    count = len(sheet.panels)
    figure, panels = style.panels(count, height=2.6 if count == 1 else 1.9 if count < 4 else 1.5)
    for axes, panel in zip(panels, sheet.panels):
        draw_panel(axes, layout, panel, colours_of(sheet))
    if sheet.title:
        panels[0].set_title(sheet.title)
    handles = direction_handles(layout)
    if several or points_named(sheet):
        handles = curve_handles(sheet) + handles
    finish(figure, panels, layout, handles)
    return figure


def points_named(sheet: Sheet) -> bool:
    return not sheet.title and any(text for panel in sheet.panels for _, text in panel.curves)


def colours_of(sheet: Sheet) -> dict:
    """Colour of each curve of a panel by its name, the same in all panels."""
    names = dict.fromkeys(text for panel in sheet.panels for _, text in panel.curves)
    return {name: style.COLOURS[i % len(style.COLOURS)] for i, name in enumerate(names)}


def draw_panel(axes, layout: Layout, panel: Panel, colours: dict) -> None:
    arrays = [field_of(layout.analysis, path) for path, _ in panel.curves]
    scale = scale_for(arrays[0].unit, *[array.values for array in arrays])
    for path, text in panel.curves:
        draw(axes, layout, path,
             [case.colour if layout.family else colours[text] for case in layout.cases()], scale)
    draw_yield_stresses(axes, layout.analysis, [path for path, _ in panel.curves], scale)
    axes.set_ylabel(scale.label(panel.label))
    along = layout.analysis.read(layout.along).unit
    note(axes, axis_meaning.Panel(
        Meaning((layout.along,), along, layout.scale),
        Meaning(tuple(path for path, _ in panel.curves), arrays[0].unit, scale),
        family_of(layout)))
    adapt_axis(axes, panel.curves[0][0], max(magnitude(array) for array in arrays) / scale.factor)


def draw_yield_stresses(axes, analysis: Analysis, paths: list[str], scale) -> None:
    """A line across at the yield stress of each body whose stress is drawn."""
    bodies = {found.group(1) for path in paths if (found := STRESS.search(path))}
    for body in sorted(bodies & analysis.yield_stresses.keys()):
        level = analysis.yield_stresses[body] / scale.factor
        axes.axhline(level, color=style.GREY, linestyle=":", linewidth=0.9)
        axes.annotate(f"yield stress of {body}", (0.01, level), xycoords=axes.get_yaxis_transform(), xytext=(0, 2),
                      textcoords="offset points", fontsize=8, color=style.GREY)


def adapt_axis(axes, path: str, largest: float) -> None:
    """Names for characters, whole numbers for counts, decades for orders."""
    if path.endswith("regime/class"):
        for line in axes.get_lines():  # a class is not joined with the next one
            line.set(linestyle="", marker=line.get_marker() if line.get_marker() != "None" else "o")
        axes.set_yticks(range(len(CHARACTERS)), CHARACTERS)
        axes.set_ylim(-0.4, len(CHARACTERS) - 0.6)
    elif path.endswith("period_multiple"):
        axes.yaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    elif "order_amplitude/" in path and largest > 0:
        axes.set_yscale("log")
        axes.set_ylim(largest * ORDER_RANGE, 3 * largest)


def curve_handles(sheet: Sheet) -> list[Line2D]:
    """Legend entries of the curves of a panel."""
    return [Line2D([], [], color=colour, label=text)
            for text, colour in colours_of(sheet).items() if text]
