"""Other results drawn over a figure of a branch: stepped sweeps as points, harmonic balances as
dash-dotted lines, other branches and nonlinear modes as lines of their own colour; over a figure with chosen axes as lines.
"""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .branch_curves import BALANCE, MODE, TYPES, key_of, pick, pieces
from .errors import ResultError
from .figure_axes import has_axes
from .layout import DIRECTION, Layout, kept, title_of
from .measures import field_of
from .results import Analysis, Results

MARKERS = {"forward": ">", "backward": "<"}


def find(results: Results, requested: str, stack: ExitStack) -> list[Analysis]:
    """The analyses that --overlay names: NAME of this file, FOLDER:NAME, or all of FOLDER."""
    own = [analysis for analysis in results.analyses() if analysis.name == requested]
    if own:
        return own
    place, colon, name = requested.rpartition(":")
    folder = Path(place if colon else requested)
    if not colon and not folder.exists():
        known = ", ".join(analysis.name for analysis in results.analyses())
        raise ResultError(f"--overlay {requested}: neither an analysis of {results.file} ({known}) "
                          "nor a result folder")
    other = stack.enter_context(Results(folder)).analyses()
    found = [analysis for analysis in other if not colon or analysis.name == name]
    if not found:
        known = ", ".join(analysis.name for analysis in other)
        raise ResultError(f"--overlay {requested}: {folder} holds no analysis {name}; "
                          f"there are: {known}")
    return found


def attach(results: Results, analyses: list[Analysis], requests: list[str], stack: ExitStack) -> None:
    """Enters each overlay into the branches whose key it has. ResultError when it fits none."""
    branches = [analysis for analysis in analyses if analysis.type in TYPES]
    for requested in requests:
        fitting = 0
        for overlay in find(results, requested, stack):
            if shown_by(results, analyses, overlay):
                results.overlays.append(overlay)
                fitting += 1
            for branch in branches:
                if overlay.name != branch.name or overlay.file != branch.file:
                    fits = along(overlay, key_of(branch)) is not None
                    branch.overlays += [overlay] * fits
                    fitting += fits
        if not fitting:
            keys = sorted({key_of(branch) for branch in branches})
            raise ResultError(f"--overlay {requested}: " + (
                "nothing in it runs along " + " or ".join(keys) if keys
                else "there is no branch to draw it over"))


def shown_by(results: Results, analyses: list[Analysis], overlay: Analysis) -> bool:
    """Has it the quantities of a figure with chosen axes of another analysis?"""
    names = [analysis.name for analysis in analyses if (analysis.name, analysis.file) != (overlay.name, overlay.file)]
    return any(has_axes(overlay, section) for name, section in results.parameters.items()
               if name.startswith("Figure ") and section.get("From") in names)


def along(analysis: Analysis, key: str):
    """Values of the key in the shape of the fields, or None where it is not what is swept."""
    if analysis.type in TYPES:
        # A backbone lies over motions by the frequency of their forcing.
        runs = key_of(analysis) == key or (analysis.type == MODE and key == "frequency")
        return analysis.read(key).values if runs else None
    if key not in analysis.axes or analysis.read(key).values.dtype.kind != "f":
        return None
    return analysis.read(key).values


def draw(axes, base: Layout, key, shown) -> list[Line2D]:
    """All overlays of the branch on one pair of axes; `key` and `shown` are path and scale. Returns
    the entries of the legend."""
    handles: list[Line2D] = []
    colours = style.COLOURS[1:]
    for overlay, name in zip(base.analysis.overlays, names(base.analysis)):
        if not overlay.has(shown[0]):
            continue
        layout = layout_along(overlay, key[0])
        for case in layout.cases():
            colour = colour_of(base, case) or colours[len(handles) % len(colours)]
            member = title_of(overlay, case.index)
            label = f"{name}, {member}" if member else name
            handles.append(one(axes, layout, case, key, shown, colour, label))
    return handles


def names(base: Analysis) -> list[str]:
    """Of the overlays; those of other results that share theirs with the branch or another overlay
    are distinguished by as much of their folder as that takes."""
    shared = [[other for other in (base, *base.overlays)
               if other.name == overlay.name and other.file != overlay.file]
              for overlay in base.overlays]
    return [f"{overlay.name} ({place_of(overlay, others)})"
            if others and overlay.file != base.file else overlay.name
            for overlay, others in zip(base.overlays, shared)]


def place_of(overlay: Analysis, others: list[Analysis]) -> str:
    """The last parts of the folder, or of a file of another name than a run gives it."""
    def parts(analysis: Analysis) -> tuple[str, ...]:
        file = Path(analysis.file).resolve()
        return (file.parent if file.name == "results.h5" else file).parts

    own = parts(overlay)
    least = next((count for count in range(1, len(own))
                  if all(parts(other)[-count:] != own[-count:] for other in others)), len(own))
    return "/".join(own[-least:])


def layout_along(analysis: Analysis, key: str) -> Layout:
    """Curves run along the key, the other axes are a family."""
    return Layout(analysis, key if key in analysis.axes else None,
                  [name for name in analysis.axes
                   if name not in (key, DIRECTION) and len(kept(analysis, name)) > 1])


def colour_of(base: Layout, case):
    """A case that the branch has too keeps its colour."""
    return next((other.colour for other in base.cases() if base.family
                 and (other.text, list(other.index)) == (case.text, list(case.index))), None)


def one(axes, layout: Layout, case, key, shown, colour, label) -> Line2D:
    analysis = layout.analysis
    if analysis.type not in TYPES:
        return points(axes, layout, case, key, shown, colour, label)
    x, y = (pick(layout, field_of(analysis, path).values, case) / scale.factor
            for path, scale in (key, shown))
    stable = np.ones(len(x), bool)
    if analysis.has("stable"):
        stable = pick(layout, analysis.read("stable").values, case) == 1
    line = "-." if analysis.type == BALANCE else "-"
    number = pick(layout, analysis.read("branch").values, case)
    for branch in np.unique(number[np.isfinite(number)]):
        here = number == branch
        pieces(axes, x[here], y[here], stable[here], colour, (line, "--"))
    return Line2D([], [], color=colour, linestyle=line, label=label)


def points(axes, layout: Layout, case, key, shown, colour, label) -> Line2D:
    """Every point of a sweep, in each direction with its own marker."""
    values = field_of(layout.analysis, shown[0]).values
    x = layout.coordinates() / key[1].factor
    for direction in layout.directions:
        y = layout.pick(values, case, direction) / shown[1].factor
        axes.plot(x, y, linestyle="", marker=MARKERS.get(direction, "."), markersize=2.5,
                  color=colour, zorder=2.5)
    marker = MARKERS.get(layout.directions[0], ".") if len(layout.directions) == 1 else ">"
    return Line2D([], [], color=colour, linestyle="", marker=marker, markersize=2.5, label=label)
