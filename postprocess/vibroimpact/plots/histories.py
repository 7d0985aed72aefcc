"""Time histories of recorded motions: points, contacts, rotors, connections; contacts shaded."""

from __future__ import annotations

import functools

from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from . import style
from .labels import quantity_label, scale_for
from .layout import layout_of, places
from .motions import Motion, bases, contact_intervals, contacts_of
from .results import Analysis, Results

MOST = 3  # points of an analysis whose histories are drawn, unless points are chosen
SHADES = ["#C9D8E6", "#F3D3C2", "#C7E5DA", "#EBD5E2"]
MOST_SHADED = 80  # more contacts than that would be a pattern, no information
ORDER = ["displacement", "absolute_displacement", "velocity", "acceleration", "normal_force", "gap"]
GROUPS = {"point": "motion", "contact": "contacts", "rotor": "rotors", "connection": "connections"}


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    for base in bases(analysis):
        if not base:
            continue  # drawn by the module of transient analyses
        directions = layout_of(analysis).directions
        for number, place in enumerate(places(analysis, MOST), 1):
            for direction in directions:
                motion = Motion(analysis, base, place, direction)
                end = "".join(f"-{part}" for part in (number if place.text else "",
                                                      direction if len(directions) > 1 else "")
                              if part)
                for group, name in GROUPS.items():
                    rows = rows_of(analysis, base, group)
                    if rows:
                        yield (f"{analysis.name}-history-{name}{end}",
                               functools.partial(history, motion, rows))


def rows_of(analysis: Analysis, base: str, group: str) -> dict[str, list[str]]:
    """Quantities of a group, each with the paths of all points, contacts, ... that have it."""
    rows: dict[str, list[str]] = {}
    for path in analysis.fields(f"{base}{group}"):
        _, _, quantity = path.removeprefix(base).split("/", 2)
        rows.setdefault(quantity, []).append(path.removeprefix(base))
    return {quantity: rows[quantity] for quantity in sorted(rows, key=rank)}


def rank(quantity: str) -> int:
    return next((i for i, start in enumerate(ORDER) if quantity.startswith(start)), len(ORDER))


def history(motion: Motion, rows: dict[str, list[str]]):
    figure, panels = style.panels(len(rows), height=1.9 if len(rows) < 4 else 1.5)
    recent = motion.recent()
    time = motion.time()[recent]
    start = time[0] if time[0] > 0 else 0.0
    scale = scale_for("s", time - start)
    names = list(dict.fromkeys(owner(path) for paths in rows.values() for path in paths))
    for axes, (quantity, paths) in zip(panels, rows.items()):
        draw_row(axes, motion, paths, (time - start) / scale.factor, recent, names)
    handles = [Line2D([], [], color=colour_of(name, names), label=name) for name in names]
    handles += shade(panels, motion, time, start, scale)
    panels[0].set_title(title(motion))
    panels[-1].set_xlabel(scale.label(f"Time from {start:.5g} s on" if start else "Time"))
    style.legend_beside(panels[0], handles)
    return figure


def owner(path: str) -> str:
    """"first.mass" of point/first.mass/displacement_x."""
    return path.split("/")[1]


def colour_of(name: str, names: list[str]) -> str:
    return style.COLOURS[names.index(name) % len(style.COLOURS)]


def draw_row(axes, motion: Motion, paths, time, recent, names) -> None:
    signals = [motion.signal(path)[recent] for path in paths]
    scale = scale_for(motion.unit(paths[0]), *signals)
    for path, signal in zip(paths, signals):
        axes.plot(time, signal / scale.factor, color=colour_of(owner(path), names))
    quantity = paths[0].split("/")[2:]
    label = "contact force" if quantity == ["normal_force"] else quantity_label(quantity[-1])
    axes.set_ylabel(scale.label(label[0].upper() + label[1:]))
    axes.margins(x=0)


def shade(panels, motion: Motion, time, start: float, scale) -> list[Patch]:
    """Background of the intervals in contact; gives the legend entries."""
    handles = []
    for number, contact in enumerate(contacts_of(motion.analysis, motion.base)):
        colour = SHADES[number % len(SHADES)]
        inside = [(max(a, time[0]), min(b, time[-1]))
                  for a, b in contact_intervals(motion, contact) if b >= time[0] and a <= time[-1]]
        for a, b in inside if len(inside) <= MOST_SHADED else []:
            for axes in panels:
                axes.axvspan((a - start) / scale.factor, (b - start) / scale.factor, color=colour,
                             linewidth=0.3, zorder=0.5)
        if 0 < len(inside) <= MOST_SHADED:
            handles.append(Patch(color=colour, label=f"in contact, {contact}"))
    return handles


def title(motion: Motion) -> str:
    return ", ".join(filter(None, [motion.place.text, motion.direction]))
