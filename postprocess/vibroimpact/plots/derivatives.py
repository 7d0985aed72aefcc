"""Derivatives of periodic motions by keys: by which part what is recorded of the motion changes when a
key changes by a part of it."""

from __future__ import annotations

import functools
import itertools

import numpy as np

from . import style
from .labels import key_label, words
from .layout import title_of, kept
from .results import Analysis, Results

MOST_CASES = 8
MOST_QUANTITIES = 6
# What is shown of a contact or of a displacement, the first first.
SHOWN = ("displacement_x/largest", "peak_force/maximum", "impulse/mean", "largest",
         "peak_to_peak")


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    keys = [key for key in analysis.members("derivative")
            if analysis.has(f"derivative/{key}/value")]
    if not keys:
        return
    cases = list(itertools.product(*[kept(analysis, name) for name in analysis.grid_axes]))
    for number, index in enumerate(cases[:MOST_CASES], 1):
        suffix = f"-{number}" if len(cases) > 1 else ""
        case = dict(zip(analysis.grid_axes, index))
        yield f"{analysis.name}-derivatives{suffix}", functools.partial(bars, analysis, case, keys)


def shown_quantities(analysis: Analysis, key: str) -> list[str]:
    folder = f"derivative/{key}/"
    fields = [path[len(folder):] for path in analysis.fields(folder[:-1])]
    chosen = [field for ending in SHOWN for field in fields if field.endswith(ending)]
    return list(dict.fromkeys(chosen))[:MOST_QUANTITIES]


def bars(analysis: Analysis, case: dict, keys: list[str]):
    quantities = [quantity for quantity in shown_quantities(analysis, keys[0])
                  if np.isfinite(elasticity(analysis, case, keys[0], quantity))]
    figure, (axes,) = style.panels(1, height=1.0 + 0.35 * len(quantities) * len(keys) ** 0.5)
    place, width = np.arange(len(quantities)), 0.8 / len(keys)
    for k, key in enumerate(keys):
        values = [elasticity(analysis, case, key, quantity) for quantity in quantities]
        axes.barh(place + (k - 0.5 * (len(keys) - 1)) * width, values, width,
                  color=style.COLOURS[k % len(style.COLOURS)], label=key_label(key))
    axes.set_yticks(place, [name_of(quantity) for quantity in quantities])
    axes.invert_yaxis()
    axes.axvline(0, color="black", lw=0.5)
    axes.set_xlabel("Relative change for a relative change of the key")
    if case:
        axes.set_title(title_of(analysis, case))
    style.legend_below(axes, axes.get_legend_handles_labels()[0])
    return figure


def elasticity(analysis: Analysis, case: dict, key: str, quantity: str) -> float:
    """p/m dm/dp"""
    derivative, value, measured = (
        float(analysis.read(path).values[tuple(case.values())])
        for path in (f"derivative/{key}/{quantity}", f"derivative/{key}/value", quantity))
    return derivative * value / measured if measured != 0 else np.nan


def name_of(quantity: str) -> str:
    place = quantity.split("/")
    return f"{words(place[-2])}, {words(place[-1]).lower()}\n{place[1]}"
