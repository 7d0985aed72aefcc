"""Figures of an analysis of type `identify`: what the force record of impacts says about damping.

Every function takes the group /analysis/NAME of results.h5 and returns a matplotlib figure.
Outer axes of a parameter grid stand before the axes of a field; where impacts are pooled over a
grid they are flattened, shorter points being padded with NaN by the file.
"""
from __future__ import annotations

import h5py
import numpy as np
from matplotlib.figure import Figure

SETS = {"printed": "tab:red", "corrected": "tab:orange", "exact": "tab:blue"}
FIELD = "identification/"


def figures(analysis: h5py.Group) -> dict[str, Figure]:
    """All figures that fit what the analysis holds, by file name without suffix."""
    drawn = {
        "impulse_and_peak": impulse_and_peak(analysis),
        "restitution_over_speed": restitution_over_speed(analysis),
        "damping_factor_over_speed": damping_factor_over_speed(analysis),
        "restitution_over_ratio": restitution_over_ratio(analysis),
        "first_pulse": first_pulse(analysis),
    }
    if analysis[FIELD + "exact/restitution_map"].ndim == 2:
        drawn["restitution_map"] = restitution_map(analysis)
    if FIELD + "record/force" in analysis and analysis[FIELD + "record/force"].ndim == 1:
        drawn["force_record"] = force_record(analysis)
    return drawn


def restitution_map(analysis: h5py.Group) -> Figure:
    """Restitution coefficient over impulse and peak force, by each set of formulas."""
    figure = Figure(figsize=(12, 4), layout="constrained")
    axes = figure.subplots(1, len(SETS), sharey=True)
    impulse = analysis[FIELD + "impulse_axis"][()]
    force = analysis[FIELD + "peak_force_axis"][()]
    levels = np.linspace(-0.6, 1, 17)
    filled = None
    for axis, name in zip(axes, SETS):
        values = analysis[f"{FIELD}{name}/restitution_map"][()]
        filled = axis.contourf(impulse, force, values.T, levels, cmap="viridis", extend="min")
        axis.plot(_column(analysis, "impulse"), _column(analysis, "peak_force"), "w.", markeredgecolor="k")
        axis.set(title=name, xlabel="impulse J [N s]")
    axes[0].set_ylabel("peak force $f_m$ [N]")
    figure.colorbar(filled, ax=axes, label="restitution coefficient e")
    return figure


def force_record(analysis: h5py.Group) -> Figure:
    """Sampled force record over the true peaks of the pulses."""
    figure = Figure(figsize=(9, 4), layout="constrained")
    axis = figure.subplots()
    impacts = _contact(analysis)["impact"]
    axis.vlines(impacts["time"][()], 0, impacts["peak_force"][()], "0.75", label="pulses, true peak")
    axis.plot(analysis[FIELD + "record/time"][()], analysis[FIELD + "record/force"][()], ".-",
              color="tab:blue", markersize=3, linewidth=0.8, label="record")
    axis.set(xlabel="time [s]", ylabel="contact force [N]")
    axis.legend()
    return figure


def impulse_and_peak(analysis: h5py.Group) -> Figure:
    """Impulse against peak force of all impacts."""
    figure = Figure(figsize=(6, 4.5), layout="constrained")
    axis = figure.subplots()
    axis.loglog(_column(analysis, "peak_force"), _column(analysis, "impulse"), ".")
    axis.set(xlabel="peak force $f_m$ [N]", ylabel="impulse J [N s]")
    return figure


def restitution_over_speed(analysis: h5py.Group) -> Figure:
    """Identified restitution over identified approach speed, beside what the motion shows."""
    figure = Figure(figsize=(7, 5), layout="constrained")
    axis = figure.subplots()
    impacts = _contact(analysis)["impact"]
    axis.semilogx(np.ravel(impacts["approach_speed"]), np.ravel(impacts["restitution_coefficient"]),
                  "k+", markersize=9, label="motion")
    for name, colour in SETS.items():
        speed, restitution = (_column(analysis, f"{name}/{key}")
                              for key in ("approach_speed", "restitution_coefficient"))
        low, high = (_column(analysis, f"{name}/restitution_{end}") for end in ("low", "high"))
        known = np.isfinite(restitution)
        errors = np.clip([restitution - low, high - restitution], 0, None)[:, known]
        axis.errorbar(speed[known], restitution[known], errors, fmt=".", color=colour,
                      elinewidth=0.6, label=name)
        _draw_fit(axis, speed, restitution, colour)
    axis.axhline(0, color="0.7", linewidth=0.8)
    axis.set(xlabel="approach speed $v_c$ [m/s]", ylabel="restitution coefficient e")
    axis.legend()
    return figure


