"""Sensitivities: which share of the variance of each quantity each key brings about, by itself and
together with the others, with their standard errors."""

from __future__ import annotations

import functools
import itertools

import numpy as np

from . import style
from .labels import key_label, own_name
from .layout import describe, kept
from .results import Analysis, Results

TYPE = "sensitivity"
MOST_CASES = 8
WIDTH = 0.38
BARS = (("first_order", "by itself"), ("total", "with interactions"))


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if not analysis.members("total"):
        return
    cases = list(itertools.product(*[kept(analysis, name) for name in analysis.grid_axes]))
    for number, index in enumerate(cases[:MOST_CASES], 1):
        suffix = f"-{number}" if len(cases) > 1 else ""
        case = dict(zip(analysis.grid_axes, index))
        yield f"{analysis.name}-shares{suffix}", functools.partial(shares, analysis, case)


def shares(analysis: Analysis, case: dict):
    quantities = analysis.members("total")
    figure, panels = style.panels(len(quantities), height=2.0)
    entries = []
    for axes, quantity in zip(panels, quantities):
        keys = analysis.members(f"total/{quantity}")
        place = np.arange(len(keys))
        for side, (order, label) in zip((-0.5, 0.5), BARS):
            values, errors = ([result(analysis, case, f"{kind}/{quantity}/{key}") for key in keys]
                              for kind in (order, f"{order}_error"))
            bars = axes.bar(place + side * WIDTH, values, WIDTH, yerr=2 * np.array(errors),
                            color=style.COLOURS[0 if side < 0 else 1], label=label,
                            error_kw={"lw": 0.8})
            if axes is panels[0]:
                entries.append(bars)
        axes.axhline(0, color="black", lw=0.5)
        axes.set_ylabel(own_name(quantity))
        axes.set_xticks(place, [key_label(key) for key in keys])
    panels[0].set_title("Share of the variance, with twice its standard error"
                        + (", " + describe(analysis, case) if case else ""))
    style.legend_below(panels[-1], entries)
    return figure


def result(analysis: Analysis, case: dict, path: str) -> float:
    return float(analysis.read(path).values[tuple(case.values())][0])
