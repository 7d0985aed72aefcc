"""Orbits in circular gaps: where the first side moves about the second's centre, and the circle on which they touch."""

from __future__ import annotations

import functools

import numpy as np

from . import cycles, style
from .labels import scale_for
from .motions import Motion, bases
from .results import Analysis, Results


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    for base in bases(analysis)[:1]:
        for contact in analysis.members(f"{base}contact"):
            if all(analysis.has(f"{base}contact/{contact}/{name}") for name in ("place_1", "place_2", "gap")):
                yield f"{analysis.name}-orbit-{contact}", functools.partial(orbits, analysis, base, contact)


def orbits(analysis: Analysis, base: str, contact: str):
    entries = list(cycles.motions(analysis, base))
    paths = [[place(motion, contact) for motion in directions] for _, directions in entries]
    radius = touching_radius(entries[0][1][0], contact)
    scale = scale_for("m", *[values for panel in paths for path in panel for values in path], np.array([radius]))
    figure, panels = style.panel_grid(len(entries), height=3.2)
    angle = np.linspace(0, 2 * np.pi, 361)
    for axes, (text, _), panel in zip(panels, entries, paths):
        for number, path in enumerate(panel):
            axes.plot(path[0] / scale.factor, path[1] / scale.factor, color=style.COLOURS[number],
                      linestyle=style.DIRECTION_LINES[number])
        axes.plot(radius / scale.factor * np.cos(angle), radius / scale.factor * np.sin(angle), color="black",
                  linewidth=0.8, linestyle=":")
        axes.set_aspect("equal", adjustable="datalim")
        style.panel_title(axes, text, panels)
    style.label_grid(panels, scale.label("Relative position, along"), scale.label("Relative position, across"))
    style.legend_beside(style.upper_right(panels), cycles.direction_handles(analysis))
    figure.suptitle(f"Contact {contact}", x=0.01, ha="left", fontsize=10)
    return figure


def place(motion: Motion, contact: str):
    return [motion.signal(f"contact/{contact}/{name}") for name in ("place_1", "place_2")]


def touching_radius(motion: Motion, contact: str) -> float:
    """Of one side in the other the gap is this radius less the distance of the centres, of round sides beside each other
    the distance less the radius: one of the two is the same at all instants."""
    gap, distance = motion.signal(f"contact/{contact}/gap"), np.hypot(*place(motion, contact))
    inside, beside = gap + distance, distance - gap
    return float(np.median(inside if np.ptp(inside) <= np.ptp(beside) else beside))
