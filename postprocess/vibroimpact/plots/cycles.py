"""Force-displacement cycles: contact force over penetration, and over the displacement of a point."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D

from . import envelopes, style
from .labels import scale_for
from .layout import layout_of, places
from .motions import Motion, bases, contacts_of, finely_sampled, parts
from .parameters_text import contact_sides, direction_of
from .results import Analysis, Results


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it; nothing where samples are too far apart."""
    for base in bases(analysis)[:1]:
        contacts = [contact for contact in contacts_of(analysis, base)
                    if all(analysis.has(f"{base}contact/{contact}/{name}")
                           for name in ("normal_force", "gap"))
                    and parts(analysis, base, contact) and shown(analysis, base, contact)]
        for contact in contacts:
            yield (f"{analysis.name}-cycle-{contact}",
                   functools.partial(over_penetration, analysis, base, contact))
        for point, axis in pressed_points(analysis, base, contacts):
            yield (f"{analysis.name}-force-displacement-{point}-{axis}",
                   functools.partial(over_displacement, analysis, base, contacts, point, axis))


def shown(analysis: Analysis, base: str, contact: str) -> bool:
    """Whether any of the motions has contacts that are finely sampled."""
    return any(finely_sampled(motion, contact)
               for _, directions in motions(analysis, base) for motion in directions)


def pressed_points(analysis: Analysis, base: str, contacts) -> list[tuple[str, str]]:
    """First sides of contacts along an axis whose displacement there is sampled."""
    found = {}
    for contact in contacts:
        direction = direction_of(analysis.parameters, contact)
        sides = contact_sides(analysis.parameters, contact)
        if direction and sides and analysis.has(
                f"{base}point/{sides[0]}/displacement_{direction[0]}"):
            found[sides[0], direction[0]] = None
    return list(found)


def motions(analysis: Analysis, base: str):
    """For every panel its title and the motions of all directions."""
    for place in places(analysis):
        yield place.text, [Motion(analysis, base, place, direction)
                           for direction in layout_of(analysis).directions]


def fine_motions(analysis: Analysis, base: str, contacts):
    """Those that show the course of one of the contacts."""
    for text, directions in motions(analysis, base):
        fine = [motion if any(finely_sampled(motion, contact) for contact in contacts) else None
                for motion in directions]
        if any(fine):
            yield text, fine


def over_penetration(analysis: Analysis, base: str, contact: str):
    def curve(motion):
        gap = motion.signal(f"contact/{contact}/gap")
        force = motion.signal(f"contact/{contact}/normal_force")
        _, force, gap = envelopes.with_jumps(motion.time(), force, gap)
        # One sample on either side closes the cycle; what lies between contacts is left out.
        closed = (np.abs(force) > 0) | (gap < 0)
        near = closed | np.roll(closed, 1) | np.roll(closed, -1)
        return np.where(near, -gap, np.nan), np.where(near, force, np.nan)

    figure = cycles(fine_motions(analysis, base, [contact]), curve, "Penetration",
                             "Contact force")
    figure.suptitle(f"Contact {contact}", x=0.01, ha="left", fontsize=10)
    return figure


def over_displacement(analysis: Analysis, base: str, contacts, point: str, axis: str):
    """Sum of all contact forces that the point exerts along the axis."""
    pressing = {contact: sign for contact in contacts if (sign := sign_of(analysis, contact, point, axis))}

    def curve(motion):
        signals = [motion.time(), motion.signal(f"point/{point}/displacement_{axis}")]
        for contact in pressing:
            signals += [motion.signal(f"contact/{contact}/{name}") for name in ("normal_force", "gap")]
        for k in range(2, len(signals), 2):
            rest = [j for j in range(1, len(signals)) if j not in (k, k + 1)]
            places = [0, k, k + 1, *rest]
            made = envelopes.with_jumps(*[signals[j] for j in places])
            signals = [made[places.index(j)] for j in range(len(signals))]
        return signals[1], sum(sign * force for sign, force in zip(pressing.values(), signals[2::2]))

    figure = cycles(fine_motions(analysis, base, contacts), curve, f"Displacement ${axis}$",
                       f"Contact force along ${axis}$")
    figure.suptitle(f"Force of {point} on its contacts", x=0.01, ha="left", fontsize=10)
    return figure


def sign_of(analysis: Analysis, contact: str, point: str, axis: str) -> int:
    """Of the force that the point exerts along the axis; 0 where it has no part in the contact."""
    direction = direction_of(analysis.parameters, contact)
    sides = contact_sides(analysis.parameters, contact)
    if not direction or direction[0] != axis or point not in sides:
        return 0
    return direction[1] if sides[0] == point else -direction[1]


def cycles(entries, curve, x_label: str, y_label: str):
    """A panel for each entry: title and a motion or None for each direction."""
    entries = list(entries)
    figure, panels = style.panel_grid(len(entries))
    curves = [[curve(motion) if motion else None for motion in directions]
              for _, directions in entries]
    drawn = [pair for panel in curves for pair in panel if pair]
    x_scale = scale_for("m", *[x for x, _ in drawn])
    y_scale = scale_for("N", *[y for _, y in drawn])
    for axes, (text, _), panel in zip(panels, entries, curves):
        for number, pair in enumerate(panel):
            if pair:
                axes.plot(pair[0] / x_scale.factor, pair[1] / y_scale.factor,
                          color=style.COLOURS[number], linestyle=style.DIRECTION_LINES[number])
        style.panel_title(axes, text, panels)
    style.label_grid(panels, x_scale.label(x_label), y_scale.label(y_label))
    motion = next(motion for _, directions in entries for motion in directions if motion)
    style.legend_beside(style.upper_right(panels), direction_handles(motion.analysis))
    return figure


def direction_handles(analysis: Analysis) -> list[Line2D]:
    """Legend entries where both directions are in a panel."""
    names = layout_of(analysis).directions
    return [Line2D([], [], color=style.COLOURS[i], linestyle=style.DIRECTION_LINES[i], label=name)
            for i, name in enumerate(names)] if len(names) > 1 else []
