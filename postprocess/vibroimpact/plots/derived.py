"""Derived quantities in a result file: fields, curves, bands and level lines over the axes that are
left of an analysis.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .layout import DIRECTION, kept
from .results import Analysis

BOUND = "bound"


@dataclass(frozen=True)
class Derived:
    """`dimensions`: axes of the analysis that are left, without the direction; `axis`: the axis
    whose coordinate the values are, or "" ; `pair`: the axes of level lines."""

    analysis: Analysis
    name: str
    values: np.ndarray
    unit: str
    all_dimensions: list[str]
    axis: str
    pair: tuple[str, ...]

    @property
    def dimensions(self) -> list[str]:
        return [name for name in self.all_dimensions
                if name in self.analysis.axes and name != DIRECTION]

    @property
    def is_band(self) -> bool:
        return self.all_dimensions[-1:] == [BOUND]

    @property
    def directions(self) -> list[str]:
        if DIRECTION not in self.all_dimensions:
            return [""]
        names = self.analysis.read(DIRECTION).values
        return [str(names[i]) for i in kept(self.analysis, DIRECTION)]

    def of_direction(self, direction: str) -> np.ndarray:
        """Values without the dimension of the direction; only the chosen points of the axes."""
        values = self.values
        for number, name in enumerate(self.all_dimensions):
            if name in self.dimensions:
                values = np.take(values, kept(self.analysis, name), axis=number)
        if direction:
            number = list(self.analysis.read(DIRECTION).values).index(direction)
            values = np.take(values, number, axis=self.all_dimensions.index(DIRECTION))
        return values

    @property
    def text(self) -> str:
        return self.analysis.symbol(self.name)


def derived_of(analysis: Analysis) -> list[Derived]:
    """All that can be drawn: single numbers are left out."""
    found = []
    for name in analysis.members("derived"):
        path = f"derived/{name}"
        if not analysis.has(path) or analysis.is_coordinate(path):
            continue
        attributes = analysis.attributes(path)
        array = analysis.read(path)
        if array.values.ndim:
            found.append(Derived(
                analysis, name, array.values, array.unit, analysis.dimensions(path),
                str(attributes.get("axis", "")), axes_attribute(attributes.get("axes", ""))))
    return found


def axes_attribute(value) -> tuple[str, ...]:
    """"first second" or an array of both."""
    return tuple(value.split()) if isinstance(value, str) else tuple(str(name) for name in value)


def coordinates(analysis: Analysis, axis: str) -> np.ndarray:
    return analysis.read(axis).values[kept(analysis, axis)]


def can_span(analysis: Analysis, axis: str, least: int = 3) -> bool:
    """Whether a map can have the axis: numbers that rise or fall throughout."""
    values = coordinates(analysis, axis)
    if values.dtype.kind != "f" or len(values) < least:
        return False
    steps = np.diff(values)
    return bool(np.all(steps > 0) or np.all(steps < 0))


def pair_of(entry: Derived) -> tuple[str, ...]:
    """The two axes of the plane in which a curve, band or level line lies; empty for others."""
    if len(entry.pair) == 2:
        return entry.pair
    known = len(entry.dimensions) == 1 and entry.axis in entry.analysis.axes
    return (entry.dimensions[0], entry.axis) if known else ()
