"""Fits: measured data with the model at the start and at the best fit and what is left between them,
residuals against those of a normal distribution, confidence ellipses of pairs of keys, and the way of the
sum of squares."""

from __future__ import annotations

import functools
import itertools
from statistics import NormalDist

import numpy as np

from . import searches, style
from .labels import key_label, own_name, scale_for
from .layout import describe, kept
from .results import Analysis, Results

TYPE = "estimate"
START = 1  # the first evaluation of a start is at its beginning
LEVEL = 0.95
MOST_PAIRS = 15


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
        if best_start(analysis, case) is not None:
            yield (f"{analysis.name}-residuals{suffix}",
                   functools.partial(residuals, analysis, case))
        if len(determined_keys(analysis, case)) > 1:
            yield (f"{analysis.name}-ellipses{suffix}",
                   functools.partial(ellipses, analysis, case))
        yield (f"{analysis.name}-history{suffix}",
               functools.partial(searches.history, analysis, case, "sum_of_squares"))


def best_start(analysis: Analysis, case: dict) -> int | None:
    sums = searches.values_of(analysis, "sum_of_squares", case)[:, 0]
    return int(np.nanargmin(sums)) if np.any(np.isfinite(sums)) else None


def data(analysis: Analysis, group: str, name: str, case: dict, evaluation: int = 0) -> np.ndarray:
    """Of an evaluation of the best start, by default the best fit; empty when there is none."""
    best = best_start(analysis, case)
    values = analysis.read(f"{group}/{name}").values[tuple(case.values())]
    if best is None or evaluation >= values.shape[1]:
        return np.array([])
    values = values[best, evaluation]
    return values[np.isfinite(values)]


def of_best(analysis: Analysis, path: str, case: dict):
    """A number or array of the best fit; NaN without statistics."""
    best = best_start(analysis, case)
    if best is None or not analysis.has(path):
        return np.nan
    return analysis.read(path).values[tuple(case.values())][best, 0]


def curve(analysis: Analysis, name: str, case: dict):
    figure, (above, below) = style.panels(2, height=2.2)
    at, measured, model, residual = (data(analysis, group, name, case)
                                     for group in ("abscissa", "measured", "model", "residual"))
    x = scale_for(analysis.read(f"abscissa/{name}").unit, at)
    y = scale_for(analysis.read(f"measured/{name}").unit, measured, model)
    above.plot(at / x.factor, measured / y.factor, "o", color=style.COLOURS[1], alpha=0.6,
               markerfacecolor="none", label="measured")
    start = data(analysis, "model", name, case, START)
    if len(start) == len(at):
        above.plot(at / x.factor, start / y.factor, "--", color=style.GREY, label="start")
    above.plot(at / x.factor, model / y.factor, color=style.COLOURS[0], label="model")
    above.set_ylabel(y.label(own_name(name)))
    above.set_ylim(*around(measured / y.factor, model / y.factor))
    below.axhline(0, color=style.GREY, linewidth=0.7)
    below.plot(at / x.factor, residual, "o", color=style.COLOURS[1], markerfacecolor="none")
    below.set_ylabel("Residual")
    below.set_xlabel(x.label(abscissa_name(analysis, name)))
    if case:
        above.set_title(describe(analysis, case))
    style.legend_beside(above)
    return figure


def around(*curves) -> tuple[float, float]:
    """Limits with a tenth of room; a start far off leaves them."""
    low, high = (end([end(curve) for curve in curves]) for end in (min, max))
    room = 0.1 * (high - low) or 1.0
    return low - room, high + room


def abscissa_name(analysis: Analysis, data_set: str) -> str:
    """By its unit, else as the section of the data calls it."""
    unit = analysis.read(f"abscissa/{data_set}").unit
    section = analysis.parameters.get(f"Analysis {analysis.name}", {}).get("Estimate", {})
    column = section.get(f"Data {data_set}", {}).get("Abscissa column", "")
    return {"Hz": "Frequency", "s": "Time"}.get(unit) or (
        "Abscissa of the data" if column.isdigit() or not column else key_label(column))


