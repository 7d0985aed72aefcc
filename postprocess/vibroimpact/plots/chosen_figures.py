"""Figures that sections "Figure" of the parameters describe: curves or maps with chosen axes."""

from __future__ import annotations

import functools
from contextlib import suppress

import numpy as np
from matplotlib.lines import Line2D

from . import emphasis, maps, style
from .axis_meaning import Meaning, Panel, note
from .choice import choose, highlight, is_called
from .chosen_curves import curves
from .curves import LARGEST_LEGEND, colour_bar
from .derived import derived_of, pair_of
from .errors import ResultError
from .figure_axes import FigureAxis, Quantity, find, plain, read_axis, together
from .labels import own_name
from .layout import Layout, family_of, kept
from .results import Analysis, Results


def figures(results: Results, analysis: Analysis):
    """Name of each figure of an analysis and what draws it."""
    for section, keys in results.parameters.items():
        name = section.removeprefix("Figure ")
        if name != section and keys.get("From") == analysis.name:
            yield name, functools.partial(figure, results, name, keys)


def figure(results: Results, name: str, section: dict):
    try:
        if section.get("Colour", {}).get("Quantity", ""):
            return map_figure(results, section)
        return curve_figure(results, section)
    except ResultError as error:
        raise ResultError(f"Figure {name}: {error}") from error


def analyses_of(results: Results, section: dict) -> list[Analysis]:
    """The analysis and, where the run has computed it, its reference, with the chosen points of both."""
    there = [analysis.name for analysis in results.analyses()]
    names = [section["From"], *[name for name in [section.get("Reference", "")] if name in there]]
    analyses = [results.analysis(name) for name in names]
    for request in filter(str.strip, section.get("Where", "").split(";")):
        axis = request.partition("=")[0].strip()
        if not any(is_called(name, axis) for analysis in analyses for name in analysis.axes) \
                and len(analyses) == 1 + bool(section.get("Reference", "")):
            raise ResultError(f"Where: {request.strip()}: {names[0]} has no such axis")
        choose(analyses[0], [request.strip()])
        for reference in analyses[1:]:
            with suppress(ResultError):  # it need not have the same points
                choose(reference, [request.strip()])
    highlight(analyses[0], results.emphasis.highlight)
    return analyses


def curve_figure(results: Results, section: dict):
    analyses = analyses_of(results, section)
    names, given = several(section["Vertical"]["Quantity"]), several(section.get("Names", ""))
    across = read_axis(results, section["Horizontal"], analyses)
    sheets = [[across, axis] for axis in together(
        [read_axis(results, section["Vertical"] | {"Quantity": name},
                   analyses if name == names[0] else analyses[:1]) for name in names], analyses[0])]
    shown, (axes,) = style.panels(1, height=3.0)
    handles, compared = [], []
    for reference in analyses[1:]:
        compared += curves(axes, reference, sheets[0], colour="black", linewidth=1.5).drawn
        handles.append(Line2D([], [], color="black", linewidth=1.5,
                              label=section.get("Reference label", "") or reference.name))
    for number, both in enumerate(sheets):
        colour = style.COLOURS[number % len(style.COLOURS)] if len(sheets) > 1 else None
        look = {} if section.get("Joined", "true") == "true" else \
            dict(linestyle="", marker="o", markersize=3, markevery=None)
        family = curves(axes, analyses[0], both, colour, **look)
        handles += family.handles if not colour else [
            Line2D([], [], color=colour, label=given[number] if number < len(given)
                   else find(analyses[0], names[number]).label, **look)]
    handles += overlaid(axes, results, section, sheets)
    for axis, letter in zip(sheets[0], "xy"):
        axis.apply(axes, letter)
    handles += emphasis.draw(axes, results.emphasis, family.drawn, compared)
    finish(shown, axes, family.layout, sheets, handles, section)
    return shown


def overlaid(axes, results: Results, section: dict, sheets) -> list[Line2D]:
    """The same quantities of the analyses that --overlay names, where the figure is of another one."""
    handles = []
    for other in results.overlays:
        if other.name == section["From"] and other.file == str(results.file):
            continue
        with suppress(ResultError):
            for request in filter(str.strip, section.get("Where", "").split(";")):
                choose(other, [request.strip()])
            for both in sheets:
                colour = emphasis.OVERLAY_COLOURS[len(handles) % len(emphasis.OVERLAY_COLOURS)]
                curves(axes, other, both, colour, **emphasis.OVERLAY)
                handles.append(Line2D([], [], color=colour, label=own_name(other.name), **emphasis.OVERLAY))
    return handles


