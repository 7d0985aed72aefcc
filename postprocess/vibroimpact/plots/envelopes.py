"""Histories: a line, or where it would be a solid block the band between its extremes; a contact force with
the instants between the samples at which it jumps."""

from __future__ import annotations

import numpy as np

MOST_REVERSALS = 400  # of a line as wide as a page
COLUMNS = 500
SMALLEST_JUMP = 0.02  # of the largest force
BAND = 0.45  # opacity


def draw(axes, along, values, color, **look) -> None:
    if reversals(values) <= MOST_REVERSALS:
        axes.plot(along, values, color=color, **look)
        return
    place, low, high = envelope(along, values)
    axes.fill_between(place, low, high, color=color, alpha=BAND, linewidth=0)
    for bound in (low, high):
        axes.plot(place, bound, color=color, linewidth=0.6)


def reversals(values) -> int:
    """How often a signal turns by more than a hundredth of its range."""
    known = values[np.isfinite(values)]
    if known.size < 3:
        return 0
    steps = np.diff(np.round(known / (np.ptp(known) / 100 or 1.0)))
    signs = np.sign(steps[steps != 0])
    return int(np.count_nonzero(np.diff(signs)))


def envelope(along, values):
    """Least and largest value in each of COLUMNS equal parts; NaN where there is no sample."""
    edges = np.linspace(along[0], along[-1], COLUMNS + 1)
    place = np.clip(np.searchsorted(edges, along, "right") - 1, 0, COLUMNS - 1)
    low, high = np.full(COLUMNS, np.inf), np.full(COLUMNS, -np.inf)
    known = np.isfinite(values)
    np.minimum.at(low, place[known], values[known])
    np.maximum.at(high, place[known], values[known])
    found = low <= high
    return (edges[1:] + edges[:-1]) / 2, np.where(found, low, np.nan), np.where(found, high, np.nan)


def with_jumps(time, force, gap, *others):
    """All with two points more where the gap closes or opens between two samples: force and gap 0 outside, and
    the force that the samples inside lead to. Damping makes it jump there. The `others` run straight on."""
    acts = force != 0
    crosses = (gap[1:] > 0) != (gap[:-1] > 0)
    edges = np.flatnonzero((acts[1:] != acts[:-1]) & crosses)
    share = gap[edges] / (gap[edges] - gap[edges + 1])

    def between(values):
        return values[edges] + share * (values[edges + 1] - values[edges])

    inside = np.where(acts[edges + 1], at_edge(time, force, edges + 1, 1, between(time)),
                      at_edge(time, force, edges, -1, between(time)))
    pairs = np.where(acts[edges + 1], [0 * inside, inside], [inside, 0 * inside]).T.ravel()
    at = np.repeat(edges + 1, 2)
    return (np.insert(time, at, np.repeat(between(time), 2)), np.insert(force, at, pairs),
            *[np.insert(values, at, np.repeat(between(values), 2)) for values in (gap, *others)])


def at_edge(time, force, inside, step: int, when) -> np.ndarray:
    """The straight line through the two samples next to an edge; 0 where it changes its sign, one is missing, or
    it is as small as the curvature of a force that does not jump."""
    second = np.clip(inside + step, 0, len(force) - 1)
    known = (second != inside) & (force[second] != 0)
    apart = np.where(known, time[second] - time[inside], 1.0)
    value = force[inside] + (force[second] - force[inside]) / apart * (when - time[inside])
    least = SMALLEST_JUMP * np.abs(force).max(initial=0.0)
    return np.where(known & (value * force[inside] > 0) & (np.abs(value) > least), value, 0.0)
