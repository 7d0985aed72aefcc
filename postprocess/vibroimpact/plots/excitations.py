"""Frequencies of the excitations over time, as far as the stored parameters tell them."""

from __future__ import annotations

import math

import numpy as np

from .parameters_text import number
from .results import Analysis


def frequencies(analysis: Analysis, time: np.ndarray) -> list[tuple[str, np.ndarray]]:
    """Name and frequency, as results have them, of each acting excitation that has one; NaN where it does not act."""
    section = analysis.parameters.get(f"Analysis {analysis.name}", {})
    acting = section.get("Excitations", "all")
    found = []
    for title, excitation in analysis.parameters.items():
        name = title.removeprefix("Excitation ")
        if name == title or acting != "all" and name not in acting.replace(",", " ").split():
            continue
        values = frequency_of(excitation, analysis.parameters, time)
        if values is not None:
            found.append((name, values))
    return found


def frequency_of(excitation: dict, parameters: dict, time: np.ndarray):
    history = excitation.get("History", "harmonic")
    if history == "sine sweep":
        return sweep_frequency(excitation.get("Sine sweep", {}), parameters, time)
    value = number(excitation.get("Frequency", ""), parameters)
    if history not in ("harmonic", "ramped harmonic") or value is None:
        return None
    return np.full(len(time), value / turn(parameters))


def sweep_frequency(sweep: dict, parameters: dict, time: np.ndarray):
    """Between From and To over Duration, then held or nothing."""
    first, last, duration = (number(sweep.get(key, ""), parameters)
                             for key in ("From", "To", "Duration"))
    if None in (first, last, duration):
        return None
    part = np.clip(time / duration, 0, 1)
    if sweep.get("Law", "linear") == "logarithmic":
        values = first * (last / first) ** part
    else:
        values = first + (last - first) * part
    after = time > duration if sweep.get("After", "hold") == "stop" else np.zeros(len(time), bool)
    return np.where(after | (time < 0), np.nan, values) / turn(parameters)


def turn(parameters: dict) -> float:
    """Frequencies of parameters are in rad/s, of results in Hz or, without units, angular too."""
    return 1.0 if parameters.get("Units") == "dimensionless" else 2 * math.pi
