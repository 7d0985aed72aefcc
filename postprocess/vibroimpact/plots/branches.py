"""Branches of periodic motions: stable parts solid, unstable ones dashed, special points marked, with
what --overlay asks for; and their multipliers, in the complex plane and over the key. A harmonic
balance has no multipliers; its lines are solid.
"""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D

from . import overlays, style
from .axis_meaning import Meaning, Panel, note
from .branch_curves import MODE, TYPES, key_name, key_of, pick, pieces
from .curves import explain
from .labels import scale_for
from .layout import LARGEST_FAMILY, Layout, family_of, kept
from .measures import Panel as Curves
from .measures import Sheet, field_of, sheets
from .results import Analysis, Results

#        of `special/kind`
KINDS = {1: ("fold", "o"), 2: ("branch point", "X"), 3: ("period doubling", "^"),
         4: ("loss of symmetry", "v"), 5: ("Neimark–Sacker", "s"), 6: ("grazing", "d"),
         7: ("grazing fold", "D"), 8: ("other contact changes", "|"), 9: ("crossing-sliding", "<"),
         10: ("grazing-sliding", ">"), 11: ("switching-sliding", "P"), 12: ("adding-sliding", "h"),
         13: ("fold of the frequency", "*")}
CRITICAL = (1, 2, 3, 4, 5)  # kinds at which a multiplier is on the unit circle


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if analysis.type not in TYPES or not analysis.has("arclength"):
        return
    layout = Layout(analysis, None, [name for name in analysis.axes
                                     if len(kept(analysis, name)) > 1])
    if len(layout.cases()) > LARGEST_FAMILY:
        return
    for sheet in (*frequency_sheets(analysis), *sheets(analysis, "", separate=True)):
        yield f"{analysis.name}-{sheet.name}", functools.partial(branch_figure, layout, sheet)
    if analysis.has("multiplier_real"):
        yield f"{analysis.name}-multipliers", functools.partial(multiplier_figure, layout)
        yield f"{analysis.name}-multiplier-moduli", functools.partial(modulus_figure, layout)


def frequency_sheets(analysis: Analysis):
    """Of a nonlinear mode: frequency over energy, and with losses the damping ratio."""
    if analysis.type == MODE:
        panels = [Curves("Frequency", [("frequency", "")])]
        if np.any(analysis.read("damping_ratio").values > 0):
            panels.append(Curves("Damping ratio", [("damping_ratio", "")]))
        yield Sheet("frequency", "", panels)


def key_scale(analysis: Analysis):
    """The key and how its values are shown."""
    key = key_of(analysis)
    return key, scale_for(analysis.read(key).unit, analysis.read(key).values)


def branch_figure(layout: Layout, sheet):
    analysis, key = layout.analysis, key_scale(layout.analysis)
    count = len(sheet.panels)
    figure, panels = style.panels(count, height=2.6 if count == 1 else 1.9)
    found: set[int] = set()
    laid: dict[str, Line2D] = {}
    for axes, panel in zip(panels, sheet.panels):
        path = panel.curves[0][0]
        field = field_of(analysis, path)
        shown = (path, scale_for(field.unit, field.values))
        for case in layout.cases():
            draw(axes, layout, case, key, shown)
            found |= mark(axes, layout, case, key, shown)
        laid |= {handle.get_label(): handle for handle in overlays.draw(axes, layout, key, shown)}
        axes.set_ylabel(shown[1].label(panel.label))
        note(axes, Panel(Meaning((key[0],), analysis.read(key[0]).unit, key[1]),
                         Meaning((path,), field.unit, shown[1]), family_of(layout)))
    if sheet.title:
        panels[0].set_title(sheet.title)
    panels[-1].set_xlabel(key[1].label(key_name(key[0])))
    explain(figure, panels, layout,
            line_handles(layout, laid) + kind_handles(found) + list(laid.values()))
    return figure


def draw(axes, layout: Layout, case, key, shown) -> None:
    """Every branch of a case; a piece between two points is solid when both are stable."""
    analysis = layout.analysis
    x, y = (pick(layout, field_of(analysis, path).values, case) / scale.factor
            for path, scale in (key, shown))
    for here, stable in parts(layout, case):
        pieces(axes, x[here], y[here], stable[here], colour_of(layout, case))


def parts(layout: Layout, case):
    """For each branch of a case which points are its own, and which of all are stable; without
    multipliers all count as stable."""
    analysis = layout.analysis
    number = pick(layout, analysis.read("branch").values, case)
    stable = np.ones(number.shape, bool)
    if analysis.has("stable"):
        stable = pick(layout, analysis.read("stable").values, case) == 1
    for branch in np.unique(number[np.isfinite(number)]):
        yield number == branch, stable


def colour_of(layout: Layout, case):
    return case.colour if layout.family else style.COLOURS[0]


def special_kinds(layout: Layout, case) -> np.ndarray:
    analysis = layout.analysis
    if not analysis.has("special/kind"):
        return np.array([])
    return pick(layout, analysis.read("special/kind").values, case)


