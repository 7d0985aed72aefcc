"""Time histories of recorded motions: points, contacts, rotors, connections; contacts shaded."""

from __future__ import annotations

import functools

from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from . import envelopes, friction, style
from .axis_meaning import Meaning, Panel, note
from .labels import Scale, quantity_label, scale_for, with_unit
from .layout import layout_of, place_of, places
from .motions import Motion, bases, contact_intervals, contacts_of, is_always_closed, parts
from .results import Analysis, Results

MOST = 3  # points of an analysis whose histories are drawn, unless points are chosen
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
        _, name, quantity = path.removeprefix(base).split("/", 2)
        if quantity in ("gap", "normal_force") and not parts(analysis, base, name):
            continue  # two constants
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
    colours = colours_of(motion, [path for paths in rows.values() for path in paths])
    for axes, paths in zip(panels, rows.values()):
        shown = draw_row(axes, motion, paths, (time - start) / scale.factor, recent, colours)
        note(axes, Panel(
            Meaning(("time",), "s", scale, start=start),
            Meaning(tuple(motion.base + path for path in paths), motion.unit(paths[0]), shown),
            place=place_of(motion.analysis, motion.place)))
    handles = [Line2D([], [], color=colour, label=name) for name, colour in colours.items()]
    handles += shade(panels, motion, time, start, scale)
    panels[0].set_title(title(motion))
    panels[-1].set_xlabel(scale.label(f"Time from {with_unit(f'{start:.5g}', 's')} on" if start else "Time"))
    style.legend_beside(panels[0], handles)
    return figure


def owner(path: str) -> str:
    """"first.mass" of point/first.mass/displacement_x."""
    return path.split("/")[1]


def colours_of(motion: Motion, paths: list[str]) -> dict[str, str]:
    """Of the owners of the paths; a contact has the colour of its shade."""
    contacts = contacts_of(motion.analysis, motion.base)
    owners = list(dict.fromkeys((path.split("/")[0], owner(path)) for path in paths))
    others = [name for group, name in owners if group != "contact"]
    return {name: style.contact_colour(contacts.index(name), len(contacts)) if group == "contact"
            else style.POINT_COLOURS[others.index(name) % len(style.POINT_COLOURS)]
            for group, name in owners}


def draw_row(axes, motion: Motion, paths, time, recent, colours) -> Scale:
    signals = [motion.signal(path)[recent] for path in paths]
    scale = scale_for(motion.unit(paths[0]), *signals)
    for path, signal in zip(paths, signals):
        at = time
        gap, rate = path.replace("normal_force", "gap"), path.replace("friction_force", "slip_rate")
        if gap != path and motion.has(gap):
            at, signal, _ = envelopes.with_jumps(time, signal, motion.signal(gap)[recent])
        if rate != path and motion.has(rate):
            at, signal = friction.with_jumps(time, signal, motion.signal(rate)[recent])
        envelopes.draw(axes, at, signal / scale.factor, color=colours[owner(path)])
    quantity = paths[0].split("/")[2:]
    label = "contact force" if quantity == ["normal_force"] else quantity_label(quantity[-1])
    axes.set_ylabel(scale.label(label[0].upper() + label[1:]))
    axes.margins(x=0)
    return scale


def shade(panels, motion: Motion, time, start: float, scale) -> list[Patch]:
    """Background of the intervals in contact, but of contacts that never part, and darker of those in which the sides
    stick; gives the legend entries."""
    handles = []
    contacts = contacts_of(motion.analysis, motion.base)
    for number, contact in enumerate(contacts):
        shown = []
        if not friction.slides(motion, contact) or not is_always_closed(motion, contact):
            shown.append(("in contact", style.SHADE, contact_intervals(motion, contact)))
        if friction.slides(motion, contact):
            shown.append(("sticks", style.DARK_SHADE if shown else style.SHADE, friction.stick_intervals(motion, contact)))
        for text, opacity, intervals in shown:
            look = dict(color=style.contact_colour(number, len(contacts)), alpha=opacity, linewidth=0)
            inside = [(max(a, time[0]), min(b, time[-1])) for a, b in intervals if b >= time[0] and a <= time[-1]]
            for a, b in inside if len(inside) <= MOST_SHADED else []:
                for axes in panels:
                    axes.axvspan((a - start) / scale.factor, (b - start) / scale.factor, zorder=0.5, **look)
            if 0 < len(inside) <= MOST_SHADED:
                handles.append(Patch(label=f"{text}, {contact}", **look))
    return handles


def title(motion: Motion) -> str:
    return ", ".join(filter(None, [motion.place.text, motion.direction]))
