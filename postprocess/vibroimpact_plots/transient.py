"""Time histories: contact force and gap, motion, the first impact close up, phase portraits."""

from __future__ import annotations

import numpy as np
from matplotlib.lines import Line2D

from . import style
from .cases import cases, explain
from .labels import quantity_label, scale_for
from .results import Analysis, Array, Results

CLOSE_UP = "close_up/"


def figures(results: Results, analysis: Analysis):
    """Name and figure, one after the other."""
    for contact in analysis.members("contact"):
        if analysis.has(f"contact/{contact}/normal_force"):
            yield f"{analysis.name}-contact-{contact}", contact_history(analysis, contact)
            window = first_impact(analysis, contact)
            if window is not None:
                yield (f"{analysis.name}-first-impact-{contact}",
                       close_up(analysis, contact, *window))
    for point in analysis.members("point"):
        quantities = analysis.members(f"point/{point}")
        if quantities:
            yield f"{analysis.name}-motion-{point}", motion(analysis, point, quantities)
        for quantity in quantities:
            velocity = quantity.replace("displacement", "velocity")
            if quantity.startswith("displacement") and velocity in quantities:
                yield (f"{analysis.name}-phase-{point}-{quantity[-1]}",
                       phase_portrait(analysis, point, quantity, velocity))


def of_case(array: Array, analysis: Analysis, index: tuple) -> np.ndarray:
    """The history of one case; a coordinate that all cases share has no outer axes."""
    return array.values if array.values.ndim == 1 else array.values[index]


def draw(axes, analysis, x: Array, y: Array, x_scale, y_scale, shift=0.0) -> None:
    for case in cases(analysis):
        axes.plot(
            (of_case(x, analysis, case.index) - shift) / x_scale.factor,
            of_case(y, analysis, case.index) / y_scale.factor,
            color=case.colour,
        )


def histories(analysis: Analysis, rows: list[tuple[str, str]], title: str, peaks=None):
    """Fields below each other over the same time; `rows` holds path and label. `peaks` are times
    and values to be marked in the first."""
    time = analysis.read("time")
    time_scale = scale_for(time.unit, time.values)
    figure, panels = style.panels(len(rows))
    handles: list[Line2D] = []
    for axes, (path, label) in zip(panels, rows):
        field = analysis.read(path)
        marked = peaks is not None and axes is panels[0]
        scale = scale_for(field.unit, field.values, peaks[1].values if marked else [])
        if marked:
            handles.append(draw_peaks(axes, analysis, peaks, time_scale, scale))
        draw(axes, analysis, time, field, time_scale, scale)
        axes.set_ylabel(scale.label(label))
    panels[0].set_title(title)
    panels[-1].set_xlabel(time_scale.label("Time"))
    explain(figure, panels, analysis, cases(analysis), handles)
    return figure


def contact_history(analysis: Analysis, contact: str):
    rows = [(f"contact/{contact}/normal_force", "Contact force")]
    if analysis.has(f"contact/{contact}/gap"):
        rows.append((f"contact/{contact}/gap", "Gap"))
    peaks = impact_peaks(analysis, contact)
    return histories(analysis, rows, f"Contact {contact}", peaks)


def impact_peaks(analysis: Analysis, contact: str):
    """Start and peak force of all impacts, or None. A history is sampled and can miss the peaks of
    short impacts; the table has them as they were."""
    table = f"contact/{contact}/impact/"
    if not analysis.has(table + "start_time") or not analysis.has(table + "peak_force"):
        return None
    return analysis.read(table + "start_time"), analysis.read(table + "peak_force")


def draw_peaks(axes, analysis: Analysis, peaks, time_scale, scale) -> Line2D:
    times, forces = peaks
    for case in cases(analysis):
        axes.plot(of_case(times, analysis, case.index) / time_scale.factor,
                  of_case(forces, analysis, case.index) / scale.factor,
                  "o", fillstyle="none", color=case.colour)
    return Line2D([], [], color="#555555", marker="o", fillstyle="none", linestyle="",
                  label="peak of an impact")


def motion(analysis: Analysis, point: str, quantities: list[str]):
    rows = [(f"point/{point}/{quantity}", quantity_label(quantity)) for quantity in quantities]
    return histories(analysis, rows, f"Point {point}")


def first_impact(analysis: Analysis, contact: str):
    """Start and duration [s] of the first impact of the first case that has one, or None."""
    table = f"contact/{contact}/impact/"
    if not analysis.has(table + "start_time") or not analysis.has(table + "duration"):
        return None
    start = analysis.read(table + "start_time").values.reshape(-1)
    duration = analysis.read(table + "duration").values.reshape(-1)
    real = np.flatnonzero(np.isfinite(start) & (duration > 0))
    return (start[real[0]], duration[real[0]]) if real.size else None


def close_up(analysis: Analysis, contact: str, start: float, duration: float):
    """Force and gap around one impact; from the finer record where there is one of that time."""
    prefix = record_for(analysis, contact, start)
    time = analysis.read(prefix + "time")
    time_scale = scale_for("s", [2 * duration])
    figure, panels = style.panels(2)
    for axes, name, label in zip(panels, ["normal_force", "gap"], ["Contact force", "Gap"]):
        path = f"{prefix}contact/{contact}/{name}"
        if not analysis.has(path):
            continue
        field = analysis.read(path)
        first_case = of_case(field, analysis, (0,) * len(analysis.grid))
        times = of_case(time, analysis, (0,) * len(analysis.grid))
        inside = (times >= start - duration / 2) & (times <= start + 1.5 * duration)
        scale = scale_for(field.unit, first_case[inside])
        axes.plot((times[inside] - start) / time_scale.factor, first_case[inside] / scale.factor,
                  color=style.COLOURS[0])
        axes.set_ylabel(scale.label(label))
    panels[0].set_title(f"First impact of contact {contact}, {start:.6g} s")
    panels[-1].set_xlabel(time_scale.label("Time since first touch"))
    return figure


def record_for(analysis: Analysis, contact: str, start: float) -> str:
    if analysis.has(f"{CLOSE_UP}contact/{contact}/normal_force"):
        time = analysis.read(CLOSE_UP + "time").values
        if np.nanmin(time) <= start <= np.nanmax(time):
            return CLOSE_UP
    return ""


def phase_portrait(analysis: Analysis, point: str, displacement: str, velocity: str):
    x = analysis.read(f"point/{point}/{displacement}")
    y = analysis.read(f"point/{point}/{velocity}")
    x_scale, y_scale = scale_for(x.unit, x.values), scale_for(y.unit, y.values)
    figure, (axes,) = style.panels(1, height=3.6)
    draw(axes, analysis, x, y, x_scale, y_scale)
    axes.set_xlabel(x_scale.label(quantity_label(displacement)))
    axes.set_ylabel(y_scale.label(quantity_label(velocity)))
    axes.set_title(f"Point {point}")
    explain(figure, [axes], analysis, cases(analysis))
    return figure
