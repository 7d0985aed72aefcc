"""Friction of sampled motions: force over slip, and the intervals in which the sides stick, between whose samples both are
continued to the instant of the change.
"""

from __future__ import annotations

import functools

import numpy as np

from . import cycles, style
from .envelopes import SMALLEST_JUMP
from .labels import scale_for
from .motions import Motion, bases, contacts_of, is_closed, parts
from .results import Analysis, Results

STUCK = 1e-12  # of the largest slip rate: rounding
CLASSES = 12  # of normal force and of slip speed


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    for base in bases(analysis)[:1]:
        for contact in analysis.members(f"{base}contact"):
            if all(analysis.has(f"{base}contact/{contact}/{name}") for name in ("slip", "slip_rate", "friction_force")):
                yield (f"{analysis.name}-friction-loop-{contact}",
                       functools.partial(loops, analysis, base, contact))
            if analysis.has(f"{base}contact/{contact}/normal_force") and slides(Motion(analysis, base, None, ""), contact) \
                    and parts(analysis, base, contact):
                yield (f"{analysis.name}-friction-classes-{contact}",
                       functools.partial(distribution, analysis, base, contact))


def loops(analysis: Analysis, base: str, contact: str):
    """The force that acts on the first side, so that the loops are run through clockwise; nothing between contacts."""
    def curve(motion):
        rate, slip, force = (motion.signal(f"contact/{contact}/{name}") for name in ("slip_rate", "slip", "friction_force"))
        closed = is_closed(motion, contact) if contact in contacts_of(analysis, base) else np.ones(len(rate), bool)
        near = closed | np.roll(closed, 1) | np.roll(closed, -1)
        _, force, slip, near = with_jumps(motion.time(), -force, rate, slip, near.astype(float))
        return np.where(near > 0, slip, np.nan), np.where(near > 0, force, np.nan)

    figure = cycles.cycles(cycles.motions(analysis, base), curve, "Slip", "Friction force")
    figure.suptitle(f"Contact {contact}", x=0.01, ha="left", fontsize=10)
    return figure


def slides(motion: Motion, contact: str) -> bool:
    return motion.has(f"contact/{contact}/slip_rate")


def stick_intervals(motion: Motion, contact: str) -> list[tuple[float, float]]:
    """Begin and end of each, where the sides do not slide at all: a spring-slider always deforms a little."""
    time, rate = motion.time(), motion.signal(f"contact/{contact}/slip_rate")
    held = np.concatenate([[False], states(rate) == 0, [False]])
    edges, when = changes(time, rate)
    instants = dict(zip(edges, when))
    first, last = (np.flatnonzero(held[1:] & ~held[:-1]), np.flatnonzero(held[:-1] & ~held[1:]) - 1)
    return [(instants.get(a - 1, time[a]), instants.get(b, time[b])) for a, b in zip(first, last)]


def states(rate: np.ndarray) -> np.ndarray:
    """0 where the sides stick, else the sign of the rate; a single zero is that of a turn, and belongs to what follows."""
    signs = np.where(np.abs(rate) <= STUCK * np.abs(rate).max(initial=0.0), 0, np.sign(rate))
    held = signs == 0
    alone = held & ~np.append(False, held[:-1]) & ~np.append(held[1:], False)
    return np.where(alone, np.append(signs[1:], 0), signs)


def changes(time: np.ndarray, rate: np.ndarray):
    """The samples behind which the sides come to stick, begin to slip or turn, and the instant: of the slip rate, which is
    continuous, the zero of the straight line through both neighbours, or through two on the side that moves."""
    state = states(rate)
    edges = np.flatnonzero(np.diff(state))
    when = []
    for i in edges:
        a, b = (i, i + 1) if state[i] and state[i + 1] else (i - 1, i) if state[i] else (i + 1, i + 2)
        known = 0 <= a and b < len(rate) and rate[a] != rate[b]
        zero = time[a] - rate[a] * (time[b] - time[a]) / (rate[b] - rate[a]) if known else time[i]
        when.append(np.clip(zero, time[i], time[i + 1]))
    return edges, np.array(when)


def with_jumps(time, force, rate, *others):
    """All with two points more where the friction force jumps between two samples: what the samples on either side lead to.
    The `others` run straight on."""
    edges, when = changes(time, rate)
    ends = [[beside(time, force, i, i - 1, at), beside(time, force, i + 1, i + 2, at)] for i, at in zip(edges, when)]
    least = [max(SMALLEST_JUMP * np.abs(force).max(), abs(force[i + 1] - force[i]) / 2) for i in edges]  # else it is a bend
    jumps = np.array([abs(after - before) > size for (before, after), size in zip(ends, least)], bool)
    edges, when, ends = edges[jumps], when[jumps], np.array(ends)[jumps] if len(ends) else np.empty((0, 2))
    at = np.repeat(edges + 1, 2)
    return (np.insert(time, at, np.repeat(when, 2)), np.insert(force, at, ends.ravel()),
            *[np.insert(values, at, np.repeat(np.interp(when, time, values), 2)) for values in others])


def beside(time, force, first: int, second: int, at: float) -> float:
    """The straight line through two samples on the same side of a change, or the one that there is."""
    if not 0 <= second < len(force):
        return force[first]
    slope = (force[second] - force[first]) / (time[second] - time[first])
    return force[first] + slope * (at - time[first])


def distribution(analysis: Analysis, base: str, contact: str):
    """Share of the time in contact for classes of normal force and slip speed, of all samples."""
    entries = list(cycles.motions(analysis, base))
    samples = [[shares(motion, contact) for motion in directions] for _, directions in entries]
    scales = [scale_for(unit, *[part[k] for panel in samples for part in panel]) for k, unit in enumerate(("m/s", "N"))]
    tops = [max(part[k].max(initial=0.0) for panel in samples for part in panel) / scales[k].factor for k in (0, 1)]
    figure, panels = style.panel_grid(len(entries), height=2.6)
    classes = []
    for panel in samples:
        both = [np.concatenate([part[k] for part in panel]) / scales[k].factor for k in (0, 1)]
        counts, *edges = np.histogram2d(*both, bins=CLASSES, range=[[0, top or 1] for top in tops])
        classes.append(np.where(counts > 0, counts / max(len(both[0]), 1), np.nan))
    for axes, (text, _), values in zip(panels, entries, classes):
        mesh = axes.pcolormesh(*edges, values.T, cmap=style.SEQUENCE, vmin=0, vmax=np.nanmax(classes))
        style.panel_title(axes, text, panels)
    style.label_grid(panels, scales[0].label("Slip speed"), scales[1].label("Normal force"))
    figure.colorbar(mesh, ax=panels, label="Share of the time in contact", pad=0.02)
    figure.suptitle(f"Contact {contact}", x=0.01, ha="left", fontsize=10)
    return figure


def shares(motion: Motion, contact: str):
    """Slip speed and normal force of the samples in contact."""
    speed, force = (np.abs(motion.signal(f"contact/{contact}/{name}")) for name in ("slip_rate", "normal_force"))
    return speed[force > 0], force[force > 0]
