"""Which curves belong together in a figure: one sheet for each kind of measure of a quantity."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from .labels import quantity_label, words
from .results import Analysis, Array

MAIN = ["peak_to_peak", "largest"]  # the first that is there is drawn
PEAKS = [("largest", "largest magnitude"), ("maximum", "maximum"), ("minimum", "minimum")]
AVERAGES = [("rms", "rms"), ("rms_about_mean", "rms about mean"), ("mean", "mean")]
HARMONIC = [("amplitude", "amplitude"), ("phase", "phase")]
CONTACT = [
    ("normal_force/maximum", "Largest contact force"),
    ("gap/minimum", "Smallest gap"),
    ("impacts_per_period", "Impacts per period"),
    ("contact_fraction", "Share of time\nin contact"),
]
IMPACTS = [
    ("approach_speed/maximum", "Largest\napproach speed"),
    ("impulse/maximum", "Largest impulse"),
    ("contact_duration/maximum", "Longest contact"),
    ("penetration/maximum", "Largest penetration"),
    ("dissipated_energy_per_period", "Energy lost\nper period"),
]
FRICTION = [
    ("slip/peak_to_peak", "Slip,\npeak-to-peak"),
    ("friction/energy", "Energy that\nfriction takes"),
    ("friction/work_rate", "Work rate\nof wear"),
    ("friction/stick_fraction", "Share of time\nin stick"),
]
ENERGY = [
    ("energy/input_work_per_period", "input"),
    ("energy/damping_work_per_period", "damping"),
    ("energy/contact_work_per_period", "contacts"),
]
REGIME = [
    ("regime/class", "Character"),
    ("regime/period_multiple", "Periods until\nit repeats"),
    ("regime/exponent", "Largest Lyapunov\nexponent"),
    ("lyapunov/exponent", "Largest Lyapunov\nexponent"),
]
ORDERS = 4
ROUND_OFF = 1e-8  # of the largest value in a sheet
TINY = {"m": 1e-13, "m/s": 1e-12, "rad": 1e-13}  # what rounding leaves of a motion that is not there


@dataclass(frozen=True)
class Panel:
    """One pair of axes: label, and for each curve its path and name."""

    label: str
    curves: list[tuple[str, str]]


@dataclass(frozen=True)
class Sheet:
    """One figure."""

    name: str
    title: str
    panels: list[Panel] = field(default_factory=list)


def sheets(analysis: Analysis, root: str, separate: bool) -> list[Sheet]:
    """All figures of curves for the fields below `root` ("" or "recorded/"). `separate`: one curve
    in a panel, because colours are needed for a family."""
    found = [*of_points(analysis, root, separate)]
    for kind in ("connection", "body", "rotor"):
        for name in analysis.members(f"{root}{kind}"):
            for quantity in analysis.members(f"{root}{kind}/{name}"):
                found += of_quantity(analysis, f"{root}{kind}/{name}/{quantity}",
                                     f"{kind}-{name}-{dashed(quantity)}",
                                     f"{kind.capitalize()} {name}")
    for name in analysis.members(f"{root}contact"):
        found += of_contact(analysis, f"{root}contact/{name}", name)
    found.append(Sheet("energy", "", [Panel("Energy per period", there(analysis, ENERGY, root))]))
    found.append(rows_sheet(analysis, "regime", "", root, regime_rows(analysis, root)))
    derived = [] if root or analysis.type == "frequency response" else analysis.members("derived")
    found += [Sheet(f"derived-{name}", "", [Panel(analysis.symbol(name), [(f"derived/{name}", "")])])
              for name in derived if analysis.has(f"derived/{name}")
              and analysis.dimensions(f"derived/{name}") == analysis.axes]
    found += orders(analysis, root)
    shown = [without_rounding(analysis, split(sheet) if separate else sheet) for sheet in found]
    return [sheet for sheet in shown if sheet.panels]


def without_rounding(analysis: Analysis, sheet: Sheet) -> Sheet:
    """Without curves that are zero, rounding beside others of the sheet in the same unit, or not there."""
    largest = {path: magnitude(field_of(analysis, path)) for panel in sheet.panels for path, _ in panel.curves}
    of_unit: dict[str, float] = {}
    for path, size in largest.items():
        unit = field_of(analysis, path).unit
        of_unit[unit] = max(size, of_unit.get(unit, 0.0))

    def shows(path):
        array = field_of(analysis, path)
        return largest[path] > ROUND_OFF * of_unit[array.unit] and largest[path] > TINY.get(array.unit, 0.0)

    panels = [Panel(panel.label, [curve for curve in panel.curves if is_count(curve[0]) or shows(curve[0])])
              for panel in sheet.panels]
    return Sheet(sheet.name, sheet.title, [panel for panel in panels if panel.curves])


def is_count(path: str) -> bool:
    """Of periods or classes, where 0 is a finding."""
    return "regime/" in path


def field_of(analysis: Analysis, path: str) -> Array:
    """A field; `path[k]` is component k of its last dimension."""
    match = re.fullmatch(r"(.*)\[(\d+)\]", path)
    if not match:
        return analysis.read(path)
    whole = analysis.read(match[1])
    number = int(match[2])
    missing = number >= whole.values.shape[-1]
    values = np.full(whole.values.shape[:-1], np.nan) if missing else whole.values[..., number]
    return Array(values, whole.unit)


def magnitude(array: Array) -> float:
    return np.nanmax(np.abs(array.values), initial=0.0)


def dashed(name: str) -> str:
    return name.replace("_", "-")


def there(analysis: Analysis, rows, root: str) -> list[tuple[str, str]]:
    return [(root + path, text) for path, text in rows if analysis.has(root + path)]


def rows_sheet(analysis: Analysis, name: str, title: str, root: str, rows) -> Sheet:
    """A panel for each of the fields that are there."""
    return Sheet(name, title, [Panel(label, [(path, "")])
                               for path, label in there(analysis, rows, root)])


def regime_rows(analysis: Analysis, root: str):
    """Without the number of periods where no motion repeats itself."""
    multiple = f"{root}regime/period_multiple"
    repeats = analysis.has(multiple) and np.any(analysis.read(multiple).values > 0)
    return [row for row in REGIME if repeats or row[0] != "regime/period_multiple"]


def split(sheet: Sheet) -> Sheet:
    """One curve in each panel."""
    panels = [Panel(panel.label + (f",\n{text}" if text and len(panel.curves) > 1 else ""),
                    [(path, text)])
              for panel in sheet.panels for path, text in panel.curves]
    return Sheet(sheet.name, sheet.title, panels)


def of_points(analysis: Analysis, root: str, separate: bool) -> list[Sheet]:
    """Extreme values, averages, transmissibility and harmonic response of all points together, or of
    each by itself."""
    points = analysis.members(f"{root}point")
    quantities = list(dict.fromkeys(
        quantity for point in points for quantity in analysis.members(f"{root}point/{point}")))
    groups = [[point] for point in points] if separate else [points]
    found = []
    for quantity in quantities:
        for group in groups:
            suffix = f"-{group[0]}" if separate else ""
            title = f"Point {group[0]}" if separate else ""
            label = quantity_label(quantity)

            def sheet(kind, measures):
                panels = [Panel(f"{label},\n{text}", there(
                    analysis, [(f"point/{point}/{quantity}/{measure}", point) for point in group],
                    root)) for measure, text in measures]
                return Sheet(dashed(quantity) + kind + suffix, title,
                             [panel for panel in panels if panel.curves])

            found += [sheet("", main_of(analysis, root, group, quantity)),
                      sheet("-peaks", PEAKS), sheet("-averages", AVERAGES),
                      sheet("-transmissibility", [("transmissibility", "transmissibility")]),
                      sheet("-response", HARMONIC if any(analysis.has(
                          f"{root}point/{point}/{quantity}/phase") for point in group) else [])]
    return found


def main_of(analysis: Analysis, root: str, points, quantity: str):
    """The measure that is drawn first, and its words; a list of one or none."""
    for measure in MAIN:
        if any(analysis.has(f"{root}point/{point}/{quantity}/{measure}") for point in points):
            return [(measure, words(measure))]
    return []


def of_quantity(analysis: Analysis, path: str, name: str, title: str) -> list[Sheet]:
    """Figures of one quantity of a connection, body or rotor."""
    label = quantity_label(path.rsplit("/", 1)[-1])

    def sheet(kind, measures):
        return Sheet(name + kind, title, [Panel(f"{label},\n{text}", [(f"{path}/{measure}", "")])
                                          for measure, text in measures
                                          if analysis.has(f"{path}/{measure}")])

    return [sheet("", [("peak_to_peak", "peak-to-peak"),
                       ("transmissibility", "transmissibility")]),
            sheet("-peaks", PEAKS), sheet("-averages", AVERAGES)]


def of_contact(analysis: Analysis, path: str, name: str) -> list[Sheet]:
    title = f"Contact {name}"
    stop = [(f"internal/{state}/{end}", f"{quantity_label(state)},\n{end}")
            for state in analysis.members(f"{path}/internal") for end in ("maximum", "minimum")]
    stop += [(f"stop_position/{end}", f"Stop position,\n{end}") for end in ("maximum", "minimum")]
    averages = [(f"normal_force/{measure}", f"Contact force,\n{text}")
                for measure, text in AVERAGES]
    gaps = [analysis.read(f"{path}/{end}") for end in ("gap/minimum", "gap/maximum") if analysis.has(f"{path}/{end}")]
    held = len(gaps) == 2 and not any(map(magnitude, gaps))  # by a constant force
    return [rows_sheet(analysis, f"contact-{name}{kind}", title, f"{path}/", rows)
            for kind, rows in [("", [] if held else CONTACT), ("-impacts", IMPACTS), ("-friction", FRICTION),
                               ("-stop", stop), ("-averages", averages)]]


def orders(analysis: Analysis, root: str) -> list[Sheet]:
    """Amplitudes of the first orders of the forcing frequency, by the path and the number."""
    return [
        Sheet("orders-" + dashed(path.split("/", 2)[-1].replace("/", "-")),
              " ".join(path.split("order_amplitude/", 1)[1].split("/")[:2]).capitalize(),
              [Panel(f"{quantity_label(path.rsplit('/', 1)[-1])},\namplitude of an order",
                     [(f"{path}[{order}]", f"order {order + 1}") for order in range(ORDERS)])])
        for path in analysis.fields(f"{root}order_amplitude")
    ]
