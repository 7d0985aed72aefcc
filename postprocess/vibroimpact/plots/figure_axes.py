"""The axes of a section "Figure" of the parameters: what runs along each of them, divided by what, and
how it is called.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace

import numpy as np

from . import style
from .choice import is_called
from .errors import ResultError
from .labels import Scale, quantity_label, scale_for
from .layout import axis_name
from .parameters_text import number
from .results import Analysis, Results


@dataclass(frozen=True)
class Quantity:
    """Values in SI over named dimensions; `path` as in the result file."""

    path: str
    dimensions: list[str]
    values: np.ndarray
    unit: str
    label: str

    @property
    def is_coordinate(self) -> bool:
        return self.dimensions == [self.path.rsplit("/", 1)[-1]]


@dataclass(frozen=True)
class FigureAxis:
    """One axis of a figure: divide by `scale.factor`, call it `label`."""

    quantity: str
    scale: Scale
    label: str
    logarithmic: bool
    range: list[float]
    marks: list[tuple[str, float]]
    by_own: bool = False  # each curve is divided by its own largest value

    def of(self, values: np.ndarray) -> np.ndarray:
        """Of one curve, in the numbers at the axis."""
        return values / (np.nanmax(np.abs(values)) if self.by_own else self.scale.factor)

    def apply(self, axes, letter: str) -> None:
        axes.set(**{f"{letter}label": self.scale.label(self.label)})
        if self.logarithmic:
            axes.set(**{f"{letter}scale": "log"})
            style.label_between_decades(getattr(axes, f"{letter}axis"))
        if self.range:
            axes.set(**{f"{letter}lim": self.range})


def plain(label: str) -> str:
    r"""eta_a of $\eta_{a}$."""
    return "".join(letter for letter in label if letter not in "$\\{} ").strip()


def find(analysis: Analysis, name: str) -> Quantity:
    """One quantity, or a sum such as "- left/gap/minimum - right/gap/minimum"; a term over fewer axes, such as an axis
    itself, is the same along the others."""
    terms = re.findall(r"(?:^|\s)([-+]?)\s*(\S+)", name)
    found = [single(analysis, term) for _, term in terms]
    if [sign for sign, _ in terms] == [""]:
        return found[0]
    largest = max(found, key=lambda term: len(term.dimensions))
    if any(not set(term.dimensions) <= set(largest.dimensions) for term in found):
        raise ResultError(f"{name}: these run over different axes")
    values = sum((-1.0 if sign == "-" else 1.0) * over(term, largest.dimensions)
                 for (sign, _), term in zip(terms, found))
    return Quantity(largest.path, largest.dimensions, values, largest.unit, name)


def over(term: Quantity, dimensions: list[str]) -> np.ndarray:
    """Its values with a length of 1 along the dimensions that it does not have."""
    order = [term.dimensions.index(name) for name in dimensions if name in term.dimensions]
    sizes = iter(np.transpose(term.values, order).shape)
    return np.transpose(term.values, order).reshape(
        [next(sizes) if name in term.dimensions else 1 for name in dimensions])


def single(analysis: Analysis, name: str) -> Quantity:
    """A derived quantity, a field, or an axis by its full name or the last part of it. Times of a
    history count from its beginning."""
    for path in (f"derived/{name}", name):
        if analysis.has(path):
            array = analysis.read(path)
            if path.endswith("history_time"):
                array.values = array.values - array.values[..., :1]
            own = path in analysis.axes or analysis.is_coordinate(path)
            return Quantity(path, [path.rsplit("/", 1)[-1]] if own
                            else analysis.dimensions(path), array.values,
                            array.unit, axis_name(analysis, path) if own
                            else label_of(analysis, path))
    for axis in analysis.axes:
        if is_called(axis, name):
            array = analysis.read(axis)
            return Quantity(axis, [axis], array.values, array.unit, axis_name(analysis, axis))
    raise ResultError(f"the analysis {analysis.name} has no quantity {name}")


def has_axes(analysis: Analysis, section: dict) -> bool:
    """Has it the quantities of a figure of curves?"""
    try:
        for axis in ("Horizontal", "Vertical"):
            find(analysis, section[axis]["Quantity"].split(",")[0])
    except ResultError:
        return False
    return not section.get("Colour", {}).get("Quantity", "")


def label_of(analysis: Analysis, path: str) -> str:
    if path.startswith("derived/"):
        return analysis.symbol(path.removeprefix("derived/"))
    parts = path.rsplit("/", 2)
    return ", ".join([quantity_label(parts[-2]), *[p.replace("_", " ") for p in parts[-1:]]]) \
        if len(parts) > 1 else quantity_label(path)


def read_axis(results: Results, section: dict, analyses: list[Analysis]) -> FigureAxis | None:
    """`analyses`: those whose values are drawn; None for an axis that the section does not have."""
    name = section.get("Quantity", "")
    if not name:
        return None
    quantities = [find(analysis, name) for analysis in analyses]
    scale = divisor(results, section, name, quantities[0].unit) or scale_for(
        quantities[0].unit, *[quantity.values for quantity in quantities])
    return FigureAxis(
        name, scale, section.get("Label", "") or quantities[0].label,
        section.get("Scale", "") == "logarithmic",
        numbers(section.get("Range", ""), results.parameters),
        marks(section.get("Marks", ""), results.parameters),
        section.get("Divide by largest of", "") == analyses[0].name)


def together(axes: list[FigureAxis], analysis: Analysis) -> list[FigureAxis]:
    """Several quantities at one axis: with one prefix, and a label that says what all have in common; the
    legend has the name of each."""
    found = [find(analysis, axis.quantity) for axis in axes]
    labels = list(dict.fromkeys(axis.label for axis in axes))
    label = labels[0] if len(labels) == 1 else common_label([entry.label for entry in found])
    same = all(axis.scale.unit for axis in axes) and len({entry.unit for entry in found}) == 1
    scale = scale_for(found[0].unit, *[entry.values for entry in found]) if same else None
    return [replace(axis, label=label, scale=scale or axis.scale) for axis in axes]


def common_label(labels: list[str]) -> str:
    """The parts between commas that all have; empty where there are none."""
    parts = [label.split(", ") for label in labels]
    return ", ".join(part for part in parts[0] if all(part in other for other in parts))


def divisor(results: Results, section: dict, name: str, unit: str) -> Scale | None:
    """In the unit of the result file, where frequencies are in hertz."""
    if section.get("Divide by", ""):
        value = number(section["Divide by"], results.parameters)
        if value is None:
            raise ResultError(f"Divide by = {section['Divide by']}: not a number")
        return Scale(value / (2 * math.pi if unit == "Hz" else 1.0), "")
    if section.get("Divide by largest of", ""):
        other = results.analysis(section["Divide by largest of"])
        return Scale(float(np.nanmax(np.abs(find(other, name).values))), "")
    return None


def numbers(text: str, parameters: dict) -> list[float]:
    return [number(part, parameters) for part in text.split(",") if part.strip()]


def marks(text: str, parameters: dict) -> list[tuple[str, float]]:
    """LABEL = NUMBER, ..."""
    found = []
    for part in filter(str.strip, text.split(",")):
        label, _, value = part.rpartition("=")
        position = number(value, parameters)
        if not label or position is None:
            raise ResultError(f"Marks: '{part.strip()}' is not LABEL = NUMBER")
        found.append((label.strip(), position))
    return found


