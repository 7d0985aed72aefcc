"""Basins of attraction: images of cells with the motions they lead to, and shares stacked over a key."""

from __future__ import annotations

import functools
import itertools

import numpy as np
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from . import style
from .axis_meaning import Meaning, Panel, note
from .labels import Scale, key_label
from .layout import axis_name, axis_scale, describe, kept
from .results import Analysis, Results

TYPES = ("basins", "basin shares")
#   marks of cells that lead to none of the attractors
MARKS = {-1: ("undecided", "#BBBBBB"), -2: ("no motion", "#FFFFFF"), -3: ("another motion", "#F0E442")}
SAME_MOTION = 0.3  # of the range of the states: how far one moves between neighbouring values
MOST_CASES = 8


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if analysis.has("cell/attractor"):
        outer = analysis.axes[:-1]
        cases = list(itertools.product(*[kept(analysis, name) for name in outer]))
        for number, index in enumerate(cases[:MOST_CASES], 1):
            suffix = f"-{number}" if len(cases) > 1 else ""
            yield (f"{analysis.name}-basins{suffix}",
                   functools.partial(image, analysis, dict(zip(outer, index))))
    elif analysis.type == "basin shares" and len(long_axes(analysis)) == 1:
        yield f"{analysis.name}-shares", functools.partial(stack, analysis)


def long_axes(analysis: Analysis) -> list[str]:
    return [name for name in analysis.axes if len(kept(analysis, name)) > 1]


def image(analysis: Analysis, case: dict):
    second, first = analysis.axes[-1], analysis.dimensions("cell/attractor")[-1]
    index = tuple(case.values())
    marks = analysis.read("cell/attractor").values[index]
    figure, (axes,) = style.panels(1, height=4.0)
    colours, limits = colour_map(int(np.nanmax(marks, initial=0)) + 1)
    x, y = (edges(analysis.read(name).values / axis_scale(analysis, name).factor)
            for name in (first, second))
    axes.pcolormesh(x, y, marks, cmap=colours, norm=limits, rasterized=True)
    axes.grid(False)
    mark_attractors(axes, analysis, index, (first, second))
    for name, put in ((first, axes.set_xlabel), (second, axes.set_ylabel)):
        put(axis_scale(analysis, name).label(key_label(name.replace(".", "/"))))
    note(axes, Panel(*[Meaning((name,), analysis.read(name).unit, axis_scale(analysis, name))
                       for name in (first, second)]))
    if case:
        axes.set_title(describe(analysis, case))
    style.legend_beside(axes, handles(marks))
    return figure


def colour_map(count: int):
    """Of the marks -3, -2, -1 and the attractors 0, 1, ..."""
    colours = [MARKS[mark][1] for mark in sorted(MARKS)] + [colour(a) for a in range(count)]
    return ListedColormap(colours), BoundaryNorm(np.arange(-3.5, count), len(colours))


def colour(attractor: int) -> str:
    return style.COLOURS[attractor % len(style.COLOURS)]


def edges(centres: np.ndarray) -> np.ndarray:
    """Of cells of equal width around their centres."""
    half = 0.5 * (centres[-1] - centres[0]) / max(len(centres) - 1, 1) if len(centres) > 1 else 0.5
    return np.append(centres - half, centres[-1] + half)


def mark_attractors(axes, analysis: Analysis, index, names) -> None:
    if not analysis.has("attractors/first_axis"):
        return
    x, y = (analysis.read(f"attractors/{place}").values[index][0] / axis_scale(analysis, name).factor
            for place, name in zip(("first_axis", "second_axis"), names))
    axes.plot(x, y, linestyle="none", marker="o", markersize=6, markerfacecolor="white",
              markeredgecolor="black", zorder=3, clip_on=True)


