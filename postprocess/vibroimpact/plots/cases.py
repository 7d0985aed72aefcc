"""The cases of a parameter grid as a family of curves, one colour each."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

from matplotlib.lines import Line2D

from . import style
from .labels import key_label, scale_for, value_text
from .results import Analysis

LARGEST_LEGEND = 8


@dataclass(frozen=True)
class Case:
    """One grid point: its place along the grid axes, colour and description."""

    index: tuple
    colour: object
    text: str


def cases(analysis: Analysis) -> list[Case]:
    """All grid points in order; one case without a grid."""
    axes = [analysis.read(name) for name in analysis.grid_axes]
    indices = list(itertools.product(*[range(len(axis.values)) for axis in axes]))
    colours = style.colours_along(len(indices))
    return [
        Case(
            index,
            colour,
            ", ".join(value_text(axis.values[i], axis.unit) for axis, i in zip(axes, index)),
        )
        for index, colour in zip(indices, colours)
    ]


def name_of_grid(analysis: Analysis) -> str:
    """The last part of each key: "Clearance" of "Contact/heads/Clearance"."""
    return ", ".join(key_label(key) for key in analysis.grid)


def explain(figure, axes, analysis: Analysis, family: list[Case], more_handles=()) -> None:
    """Legend or colour bar of a family beside the uppermost of the axes, with further entries."""
    handles = list(more_handles)
    if analysis.grid and len(family) <= LARGEST_LEGEND:
        handles = [Line2D([], [], color=case.colour, label=case.text) for case in family] + handles
    style.legend_beside(axes[0], handles, name_of_grid(analysis) or None)
    if analysis.grid and len(family) > LARGEST_LEGEND:
        explain_by_colour_bar(figure, axes, analysis, family)


def explain_by_colour_bar(figure, axes, analysis: Analysis, family: list[Case]) -> None:
    first = analysis.read(analysis.grid_axes[0])
    if len(analysis.grid) == 1 and first.values.dtype.kind == "f":
        scale = scale_for(first.unit, first.values)
        style.colour_bar(figure, axes, first.values / scale.factor,
                         scale.label(name_of_grid(analysis)))
    else:
        style.colour_bar(figure, axes, range(1, len(family) + 1), "Number of the grid point")
