"""Fits: measured data with the model at the best fit and what is left between them, and the way of the
sum of squares."""

from __future__ import annotations

import functools
import itertools

import numpy as np

from . import searches, style
from .labels import quantity_label, scale_for, words
from .layout import describe, kept
from .results import Analysis, Results

TYPE = "estimate"


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if not analysis.has("sum_of_squares"):
        return
    cases = list(itertools.product(*[kept(analysis, name) for name in analysis.grid_axes]))
    for number, index in enumerate(cases[:searches.MOST_CASES], 1):
        suffix = f"-{number}" if len(cases) > 1 else ""
        case = dict(zip(analysis.grid_axes, index))
        for name in analysis.members("measured"):
            if len(data(analysis, "measured", name, case)) > 1:
                yield (f"{analysis.name}-fit-{name}{suffix}",
                       functools.partial(curve, analysis, name, case))
        yield (f"{analysis.name}-history{suffix}",
               functools.partial(searches.history, analysis, case, "sum_of_squares"))


def best_start(analysis: Analysis, case: dict) -> int | None:
    sums = searches.values_of(analysis, "sum_of_squares", case)[:, 0]
    return int(np.nanargmin(sums)) if np.any(np.isfinite(sums)) else None


def data(analysis: Analysis, group: str, name: str, case: dict) -> np.ndarray:
    """Of the best fit; empty when there is none."""
    best = best_start(analysis, case)
    if best is None:
        return np.array([])
    values = analysis.read(f"{group}/{name}").values[tuple(case.values())][best, 0]
    return values[np.isfinite(values)]


def curve(analysis: Analysis, name: str, case: dict):
    figure, (above, below) = style.panels(2, height=2.2)
    at, measured, model, residual = (data(analysis, group, name, case)
                                     for group in ("abscissa", "measured", "model", "residual"))
    x = scale_for(analysis.read(f"abscissa/{name}").unit, at)
    y = scale_for(analysis.read(f"measured/{name}").unit, measured, model)
    above.plot(at / x.factor, model / y.factor, color=style.COLOURS[0], label="model")
    above.plot(at / x.factor, measured / y.factor, "o", color=style.COLOURS[1],
               markerfacecolor="none", label="measured")
    above.set_ylabel(y.label(quantity_label(name)))
    below.axhline(0, color=style.GREY, linewidth=0.7)
    below.plot(at / x.factor, residual, "o", color=style.COLOURS[1], markerfacecolor="none")
    below.set_ylabel("Residual")
    below.set_xlabel(x.label("Frequency" if x.unit == "Hz" else words("abscissa").capitalize()))
    if case:
        above.set_title(describe(analysis, case))
    style.legend_beside(above)
    return figure