def handles(marks: np.ndarray):
    """Each motion with its share of the cells; marks only where there are some."""
    known = marks[np.isfinite(marks)]
    shares = {mark: np.mean(known == mark) for mark in np.unique(known)}
    entries = [Patch(color=colour(int(mark)), label=f"motion {int(mark) + 1}: {share:.4f}")
               for mark, share in shares.items() if mark >= 0]
    entries += [Patch(facecolor=MARKS[mark][1], edgecolor="black", linewidth=0.5,
                      label=f"{MARKS[mark][0]}: {shares[mark]:.4f}")
                for mark in MARKS if mark in shares]
    return entries + [Line2D([], [], linestyle="none", marker="o", markerfacecolor="white",
                             markeredgecolor="black", label="motion at phase 0")]


def stack(analysis: Analysis):
    name = long_axes(analysis)[0]
    places = tuple(kept(analysis, axis) if axis == name else kept(analysis, axis)[0]
                   for axis in analysis.axes)
    shares = analysis.read("attractors/share").values[places]
    states = analysis.read("attractors/state").values[places]
    tracks = numbered(follow(states))
    heights = np.zeros((max(max(row, default=0) for row in tracks) + 1, len(shares)))
    for i, row in enumerate(tracks):
        for attractor, track in enumerate(row):
            heights[track, i] = shares[i, attractor]
    rest = 1 - heights.sum(axis=0)
    scale = axis_scale(analysis, name)
    x = analysis.read(name).values[kept(analysis, name)] / scale.factor
    figure, (axes,) = style.panels(1, height=3.0)
    layers = axes.stackplot(x, heights, rest, linewidth=0, step="mid",
                            colors=[*map(colour, range(len(heights))), MARKS[-1][1]])
    for layer, text in zip(layers, [*(f"motion {t + 1}" for t in range(len(heights))), "undecided"]):
        layer.set_label(text)
    axes.set_ylim(0, 1)
    axes.set_xlim(x[0], x[-1])
    axes.set_ylabel("Share of the starts")
    axes.set_xlabel(scale.label(axis_name(analysis, name)))
    note(axes, Panel(Meaning((name,), analysis.read(name).unit, scale),
                     Meaning(("attractors/share",), "1", Scale(1.0, ""))))
    found = [layer for layer, height in zip(layers, [*heights, rest]) if np.any(height > 0)]
    style.legend_beside(axes, found)
    return figure


def numbered(tracks: list[list[int]]) -> list[list[int]]:
    """As the program numbers the motions where most of them exist, which is how images of cells have them."""
    order = list(dict.fromkeys([*max(tracks, key=len), *itertools.chain(*tracks)]))
    return [[order.index(track) for track in row] for row in tracks]


def follow(states: np.ndarray) -> list[list[int]]:
    """For each value of the key, which motion each attractor belongs to: the one whose last state
    is nearest, unless that is far off. `states`: values x attractors x entries, padded by NaN. The
    many small entries of a body with many modes must not outweigh the few that say how it moves:
    distances are those of whole states over the length of the range. What one value and the next
    have left over, one attractor each, is the same motion too."""
    reach = np.linalg.norm(np.nanmax(states, axis=(0, 1)) - np.nanmin(states, axis=(0, 1))) or 1.0
    last: list[np.ndarray] = []
    tracks = []
    for row in states / reach:
        present = [state for state in row if np.all(np.isfinite(state))]
        pairs = sorted((np.linalg.norm(state - known), a, t)
                       for a, state in enumerate(present) for t, known in enumerate(last))
        chosen: dict[int, int] = {}
        for distance, a, t in pairs:
            if distance < SAME_MOTION and a not in chosen and t not in chosen.values():
                chosen[a] = t
        before = tracks[-1] if tracks else []
        lost = [t for t in before if t not in chosen.values()]
        if len(lost) == 1 and len(present) == len(before) == len(chosen) + 1:
            chosen[next(a for a in range(len(present)) if a not in chosen)] = lost[0]
        for a, state in enumerate(present):
            if a not in chosen:
                chosen[a] = len(last)
                last.append(state)
            last[chosen[a]] = state
        tracks.append([chosen[a] for a in range(len(present))])
    return tracks
