"""Campbell diagrams: frequencies of whirl over the speed, their damping, and the critical speeds."""

from __future__ import annotations

import functools

import numpy as np

from . import style
from .results import Analysis, Results

TYPE = "campbell"
TO_AND_FRO = 1e-6
PER_MINUTE = 60 / (2 * np.pi)
DIRECTIONS = {1: ("forward", "-"), -1: ("backward", "--"), 0: ("to and fro", ":")}


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    yield f"{analysis.name}-campbell", functools.partial(diagram, analysis)


def diagram(analysis: Analysis):
    read = {name: analysis.read(name).values for name in ("speed", "frequency", "damping_ratio", "whirl")}
    damped = bool(np.nanmax(np.abs(read["damping_ratio"]), initial=0) > 1e-9)
    figure, panels = style.panels(2 if damped else 1, height=2.2 if damped else 3)
    speed = read["speed"] * PER_MINUTE
    for mode in range(len(read["frequency"])):
        draw_mode(panels, mode, speed, read, damped)
    draw_multiples(panels[0], analysis, speed, read["frequency"])
    panels[0].set_ylabel("Frequency (Hz)")
    panels[0].set_ylim(bottom=0)
    if damped:
        panels[1].set_ylabel("Damping ratio (%)")
    panels[-1].set_xlabel("Speed (rpm)")
    draw_key(panels[0], read["whirl"])
    return figure


def draw_mode(panels, mode: int, speed, read: dict, damped: bool) -> None:
    """One line for each direction of whirl that the mode has; at rest it has that of the speed beside."""
    colour = style.COLOURS[mode % len(style.COLOURS)]
    direction = direction_of(read["whirl"][mode], speed)
    for sign, (_, line) in DIRECTIONS.items():
        here = direction == sign
        here[:-1] |= here[1:]  # up to where the direction changes
        draw(panels[0], speed, np.where(here, read["frequency"][mode], np.nan), colour, line)
        if damped:
            draw(panels[1], speed, np.where(here, 100 * read["damping_ratio"][mode], np.nan), colour, line)


def draw(axes, speed, values, colour, line) -> None:
    if np.isfinite(values).any():
        axes.plot(speed, values, color=colour, linestyle=line)


def direction_of(whirl, speed):
    direction = np.where(np.abs(whirl) > TO_AND_FRO, np.sign(whirl), 0)
    rest = np.flatnonzero(speed == 0)
    for k in rest:
        direction[k] = direction[k + 1] if k + 1 < len(direction) else direction[k - 1]
    return direction


def draw_multiples(axes, analysis: Analysis, speed, frequency) -> None:
    """Lines of the multiples of the speed, and circles where a frequency crosses one."""
    if not analysis.has("critical/speed"):
        return
    at = {name: np.atleast_1d(analysis.read(f"critical/{name}").values) for name in ("speed", "frequency", "multiple")}
    top = 1.05 * np.nanmax(frequency)
    for multiple in np.unique(at["multiple"]):
        line = multiple * np.abs(speed) / 60
        axes.plot(speed, np.where(line <= top, line, np.nan), color="0.6", linewidth=0.8)
        end = np.flatnonzero(line <= top)[-1]
        axes.annotate(f"{multiple:g} ×", (speed[end], line[end]), color="0.4", fontsize="small",
                      ha="right", va="bottom")
    axes.plot(at["speed"] * PER_MINUTE, at["frequency"], "o", color="black", fillstyle="none")


def draw_key(axes, whirl) -> None:
    shown = {sign for sign in DIRECTIONS if (np.sign(np.where(np.abs(whirl) > TO_AND_FRO, whirl, 0))[:, 1:] == sign).any()}
    for sign in (1, -1, 0):
        if sign in shown:
            axes.plot([], [], color="0.3", linestyle=DIRECTIONS[sign][1], label=DIRECTIONS[sign][0])
    style.legend_beside(axes, title="Whirl")
