"""Wavelet scalograms and short-time spectrograms over time, with the frequency of the excitation."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullFormatter

from . import style
from .excitations import frequencies
from .labels import scale_for
from .layout import Place, layout_of, places
from .results import Analysis, Results
from .spectra import what

DECADES = 3  # below the largest amplitude that are shown
MOST = 3  # points of an analysis that are drawn, unless points are chosen
AXES = {"wavelet": ("scale_frequency", "wavelet_time"),
        "spectrogram": ("spectrogram_frequency", "spectrogram_time")}


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    directions = layout_of(analysis).directions
    for root in ("", "recorded/"):
        for kind in AXES:
            for path in analysis.fields(f"{root}{kind}"):
                if analysis.dimensions(path)[-2:] != list(AXES[kind]):
                    continue
                name = "-".join(path.removeprefix(f"{root}{kind}/").split("/")[1:])
                for number, place in enumerate(places(analysis, MOST), 1):
                    for direction in directions:
                        end = "".join(f"-{part}" for part in (
                            number if place.text else "",
                            direction if len(directions) > 1 else "") if part)
                        kind_name = "wavelet" if kind == "wavelet" else "short-time-spectrum"
                        yield (f"{analysis.name}-{kind_name}-{name.replace('_', '-')}{end}",
                               functools.partial(picture, analysis, kind, root, path, place,
                                                 direction))


def picture(analysis: Analysis, kind: str, root: str, path: str, place: Place, direction: str):
    """Amplitude as colour over time and frequency."""
    array = analysis.read(path)
    values = place.pick(analysis, array, direction) if analysis.axes else array.values
    frequency, time = (along(analysis, path, name, place, direction) for name in AXES[kind])
    scale, x_scale, y_scale = (scale_for(array.unit, values), scale_for("s", time),
                               scale_for("Hz", frequency))
    figure, (axes,) = style.panels(1, height=3.4)
    largest = np.nanmax(values) / scale.factor
    mesh = axes.pcolormesh(time / x_scale.factor, frequency / y_scale.factor,
                           np.maximum(values / scale.factor, largest / 10**DECADES),
                           norm=LogNorm(largest / 10**DECADES, largest), cmap=style.SEQUENCE,
                           shading="nearest", rasterized=True)
    figure.colorbar(mesh, ax=axes, label=scale.label("Amplitude"), pad=0.015)
    if kind == "wavelet":
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter(NullFormatter())
    axes.grid(False)
    axes.set(xlabel=x_scale.label("Time"), ylabel=y_scale.label("Frequency"),
             title=", ".join(filter(None, [what(path), place.text, direction])))
    handles = draw_edges(axes, analysis, root, place, direction, time, frequency, x_scale, y_scale)
    handles += draw_excitations(axes, analysis, time, x_scale, y_scale)
    axes.set(xlim=(time[0] / x_scale.factor, time[-1] / x_scale.factor),
             ylim=(max(frequency[0], 0) / y_scale.factor, frequency[-1] / y_scale.factor))
    if handles:
        style.legend_below(axes, handles)
    return figure


def along(analysis: Analysis, path: str, dimension: str, place: Place, direction: str):
    array = analysis.coordinate(path, dimension)
    return array.values if array.values.ndim == 1 else place.pick(analysis, array, direction)


def draw_edges(axes, analysis, root, place, direction, time, frequency, x_scale, y_scale) -> list:
    """Hatched where the transform has edge effects of the record."""
    if not analysis.has(f"{root}wavelet_edge") or axes.get_yscale() != "log":
        return []
    edge = analysis.read(f"{root}wavelet_edge")
    width = edge.values if edge.values.ndim == 1 else place.pick(analysis, edge, direction)
    width = np.minimum(width, (time[-1] - time[0]) / 2)
    look = dict(facecolor="none", edgecolor="#FFFFFFAA", hatch="/", linewidth=0.6)
    y = frequency / y_scale.factor
    axes.fill_betweenx(y, time[0] / x_scale.factor, (time[0] + width) / x_scale.factor, **look)
    axes.fill_betweenx(y, (time[-1] - width) / x_scale.factor, time[-1] / x_scale.factor, **look)
    return [Patch(facecolor="#BBBBBB", edgecolor="white", hatch="/", label="edge effects")]


def draw_excitations(axes, analysis: Analysis, time, x_scale, y_scale) -> list[Line2D]:
    """Frequencies of the excitations where the parameters tell them."""
    handles = []
    for number, (name, frequency) in enumerate(frequencies(analysis, time)):
        look = dict(color=["#FF6F4E", "white"][number % 2], linestyle="--", linewidth=0.9)
        axes.plot(time / x_scale.factor, frequency / y_scale.factor, **look)
        handles.append(Line2D([], [], label=f"excitation frequency ({name})", **look))
    return handles
