"""Axis labels: a readable unit with an SI prefix that suits the values."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

PREFIXES = [(1e-9, "n"), (1e-6, "µ"), (1e-3, "m"), (1.0, ""), (1e3, "k"), (1e6, "M"), (1e9, "G")]
TYPESET = {"m/s^2": "m/s²", "rad/s^2": "rad/s²", "N s": "N s"}
# What the command line sets: Hz shown as rad/s; False for dimensionless results.
SHOWN = {"angular": False, "units": True}


@dataclass(frozen=True)
class Scale:
    """Divide SI values by `factor` to show them in `unit`."""

    factor: float
    unit: str

    def label(self, quantity: str) -> str:
        return " ".join(filter(None, [quantity, self.unit and f"({self.unit})"]))


def scale_for(unit: str, *arrays) -> Scale:
    """The prefix that brings the largest magnitude of the arrays between 1 and 1000."""
    if unit == "Hz" and SHOWN["angular"]:
        return Scale(1 / (2 * np.pi), "rad/s" if SHOWN["units"] else "")
    if unit == "1" or not SHOWN["units"]:
        return Scale(1.0, "")
    if not takes_prefix(unit):
        return Scale(1.0, typeset(unit))
    largest = max((np.nanmax(np.abs(a), initial=0.0) for a in map(finite, arrays)), default=0.0)
    # A picture of 0.9995 m to 1.0005 m should not say 1000 mm at its upper end.
    fitting = [prefix for prefix in PREFIXES if prefix[0] <= largest * 1.0000001
               and (unit != "s" or prefix[0] <= 1)]
    factor, letter = fitting[-1] if fitting and largest > 0 else (1.0, "")
    return Scale(factor, letter + typeset(unit))


def takes_prefix(unit: str) -> bool:
    """Whether the first symbol may: N s/m becomes kN s/m. A power of it stays, accelerations are read in m/s^2."""
    return bool(re.match(r"(m|s|N|J|W|Pa)(?![\w^])", unit)) and unit != "m/s^2"


def with_unit(text: str, unit: str) -> str:
    """"2.4 Hz", or the number alone where results have no units."""
    return f"{text} {unit}" if SHOWN["units"] else text


def typeset(unit: str) -> str:
    """Powers above the line, and a micro sign."""
    unit = re.sub(r"(?<![A-Za-z])u(?=(m|s|N|J|W|Pa|g|rad)(?![A-Za-z]))", "µ", unit)
    return TYPESET.get(unit) or re.sub(r"\^\(?(-?[\d.]+)\)?", r"$^{\1}$", unit)


def finite(array) -> np.ndarray:
    array = np.asarray(array, dtype=float)
    return array[np.isfinite(array)]


def words(name: str) -> str:
    """"contact_duration" as "contact duration"."""
    return name.replace("peak_to_peak", "peak-to-peak").replace("_", " ").replace("von mises", "von Mises")


def quantity_label(quantity: str) -> str:
    """"displacement_x" as "Displacement x"; the direction in italics."""
    stem, _, direction = quantity.rpartition("_")
    if stem and direction in {"x", "y", "z"}:
        text = f"{words(stem)} ${direction}$"
    else:
        text = words(quantity)
    return text[0].upper() + text[1:]


def value_text(value, unit: str) -> str:
    """One coordinate in words: "3 mm", "forward"."""
    if isinstance(value, str):
        return value
    scale = scale_for(unit, [value])
    return f"{powers_of_ten(f'{float(value) / scale.factor:.4g}')} {scale.unit}".strip()


def powers_of_ten(text: str) -> str:
    """2.1·10^11 of 2.1e+11, typeset."""
    return re.sub(r"(?<=\d)[eE]\+?(-?)0*(\d+)", r"·10$^{\1\2}$", text)


GREEK = {"alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda",
         "mu", "nu", "xi", "rho", "sigma", "tau", "phi", "varphi", "chi", "psi", "omega"}


def key_label(path: str) -> str:
    """Name of a key as it was written: "Clearance" of Contact/heads/Clearance, "fm" of Variables/fm, "slip load" of
    Variables/slip_load; symbols of one letter are typeset."""
    name = path.rsplit("/", 1)[-1]
    match = re.fullmatch(r"([A-Za-z]+?)_?(\d*)", name)
    if match and (match[1] in GREEK or len(match[1]) == 1):
        stem = "\\" + match[1] if match[1] in GREEK else match[1]
        return f"${stem}_{{{match[2]}}}$" if match[2] else f"${stem}$"
    return own_name(name) if min(map(len, name.split("_"))) > 2 else name


def own_name(name: str) -> str:
    """Of what the user named: the letters stay, "peak_force" is "peak force"."""
    return name.replace("_", " ")
