"""A group of results.h5 as one xarray.Dataset; vibroimpact.open(folder) hands these out.

    from vibroimpact.plots.labelled import open_analysis
    release = open_analysis("output/impacting-beams/results.h5", "release")
    release["contact/heads/normal_force"].plot()

Without this module, xarray.open_dataset(file, engine="netcdf4", group="analysis/release") opens one
group of the file at a time.
"""

from __future__ import annotations

import h5py
import xarray

from .results import read_array


def open_analysis(file, name: str) -> xarray.Dataset:
    """All fields of an analysis."""
    return open_group(file, f"analysis/{name}")


def open_group(file, path: str) -> xarray.Dataset:
    """All arrays of a group and those below by their path, in SI, with their axes as coordinates; unit
    and description as attributes (`units`, where xarray's own figures look, is left out for pure numbers)."""
    variables = {}

    def collect(path, item):
        if isinstance(item, h5py.Dataset):
            own = [path.replace("/", "_")] if h5py.h5ds.is_scale(item.id) else None
            dimensions = own or [scale_name(dimension) for dimension in item.dims]
            array = read_array(item)
            attributes = {"unit": array.unit, "description": str(item.attrs.get("description", ""))}
            if array.unit != "1":
                attributes["units"] = array.unit
            variables[own[0] if own else path] = (dimensions, array.values, attributes)

    with h5py.File(file, "r") as results:
        group = results[path]

        def scale_name(dimension):
            return dimension[0].name[len(group.name) + 1 :].replace("/", "_")

        group.visititems(collect)
        return xarray.Dataset(variables, attrs=dict(group.attrs))
