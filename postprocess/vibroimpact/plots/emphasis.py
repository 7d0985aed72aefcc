"""What --highlight, --peaks and --below-reference add to the curves of a figure with chosen axes, and the look
of the analyses that --overlay draws over them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from . import style
from .results import Emphasis

PEAK = dict(linestyle="", marker="o", markersize=4, color="black", zorder=4)
BELOW = dict(facecolor="#D9D9D9", linewidth=0, zorder=0)
LEAST = 1e-3  # of the largest value of the reference: a smaller distance is none


OVERLAY = dict(linestyle="-.", marker="", zorder=2.5)
OVERLAY_COLOURS = style.COLOURS[3:]  # those before are of small families


@dataclass(frozen=True)
class Curve:
    """In the numbers at the axes; `loose` points have not settled or do not repeat themselves."""

    x: np.ndarray
    y: np.ndarray
    loose: np.ndarray
    colour: object


def draw(axes, wanted: Emphasis, curves: list[Curve], compared: list[Curve]) -> list:
    """Legend entries; `compared` has the curve of the reference, where there is one."""
    handles = peaks(axes, curves + compared) if wanted.peaks else []
    return handles + (below(axes, curves, compared[0]) if wanted.below and compared else [])


def look_of(colour) -> dict:
    return dict(linewidth=1.9, zorder=3) if colour == style.HIGHLIGHT else {}


def peaks(axes, curves: list[Curve]) -> list[Line2D]:
    """The largest value within the axes of each colour, of motions that repeat themselves."""
    low, high = axes.get_xlim()
    for colour in dict.fromkeys(curve.colour for curve in curves):
        x, y, loose = (np.concatenate([getattr(curve, name) for curve in curves if curve.colour == colour])
                       for name in ("x", "y", "loose"))
        shown = np.where(loose | (x < low) | (x > high), np.nan, y)
        if np.isfinite(shown).any():
            place = int(np.nanargmax(shown))
            axes.plot(x[place], y[place], **PEAK)
    return [Line2D([], [], label="largest value", **PEAK)]


def below(axes, curves: list[Curve], reference: Curve) -> list[Patch]:
    """Shades where the highlighted curve is below the reference."""
    limit = LEAST * np.nanmax(reference.y)
    for curve in [entry for entry in curves if entry.colour == style.HIGHLIGHT][:1]:  # of the first direction
        distance = np.interp(curve.x, reference.x, reference.y, np.nan, np.nan) - curve.y
        for first, last in ranges(distance > limit):
            axes.axvspan(edge(curve.x, distance, limit, first - 1, first),
                         edge(curve.x, distance, limit, last, last + 1), **BELOW)
    return [Patch(facecolor=BELOW["facecolor"], label="red below black")]


def ranges(inside: np.ndarray) -> list[tuple[int, int]]:
    """First and last index of each run of true values."""
    steps = np.diff(np.concatenate([[0], inside.astype(int), [0]]))
    return list(zip(np.flatnonzero(steps == 1), np.flatnonzero(steps == -1) - 1))


def edge(x, distance, limit: float, a: int, b: int) -> float:
    """Where the distance passes the limit between two neighbours, or the end of the curve."""
    if a < 0 or b >= len(x):
        return x[max(a, 0) if a >= 0 else b]
    return x[a] + (limit - distance[a]) / (distance[b] - distance[a]) * (x[b] - x[a])
