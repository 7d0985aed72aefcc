"""Circular gaps: where the first side moves about the second's centre with the circle on which they touch, and what
friction does along the circumference."""

from __future__ import annotations

import functools

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from . import cycles, style
from .cycles import direction_handles
from .labels import scale_for
from .layout import layout_of, places
from .motions import Motion, bases
from .results import Analysis, Results


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    for base in bases(analysis)[:1]:
        for contact in analysis.members(f"{base}contact"):
            if all(analysis.has(f"{base}contact/{contact}/{name}") for name in ("place_1", "place_2", "gap")):
                yield f"{analysis.name}-orbit-{contact}", functools.partial(orbits, analysis, base, contact)
    for root in ("", "recorded/"):
        for contact in analysis.members(f"{root}contact"):
            if analysis.has(f"{root}contact/{contact}/friction/sector/work_rate"):
                yield f"{analysis.name}-sectors-{contact}", functools.partial(sectors, analysis, root, contact)


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


def sectors(analysis: Analysis, root: str, contact: str):
    """The work rate of each sector of the circumference with twice its standard error on both sides."""
    folder = f"{root}contact/{contact}/friction/sector"
    rate, error = (analysis.read(f"{folder}/{name}") for name in ("work_rate", "work_rate_error"))
    angle = analysis.coordinate(f"{folder}/work_rate", "friction_sector").values
    scale, entries, directions = scale_for("W", rate.values), places(analysis), layout_of(analysis).directions
    largest = np.nanmax(rate.values + np.nan_to_num(2 * error.values)) / scale.factor or 1.0
    columns = min(3, len(entries))
    rows = -(-len(entries) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(2.1 * max(columns, 2), 0.5 + 2.3 * rows), squeeze=False,
                                subplot_kw={"projection": "polar"})
    for unused in grid.flat[len(entries):]:
        unused.remove()
    for axes, place in zip(grid.flat, entries):
        for number, direction in enumerate(directions):
            height, spread = (place.pick(analysis, array, direction) / scale.factor for array in (rate, error))
            axes.bar(angle, height, 2 * np.pi / len(angle), color=style.COLOURS[number], alpha=0.75, edgecolor="white",
                     linewidth=0.4)
            axes.errorbar(angle, height, np.nan_to_num(2 * spread), fmt="none", ecolor="black", elinewidth=0.7)
        axes.tick_params(labelsize=7)
        axes.set_rlim(0, 1.05 * largest)
        axes.set_yticks(MaxNLocator(3).tick_values(0, largest)[1:])
        style.panel_title(axes, place.text, list(grid.flat[:len(entries)]), pad=22)
    style.legend_beside(grid[0, min(columns, len(entries)) - 1], direction_handles(analysis))
    figure.suptitle(scale.label(f"Contact {contact}: work rate"), x=0.01, ha="left", fontsize=10)
    return figure
