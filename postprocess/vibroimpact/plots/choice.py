"""The points of the outer axes that --at picks, and those that --highlight shows above the others."""

from __future__ import annotations

import math

import numpy as np

from .errors import ResultError
from .parameters_text import followers, number
from .results import Analysis


def choose(analysis: Analysis, requests: list[str]) -> None:
    """Enters the indices of the chosen points into the analysis; several requests for one axis narrow each other.
    Axes that it does not have are left to the other analyses."""
    for requested in requests:
        name, equals, values = requested.partition("=")
        if not equals or not values.strip():
            raise ResultError(f"--at {requested}: AXIS=VALUES is wanted")
        wanted = [value.strip() for value in values.split(",")]
        for axis in analysis.axes:
            indices = indices_at(analysis, axis, name.strip(), wanted)
            if indices is not None:
                before = analysis.chosen.get(axis, indices)
                analysis.chosen[axis] = [i for i in indices if i in before]
                if not analysis.chosen[axis]:
                    raise ResultError(f"--at {requested}: {analysis.name} has no such point of those chosen before")


def indices_at(analysis: Analysis, axis: str, name: str, wanted: list[str]) -> list[int] | None:
    """Where an axis, or a key that changes with it, has the wanted values; None where it is called otherwise."""
    if is_called(axis, name):
        every = analysis.read(axis).values  # which may hold a value twice, with other keys tied to it
        nearest = every[[index_of(analysis, axis, value) for value in wanted]]
        return [i for i, value in enumerate(every) if value in nearest]
    if axis not in analysis.grid_axes:
        return None
    key = analysis.grid[analysis.grid_axes.index(axis)]
    for path, texts in followers(analysis.parameters, analysis.name, key):
        if is_called(path.replace("/", "."), name):
            return [i for i, text in enumerate(texts)
                    if any(text == value or number(text, {}) == number(value, {}) is not None for value in wanted)]
    return None


def highlight(analysis: Analysis, requests: list[str]) -> None:
    """AXIS=VALUE, or AXIS=VALUE:NAME with what the legend adds; entered into the analysis as choose() does."""
    for requested in requests:
        point, _, name = requested.partition(":")
        axis, equals, value = point.partition("=")
        if not equals or not value.strip():
            raise ResultError(f"--highlight {requested}: AXIS=VALUE or AXIS=VALUE:NAME is wanted")
        for own in analysis.axes:
            if is_called(own, axis.strip()):
                analysis.highlighted[own] = index_of(analysis, own, value.strip()), name.strip()


def is_called(axis: str, name: str) -> bool:
    """By its full name or the last part of it, in any case."""
    names = (axis, axis.replace(".", "/"), axis.rsplit(".", 1)[-1])
    return name.lower() in [candidate.lower() for candidate in names]


def index_of(analysis: Analysis, axis: str, text: str) -> int:
    coordinate = analysis.read(axis)
    if coordinate.values.dtype.kind != "f":
        known = [str(value) for value in coordinate.values]
        if text not in known:
            raise ResultError(f"--at {axis}={text}: there are {', '.join(known)}")
        return known.index(text)
    value = number(text, {})
    if value is None:
        raise ResultError(f"--at {axis}={text}: not a number")
    if coordinate.unit == "Hz" and any(c.isalpha() for c in text.replace("e", "")):
        value /= 2 * math.pi  # units of frequencies are read as rad/s
    return int(np.nanargmin(np.abs(coordinate.values - value)))
