"""Primitives of mechanical sketches, as SVG: masses, springs, dashpots, ground, clearances, arrows.

Lengths are in pixels, x to the right and y downwards; a point is a pair of numbers. Symbols are written as
in "k_1 (x_1 - x_0)": single letters are slanted, what follows an underscore (one character, or several in
braces) is a subscript.
"""

from __future__ import annotations

import math
import re
from html import escape

INK = "#1a1a1a"
PALE = "#c3c9d1"
BODY = "#dbe4ee"
CONTACT = "#b3362c"
MOTION = "#1f5f99"
FONT = "STIX Two Text, Times New Roman, Times, Liberation Serif, serif"
SIZE = 17
MARGIN = 12
LINE = 1.6


def along(start, end):
    """The unit vector from start to end, the one across it (to its right), and the distance."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.hypot(dx, dy)
    return (dx / length, dy / length), (-dy / length, dx / length), length


def place(origin, direction, across, s, t):
    return (origin[0] + s * direction[0] + t * across[0], origin[1] + s * direction[1] + t * across[1])


class Sketch:
    """Collects shapes and knows how much room they take."""

    def __init__(self, description: str):
        self.description = description
        self.elements: list[str] = []
        self.corners = [math.inf, math.inf, -math.inf, -math.inf]

    def reach(self, *points) -> None:
        for x, y in points:
            left, top, right, bottom = self.corners
            self.corners = [min(left, x), min(top, y), max(right, x), max(bottom, y)]

    # Lines -------------------------------------------------------------------------------------------

    def path(self, points, colour=INK, width=LINE, closed=False, fill="none", dashes="") -> None:
        self.reach(*points)
        text = "M" + " L".join(f"{x:.1f},{y:.1f}" for x, y in points) + ("Z" if closed else "")
        style = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.elements.append(f'<path d="{text}" fill="{fill}" stroke="{colour}" stroke-width="{width}"'
                             f' stroke-linejoin="round"{style}/>')

    def line(self, start, end, **style) -> None:
        self.path([start, end], **style)

    def curve(self, function, start: float, end: float, **style) -> None:
        """The points function(s) for s from start to end."""
        self.path([function(start + (end - start) * i / 40) for i in range(41)], **style)

    def circle(self, centre, radius: float, colour=INK, fill=BODY, width=LINE, dashes="") -> None:
        x, y = centre
        self.reach((x - radius, y - radius), (x + radius, y + radius))
        style = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.elements.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{fill}" stroke="{colour}"'
                             f' stroke-width="{width}"{style}/>')

    def arrow(self, start, end, colour=MOTION, both=False, width=LINE) -> None:
        self.line(start, end, colour=colour, width=width)
        self.arrow_head(start, end, colour)
        if both:
            self.arrow_head(end, start, colour)

    def arrow_head(self, start, end, colour) -> None:
        direction, across, _ = along(start, end)
        wings = [place(end, direction, across, -9, side) for side in (-3.5, 3.5)]
        self.path([wings[0], end, wings[1]], colour=colour, fill=colour, closed=True, width=0.5)

    def coordinate(self, start, end, zero, centre, name, anchor="start") -> None:
        """An arrow from a thin line between the two places `zero`, and its name."""
        self.arrow(start, end)
        self.line(*zero, colour=MOTION, width=0.8)
        self.symbol(centre, name, colour=MOTION, anchor=anchor)

    # Parts of machines -------------------------------------------------------------------------------

    def ground(self, start, end) -> None:
        """A line that does not move, hatched on its right as seen from start to end."""
        direction, across, length = along(start, end)
        self.line(start, end, width=2)
        steps = max(2, round(length / 9))
        for i in range(steps):
            foot = place(start, direction, across, length * (i + 0.7) / steps, 0)
            self.line(foot, place(foot, direction, across, -7, 9), width=1)

    def mass(self, centre, width, height, symbol="", fill=BODY) -> None:
        x, y = centre
        box = [(x - width / 2, y - height / 2), (x + width / 2, y - height / 2),
               (x + width / 2, y + height / 2), (x - width / 2, y + height / 2)]
        self.path(box, closed=True, fill=fill)
        if symbol:
            self.symbol(centre, symbol)

    def spring(self, start, end, symbol="", side=1, coils=5, colour=INK, half_width=8) -> None:
        direction, across, length = along(start, end)
        lead = 0.17 * length
        step = (length - 2 * lead) / (2 * coils)
        points = [start, place(start, direction, across, lead, 0)]
        points += [place(start, direction, across, lead + (i + 0.5) * step,
                         half_width if i % 2 else -half_width) for i in range(2 * coils)]
        points += [place(start, direction, across, length - lead, 0), end]
        self.path(points, colour=colour)
        self.beside(start, end, symbol, side * (half_width + 8), colour)

    def dashpot(self, start, end, symbol="", side=1, colour=INK, half_width=8) -> None:
        direction, across, length = along(start, end)
        def at(s, t):
            return place(start, direction, across, s * length, t)
        bottom, piston, rim = 0.38, 0.5, 0.64
        self.line(start, at(bottom, 0), colour=colour)
        self.path([at(rim, -half_width), at(bottom, -half_width), at(bottom, half_width),
                   at(rim, half_width)], colour=colour)
        self.line(at(piston, -half_width + 2), at(piston, half_width - 2), colour=colour, width=2.4)
        self.line(at(piston, 0), end, colour=colour)
        self.beside(start, end, symbol, side * (half_width + 8), colour)

    def stop(self, start, end, half_width, springs, side=1) -> None:
        """A contact face at `end` on a spring and a dashpot, from `start`. springs: their two symbols; the
        second may be missing: the spring alone, in the middle."""
        direction, across, _ = along(start, end)
        self.line(place(end, direction, across, 0, -half_width), place(end, direction, across, 0, half_width),
                  colour=CONTACT, width=3)
        places = (-half_width * 0.62, half_width * 0.62) if len(springs) == 2 else (0,)
        for shape, symbol, t in zip((self.spring, self.dashpot), springs, places):
            outwards = -1 if t < 0 else 1
            shape(place(start, direction, across, 0, t), place(end, direction, across, 0, t), symbol,
                  side=outwards * (1 if len(springs) == 2 else side), colour=CONTACT, half_width=6)

    def clearance(self, start, end, symbol, offset=0, side=1) -> None:
        """A length between two points, drawn `offset` to the right of the line through them."""
        direction, across, length = along(start, end)
        a, b = (place(p, direction, across, 0, offset) for p in (start, end))
        for foot, head in ((start, a), (end, b)):
            if offset:
                past = place(head, direction, across, 0, math.copysign(4, offset))
                self.line(foot, past, width=0.7, colour="#777777")
        if length < 26:  # from outside
            self.arrow(place(a, direction, across, -20, 0), a, colour=INK, width=1)
            self.arrow(place(b, direction, across, 20, 0), b, colour=INK, width=1)
        else:
            self.arrow(a, b, colour=INK, both=True, width=1)
        self.beside(a, b, symbol, side * 10, INK)

    # Text --------------------------------------------------------------------------------------------

    def beside(self, start, end, symbol, distance, colour) -> None:
        """The symbol beside the middle of a line, to its right where the distance is positive."""
        if not symbol:
            return
        direction, across, length = along(start, end)
        x, y = place(start, direction, across, length / 2, distance)
        sideways = across[0] * math.copysign(1, distance)
        anchor = "middle" if abs(sideways) < 0.5 else "start" if sideways > 0 else "end"
        lift = 0 if anchor != "middle" else 5 * across[1] * math.copysign(1, distance)
        self.symbol((x, y + lift), symbol, colour=colour, anchor=anchor)

    def symbol(self, centre, text, colour=INK, anchor="middle", size=SIZE) -> None:
        self.text(centre, symbols_as_svg(text, size), colour, anchor, size, plain_length(text))

    def words(self, centre, text, colour=INK, anchor="middle", size=14) -> None:
        self.text(centre, escape(text), colour, anchor, size, len(text))

    def text(self, centre, content, colour, anchor, size, letters) -> None:
        x, y = centre
        width = 0.5 * size * letters
        left = {"start": x, "middle": x - width / 2, "end": x - width}[anchor]
        self.reach((left, y - 0.6 * size), (left + width, y + 0.6 * size))
        self.elements.append(f'<text x="{x:.1f}" y="{y + 0.32 * size:.1f}" text-anchor="{anchor}" fill="{colour}"'
                             f' font-size="{size}">{content}</text>')

    def as_svg(self) -> str:
        left, top, right, bottom = self.corners
        x, y = math.floor(left - MARGIN), math.floor(top - MARGIN)
        width, height = math.ceil(right + MARGIN) - x, math.ceil(bottom + MARGIN) - y
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{x} {y} {width} {height}" width="{width}"'
                f' height="{height}" role="img" font-family="{FONT}">\n<title>{escape(self.description)}</title>\n'
                f'<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="white"/>\n')
        return head + "\n".join(self.elements) + "\n</svg>\n"


SUBSCRIPT = re.compile(r"_(\{[^}]*\}|.)")


def plain_length(text: str) -> float:
    """In letters; a letter of a subscript is smaller."""
    below = sum(len(match.strip("{}")) for match in SUBSCRIPT.findall(text))
    return len(SUBSCRIPT.sub("", text)) + 0.7 * below


def symbols_as_svg(text: str, size: float) -> str:
    pieces, drop = [], 0.25 * size
    for part in re.split(r"(_\{[^}]*\}|_.)", text):
        if part.startswith("_"):
            below = part[1:].strip("{}")
            pieces.append(f'<tspan dy="{drop:.1f}" font-size="{0.7 * size:.1f}">{slanted(below)}</tspan>'
                          f'<tspan dy="{-drop:.1f}">&#8203;</tspan>')
        elif part:
            pieces.append(slanted(part))
    return "".join(pieces)


def slanted(text: str) -> str:
    """Letters are variables; the names of functions are upright."""
    words = re.split(r"(sin|cos|[^\W\d_])", text)  # every second one is a letter or a function
    return "".join(f'<tspan font-style="italic">{word}</tspan>' if i % 2 and len(word) == 1 else escape(word)
                   for i, word in enumerate(words))
