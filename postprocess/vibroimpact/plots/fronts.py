"""Pareto fronts: all evaluations and the front in the plane of each two objectives, and the values of
the keys along it."""

from __future__ import annotations

import functools
import itertools

import numpy as np

from . import style
from .labels import key_label, own_name, scale_for
from .layout import describe, kept
from .results import Analysis, Results

TYPE = "pareto front"
MOST_CASES = 8
MOST_KEYS = 4


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    goals = analysis.members("front/objective")
    if not goals:
        return
    cases = list(itertools.product(*[kept(analysis, name) for name in analysis.grid_axes]))
    for number, index in enumerate(cases[:MOST_CASES], 1):
        suffix = f"-{number}" if len(cases) > 1 else ""
        case = dict(zip(analysis.grid_axes, index))
        for first, second in itertools.combinations(goals, 2):
            between = f"-{first}-{second}" if len(goals) > 2 else ""
            yield (f"{analysis.name}-front{between}{suffix}",
                   functools.partial(front, analysis, case, first, second))
        yield f"{analysis.name}-keys{suffix}", functools.partial(keys_along, analysis, case, goals[0])


def on_front(analysis: Analysis, case: dict, path: str) -> np.ndarray:
    """Along the front, in its order."""
    values = analysis.read(f"front/{path}").values[tuple(case.values())][0]
    return values[np.isfinite(values)]


def meets(analysis: Analysis, case: dict) -> np.ndarray:
    """Of all evaluations."""
    good = True
    for name in analysis.members("excess"):
        good = good & (analysis.read(f"excess/{name}").values[tuple(case.values())][1:] <= 1e-6)
    return good


def front(analysis: Analysis, case: dict, first: str, second: str):
    figure, (axes,) = style.panels(1, height=3.4)
    good, points, scales = meets(analysis, case), [], []
    for name in (first, second):
        values = analysis.read(f"objective/{name}").values[tuple(case.values())][1:]
        scales.append(scale_for(analysis.read(f"objective/{name}").unit,
                                on_front(analysis, case, f"objective/{name}")))
        points.append(np.where(good, values, np.nan) / scales[-1].factor)
    entries = axes.plot(*points, ".", color=style.GREY, markersize=3, label="evaluations")
    line = [on_front(analysis, case, f"objective/{name}") / scale.factor
            for name, scale in zip((first, second), scales)]
    entries += axes.plot(*line, ".-", color=style.COLOURS[1], label="front")
    for scale, name, show, values in zip(scales, (first, second), (axes.set_xlabel, axes.set_ylabel),
                                         line):
        show(scale.label(own_name(name)))
    frame(axes, line, points)
    if case:
        axes.set_title(describe(analysis, case))
    style.legend_below(axes, entries)
    return figure


def frame(axes, line, points) -> None:
    """The front and, where there is so much, as much again of the rest."""
    for values, others, limit in zip(line, points, (axes.set_xlim, axes.set_ylim)):
        room = max(np.ptp(values), 1e-12 * np.abs(values).max())
        limit(values.min() - 0.1 * room, min(values.max() + room, np.nanmax(others) + 0.1 * room))


def keys_along(analysis: Analysis, case: dict, goal: str):
    names = analysis.members("front/key")[:MOST_KEYS]
    figure, panels = style.panels(len(names), height=1.6)
    x = on_front(analysis, case, f"objective/{goal}")
    along = scale_for(analysis.read(f"front/objective/{goal}").unit, x)
    for axes, name in zip(panels, names):
        values = on_front(analysis, case, f"key/{name}")
        scale = scale_for(analysis.read(f"front/key/{name}").unit, values)
        axes.plot(x / along.factor, values / scale.factor, ".", color=style.COLOURS[0])
        axes.set_ylabel(scale.label(key_label(name)))
    panels[-1].set_xlabel(along.label(own_name(goal)))
    if case:
        panels[0].set_title(describe(analysis, case))
    return figure
