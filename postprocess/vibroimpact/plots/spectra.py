"""Amplitude spectra at chosen points, and over the swept axis as a spectrogram, with order lines."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.colors import LogNorm

from . import style
from .axis_meaning import Meaning, Panel, note
from .cycles import direction_handles
from .labels import quantity_label, scale_for
from .layout import Layout, axis_name, layout_of, place_of, places
from .results import Analysis, Results

DECADES = 4  # below the largest amplitude that are shown
CORNER = 0.15  # decades that a label keeps away from the corner of the axes
MOST_CASES = 4
LEAST_COLUMNS = 8
MOST_ORDERS = 12
ROWS = 160


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    layout = layout_of(analysis)
    for root in ("", "recorded/"):
        for path in analysis.fields(f"{root}spectrum"):
            if path.rsplit("/", 1)[-1] in ("frequency", "order"):
                continue
            name = "-".join(path.removeprefix(f"{root}spectrum/").split("/")[1:]).replace("_", "-")
            yield (f"{analysis.name}-spectrum-{name}",
                   functools.partial(spectra, analysis, root, path))
            if layout.along is None or len(layout.coordinates()) < LEAST_COLUMNS:
                continue
            for number, case in enumerate(layout.cases()[:MOST_CASES], 1):
                for direction in layout.directions:
                    end = "".join(f"-{part}" for part in (
                        number if layout.family else "",
                        direction if len(layout.directions) > 1 else "") if part)
                    yield (f"{analysis.name}-spectrogram-{name}{end}",
                           functools.partial(spectrogram, layout, root, path, case, direction))


def what(path: str) -> str:
    """"Displacement x of first.mass" of .../point/first.mass/displacement_x."""
    _, owner, quantity = path.rsplit("/", 2)
    return f"{quantity_label(quantity)} of {owner}"


def spectra(analysis: Analysis, root: str, path: str):
    """Amplitudes over frequency; vertical lines and numbers: orders of the forcing frequency."""
    entries = places(analysis)
    directions = layout_of(analysis).directions
    figure, panels = style.panel_grid(len(entries), columns=2, height=1.8, share_x=False)
    amplitude, frequency, order = (analysis.read(name) for name in
                                   (path, f"{root}spectrum/frequency", f"{root}spectrum/order"))
    scale, across = scale_for(amplitude.unit, amplitude.values), scale_for("Hz", frequency.values)
    for axes, place in zip(panels, entries):
        for number, direction in enumerate(directions):
            x, y, n = (place.pick(analysis, array, direction)
                       for array in (frequency, amplitude, order))
            axes.plot(x / across.factor, y / scale.factor, color=style.COLOURS[number],
                      linestyle=style.DIRECTION_LINES[number], linewidth=0.8)
            if number == 0:
                draw_orders(axes, x / across.factor, n)
        style.panel_title(axes, place.text, panels, pad=12)
        note(axes, Panel(Meaning(("frequency",), "Hz", across), Meaning((path,), amplitude.unit, scale),
                         place=place_of(analysis, place)))
    logarithmic(panels, np.nanmax(amplitude.values) / scale.factor)
    style.label_grid(panels, across.label("Frequency"), scale.label("Amplitude"))
    figure.suptitle(what(path), x=0.01, ha="left", fontsize=10)
    style.legend_beside(style.upper_right(panels), direction_handles(analysis))
    return figure


def logarithmic(panels, largest: float) -> None:
    """Some decades below the largest value; where all are zero there is no logarithm."""
    if largest <= 0:
        return
    for axes in panels:
        axes.set_yscale("log")
    panels[0].set_ylim(below_decade(largest / 10**DECADES), 2 * largest)


def below_decade(lower: float) -> float:
    """The lower end of a logarithmic axis, moved down where the label of a decade would stand at the corner."""
    above = np.ceil(np.log10(lower)) - np.log10(lower)
    return lower * 10 ** -CORNER if above < CORNER else lower


def draw_orders(axes, frequency, order) -> None:
    """At whole orders, numbered above the axes where there is room; subharmonics are not marked."""
    known = np.isfinite(frequency) & np.isfinite(order) & (order > 0)
    if not known.any():
        return
    forcing = np.median(frequency[known] / order[known])
    highest = int(np.floor(order[known].max() + 1e-9))
    step = max(1, -(-highest // MOST_ORDERS))
    for number in range(1, highest + 1):
        axes.axvline(number * forcing, color="#BBBBBB", linewidth=0.5, linestyle=":", zorder=0.8)
        if number % step == 0 or number == 1:
            axes.text(number * forcing, 1.01, str(number), fontsize=7, color=style.GREY,
                      ha="center", va="bottom", transform=axes.get_xaxis_transform())
    axes.set_xlim(0, frequency[known].max())
    axes.grid(False, axis="x")


def spectrogram(layout: Layout, root: str, path: str, case, direction: str):
    """Amplitudes as colours over the swept axis and frequency; lines: orders."""
    analysis = layout.analysis
    amplitude, frequency, order = (
        layout.curve(name, case, direction)
        for name in (path, f"{root}spectrum/frequency", f"{root}spectrum/order"))
    unit = analysis.read(path).unit
    scale, across = scale_for(unit, amplitude), scale_for("Hz", frequency)
    x = layout.coordinates() / layout.scale.factor
    figure, (axes,) = style.panels(1, height=3.4)
    mesh = columns(axes, x, frequency / across.factor, amplitude / scale.factor)
    figure.colorbar(mesh, ax=axes, label=scale.label("Amplitude"), pad=0.015)
    order_lines(axes, x, frequency / across.factor, order)
    along = axis_name(analysis, layout.along)
    axes.set_xlabel(layout.scale.label("Excitation frequency" if along == "Frequency" else along))
    axes.set_ylabel(across.label("Frequency in the response"))
    axes.set_title(", ".join(filter(None, [what(path), case.text, direction])))
    swept = analysis.read(layout.along).unit
    note(axes, Panel(Meaning((layout.along,), swept, layout.scale),
                     Meaning((f"{root}spectrum/frequency",), "Hz", across)))
    return figure


def columns(axes, x, frequency, amplitude):
    """A column for each point of the sweep; a row shows the largest of the lines in it, so that
    the narrow lines of periodic motions are seen."""
    edges = np.concatenate([[x[0] - (x[1] - x[0]) / 2], (x[1:] + x[:-1]) / 2,
                            [x[-1] + (x[-1] - x[-2]) / 2]])
    rows = np.linspace(0, np.nanmax(frequency), ROWS + 1)
    picture = np.full((ROWS, len(x)), np.nan)
    for i in range(len(x)):
        known = np.isfinite(frequency[i]) & np.isfinite(amplitude[i])
        place = np.clip(np.searchsorted(rows, frequency[i, known], "right") - 1, 0, ROWS - 1)
        covered = rows[:-1] <= frequency[i, known].max(initial=-1)
        picture[covered, i] = 0.0
        np.maximum.at(picture[:, i], place, amplitude[i, known])
    largest = np.nanmax(amplitude)
    norm = LogNorm(largest / 10**DECADES, largest)
    mesh = axes.pcolormesh(edges, rows, np.maximum(picture, norm.vmin), norm=norm,
                           cmap=style.SEQUENCE, rasterized=True)
    axes.set_ylim(0, rows[-1])
    axes.grid(False)
    return mesh


def order_lines(axes, x, frequency, order) -> None:
    """n times the forcing frequency, numbered at the end of the axis."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(order > 0, frequency / order, np.nan)
    known = np.isfinite(ratio).any(axis=1)
    forcing = np.array([np.nanmedian(row) for row in ratio[known]])
    highest = int(np.floor(np.nanmax(order) + 1e-9))
    step = max(1, -(-highest // MOST_ORDERS))
    for number in range(1, highest + 1, step):
        axes.plot(x[known], number * forcing, color="white", linewidth=0.4, linestyle=":", alpha=0.6)
        end = int(np.argmax(forcing))  # where the lines are farthest apart
        if number * forcing[end] < 0.99 * axes.get_ylim()[1]:
            axes.annotate(str(number), (x[known][end], number * forcing[end]), color="white",
                          xytext=(1 if end == 0 else -1, 1), textcoords="offset points", fontsize=7,
                          ha="left" if end == 0 else "right")
