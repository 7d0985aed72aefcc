"""Reads results.h5: analyses, their axes and fields, and bodies."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from .errors import ResultError
from .labels import own_name
from .parameters_text import judges_steadiness, sections

MOST_KEPT = 100_000  # entries of an array that is read once for all figures


@dataclass
class Array:
    """Values with their unit."""

    values: np.ndarray
    unit: str


@dataclass(frozen=True)
class Emphasis:
    """`highlight`: AXIS=VALUE:NAME of members of families; `peaks` and `below` the reference: whether they are
    marked."""

    highlight: tuple[str, ...] = ()
    peaks: bool = False
    below: bool = False


def read_array(dataset: h5py.Dataset) -> Array:
    """Numbers or texts of a dataset."""
    is_text = h5py.check_string_dtype(dataset.dtype) is not None
    values = dataset.asstr()[()] if is_text else dataset[()]
    return Array(np.asarray(values), str(dataset.attrs.get("unit", "1")))


def yield_stresses(file: h5py.File) -> dict[str, float]:
    """Of the bodies that have one, by their names [Pa]."""
    return {name: float(body["yield_stress"][()]) for name, body in file.get("body", {}).items()
            if "yield_stress" in body}


class Analysis:
    """One analysis: outer axes (grid axes first), and fields by their path."""

    def __init__(self, group: h5py.Group, parameters: dict | None = None):
        self._group = group
        self.name = group.name.rsplit("/", 1)[-1]
        self.type = str(group.attrs["type"])
        self.grid = [str(key) for key in group.attrs.get("grid", [])]
        self.parameters = parameters or {}
        self.chosen: dict[str, list[int]] = {}  # indices along an axis, of the axes with a choice
        self.highlighted: dict[str, tuple[int, str]] = {}  # index along an axis, and its name in the legend
        self.overlays: list[Analysis] = []  # drawn over the figures of this one
        self.shown: dict[str, tuple] = {}  # scale and label of an axis that a figure chooses
        self._read: dict[str, Array] = {}
        self._dimensions: dict[str, list[str]] = {}
        self.yield_stresses = yield_stresses(group.file)

    @property
    def file(self) -> str:
        return self._group.file.filename

    @property
    def axes(self) -> list[str]:
        """Names of the outer axes."""
        return self.dimensions("status")

    @property
    def grid_axes(self) -> list[str]:
        """Names of the axes of the parameter grid around the analysis."""
        return self.axes[: len(self.grid)]

    def has(self, path: str) -> bool:
        return isinstance(self._group.get(path), h5py.Dataset)

    def read(self, path: str) -> Array:
        """A field or axis; its first dimensions are the outer axes, unless it is a coordinate."""
        array = self._read.get(path) or read_array(self._group[path])
        if array.values.size <= MOST_KEPT:
            array.values.setflags(write=False)
            self._read[path] = array
        return Array(array.values, array.unit)

    @property
    def judges_steadiness(self) -> bool:
        """Does `steady` tell motions that have settled from others?"""
        return self.has("steady") and judges_steadiness(self.parameters, self.name)

    def symbol(self, derived: str) -> str:
        """Of a derived quantity: its key Symbol, else its name in words."""
        section = self.parameters.get(f"Derived {derived}", {})
        return section.get("Symbol", "") or own_name(derived)

    def members(self, path: str) -> list[str]:
        """Names in a group below the analysis, in the order of the file; empty without it."""
        group = self._group.get(path)
        return list(group) if isinstance(group, h5py.Group) else []

    def fields(self, path: str) -> list[str]:
        """Paths of all datasets below a group, without coordinates."""
        group = self._group.get(path)
        if not isinstance(group, h5py.Group):
            return []
        found: list[str] = []
        group.visititems(lambda name, item: found.append(f"{path}/{name}")
                         if isinstance(item, h5py.Dataset) and not h5py.h5ds.is_scale(item.id)
                         else None)
        return found

    def dimensions(self, path: str) -> list[str]:
        """Names of the dimensions of a field."""
        if path not in self._dimensions:  # figures ask for those of `status` all the time
            self._dimensions[path] = [dimension.label for dimension in self._group[path].dims]
        return list(self._dimensions[path])

    def is_coordinate(self, path: str) -> bool:
        return h5py.h5ds.is_scale(self._group[path].id)

    def attributes(self, path: str) -> dict:
        return dict(self._group[path].attrs)

    def coordinate(self, path: str, dimension: str) -> Array:
        """Coordinates along a dimension of a field: the scale of that name in its group or above.
        A field of the same name beside the field itself, one row for each point, comes first."""
        folder = path.rsplit("/", 1)[0] if "/" in path else ""
        while True:
            place = f"{folder}/{dimension}" if folder else dimension
            if self.has(place):
                return self.read(place)
            if not folder:
                raise ResultError(f"{self.name}: {path} has no coordinates {dimension}")
            folder = folder.rsplit("/", 1)[0] if "/" in folder else ""


class Body:
    """One reduced body."""

    def __init__(self, group: h5py.Group):
        self._group = group
        self.name = group.name.rsplit("/", 1)[-1]
        self.type = str(group.attrs["type"])

    def has(self, name: str) -> bool:
        return name in self._group

    def read(self, name: str) -> Array:
        return read_array(self._group[name])


class Results:
    """A result file, open for reading."""

    def __init__(self, place: Path):
        self.file = place / "results.h5" if place.is_dir() else place
        if not self.file.is_file():
            what = "no results.h5 in it" if place.is_dir() else "no such result folder or file"
            raise ResultError(f"{place}: {what}")
        try:
            self._file = h5py.File(self.file, "r")
        except OSError as error:
            raise ResultError(f"{self.file}: not a result file of vibroimpact ({error})") from error
        self.emphasis = Emphasis()
        self.emphasis = Emphasis()
        self.overlays: list[Analysis] = []  # over the figures with chosen axes
        if "version" not in self._file.attrs:
            raise ResultError(f"{self.file}: not a result file of vibroimpact")

    def __enter__(self) -> "Results":
        return self

    def __exit__(self, *error) -> None:
        self._file.close()

    @property
    def folder(self) -> Path:
        return self.file.parent

    @functools.cached_property
    def parameters(self) -> dict:
        """The stored parameters, as sections() gives them."""
        return sections(str(self._file.attrs.get("parameters", "")))

    @property
    def dimensionless(self) -> bool:
        """Has the file Units = dimensionless?"""
        return self.parameters.get("Units", "SI") == "dimensionless"

    def take_figures(self, file: Path) -> None:
        """The sections Figure of a parameter file, the symbols of its derived quantities, and its
        variables where the stored parameters have none of the name."""
        other = sections(file.read_text())
        self.parameters["Variables"] = ", ".join(filter(None, [
            known.get("Variables", "") for known in (other, self.parameters)]))
        for name in [name for name in self.parameters if name.startswith("Figure ")]:
            del self.parameters[name]
        for name, keys in other.items():
            if name.startswith("Figure "):
                self.parameters[name] = keys
            elif name.startswith("Derived ") and "Symbol" in keys:
                self.parameters.setdefault(name, {})["Symbol"] = keys["Symbol"]

    def analyses(self) -> list[Analysis]:
        parameters = self.parameters
        return [Analysis(group, parameters) for group in self._file.get("analysis", {}).values()]

    def analysis(self, name: str) -> Analysis:
        found = [analysis for analysis in self.analyses() if analysis.name == name]
        if not found:
            raise ResultError(f"{self.file}: there is no analysis {name}")
        return found[0]

    def bodies(self) -> list[Body]:
        return [Body(group) for group in self._file.get("body", {}).values()]