def mark(axes, layout: Layout, case, key, shown) -> set[int]:
    """Special points of a case; returns their kinds."""
    kinds = special_kinds(layout, case)
    if not len(kinds):
        return set()
    x, y = (pick(layout, field_of(layout.analysis, f"special/{path}").values, case) / scale.factor
            for path, scale in (key, shown))
    return mark_kinds(axes, kinds, x, y, colour_of(layout, case))


def mark_kinds(axes, kinds, x, y, colour) -> set[int]:
    for kind, (_, marker) in KINDS.items():
        here = kinds == kind
        axes.plot(x[here], y[here], linestyle="", marker=marker, markersize=5, color=colour,
                  markerfacecolor="white", zorder=3)
    return {int(kind) for kind in kinds[np.isfinite(kinds)]}


def line_handles(layout: Layout, laid=()) -> list[Line2D]:
    """Stable and unstable; beside overlays the branch's own name and colour."""
    own = Line2D([], [], color=style.COLOURS[0], label=layout.analysis.name)
    named = [own] if laid and not layout.family else []
    if not layout.analysis.has("stable"):
        return named
    return named + [Line2D([], [], color=style.GREY, linestyle=line, label=label)
                    for line, label in (("-", "stable"), ("--", "unstable"))]


def kind_handles(found: set[int]) -> list[Line2D]:
    return [Line2D([], [], color=style.GREY, linestyle="", marker=marker, markersize=5,
                   markerfacecolor="white", label=label)
            for kind, (label, marker) in KINDS.items() if kind in found]


def multipliers(layout: Layout, case, prefix="") -> np.ndarray:
    real, imaginary = (pick(layout, layout.analysis.read(f"{prefix}multiplier_{part}").values, case)
                       for part in ("real", "imaginary"))
    return real + 1j * imaginary


def multiplier_figure(layout: Layout):
    """Multipliers of all points against the unit circle; those far outside are left out. Without a
    family the colour is that of the key."""
    analysis = layout.analysis
    figure, (axes,) = style.panels(1, height=3.0)
    angle = np.linspace(0, 2 * np.pi, 361)
    axes.plot(np.cos(angle), np.sin(angle), color=style.GREY, linewidth=0.8)
    for case in layout.cases():
        values = multipliers(layout, case)
        if layout.family:
            axes.plot(values.real.ravel(), values.imag.ravel(), "o", markersize=2,
                      markeredgewidth=0, color=case.colour, rasterized=True)
        else:
            colour_by_key(figure, axes, layout, case, values)
    axes.set_xlim(-2.2, 2.2)
    axes.set_ylim(-1.4, 1.4)
    axes.set_aspect("equal")
    axes.set_xlabel("Multipliers, real part")
    axes.set_ylabel("Imaginary part")
    explain(figure, [axes], layout, [])
    return figure


def colour_by_key(figure, axes, layout: Layout, case, values) -> None:
    key, scale = key_scale(layout.analysis)
    along = pick(layout, layout.analysis.read(key).values, case) / scale.factor
    drawn = axes.scatter(values.real.ravel(), values.imag.ravel(), s=4, linewidths=0,
                         c=np.repeat(along, values.shape[1]), cmap=style.SEQUENCE, rasterized=True)
    figure.colorbar(drawn, ax=axes, label=scale.label(key_name(key)), pad=0.015)


def modulus_figure(layout: Layout):
    """Absolute values of the multipliers over the key; motions are stable where all are below 1."""
    key, scale = key_scale(layout.analysis)
    figure, (axes,) = style.panels(1, height=2.6)
    axes.axhline(1, color=style.GREY, linewidth=0.8)
    found: set[int] = set()
    largest = 0.0
    for case in layout.cases():
        x = pick(layout, layout.analysis.read(key).values, case) / scale.factor
        moduli = np.sort(np.abs(multipliers(layout, case)), axis=1)
        largest = max(largest, np.nanmax(moduli))
        for here, stable in parts(layout, case):
            for column in moduli[here].T:
                pieces(axes, x[here], column, stable[here], colour_of(layout, case))
        found |= mark_moduli(axes, layout, case, (key, scale))
    axes.set_ylim(0, min(1.1 * max(largest, 1), 3))
    axes.set_xlabel(scale.label(key_name(key)))
    axes.set_ylabel("Multipliers,\nabsolute value")
    explain(figure, [axes], layout, line_handles(layout) + kind_handles(found))
    return figure


def mark_moduli(axes, layout: Layout, case, key) -> set[int]:
    """At the multiplier nearest to the unit circle, or where none is critical the largest."""
    kinds = special_kinds(layout, case)
    if not len(kinds) or not layout.analysis.has("special/multiplier_real"):
        return set()
    x = pick(layout, layout.analysis.read(f"special/{key[0]}").values, case) / key[1].factor
    moduli = np.abs(multipliers(layout, case, "special/"))
    nearest = np.nanargmin(np.abs(np.nan_to_num(moduli, nan=np.inf) - 1), axis=1)
    critical = np.take_along_axis(moduli, nearest[:, None], axis=1)[:, 0]
    y = np.where(np.isin(kinds, CRITICAL), critical, np.max(np.nan_to_num(moduli), axis=1))
    return mark_kinds(axes, kinds, x, y, colour_of(layout, case))
