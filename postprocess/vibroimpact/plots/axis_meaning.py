"""What the axes of a drawn panel show, so that points from a table can be drawn into it."""

from __future__ import annotations

from dataclasses import dataclass, field

from .labels import Scale


@dataclass(frozen=True)
class Meaning:
    """Values in `unit` are divided by `scale.factor`; columns may have one of the `names`, or the last
    parts of one: "displacement_x/amplitude" of "point/first.mass/displacement_x/amplitude"; one called
    as the `label` has the numbers that stand at the axis, which begin at `start` in `unit`."""

    names: tuple[str, ...]
    unit: str
    scale: Scale
    label: str = ""
    start: float = 0.0

    def is_called(self, column: str) -> bool:
        return any(name.lower() == column.lower() or name.lower().endswith("/" + column.lower())
                   or name.lower().endswith("." + column.lower()) for name in self.names if name)


@dataclass(frozen=True)
class Panel:
    """`members`: for each axis of a family its name, unit, and the colour of each value. `place`: the
    axes of the analysis and the values in SI for which the panel stands; a row with another value of one is
    not drawn into it."""

    x: Meaning
    y: Meaning
    members: list[tuple[Meaning, dict]] = field(default_factory=list)
    place: list[tuple[Meaning, float]] = field(default_factory=list)


def note(axes, panel: Panel) -> None:
    axes.vibroimpact_panel = panel


def panel_of(axes) -> Panel | None:
    return getattr(axes, "vibroimpact_panel", None)
