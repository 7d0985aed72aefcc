"""Searches: how objective and keys change from one evaluation to the next, and where in the plane of
the first two keys the evaluations lie."""

from __future__ import annotations

import functools
import itertools

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .labels import key_label, own_name, scale_for
from .layout import describe, kept
from .results import Analysis, Results

TYPE = "optimise"
MOST_CASES = 8
MOST_STARTS = 12
MOST_KEYS = 4
FAILED, INFEASIBLE = "failed", "misses a constraint"


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if not analysis.has("objective"):
        return
    cases = list(itertools.product(*[kept(analysis, name) for name in analysis.grid_axes]))
    for number, index in enumerate(cases[:MOST_CASES], 1):
        suffix = f"-{number}" if len(cases) > 1 else ""
        case = dict(zip(analysis.grid_axes, index))
        yield f"{analysis.name}-history{suffix}", functools.partial(history, analysis, case)
        if len(analysis.members("key")) > 1:
            yield f"{analysis.name}-plane{suffix}", functools.partial(plane, analysis, case)


def values_of(analysis: Analysis, path: str, case: dict) -> np.ndarray:
    """Over starts and evaluations; the first evaluation is the result."""
    values = analysis.read(path).values[tuple(case.values())]
    return values[kept(analysis, "start")[:MOST_STARTS]]


def good(analysis: Analysis, case: dict, path: str = "objective") -> np.ndarray:
    """Where an evaluation meets all constraints."""
    meets = np.isfinite(values_of(analysis, path, case))
    for name in analysis.members("excess"):
        meets &= values_of(analysis, f"excess/{name}", case) <= 1e-6
    return meets


def best_so_far(objective: np.ndarray, meets: np.ndarray, sense: float) -> np.ndarray:
    """`sense`: 1 where less is better."""
    return sense * np.fmin.accumulate(np.where(meets, sense * objective, np.nan))


def sense_of(objective: np.ndarray, meets: np.ndarray) -> float:
    """By the results, which are the best evaluations."""
    for row, allowed in zip(objective, meets):
        if np.isfinite(row[0]) and np.ptp(row[1:][allowed[1:]]) > 0:
            return 1.0 if row[0] <= np.min(row[1:][allowed[1:]]) else -1.0
    return 1.0


def history(analysis: Analysis, case: dict, path: str = "objective"):
    keys = analysis.members("key")[:MOST_KEYS]
    figure, panels = style.panels(1 + len(keys), height=1.6)
    objective, meets = values_of(analysis, path, case), good(analysis, case, path)
    sense = sense_of(objective, meets)
    scale = scale_for(analysis.read(path).unit, objective)
    panels[0].set_ylabel(scale.label(objective_name(analysis, path)))
    colours = style.colours_along(len(objective))
    tried = np.isfinite(values_of(analysis, f"key/{keys[0]}", case))
    for start, colour in enumerate(colours):
        number = np.flatnonzero(tried[start, 1:]) + 1
        row = objective[start] / scale.factor
        dots(panels[0], number, row, meets[start], colour)
        panels[0].plot(number, best_so_far(row[1:], meets[start][1:], sense)[number - 1],
                       color=colour, drawstyle="steps-post")
        failed = number[~np.isfinite(row[number])]
        if len(failed) > 0:
            panels[0].plot(failed, np.full(len(failed), 0.03), "x", color=colour,
                           transform=panels[0].get_xaxis_transform())
        for axes, name in zip(panels[1:], keys):
            values = values_of(analysis, f"key/{name}", case)[start]
            unit = scale_for(analysis.read(f"key/{name}").unit, values)
            dots(axes, number, values / unit.factor, meets[start], colour)
            axes.set_ylabel(unit.label(key_label(name)))
    panels[-1].set_xlabel("Evaluation")
    if case:
        panels[0].set_title(describe(analysis, case))
    style.legend_beside(panels[0], handles(colours, objective, meets, tried))
    return figure


def dots(axes, number, values, meets, colour) -> None:
    allowed = meets[number]
    axes.plot(number[allowed], values[number[allowed]], ".", color=colour)
    axes.plot(number[~allowed], values[number[~allowed]], ".", color=colour, markerfacecolor="none")


def objective_name(analysis: Analysis, path: str = "objective") -> str:
    if path != "objective":
        return own_name(path)
    name = str(analysis.attributes(path).get("description", path)).split(",")[0].rsplit("/", 1)[-1]
    return analysis.symbol(name) if f"Derived {name}" in analysis.parameters else own_name(name)


def handles(colours, objective, meets, tried):
    entries = []
    if len(colours) > 1:
        entries = [Line2D([], [], color=colour, label=f"start {start}")
                   for start, colour in enumerate(colours, 1)]
    if np.any(np.isfinite(objective) & ~meets):
        entries.append(Line2D([], [], color="black", linestyle="none", marker=".",
                              markerfacecolor="none", label=INFEASIBLE))
    if np.any(tried & ~np.isfinite(objective)):
        entries.append(Line2D([], [], color="black", linestyle="none", marker="x", label=FAILED))
    return entries


def plane(analysis: Analysis, case: dict):
    """Of the first two keys; the colour is the objective."""
    names = analysis.members("key")[:2]
    objective, meets = values_of(analysis, "objective", case), good(analysis, case)
    keys = [values_of(analysis, f"key/{name}", case) for name in names]
    scales = [scale_for(analysis.read(f"key/{name}").unit, values)
              for name, values in zip(names, keys)]
    x, y = (values / scale.factor for values, scale in zip(keys, scales))
    figure, (axes,) = style.panels(1, height=3.4)
    shown = scale_for(analysis.read("objective").unit, objective)
    inside = meets.copy()
    inside[:, 0] = False
    points = axes.scatter(x[inside], y[inside], c=objective[inside] / shown.factor, s=9,
                          cmap=style.SEQUENCE, zorder=2)
    figure.colorbar(points, ax=axes, label=shown.label(objective_name(analysis)), pad=0.015)
    missed = np.isfinite(objective) & ~meets
    failed = np.isfinite(x) & ~np.isfinite(objective)
    entries = []
    for marked, marker, label in ((missed, "o", INFEASIBLE), (failed, "x", FAILED)):
        if np.any(marked):
            entries += axes.plot(x[marked], y[marked], marker, linestyle="none", markersize=3,
                                 color=style.GREY, markerfacecolor="none", label=label)
    sense = sense_of(objective, meets)
    if np.any(np.isfinite(objective[:, 0])):
        best = int(np.nanargmin(sense * objective[:, 0]))
        entries += axes.plot(x[best, 0], y[best, 0], "*", markersize=11, color=style.COLOURS[1],
                             markeredgecolor="white", linestyle="none", label="best", zorder=4)
    axes.set_xlabel(scales[0].label(key_label(names[0])))
    axes.set_ylabel(scales[1].label(key_label(names[1])))
    if case:
        axes.set_title(describe(analysis, case))
    style.legend_below(axes, entries)
    return figure
