"""The points of the outer axes that --at picks, and those that --highlight shows above the others."""

from __future__ import annotations

import math

import numpy as np

from .errors import ResultError
from .parameters_text import number
from .results import Analysis


def choose(analysis: Analysis, requests: list[str]) -> None:
    """Enters the indices of the chosen points into the analysis; axes it does not have are left
    to the other analyses."""
    for requested in requests:
        name, equals, values = requested.partition("=")
        if not equals or not values.strip():
            raise ResultError(f"--at {requested}: AXIS=VALUES is wanted")
        for axis in analysis.axes:
            if is_called(axis, name.strip()):
                wanted = [index_of(analysis, axis, value.strip()) for value in values.split(",")]
                every = analysis.read(axis).values  # which may hold a value twice, with other keys tied to it
                analysis.chosen[axis] = [i for i, value in enumerate(every) if value in every[wanted]]


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
