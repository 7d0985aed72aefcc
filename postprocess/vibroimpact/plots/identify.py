"""Identification of impact damping: what a force record says about restitution and damping.

Impacts of all cases of a parameter grid are shown together.
"""

from __future__ import annotations

import functools

import matplotlib.pyplot as plt
import numpy as np

from . import style
from .axis_meaning import Meaning, Panel, note
from .cases import cases, name_of_grid
from .labels import Scale, scale_for, typeset
from .results import Analysis, Results

SETS = dict(zip(["exact", "corrected", "printed"], style.COLOURS))
RESTITUTION = "Restitution coefficient $e$"
HARD = 0.1  # m/s; slower impacts are disturbed by the rest of the structure


def figures(results: Results, analysis: Analysis):
    """Name and what draws it, for every contact that was identified."""
    for contact in analysis.members("contact"):
        sheet = Sheet(analysis, contact)
        if not analysis.has(sheet.path("compliance")):
            continue
        base = f"{analysis.name}-{contact}"
        yield f"{base}-impulse-and-peak", functools.partial(impulse_and_peak, sheet)
        yield f"{base}-restitution", functools.partial(restitution_over_speed, sheet)
        yield f"{base}-damping-factor", functools.partial(damping_factor_over_speed, sheet)
        if sheet.moves:
            yield f"{base}-pulses", functools.partial(first_pulses, sheet)
        if not analysis.grid:
            yield f"{base}-restitution-map", functools.partial(restitution_map, sheet)
            yield f"{base}-ratio", functools.partial(restitution_over_ratio, sheet)
            if analysis.has(sheet.path("record/force")):
                yield f"{base}-record", functools.partial(force_record, sheet)


class Sheet:
    """Results of one identified contact."""

    def __init__(self, analysis: Analysis, contact: str):
        self.analysis = analysis
        self.contact = contact

    @property
    def moves(self) -> bool:
        """Is there a motion beside the record?"""
        return self.analysis.has(f"contact/{self.contact}/impact/approach_speed")

    def path(self, name: str) -> str:
        return f"contact/{self.contact}/identification/{name}"

    def identified(self, name: str) -> np.ndarray:
        """Of all impacts of all cases, NaN included."""
        return self.analysis.read(self.path(name)).values.ravel()

    def one(self, name: str) -> float:
        """A number of the first case."""
        return float(self.analysis.read(self.path(name)).values.ravel()[0])

    def of_motion(self, name: str) -> np.ndarray:
        if not self.moves:
            return np.array([])
        return self.analysis.read(f"contact/{self.contact}/impact/{name}").values.ravel()

    def rows(self, path: str) -> np.ndarray:
        """Case, position; a coordinate that all cases share is repeated."""
        values = self.analysis.read(path).values
        rows = values.reshape(-1, values.shape[-1])
        return np.broadcast_to(rows, (len(cases(self.analysis)), rows.shape[1]))


def impulse_and_peak(sheet: Sheet):
    figure, (axes,) = style.panels(1, height=3.2)
    axes.loglog(sheet.identified("peak_force"), sheet.identified("impulse"), "o")
    axes.set(xlabel="Peak force $f_m$ (N)", ylabel="Impulse $J$ (N s)",
             title=f"Contact {sheet.contact}")
    return figure


def restitution_over_speed(sheet: Sheet):
    """e over v_c by each set with its interval, and what the motion itself shows."""
    figure, (axes,) = style.panels(1, height=3.6)
    for name, colour in SETS.items():
        speed = sheet.identified(f"{name}/approach_speed")
        middle, low, high = (sheet.identified(f"{name}/restitution_{end}")
                             for end in ("coefficient", "low", "high"))
        known = np.isfinite(middle)
        axes.errorbar(speed[known], middle[known], np.array([middle - low, high - middle])[:, known],
                      fmt="o", color=colour, elinewidth=0.5, label=name)
    if sheet.moves:
        axes.plot(sheet.of_motion("approach_speed"), sheet.of_motion("restitution_coefficient"),
                  "k+", markersize=6, label="motion")
        draw_fit(axes, sheet)
    else:
        draw_fit_of_record(axes, sheet)
    axes.set_xscale("log")
    axes.set(xlabel="Approach speed $v_c$ (m/s)", ylabel=RESTITUTION,
             title=f"Contact {sheet.contact}")
    note(axes, Panel(Meaning(("approach_speed",), "m/s", Scale(1.0, "m/s")),
                     Meaning(("restitution_coefficient",), "1", Scale(1.0, ""))))
    style.legend_beside(axes)
    return figure


def draw_fit(axes, sheet: Sheet) -> None:
    """Power law through the hard impacts of the exact set, least squares in ln e."""
    speed = sheet.identified("exact/approach_speed")
    restitution = sheet.identified("exact/restitution_coefficient")
    usable = (restitution > 0) & (speed > HARD)
    if np.unique(speed[usable]).size < 2:
        return
    exponent, logarithm = np.polyfit(np.log(speed[usable]), np.log(restitution[usable]), 1)
    span = np.geomspace(speed[usable].min(), speed[usable].max(), 50)
    axes.plot(span, np.exp(logarithm) * span**exponent, "--", color=SETS["exact"],
              label=f"exact: {np.exp(logarithm):.4g} $v_c^{{{exponent:.3g}}}$, above {HARD} m/s")


