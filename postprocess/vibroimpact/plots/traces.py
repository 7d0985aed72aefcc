"""One curve through computed points: a line where neighbours belong to one motion that repeats itself,
a gap with a thin dotted line at a jump, and points by themselves where a motion has not settled or is
chaotic.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

ABRUPT = 0.1  # of the range of a curve: the least step that counts as a jump where none is recorded
ABRUPT_RATIO = 5.0  # of it to the steps on either side
CHAOTIC = (0, 4, 5)  # values of regime/class: not repeating, chaotic, not decided
JUMP = dict(linestyle=":", linewidth=0.8)
UNSETTLED = dict(marker="o", fillstyle="none", markersize=2.6, markeredgewidth=0.7)


@dataclass(frozen=True)
class Trace:
    """`along` rises; `loose` points are not joined; `jumps`: pairs of points (from, to) and where along
    the axis the jump lies."""

    along: np.ndarray
    values: np.ndarray
    loose: np.ndarray
    jumps: list[tuple[int, int, float]]


def plain(along, values) -> Trace:
    """Of a linear response: all points belong together."""
    return Trace(along, values, np.zeros(len(values), bool), [])


def trace(along, values, loose, bracket, backward: bool) -> Trace:
    """`bracket`: both ends of each located jump, at the point behind it in the direction of the sweep;
    None where jumps are not located, and large single steps are taken for them."""
    jumps = abrupt(along, values) if bracket is None else located(values, bracket, backward)
    settled = [(a, b, at) for a, b, at in jumps if not (loose[a] or loose[b])]
    return Trace(along, values, loose, settled)


def located(values, bracket, backward: bool) -> list[tuple[int, int, float]]:
    middle = np.where(np.isfinite(values), (bracket[0] + bracket[1]) / 2, np.nan)
    step = 1 if backward else -1
    found = [(i + step, i, middle[i]) for i in np.flatnonzero(np.isfinite(middle))]
    return [jump for jump in found if 0 <= jump[0] < len(values)]


def abrupt(along, values) -> list[tuple[int, int, float]]:
    """Single steps far larger than those beside them."""
    steps = np.abs(np.diff(values))
    if len(steps) < 3 or not np.isfinite(steps).any():
        return []
    beside = np.fmax(np.append(steps[1:], 0.0), np.insert(steps[:-1], 0, 0.0))
    large = (steps > ABRUPT * np.ptp(values[np.isfinite(values)])) & (steps > ABRUPT_RATIO * beside)
    return [(i, i + 1, (along[i] + along[i + 1]) / 2) for i in np.flatnonzero(large)]


def draw(axes, shown: Trace, colour, swapped: bool = False, **look) -> None:
    """`swapped`: the values run to the right."""
    def plot(along, values, **how):
        axes.plot(*((values, along) if swapped else (along, values)), color=colour, **how)

    line = np.where(shown.loose, np.nan, shown.values)
    gaps = [max(a, b) for a, b, _ in shown.jumps]
    plot(np.insert(shown.along, gaps, np.nan), np.insert(line, gaps, np.nan), **look)
    alone = single(line)
    if alone.any():
        plot(shown.along[alone], line[alone], linestyle="", marker=".", markersize=2.5)
    if shown.loose.any():
        plot(shown.along[shown.loose], shown.values[shown.loose], linestyle="",
             **UNSETTLED)
    for a, b, at in shown.jumps if look.get("linestyle") else []:
        plot([shown.along[a], at, at, shown.along[b]],
             [shown.values[a], shown.values[a], shown.values[b], shown.values[b]],
             zorder=1.5, label="_jump", **JUMP)


def single(line) -> np.ndarray:
    """Points without a neighbour that a line could lead to."""
    known = np.isfinite(line)
    return known & ~np.append(known[1:], False) & ~np.insert(known[:-1], 0, False)