def residuals(analysis: Analysis, case: dict):
    """Residuals of all sets over the model's values, and against the quantiles of a normal
    distribution: a straight line where they are noise of one size."""
    figure, (over, against) = style.panel_grid(2, columns=2, height=2.6, share=False)
    together = []
    for number, name in enumerate(analysis.members("residual")):
        residual, model = (data(analysis, group, name, case) for group in ("residual", "model"))
        size = np.abs(model).max(initial=0.0) or 1.0
        over.plot(model / size, residual, "o", markerfacecolor="none", label=name,
                  color=style.COLOURS[number % len(style.COLOURS)])
        together.extend(residual)
    over.axhline(0, color=style.GREY, linewidth=0.7)
    over.set(xlabel="Model over its largest value", ylabel="Residual")
    count = len(together)
    quantiles = [NormalDist().inv_cdf((i + 0.5) / count) for i in range(count)]
    sets = len(analysis.members("residual"))
    against.plot(quantiles, np.sort(together), "o", markerfacecolor="none", label="all together",
                 color=style.GREY if sets > 1 else style.COLOURS[0])
    ends = np.array([min(quantiles), max(quantiles)])
    against.plot(ends, np.mean(together) + np.std(together) * ends, color=style.GREY, linewidth=0.7)
    against.set(xlabel="Quantile of the normal distribution", ylabel="Residual")
    if case:
        over.set_title(describe(analysis, case))
    style.legend_beside(against, [*over.get_lines()[:sets], *(against.get_lines()[:1] if sets > 1 else [])])
    return figure


def determined_keys(analysis: Analysis, case: dict) -> list[str]:
    """Keys that the data determine and no bound holds."""
    return [name for name in analysis.members("key")
            if np.isfinite(of_best(analysis, f"standard_error/{name}", case))]


def radius(analysis: Analysis, case: dict) -> float:
    """Of the ellipse that holds two keys at once in 95 %, in standard errors: the root of twice the
    quantile of F with 2 and N - n degrees of freedom, or of the chi-square with 2 where the standard
    deviations of the data are known, which their intervals show."""
    fixed = [np.isnan(of_best(analysis, f"standard_error/{name}", case))
             for name in analysis.members("key")]
    freedom = (sum(len(data(analysis, "residual", name, case))
                   for name in analysis.members("residual")) - fixed.count(False))
    name = determined_keys(analysis, case)[0]
    ends = [of_best(analysis, f"interval_{end}/{name}", case) for end in ("lower", "upper")]
    quantile = np.diff(ends)[0] / 2 / of_best(analysis, f"standard_error/{name}", case)
    if np.isclose(quantile, NormalDist().inv_cdf((1 + LEVEL) / 2), rtol=1e-8) or freedom < 1:
        return float(np.sqrt(-2 * np.log(1 - LEVEL)))
    # 1 - (1 + 2 F / v)^(-v / 2) is the distribution of F with 2 and v degrees of freedom.
    return float(np.sqrt(freedom * ((1 - LEVEL) ** (-2 / freedom) - 1)))


def ellipse(centre, errors, correlation: float, size: float) -> np.ndarray:
    """Points of size^2 = d' C^-1 d around the centre, one a row; C by its Cholesky factor."""
    angle = np.linspace(0, 2 * np.pi, 181)
    circle = size * np.array([np.cos(angle), np.sin(angle)])
    factor = np.array([[1, 0], [correlation, np.sqrt(max(0.0, 1 - correlation ** 2))]])
    return np.asarray(centre) + (np.asarray(errors)[:, None] * (factor @ circle)).T


def ellipses(analysis: Analysis, case: dict):
    """One panel for each pair of keys: best fit, ellipse, and the intervals of each by itself."""
    names, order = determined_keys(analysis, case), analysis.members("key")
    correlation = of_best(analysis, "correlation", case)
    pairs = list(itertools.combinations(names, 2))[:MOST_PAIRS]
    figure, panels = style.panel_grid(len(pairs), columns=3, height=2.1, share=False)
    size = radius(analysis, case)
    for axes, pair in zip(panels, pairs):
        best, error = ([float(of_best(analysis, f"{group}/{name}", case)) for name in pair]
                       for group in ("key", "standard_error"))
        points = ellipse(best, error, correlation[order.index(pair[0]), order.index(pair[1])], size)
        scales = [scale_for(analysis.read(f"key/{name}").unit, points[:, k])
                  for k, name in enumerate(pair)]
        factors = [scale.factor for scale in scales]
        axes.plot(*(points / factors).T, color=style.COLOURS[0])
        axes.plot(*(np.array(best) / factors), "o", color=style.COLOURS[1])
        for draw, name, scale in zip((axes.axvspan, axes.axhspan), pair, scales):
            draw(*(float(of_best(analysis, f"interval_{end}/{name}", case)) / scale.factor
                   for end in ("lower", "upper")), color=style.COLOURS[0], alpha=0.1, linewidth=0)
        axes.set_xlabel(scales[0].label(key_label(pair[0])))
        axes.set_ylabel(scales[1].label(key_label(pair[1])))
    figure.suptitle("Ellipses hold both keys in 95 %, bands each by itself"
                    + (f"; {describe(analysis, case)}" if case else ""), x=0.01, ha="left",
                    fontsize=10)
    return figure