def draw_fit_of_record(axes, sheet: Sheet) -> None:
    """The program's power law of the exact set, with the laws at the ends of both intervals."""
    a, b = sheet.one("exact/fit_coefficient"), sheet.one("exact/fit_exponent")
    speed = sheet.identified("exact/approach_speed") / sheet.one("speed_unit")
    known = np.isfinite(speed)
    if not np.isfinite(a * b) or not known.any():
        return
    span = np.geomspace(speed[known].min(), speed[known].max(), 50)
    unit = sheet.one("speed_unit")
    axes.plot(span * unit, a * span**b, "--", color=SETS["exact"],
              label=f"exact: {a:.3g} $v_c^{{{b:.3g}}}$")
    ends = [sheet.one(f"exact/fit_{name}_{end}") for name in ("coefficient", "exponent")
            for end in ("low", "high")]
    if np.all(np.isfinite(ends)):
        laws = [c * span**d for c in ends[:2] for d in ends[2:]]
        axes.fill_between(span * unit, np.min(laws, axis=0), np.max(laws, axis=0), alpha=0.15,
                          color=SETS["exact"], linewidth=0, label="ends of the intervals of 95 %")


def damping_factor_over_speed(sheet: Sheet):
    figure, (axes,) = style.panels(1, height=3.2)
    for name, colour in SETS.items():
        axes.loglog(sheet.identified(f"{name}/approach_speed"),
                    sheet.identified(f"{name}/damping_factor"), "o", color=colour, label=name)
    unit = sheet.analysis.read(sheet.path("exact/damping_factor")).unit
    axes.set(xlabel="Approach speed $v_c$ (m/s)", ylabel=f"Damping factor $\\mu$ ({typeset(unit)})",
             title=f"Contact {sheet.contact}")
    style.legend_beside(axes)
    return figure


def first_pulses(sheet: Sheet):
    """Force of the first impact of every case, with its samples where there is a record."""
    figure, (axes,) = style.panels(1, height=3.2)
    time, force = (sheet.rows(f"contact/{sheet.contact}/pulse/{name}")
                   for name in ("time", "normal_force"))
    start = sheet.rows(f"contact/{sheet.contact}/impact/time")
    duration = sheet.rows(f"contact/{sheet.contact}/impact/duration")
    recorded = sheet.analysis.has(sheet.path("record/force"))
    for point, case in enumerate(cases(sheet.analysis)):
        inside = within(time[point], start[point, 0], duration[point, 0])
        axes.plot(1e6 * (time[point, inside] - start[point, 0]), force[point, inside],
                  color=case.colour, label=case.text or "force")
        if recorded:
            instants = sheet.rows(sheet.path("record/time"))[point]
            samples = sheet.rows(sheet.path("record/force"))[point]
            near = within(instants, start[point, 0], duration[point, 0])
            axes.plot(1e6 * (instants[near] - start[point, 0]), samples[near], "o",
                      color=case.colour, markersize=5)
    axes.set(xlabel="Time since first touch (µs)", ylabel="Contact force (N)",
             title=f"First impact of contact {sheet.contact}"
                   + (", dots: samples of the record" if recorded else ""))
    style.legend_beside(axes, title=name_of_grid(sheet.analysis) or None)
    return figure


def within(time: np.ndarray, start: float, duration: float) -> np.ndarray:
    return (time >= start) & (time <= start + duration)


def restitution_map(sheet: Sheet):
    """e over impulse and peak force, one panel for each set; dots are the impacts."""
    figure, panels = plt.subplots(1, len(SETS), figsize=(style.WIDTH, 2.4), sharey=True)
    impulse = sheet.analysis.read(sheet.path("impulse_axis"))
    force = sheet.analysis.read(sheet.path("peak_force_axis"))
    x, y = scale_for(impulse.unit, impulse.values), scale_for(force.unit, force.values)
    for axes, name in zip(panels, SETS):
        values = sheet.analysis.read(sheet.path(f"{name}/restitution_map")).values
        shown = axes.contourf(impulse.values / x.factor, force.values / y.factor, values.T,
                              np.linspace(-1, 1, 21), cmap=style.SEQUENCE)
        axes.plot(sheet.identified("impulse") / x.factor, sheet.identified("peak_force") / y.factor,
                  "wo", markeredgecolor="k", markersize=3)
        axes.set(title=name, xlabel=x.label("Impulse $J$"))
    panels[0].set_ylabel(y.label("Peak force $f_m$"))
    figure.colorbar(shown, ax=panels, label=RESTITUTION, pad=0.015)
    return figure


def restitution_over_ratio(sheet: Sheet):
    """The three formulas e(gamma), and the impacts as the motion shows them."""
    figure, (axes,) = style.panels(1, height=3.2)
    ratio = sheet.analysis.read(sheet.path("pulse_ratio_axis")).values
    for name, colour in SETS.items():
        axes.plot(ratio, sheet.analysis.read(sheet.path(f"{name}/restitution_curve")).values,
                  color=colour, label=name)
    if sheet.moves:
        axes.plot(sheet.identified("pulse_ratio"), sheet.of_motion("restitution_coefficient"),
                  "k+", markersize=6, label="motion")
    axes.set(xlabel=r"$\gamma = 8 k (f_m/k)^{(n+1)/n} / ((n+1) J^2 \lambda)$", ylabel=RESTITUTION,
             xlim=(1, ratio[-1]))
    style.legend_beside(axes)
    return figure


def force_record(sheet: Sheet):
    """The sampled record, and the pulses as they were."""
    figure, (axes,) = style.panels(1, height=2.8)
    if sheet.moves:
        axes.vlines(sheet.of_motion("peak_time"), 0, sheet.of_motion("peak_force"), color="0.7",
                    label="pulses, true peak")
    axes.plot(sheet.analysis.read(sheet.path("record/time")).values,
              sheet.analysis.read(sheet.path("record/force")).values, color=style.COLOURS[0],
              label="record")
    axes.set_yscale("symlog", linthresh=0.01)
    axes.set(xlabel="Time (s)", ylabel="Contact force (N)", title=f"Contact {sheet.contact}")
    style.legend_beside(axes)
    return figure