def damping_factor_over_speed(analysis: h5py.Group) -> Figure:
    """Identified damping factor over identified approach speed."""
    figure = Figure(figsize=(7, 5), layout="constrained")
    axis = figure.subplots()
    for name, colour in SETS.items():
        axis.loglog(_column(analysis, f"{name}/approach_speed"),
                    _column(analysis, f"{name}/damping_factor"), ".", color=colour, label=name)
    unit = analysis[FIELD + "exact/damping_factor"].attrs["unit"]
    axis.set(xlabel="approach speed $v_c$ [m/s]", ylabel=f"damping factor $\\mu$ [{_text(unit)}]")
    axis.legend()
    return figure


def restitution_over_ratio(analysis: h5py.Group) -> Figure:
    """The three formulas e(gamma), with the impacts of the motion."""
    figure = Figure(figsize=(6, 4.5), layout="constrained")
    axis = figure.subplots()
    ratio = analysis[FIELD + "pulse_ratio_axis"][()]
    for name, colour in SETS.items():
        curves = analysis[f"{FIELD}{name}/restitution_curve"][()].reshape(-1, ratio.shape[-1])
        axis.plot(ratio.reshape(-1, ratio.shape[-1])[0], curves[0], color=colour, label=name)
    axis.plot(_column(analysis, "pulse_ratio"),
              np.ravel(_contact(analysis)["impact/restitution_coefficient"]), "k+", label="motion")
    axis.set(xlabel="$\\gamma$", ylabel="restitution coefficient e", xlim=(1, ratio.max()))
    axis.legend()
    return figure


def first_pulse(analysis: h5py.Group) -> Figure:
    """Force of the first impact of every grid point, with its samples where there is a record."""
    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axis = figure.subplots()
    pulse = _contact(analysis)["pulse"]
    times, forces = (_rows(pulse[name]) for name in ("time", "normal_force"))
    starts = _rows(_contact(analysis)["impact/time"])
    for point, (time, force) in enumerate(zip(times, forces)):
        end = int(np.argmax(np.isnan(time))) or len(time)
        if end == 0 or np.isnan(time[0]):
            continue
        origin = starts[point][0]
        line, = axis.plot(1e6 * (time[:end] - origin), force[:end], label=_label(analysis, point))
        if FIELD + "record/force" in analysis:
            sampled = _rows(analysis[FIELD + "record/force"])[point]
            instants = _rows(analysis[FIELD + "record/time"])
            instants = instants[min(point, len(instants) - 1)]
            near = (instants > time[0] - 5e-5) & (instants < time[end - 1] + 5e-5)
            axis.plot(1e6 * (instants[near] - origin), sampled[near], "o", color=line.get_color())
    axis.set(xlabel="time since touch [µs]", ylabel="contact force [N]")
    axis.legend()
    return figure


def _draw_fit(axis, speed: np.ndarray, restitution: np.ndarray, colour: str) -> None:
    """The power law through all shown impacts, least squares in ln e."""
    usable = restitution > 0
    if np.unique(speed[usable]).size < 2:
        return
    exponent, logarithm = np.polyfit(np.log(speed[usable]), np.log(restitution[usable]), 1)
    span = np.geomspace(speed[usable].min(), speed[usable].max(), 50)
    axis.plot(span, np.exp(logarithm) * span**exponent, color=colour, linewidth=0.8,
              label=f"{np.exp(logarithm):.4g} $v_c^{{{exponent:.3g}}}$, $v_c$ in m/s")


def _column(analysis: h5py.Group, name: str) -> np.ndarray:
    return np.ravel(analysis[FIELD + name][()])


def _rows(dataset: h5py.Dataset) -> np.ndarray:
    return dataset[()].reshape(-1, dataset.shape[-1])


def _contact(analysis: h5py.Group) -> h5py.Group:
    """The contact that was identified: its impacts have the length of the identified ones."""
    dimension = _text(analysis[FIELD + "impulse"].dims[-1].label)
    return analysis["contact/" + dimension.removeprefix("impact_")]


def _label(analysis: h5py.Group, point: int) -> str:
    """Values of the outer axes at a grid point."""
    field = analysis[FIELD + "compliance"]
    parts = []
    for axis, index in enumerate(np.unravel_index(point, field.shape) if field.ndim else ()):
        scale = field.dims[axis][0]
        value = scale[index]
        shown = f"{value:.6g}" if np.issubdtype(scale.dtype, np.number) else _text(value)
        parts.append(f"{field.dims[axis].label.split('.')[-1]} = {shown}")
    return ", ".join(parts) or "force"


def _text(value: str | bytes) -> str:
    return value.decode() if isinstance(value, bytes) else value