def several(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]


def finish(shown, axes, layout: Layout, sheets, handles, section: dict) -> None:
    both = sheets[0]
    draw_marks(axes, both)
    axes.set_title(section.get("Title", ""))
    family = layout.cases() if layout.family and len(sheets) == 1 else []
    if len(family) > LARGEST_LEGEND:
        colour_bar(shown, [axes], layout, family)
        style.legend_inside(axes, handles)
    else:
        entries = [Line2D([], [], color=case.colour, label=case.text) for case in family]
        style.legend_beside(axes, entries + handles, layout.family_name if family else None)
    note(axes, Panel(*[meaning(layout.analysis, axis) for axis in both], family_of(layout)))


def meaning(analysis: Analysis, axis: FigureAxis) -> Meaning:
    return Meaning((axis.quantity,), find(analysis, axis.quantity).unit, axis.scale,
                   plain(axis.label))


def draw_marks(axes, both) -> None:
    """Lines across at the marked values, their labels at the end."""
    for axis, letter in zip(both, "xy"):
        for label, value in axis.marks:
            line, place = (axes.axvline, (value, 1.01)) if letter == "x" else \
                (axes.axhline, (1.01, value))
            line(value, color=style.GREY, linewidth=0.7, linestyle=(0, (6, 3)), zorder=1)
            transform = axes.get_xaxis_transform() if letter == "x" else axes.get_yaxis_transform()
            axes.text(*place, label, transform=transform, color=style.GREY, fontsize=9,
                      ha="center" if letter == "x" else "left",
                      va="bottom" if letter == "x" else "center", clip_on=False)


def map_figure(results: Results, section: dict):
    """Over two axes of the analysis, with derived curves of their plane on top."""
    analysis = analyses_of(results, section)[0]
    both = [read_axis(results, section[name], [analysis]) for name in ("Horizontal", "Vertical")]
    colour = read_axis(results, section["Colour"], [analysis])
    quantity = find(analysis, colour.quantity)
    names = tuple(find(analysis, axis.quantity).path for axis in both)
    for name, axis in zip(names, both):
        if name not in analysis.axes:
            raise ResultError(f"{axis.quantity} is no axis of a map of {analysis.name}")
        analysis.shown[name] = (axis.scale, axis.label)
    over = overlays(results, section, analysis, names)
    values = plane(quantity, analysis, names)
    shown = maps.draw_map(maps.Map(analysis, names, values, quantity.unit, colour.label,
                                   section.get("Title", "")), over, colour.scale, colour.range)
    axes = shown.axes[0]
    for axis, letter in zip(both, "xy"):
        axis.apply(axes, letter)
    draw_marks(axes, both)
    note(axes, Panel(*[meaning(analysis, axis) for axis in both]))
    return shown


def overlays(results: Results, section: dict, analysis: Analysis, names) -> list:
    """Derived curves of the plane: those listed in Curves, NAME or ANALYSIS:NAME, of what the run has
    computed; else all of the analysis."""
    found = []
    for wanted in several(section.get("Curves", "")):
        other, _, name = wanted.rpartition(":")
        if other and other not in [computed.name for computed in results.analyses()]:
            continue
        source = results.analysis(other) if other else analysis
        source.shown = analysis.shown
        found += [entry for entry in derived_of(source) if entry.name == name]
    if not section.get("Curves", ""):
        found = [entry for entry in derived_of(analysis) if len(maps.levels_of(entry)) <= 2]
    return [entry for entry in found if set(pair_of(entry)) == set(names)]


def plane(quantity: Quantity, analysis: Analysis, names) -> np.ndarray:
    """Values over two axes, in their order; the first chosen point of all others."""
    where = tuple(kept(analysis, name) if name in names else
                  [kept(analysis, name)[0] if name in analysis.axes else 0]
                  for name in quantity.dimensions)
    left = [name for name in quantity.dimensions if name in names]
    if set(left) != set(names):
        raise ResultError(f"{quantity.path} does not run over {' and '.join(names)}")
    values = quantity.values[np.ix_(*where)]
    values = values.reshape([len(kept(analysis, name)) for name in left])
    return values if tuple(left) == tuple(names) else values.T
