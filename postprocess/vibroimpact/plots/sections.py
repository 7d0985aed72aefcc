"""Sections of motions in a result file: where they were taken, and what is known there."""

from __future__ import annotations

from dataclasses import dataclass

from .labels import quantity_label
from .parameters_text import contact_sides, direction_of
from .results import Analysis, Array

TITLES = {"period": "End of each forcing period", "onset": "Begin of contact",
          "gap_extremum": "Extrema of the gap", "extremum": "Extrema"}


@dataclass(frozen=True)
class Section:
    """`of`: contact of an onset or gap extremum, POINT/QUANTITY of an extremum."""

    path: str
    kind: str
    of: str

    @property
    def name(self) -> str:
        """For file names: "period", "extremum-first.mass-x"."""
        kind = self.kind.replace("_", "-")
        of = self.of.replace("/displacement_", "-")
        return f"{kind}-{of}" if of else kind

    @property
    def title(self) -> str:
        if self.kind == "extremum":
            point, _, quantity = self.of.partition("/")
            return f"Extrema of {point}, {quantity_label(quantity).lower()}"
        return TITLES[self.kind] + (f" {self.of}" if self.of else "")

    def quantities(self, analysis: Analysis, kind: str) -> list[tuple[str, str]]:
        """Points and quantities of a kind, "displacement" or "velocity"."""
        return [(point, quantity) for point in analysis.members(f"{self.path}/point")
                for quantity in analysis.members(f"{self.path}/point/{point}")
                if quantity.startswith(kind)]

    def values(self, analysis: Analysis, point: str, quantity: str, other=None,
               factor: float = 1.0) -> Array:
        """Values of a quantity of a point; less that of another one, times a factor."""
        own = analysis.read(f"{self.path}/point/{point}/{quantity}")
        if other is None:
            return own
        rest = analysis.read(f"{self.path}/point/{other}/{quantity}").values
        return Array(factor * (own.values - rest), own.unit)


def sections_of(analysis: Analysis, root: str = "") -> list[Section]:
    base = f"{root}section"
    found = [Section(f"{base}/period", "period", "")] if analysis.members(f"{base}/period") else []
    for kind in ("onset", "gap_extremum"):
        found += [Section(f"{base}/{kind}/{contact}", kind, contact)
                  for contact in analysis.members(f"{base}/{kind}")]
    for point in analysis.members(f"{base}/extremum"):
        found += [Section(f"{base}/extremum/{point}/{quantity}", "extremum", f"{point}/{quantity}")
                  for quantity in analysis.members(f"{base}/extremum/{point}")]
    return found


def relative(analysis: Analysis, section: Section):
    """Second less first side of a contact between two points, counted along its normal, as point,
    quantity, other point and factor; None for a stop or an oblique normal."""
    sides = contact_sides(analysis.parameters, section.of)
    direction = direction_of(analysis.parameters, section.of)
    if len(sides) != 2 or direction is None:
        return None
    quantity = f"displacement_{direction[0]}"
    if any((side, quantity) not in section.quantities(analysis, "displacement") for side in sides):
        return None
    return sides[1], quantity, sides[0], 1.0
