"""What figures of branches have in common: their key, the values of a case, and lines that are solid
where motions are stable.
"""

from __future__ import annotations

import numpy as np

from .labels import key_label
from .layout import Layout, kept
from .results import Analysis

BRANCH, BALANCE, MODE = "branch", "harmonic balance", "nonlinear mode"
TYPES = (BRANCH, BALANCE, MODE)


def key_of(analysis: Analysis) -> str:
    """Name of the key along which the branches were followed."""
    return next(name for name in analysis.members("end")
                if name not in ("branch", "reason")
                and not analysis.is_coordinate(f"end/{name}"))


def key_name(key: str) -> str:
    return key.capitalize() if key in ("frequency", "energy") else key_label(key.replace(".", "/"))


def pick(layout: Layout, values: np.ndarray, case) -> np.ndarray:
    """Values of one case; dimensions of the field itself follow."""
    return values[tuple(case.index.get(name, kept(layout.analysis, name)[0])
                        for name in layout.analysis.axes)]


def pieces(axes, x, y, stable, colour, lines=("-", "--")) -> None:
    """Lines between neighbouring points; of the first kind where both are stable."""
    solid = stable[:-1] & stable[1:]
    for chosen, line in ((solid, lines[0]), (~solid, lines[1])):
        xs, ys = ([value for i in np.flatnonzero(chosen)
                   for value in (values[i], values[i + 1], np.nan)] for values in (x, y))
        # Neighbouring pieces are one line, so that the dashes go on.
        axes.plot(*joined(xs, ys), line, color=colour)


def joined(xs: list, ys: list):
    """Without the interruption between pieces that meet."""
    kept_x: list[float] = []
    kept_y: list[float] = []
    for i in range(0, len(xs), 3):
        if kept_x and (kept_x[-2], kept_y[-2]) == (xs[i], ys[i]):
            kept_x[-1:], kept_y[-1:] = [xs[i + 1], np.nan], [ys[i + 1], np.nan]
        else:
            kept_x += xs[i:i + 3]
            kept_y += ys[i:i + 3]
    return kept_x, kept_y
