"""Motion of the two points of a contact against each other: phase portraits from recorded
histories, and bifurcation diagrams from the sections at the end of each forcing period.
"""

from __future__ import annotations

import functools

from . import style
from .bifurcation import MOST_CASES, diagram
from .layout import layout_of
from .motions import Motion, bases
from .parameters_text import contact_sides, direction_of
from .portraits import finished, prepared, section_points
from .results import Analysis, Results
from .sections import sections_of


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    for first, second, axis in pairs(analysis):
        name = f"{second}-{first}-{axis}"
        for base in filter(None, bases(analysis)):
            if all(analysis.has(f"{base}point/{point}/{quantity}_{axis}")
                   for point in (first, second) for quantity in ("displacement", "velocity")):
                yield (f"{analysis.name}-relative-portrait-{name}",
                       functools.partial(portrait, analysis, base, first, second, axis))
        yield from diagrams(analysis, first, second, axis, name)


def pairs(analysis: Analysis) -> list[tuple[str, str, str]]:
    """First and second point of contacts, and the axis; two contacts may share them."""
    found = []
    for section in analysis.parameters:
        contact = section.removeprefix("Contact ")
        sides = contact_sides(analysis.parameters, contact) if contact != section else []
        direction = direction_of(analysis.parameters, contact)
        if len(sides) == 2 and direction is not None:
            found.append((sides[0], sides[1], direction[0]))
    return list(dict.fromkeys(found))


def diagrams(analysis: Analysis, first: str, second: str, axis: str, name: str):
    layout = layout_of(analysis)
    if layout.along is None or len(layout.cases()) > MOST_CASES:
        return
    quantity = f"displacement_{axis}"
    for section in sections_of(analysis):
        known = section.quantities(analysis, "displacement")
        if section.kind == "period" and {(first, quantity), (second, quantity)} <= set(known):
            for number, case in enumerate(layout.cases(), 1):
                suffix = f"-{number}" if layout.family else ""
                yield (f"{analysis.name}-relative-bifurcation-{name}{suffix}",
                       functools.partial(diagram, layout, section, (second, quantity, first, 1.0),
                                         case))


def portrait(analysis: Analysis, base: str, first: str, second: str, axis: str):
    """Orbits of the second point seen from the first one; dots: end of each forcing period."""
    root = base.removesuffix("history/")
    periods = [section for section in sections_of(analysis, root) if section.kind == "period"]
    figure, panels, draw = prepared(
        analysis, axis, [f"{base}point/{first}", f"{base}point/{second}"])
    for axes, place in panels:
        for number, direction in enumerate(layout_of(analysis).directions):
            motion = Motion(analysis, base, place, direction)
            x, y = (motion.signal(f"point/{second}/{quantity}_{axis}")
                    - motion.signal(f"point/{first}/{quantity}_{axis}")
                    for quantity in ("displacement", "velocity"))
            draw(axes, x, y, color=style.COLOURS[number], linestyle="-" if number == 0 else "--",
                 linewidth=0.7)
            for section in periods:
                points = [section_points(analysis, section, point, axis, place, direction)
                          for point in (first, second)]
                draw(axes, points[1][0] - points[0][0], points[1][1] - points[0][1], marker="o",
                     linestyle="", color="black", markeredgewidth=0, markersize=2.2, zorder=4)
    return finished(figure, panels, analysis, f"{second} less {first}", bool(periods))
