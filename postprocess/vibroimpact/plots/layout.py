"""How the points of an analysis become curves: the axis along which they run, both directions of a
sweep, and the family of the other axes.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from . import style
from .axis_meaning import Meaning
from .labels import Scale, key_label, powers_of_ten, scale_for, value_text
from .parameters_text import followers
from .results import Analysis, Array

LARGEST_FAMILY = 40
MOST_SHOWN = 6
DIRECTION = "direction"


@dataclass(frozen=True)
class Case:
    """One member of a family: its index by the names of its axes, colour and description."""

    index: dict
    colour: object
    text: str


@dataclass(frozen=True)
class Layout:
    """`along` is None when no numerical axis has two points. It may be a dimension of the fields
    themselves: the frequency of a frequency response."""

    analysis: Analysis
    along: str | None
    family: list[str]

    @property
    def directions(self) -> list[str]:
        if DIRECTION not in self.analysis.axes:
            return [""]
        names = self.analysis.read(DIRECTION).values
        return [str(names[i]) for i in kept(self.analysis, DIRECTION)]

    def cases(self) -> list[Case]:
        indices = list(itertools.product(*[kept(self.analysis, name) for name in self.family]))
        members = [dict(zip(self.family, index)) for index in indices]
        texts = distinct([describe(self.analysis, member) for member in members])
        names = [self.highlight(member) for member in members]
        colours = style.colours_along(len(indices), behind=any(name is not None for name in names))
        return [Case(member, colour, text) if name is None else
                Case(member, style.HIGHLIGHT, ", ".join(filter(None, [text, name])))
                for member, colour, text, name in zip(members, colours, texts, names)]

    def highlight(self, member: dict) -> str | None:
        """What the legend adds to a highlighted member; None for the others."""
        wanted = {axis: entry for axis, entry in self.analysis.highlighted.items() if axis in member}
        if not wanted or any(member[axis] != index for axis, (index, _) in wanted.items()):
            return None
        return ", ".join(name for _, name in wanted.values() if name)

    @property
    def family_name(self) -> str:
        return ", ".join(axis_name(self.analysis, name) for name in self.family)

    @property
    def scale(self):
        """Of the coordinates along the axis."""
        return axis_scale(self.analysis, self.along)

    def coordinates(self) -> np.ndarray:
        return self.analysis.read(self.along).values[kept(self.analysis, self.along)]

    def curve(self, path: str, case: Case, direction: str) -> np.ndarray:
        """Values along the axis in SI; further dimensions of the field follow."""
        return self.pick(self.analysis.read(path).values, case, direction)

    def pick(self, values: np.ndarray, case: Case, direction: str) -> np.ndarray:
        index = []
        for name in self.analysis.axes:
            if name == self.along:
                index.append(kept(self.analysis, name))
            elif name == DIRECTION:
                index.append(list(self.analysis.read(DIRECTION).values).index(direction))
            else:
                index.append(case.index.get(name, kept(self.analysis, name)[0]))
        own = [] if self.along in self.analysis.axes else [kept(self.analysis, self.along)]
        return values[tuple(index + own)]


def place_of(analysis: Analysis, place: Place) -> list[tuple[Meaning, float]]:
    """The numbers of a point along the axes, for rows of a table that belong to it."""
    found = []
    for name, number in place.index.items():
        axis = analysis.read(name)
        if axis.values.dtype.kind == "f":
            found.append((Meaning(names_of(analysis, name), axis.unit, Scale(1.0, "")),
                          float(axis.values[number])))
    return found


def names_of(analysis: Analysis, axis: str) -> tuple[str, ...]:
    return (axis, *([grid_key(analysis, axis)] if axis in analysis.grid_axes else []))


def family_of(layout: Layout) -> list[tuple[Meaning, dict]]:
    """Colours of the values of a family over one axis, for points that are drawn over it."""
    if len(layout.family) != 1:
        return []
    name = layout.family[0]
    axis = layout.analysis.read(name)
    known = {axis.values[case.index[name]]: case.colour for case in layout.cases()}
    return [(Meaning(names_of(layout.analysis, name), axis.unit, axis_scale(layout.analysis, name)), known)]


def kept(analysis: Analysis, axis: str) -> list[int]:
    """Indices along an outer axis that are drawn: all, unless some were chosen."""
    return analysis.chosen.get(axis) or list(range(len(analysis.read(axis).values)))


def layout_of(analysis: Analysis) -> Layout:
    """Curves run along the swept axis of a sweep, or the frequency of a frequency response; else
    along the longest numerical grid axis."""
    long = [name for name in analysis.axes if name != DIRECTION and len(kept(analysis, name)) > 1]
    numerical = [name for name in long if analysis.read(name).values.dtype.kind == "f"]
    if analysis.type == "frequency response":
        return Layout(analysis, "frequency", long)
    own = [name for name in numerical if name not in analysis.grid_axes]
    longest = sorted(numerical, key=lambda name: -len(kept(analysis, name)))
    along = next(iter(own + longest), None)
    return Layout(analysis, along, [name for name in long if name != along])


def distinct(texts: list[str]) -> list[str]:
    """Numbers behind texts that occur more than once."""
    return [f"{text} ({texts[:i + 1].count(text)})" if texts.count(text) > 1 else text
            for i, text in enumerate(texts)]


def grid_key(analysis: Analysis, axis: str) -> str:
    """Path of the key behind a grid axis."""
    return analysis.grid[analysis.grid_axes.index(axis)]


def following(analysis: Analysis, axis: str) -> list[tuple[str, list[str]]]:
    """Keys that change together with a grid axis and take more than one value."""
    if axis not in analysis.grid_axes:
        return []
    keys = followers(analysis.parameters, analysis.name, grid_key(analysis, axis))
    return [(path, values) for path, values in keys if len(set(values)) > 1]


def axis_name(analysis: Analysis, axis: str) -> str:
    """Name of a key without its sections; with the keys that follow it when one of them is needed
    to tell the values apart."""
    if axis in analysis.shown:
        return analysis.shown[axis][1]
    if axis not in analysis.grid_axes:
        return "Frequency" if axis == "frequency" else key_label(axis.replace(".", "/"))
    names = [grid_key(analysis, axis)]
    if repeats(analysis, axis):
        names += [path for path, _ in following(analysis, axis)]
    return ", ".join(key_label(name) for name in names)


def repeats(analysis: Analysis, axis: str) -> bool:
    values = list(analysis.read(axis).values[kept(analysis, axis)])
    return len(set(values)) < len(values)


def describe(analysis: Analysis, index: dict) -> str:
    """The coordinates of a point in words: "3 mm, 2.4 Hz"."""
    parts = []
    for axis, number in index.items():
        coordinate = analysis.read(axis)
        parts.append(point_text(analysis, axis, coordinate.values[number]))
        if repeats(analysis, axis):
            parts += [powers_of_ten(values[number]) for _, values in following(analysis, axis)]
    return ", ".join(parts)


def point_text(analysis: Analysis, axis: str, value) -> str:
    """Zero in the unit of the others: "0 mm"."""
    if isinstance(value, str) or value != 0:
        return value_text(value, analysis.read(axis).unit)
    return f"0 {axis_scale(analysis, axis).unit}".strip()


def title_of(analysis: Analysis, index: dict) -> str:
    """As a title: "Clearance = 3 mm, Frequency = 2.4 Hz"."""
    parts = []
    for axis in index:
        if len(analysis.read(axis).values) > 1:
            parts.append(f"{axis_name(analysis, axis)} = {describe(analysis, {axis: index[axis]})}")
    return ", ".join(parts)


@dataclass(frozen=True)
class Place:
    """A point whose motion is drawn by itself: index by axis, without the direction of a sweep."""

    index: dict
    text: str

    def pick(self, analysis: Analysis, array: Array, direction: str) -> np.ndarray:
        """Values at the point; a coordinate that all points share has no outer axes."""
        if array.values.ndim <= 1 and analysis.axes:
            return array.values
        where = []
        for name in analysis.axes:
            if name == DIRECTION:
                where.append(list(analysis.read(DIRECTION).values).index(direction))
            else:
                where.append(self.index[name])
        return array.values[tuple(where)]


def places(analysis: Analysis, most: int = MOST_SHOWN) -> list[Place]:
    """Finished points to be drawn by themselves, at most `most` of all, spread evenly; those that
    were chosen are drawn all."""
    axes = [name for name in analysis.axes if name != DIRECTION]
    finished = finished_points(analysis)
    points = [point for point in itertools.product(*[kept(analysis, name) for name in axes])
              if finished[point]]
    if not analysis.chosen:
        points = thinned(points, most)
    return [Place(dict(zip(axes, point)), title_of(analysis, dict(zip(axes, point))))
            for point in points]


def finished_points(analysis: Analysis) -> np.ndarray:
    """Whether a point was computed, in one direction at least."""
    finished = analysis.read("status").values == 0
    if DIRECTION in analysis.axes:
        return np.any(finished, axis=analysis.axes.index(DIRECTION))
    return finished


def thinned(indices: list, most: int) -> list:
    if len(indices) <= most:
        return indices
    return [indices[round(i * (len(indices) - 1) / (most - 1))] for i in range(most)]


def axis_scale(analysis: Analysis, axis: str):
    """Scale of the coordinates of an outer axis."""
    if axis in analysis.shown:
        return analysis.shown[axis][0]
    array = analysis.read(axis)
    return scale_for(array.unit, array.values[kept(analysis, axis)])
