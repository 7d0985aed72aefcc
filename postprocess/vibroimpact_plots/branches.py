"""Branches of periodic motions: stable parts solid, unstable ones dashed, special points marked; and
their multipliers in the complex plane.
"""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .curves import explain, field_of
from .labels import key_label, scale_for
from .layout import LARGEST_FAMILY, Layout, kept
from .measures import sheets
from .results import Analysis, Results

TYPE = "branch"
#        of `special/kind`
KINDS = {1: ("fold", "o"), 2: ("branch point", "X"), 3: ("period doubling", "^"),
         4: ("loss of symmetry", "v"), 5: ("Neimark–Sacker", "s"), 6: ("graze", "d"),
         7: ("grazing fold", "D"), 8: ("other contact changes", "|")}


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if analysis.type != TYPE or not analysis.has("arclength"):
        return
    layout = Layout(analysis, None, [name for name in analysis.axes
                                     if len(kept(analysis, name)) > 1])
    if len(layout.cases()) > LARGEST_FAMILY:
        return
    for sheet in sheets(analysis, "", separate=True):
        yield f"{analysis.name}-{sheet.name}", functools.partial(branch_figure, layout, sheet)
    yield f"{analysis.name}-multipliers", functools.partial(multiplier_figure, layout)


def key_of(analysis: Analysis) -> str:
    """Name of the key along which the branches were followed."""
    return next(name for name in analysis.members("end")
                if name not in ("branch", "reason")
                and not analysis.is_coordinate(f"end/{name}"))


def key_name(key: str) -> str:
    return "Frequency" if key == "frequency" else key_label(key.replace(".", "/"))


def pick(layout: Layout, values: np.ndarray, case) -> np.ndarray:
    """Values of one case; dimensions of the field itself follow."""
    return values[tuple(case.index.get(name, kept(layout.analysis, name)[0])
                        for name in layout.analysis.axes)]


def branch_figure(layout: Layout, sheet):
    analysis, key = layout.analysis, key_of(layout.analysis)
    count = len(sheet.panels)
    figure, panels = style.panels(count, height=2.6 if count == 1 else 1.9)
    scale = scale_for(analysis.read(key).unit, analysis.read(key).values)
    found: set[int] = set()
    for axes, panel in zip(panels, sheet.panels):
        field = field_of(analysis, panel.curves[0][0])
        units = scale_for(field.unit, field.values)
        for case in layout.cases():
            draw(axes, layout, case, (key, scale), (panel.curves[0][0], units))
            found |= mark(axes, layout, case, (key, scale), (panel.curves[0][0], units))
        axes.set_ylabel(units.label(panel.label))
    if sheet.title:
        panels[0].set_title(sheet.title)
    panels[-1].set_xlabel(scale.label(key_name(key)))
    explain(figure, panels, layout, line_handles() + kind_handles(found))
    return figure


def draw(axes, layout: Layout, case, along, shown) -> None:
    """Every branch of a case; a piece between two points is solid when both are stable."""
    analysis = layout.analysis
    x, y = (pick(layout, field_of(analysis, path).values, case) / scale.factor
            for path, scale in (along, shown))
    stable = pick(layout, analysis.read("stable").values, case)
    number = pick(layout, analysis.read("branch").values, case)
    colour = case.colour if layout.family else style.COLOURS[0]
    for branch in np.unique(number[np.isfinite(number)]):
        here = number == branch
        pieces(axes, x[here], y[here], stable[here] == 1, colour)


def pieces(axes, x, y, stable, colour) -> None:
    solid = stable[:-1] & stable[1:]
    for chosen, line in ((solid, "-"), (~solid, "--")):
        xs, ys = ([value for i in np.flatnonzero(chosen)
                   for value in (values[i], values[i + 1], np.nan)] for values in (x, y))
        # Neighbouring pieces are one line, so that the dashes go on.
        axes.plot(*joined(xs, ys), line, color=colour)


def joined(xs: list, ys: list):
    """Without the interruption between pieces that meet."""
    kept_x: list[float] = []
    kept_y: list[float] = []
    for i in range(0, len(xs), 3):
        if kept_x and (kept_x[-2], kept_y[-2]) == (xs[i], ys[i]):
            kept_x[-1:], kept_y[-1:] = [xs[i + 1], np.nan], [ys[i + 1], np.nan]
        else:
            kept_x += xs[i:i + 3]
            kept_y += ys[i:i + 3]
    return kept_x, kept_y


def mark(axes, layout: Layout, case, along, shown) -> set[int]:
    """Special points of a case; returns their kinds."""
    analysis = layout.analysis
    if not analysis.has("special/kind"):
        return set()
    kinds = pick(layout, analysis.read("special/kind").values, case)
    x, y = (pick(layout, field_of(analysis, f"special/{path}").values, case) / scale.factor
            for path, scale in (along, shown))
    colour = case.colour if layout.family else style.COLOURS[0]
    for kind, (_, marker) in KINDS.items():
        here = kinds == kind
        axes.plot(x[here], y[here], linestyle="", marker=marker, markersize=5, color=colour,
                  markerfacecolor="white", zorder=3)
    return {int(kind) for kind in kinds[np.isfinite(kinds)]}


def line_handles() -> list[Line2D]:
    return [Line2D([], [], color=style.GREY, linestyle=line, label=label)
            for line, label in (("-", "stable"), ("--", "unstable"))]


def kind_handles(found: set[int]) -> list[Line2D]:
    return [Line2D([], [], color=style.GREY, linestyle="", marker=marker, markersize=5,
                   markerfacecolor="white", label=label)
            for kind, (label, marker) in KINDS.items() if kind in found]


def multiplier_figure(layout: Layout):
    """Multipliers of all points against the unit circle; those far outside are left out."""
    analysis = layout.analysis
    figure, (axes,) = style.panels(1, height=3.0)
    angle = np.linspace(0, 2 * np.pi, 361)
    axes.plot(np.cos(angle), np.sin(angle), color=style.GREY, linewidth=0.8)
    for case in layout.cases():
        real, imaginary = (pick(layout, analysis.read(f"multiplier_{part}").values, case)
                           for part in ("real", "imaginary"))
        colour = case.colour if layout.family else style.COLOURS[0]
        axes.plot(real.ravel(), imaginary.ravel(), "o", markersize=2, markeredgewidth=0,
                  color=colour, rasterized=True)
    axes.set_xlim(-2.2, 2.2)
    axes.set_ylim(-1.4, 1.4)
    axes.set_aspect("equal")
    axes.set_xlabel("Multipliers, real part")
    axes.set_ylabel("Imaginary part")
    explain(figure, [axes], layout, [])
    return figure
