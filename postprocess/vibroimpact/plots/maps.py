"""Contour maps over two axes, with the derived curves, bands and level lines on top."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import Normal, Stroke
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter

from . import style
from .axis_meaning import Meaning, Panel, note
from .derived import Derived, can_span, coordinates, derived_of, pair_of
from .labels import scale_for
from .layout import DIRECTION, axis_name, axis_scale, layout_of
from .measures import sheets
from .results import Analysis, Results

LEVELS = 12
BLANK = ListedColormap(["white"])  # of a map without a value
MOST_LEVELS = 2  # level lines of more levels have a figure of their own
FEW_POINTS = 20  # of a curve that shows each of them
LEAST_ROWS = 8  # fewer curves than that are a family, no map
OVERLAYS = ["#D55E00", "#000000", "#CC79A7", "#56B4E9", "#E69F00"]
LINES = ["-", "--", "-.", ":"]


@dataclass(frozen=True)
class Map:
    """Values over two axes, in SI; `reduction` says what was done to get them."""

    analysis: Analysis
    axes: tuple[str, str]
    values: np.ndarray
    unit: str
    label: str
    title: str


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    flat = [entry for entry in derived_of(analysis) if pair_of(entry)]
    overlays = [entry for entry in flat if len(levels_of(entry)) <= MOST_LEVELS]
    for entry in flat:
        if entry not in overlays:
            yield (f"{analysis.name}-levels-{entry.name}", functools.partial(levels_figure, entry))
    for name, make in [*derived_maps(analysis), *recorded_maps(analysis)]:
        yield f"{analysis.name}-{name}", functools.partial(map_figure, make, overlays)
    for pair in {frozenset(pair_of(entry)): pair_of(entry) for entry in overlays}.values():
        inside = [entry for entry in overlays if set(pair_of(entry)) == set(pair)]
        name = "-".join(axis.rsplit(".", 1)[-1] for axis in pair)
        yield (f"{analysis.name}-loci-{name}",
               functools.partial(loci_figure, analysis, pair, inside))


def derived_maps(analysis: Analysis):
    """Derived fields over two axes, each direction by itself."""
    for entry in derived_of(analysis):
        axes = tuple(entry.dimensions)
        if entry.is_band or entry.pair or len(axes) != 2 or not spans(analysis, axes):
            continue
        for direction in entry.directions:
            suffix = f"-{direction}" if direction else ""
            yield (f"map-{entry.name}{suffix}",
                   lambda entry=entry, axes=axes, direction=direction: Map(
                       analysis, axes, entry.of_direction(direction), entry.unit, entry.text,
                       direction))


def spans(analysis: Analysis, axes) -> bool:
    return all(can_span(analysis, axis) for axis in axes)


def recorded_maps(analysis: Analysis):
    """Recorded measures over two axes: a grid of two keys, or a sweep and a grid key with many
    values. Over a sweep and two keys: the largest value along the sweep."""
    axes = [axis for axis in analysis.axes
            if axis != DIRECTION and len(coordinates(analysis, axis)) > 1]
    swept = [axis for axis in axes if axis not in analysis.grid_axes]
    if len(axes) not in (2, 3) or not spans(analysis, axes):
        return
    if len(axes) == 2 and swept and len(coordinates(analysis, axes[0])) < LEAST_ROWS:
        return
    for sheet in sheets(analysis, "", separate=True):
        if not suits_a_map(sheet) or len(axes) == 3 and not has_maximum(sheet):
            continue
        for direction in layout_of(analysis).directions if len(axes) == 2 else [""]:
            suffix = f"-{direction}" if direction and len(layout_of(analysis).directions) > 1 else ""
            yield (f"map-{sheet.name}{suffix}",
                   functools.partial(recorded, analysis, tuple(axes), sheet, direction))


def suits_a_map(sheet) -> bool:
    """The main measures, without counts, classes and further statistics of the same quantity. Derived
    quantities have maps of their own."""
    further = ("-peaks", "-averages", "-impacts")
    return not (sheet.name.startswith(("regime", "orders", "derived"))
                or any(part in sheet.name for part in further))


def has_maximum(sheet) -> bool:
    """Whether the largest value along a sweep means something."""
    return any(word in sheet.panels[0].curves[0][0] for word in ("peak_to_peak", "largest", "maximum", "transm"))


def recorded(analysis: Analysis, axes, sheet, direction: str) -> Map:
    """The first measure of a sheet over the two axes, or over the two grid axes of three."""
    panel = sheet.panels[0]
    array = analysis.read(panel.curves[0][0])
    values, left = array.values, list(analysis.axes)
    label, title = panel.label, sheet.title
    if len(axes) == 3:
        swept = [axis for axis in left if axis not in analysis.grid_axes]
        values = largest(values, tuple(left.index(axis) for axis in swept))
        axes = tuple(axis for axis in axes if axis in analysis.grid_axes)
        left = [axis for axis in left if axis in analysis.grid_axes]
        title += ", largest value along the sweep"
    index = []
    for axis in left:
        if axis == DIRECTION:
            index.append(list(analysis.read(DIRECTION).values).index(direction))
        else:
            index.append(slice(None) if axis in axes else 0)
    if direction:
        title += f", {direction}"
    return Map(analysis, axes, values[tuple(index)], array.unit, label, title)


def largest(values: np.ndarray, axes) -> np.ndarray:
    known = np.where(np.isfinite(values), values, -np.inf).max(axis=axes)
    return np.where(np.isfinite(known), known, np.nan)


def map_figure(make, overlays: list[Derived]):
    shown = make()
    inside = [entry for entry in overlays if set(pair_of(entry)) == set(shown.axes)]
    return draw_map(shown, inside, scale_for(shown.unit, shown.values))


def draw_map(shown: Map, overlays: list[Derived], scale, ends=()):
    """`overlays` lie in the plane of the map; `ends` of the colours, those of the values if empty."""
    analysis = shown.analysis
    figure, (axes,) = style.panels(1, height=3.6)
    x, y = (coordinates(analysis, axis) / axis_scale(analysis, axis).factor for axis in shown.axes)
    values = np.ma.masked_invalid(shown.values / scale.factor)
    levels = MaxNLocator(LEVELS).tick_values(*(ends or ends_of(values)))
    filled = axes.contourf(x, y, values.T if values.count() else np.full(values.T.shape, levels[0]), levels,
                           cmap=style.SEQUENCE if values.count() else BLANK, extend="both" if ends else "neither")
    if varies(values):
        lines = axes.contour(x, y, values.T, levels, colors="white", linewidths=0.4, alpha=0.7)
        axes.clabel(lines, levels[::2], fontsize=7, fmt="%g")
    figure.colorbar(filled, ax=axes, label=scale.label(shown.label.replace("\n", " ")), pad=0.015)
    label_plane(axes, analysis, shown.axes)
    axes.set_title(shown.title.strip(", "))
    handles = draw_overlays(axes, shown.axes, overlays)
    axes.set(xlim=(x.min(), x.max()), ylim=(y.min(), y.max()))
    if handles:
        style.legend_below(axes, handles)
    return figure


def varies(values) -> bool:
    """By more than rounding."""
    known = np.ma.compressed(values)
    return bool(known.size) and np.ptp(known) > 1e-9 * np.abs(known).max()


def ends_of(values) -> tuple[float, float]:
    """Of the colours; around values that are all the same."""
    if not np.ma.count(values):
        return 0.0, 1.0
    if varies(values):
        return values.min(), values.max()
    room = 0.05 * abs(values.max()) or 1.0
    return values.min() - room, values.max() + room


def label_plane(axes, analysis: Analysis, names) -> None:
    """Labels and logarithmic axes."""
    note(axes, Panel(*[Meaning((axis,), analysis.read(axis).unit, axis_scale(analysis, axis))
                       for axis in names]))
    for axis, letter in zip(names, "xy"):
        label = axis_scale(analysis, axis).label(axis_name(analysis, axis))
        axes.set(**{f"{letter}label": label})
        if style.is_logarithmic(coordinates(analysis, axis)):
            axes.set(**{f"{letter}scale": "log"})
            getattr(axes, f"{letter}axis").set_major_locator(LogLocator(subs=(1, 2, 5)))
            getattr(axes, f"{letter}axis").set_major_formatter("{x:g}")
            getattr(axes, f"{letter}axis").set_minor_formatter(NullFormatter())


def loci_figure(analysis: Analysis, pair, entries: list[Derived]):
    """Curves, bands and level lines by themselves."""
    figure, (axes,) = style.panels(1, height=3.0)
    handles = draw_overlays(axes, pair, entries)
    label_plane(axes, analysis, pair)
    style.legend_beside(axes, handles)
    return figure


def levels_of(entry: Derived) -> np.ndarray:
    """The levels of level lines; none for curves and bands."""
    values = entry.values[:, 2] if entry.pair else np.array([])
    return np.unique(values[np.isfinite(values)])


def levels_figure(entry: Derived):
    """Level lines of many levels, one colour for each level."""
    figure, (axes,) = style.panels(1, height=3.4)
    levels = levels_of(entry)
    x, y = (scaled(entry, axis, entry.values[:, i]) for i, axis in enumerate(entry.pair))
    scale = scale_for(entry.unit, levels)
    for level, colour in zip(levels, style.colours_along(len(levels))):
        own = (entry.values[:, 2] == level) | ~np.isfinite(entry.values[:, 2])
        axes.plot(x[own], y[own], color=colour, label=f"{level / scale.factor:.4g}")
    label_plane(axes, entry.analysis, entry.pair)
    style.legend_beside(axes, title=scale.label(entry.text))
    return figure


def draw_overlays(axes, names, entries: list[Derived]) -> list:
    """Curves, bands and level lines in the plane of two axes; gives the legend entries."""
    handles = []
    for number, entry in enumerate(entries):
        colour = OVERLAYS[number % len(OVERLAYS)]
        if entry.pair:
            handles.append(draw_level_lines(axes, names, entry, colour))
            continue
        for direction, line in zip(entry.directions, LINES):
            text = ", ".join(filter(None, [entry.text, direction]))
            draw = draw_band if entry.is_band else draw_curve
            handles.append(draw(axes, names, entry, direction, dict(color=colour, linestyle=line),
                                text))
    return handles


def scaled(entry: Derived, axis: str, values) -> np.ndarray:
    return values / axis_scale(entry.analysis, axis).factor


def draw_curve(axes, names, entry: Derived, direction: str, look: dict, text: str) -> Line2D:
    """Every further dimension is one more curve, such as the second crossing."""
    along, across = pair_of(entry)
    where = scaled(entry, along, coordinates(entry.analysis, along))
    values = scaled(entry, across, entry.of_direction(direction))
    effects = [Stroke(linewidth=3, foreground="white"), Normal()]
    for curve in values.reshape(len(where), -1).T:
        pair = (where, curve) if names[0] == along else (curve, where)
        few = dict(marker="o", markersize=2) if len(where) <= FEW_POINTS else {}
        axes.plot(*pair, linewidth=1.4, path_effects=effects, **few, **look)
    return Line2D([], [], linewidth=1.4, label=text, **look)


def draw_band(axes, names, entry: Derived, direction: str, look: dict, text: str) -> Patch:
    along, across = pair_of(entry)
    where = scaled(entry, along, coordinates(entry.analysis, along))
    bounds = scaled(entry, across, entry.of_direction(direction)).reshape(len(where), -1, 2)
    fill = axes.fill_between if names[0] == along else axes.fill_betweenx
    hatch = "/" if look["linestyle"] == "-" else "\\"
    # The field below stays visible: no filling, few lines.
    shade = dict(facecolor="none", edgecolor=look["color"] + "AA", hatch=hatch, linewidth=1.0)
    for interval in range(bounds.shape[1]):
        fill(where, bounds[:, interval, 0], bounds[:, interval, 1], **shade)
    return Patch(label=text, **shade)


def draw_level_lines(axes, names, entry: Derived, colour: str) -> Line2D:
    """Columns: both axes, level; NaN between the lines. Each level has a line style of its own."""
    x, y = (scaled(entry, axis, entry.values[:, entry.pair.index(axis)]) for axis in names)
    levels = entry.values[:, 2]
    for number, level in enumerate(levels_of(entry)):
        own = (levels == level) | ~np.isfinite(levels)
        axes.plot(x[own], y[own], color=colour, linewidth=1.3, linestyle=LINES[number % len(LINES)],
                  path_effects=[Stroke(linewidth=2.6, foreground="white"), Normal()])
    return Line2D([], [], color=colour, linewidth=1.3, label=entry.text)
