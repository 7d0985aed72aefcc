"""Time histories: contact force and gap, motion, the first impact close up, phase portraits."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D

from . import envelopes, style
from .axis_meaning import Meaning, Panel, note
from .cases import cases, explain
from .histories import shade
from .labels import key_label, quantity_label, scale_for, value_text
from .layout import places
from .motions import Motion, finely_sampled, parts
from .results import Analysis, Array, Results

MOST_STEMS = 200


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it."""
    if analysis.type != "transient":
        return
    for contact in analysis.members("contact"):
        if analysis.has(f"contact/{contact}/normal_force") and parts(analysis, "", contact):
            yield (f"{analysis.name}-contact-{contact}",
                   functools.partial(contact_history, analysis, contact))
            if swept_key(analysis, contact) is not None:
                yield (f"{analysis.name}-along-the-grid-{contact}",
                       functools.partial(along_the_grid, analysis, contact))
            if first_pulses(analysis, contact):
                yield (f"{analysis.name}-first-impact-{contact}",
                       functools.partial(close_up, analysis, contact))
    for connection in analysis.members("connection"):
        if analysis.has(f"connection/{connection}/elongation"):
            yield (f"{analysis.name}-elongation-{connection}",
                   functools.partial(motion, analysis, f"connection/{connection}",
                                     analysis.members(f"connection/{connection}")))
    for point in analysis.members("point"):
        quantities = analysis.members(f"point/{point}")
        if quantities:
            yield (f"{analysis.name}-motion-{point}",
                   functools.partial(motion, analysis, f"point/{point}", quantities))
        for quantity in quantities:
            velocity = quantity.replace("displacement", "velocity")
            if quantity.startswith("displacement") and velocity in quantities:
                yield (f"{analysis.name}-phase-{point}-{quantity[-1]}",
                       functools.partial(phase_portrait, analysis, point, quantity, velocity))


def of_case(array: Array, analysis: Analysis, index: tuple) -> np.ndarray:
    """The history of one case; a coordinate that all cases share has no outer axes."""
    return array.values if array.values.ndim == 1 else array.values[index]


def swept_key(analysis: Analysis, contact: str):
    """Number of the grid axis against which the first impacts are drawn, or None unless the grid
    has one key with numbers, at least three of them, and there was an impact; the values of further keys may be names."""
    keys = [analysis.read(name).values for name in analysis.grid_axes]
    swept = [i for i, values in enumerate(keys) if values.dtype.kind == "f"]
    fits = len(keys) in (1, 2) and len(swept) == 1 and len(keys[swept[0]]) >= 3
    peaks = f"contact/{contact}/impact/peak_force"
    return swept[0] if fits and analysis.has(peaks) and analysis.read(peaks).values.size else None


def along_the_grid(analysis: Analysis, contact: str):
    """Peak force, duration and restitution of the first impact against the swept key; a second
    key, with names, gives a family of curves."""
    table = f"contact/{contact}/impact/"
    keys = [analysis.read(name) for name in analysis.grid_axes]
    number = swept_key(analysis, contact)
    key = keys[number]
    family = [k for i, k in enumerate(keys) if i != number]
    names = [value_text(v, family[0].unit) for v in family[0].values] if family else [None]
    x_scale = scale_for(key.unit, key.values)
    figure, panels = style.panels(3)
    for axes, name, label in zip(panels, ["peak_force", "duration", "restitution_coefficient"],
                                 ["Peak force", "Duration", "Restitution coefficient"]):
        field = analysis.read(table + name)
        first = field.values[..., 0] if field.values.ndim > len(keys) else field.values
        scale = scale_for(field.unit, first)
        curves = np.moveaxis(first, number, -1).reshape(len(names), -1)
        for curve, text, colour in zip(curves, names, style.colours_along(len(names))):
            axes.plot(key.values / x_scale.factor, curve / scale.factor, "o-", color=colour,
                      label=text)
        axes.set_ylabel(scale.label(label))
        if np.all(key.values > 0) and key.values.max() > 20 * key.values.min():
            axes.set_xscale("log")
    panels[0].set_title(f"First impact of contact {contact}")
    panels[-1].set_xlabel(x_scale.label(key_label(analysis.grid[number])))
    if family:
        style.legend_beside(panels[0], panels[0].get_lines(),
                            key_label(analysis.grid[1 - number]))
    return figure


def draw(axes, analysis, x: Array, y: Array, x_scale, y_scale) -> None:
    for case in cases(analysis):
        axes.plot(
            of_case(x, analysis, case.index) / x_scale.factor,
            of_case(y, analysis, case.index) / y_scale.factor,
            color=case.colour,
        )


def draw_history(axes, analysis: Analysis, path: str, x_scale, y_scale) -> None:
    gap = path.replace("normal_force", "gap")
    for case in cases(analysis):
        time, values = (of_case(analysis.read(name), analysis, case.index) for name in ("time", path))
        if gap != path and analysis.has(gap):
            time, values, _ = envelopes.with_jumps(time, values,
                                                   of_case(analysis.read(gap), analysis, case.index))
        envelopes.draw(axes, time / x_scale.factor, values / y_scale.factor, color=case.colour)


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
        if not marked or shows_contacts(analysis, path):
            draw_history(axes, analysis, path, time_scale, scale)
        axes.set_ylabel(scale.label(label))
        note(axes, Panel(Meaning(("time",), time.unit, time_scale), Meaning((path,), field.unit, scale)))
    panels[0].set_title(title)
    panels[-1].set_xlabel(time_scale.label("Time"))
    explain(figure, panels, analysis, cases(analysis), handles)
    return figure


def contact_history(analysis: Analysis, contact: str):
    """Force and gap; of a contact that is never reached, or cannot close, the gap alone."""
    force, gap = f"contact/{contact}/normal_force", f"contact/{contact}/gap"
    if analysis.has(gap) and not np.any(np.nan_to_num(analysis.read(force).values)) and not has_impacts(analysis, contact):
        open_always = np.nanmin(analysis.read(gap).values) >= 0
        what = "never reached" if open_always else "which cannot close here"
        return histories(analysis, [(gap, "Gap")], f"Contact {contact}, {what}")
    rows = [(force, "Contact force")]
    peaks = impact_peaks(analysis, contact)
    many = peaks is not None and max(
        np.count_nonzero(np.isfinite(of_case(peaks[0], analysis, case.index)))
        for case in cases(analysis)) > MOST_STEMS  # their gap would be a block
    if analysis.has(gap) and not many:
        rows.append((gap, "Gap"))
    figure = histories(analysis, rows, f"Contact {contact}", peaks)
    draw_pulses(figure.axes[0], analysis, contact)
    return figure


def draw_pulses(axes, analysis: Analysis, contact: str) -> None:
    """Impacts are shorter than the sampling of a history; their own samples show them as they
    were."""
    time_scale = scale_for("s", analysis.read("time").values)
    force = analysis.read(f"contact/{contact}/normal_force")
    peaks = impact_peaks(analysis, contact)
    scale = scale_for(force.unit, force.values, peaks[1].values if peaks else [])
    for case in cases(analysis):
        time, samples, _ = pulses(analysis, contact, case.index)
        if np.isfinite(time).any():
            axes.plot(time / time_scale.factor, samples / scale.factor, color=case.colour)


def has_impacts(analysis: Analysis, contact: str) -> bool:
    peaks = impact_peaks(analysis, contact)
    return peaks is not None and bool(np.isfinite(peaks[0].values).any())


def impact_peaks(analysis: Analysis, contact: str):
    """Instant and force of the peaks of all impacts, or None. A history is sampled and can miss the
    peaks of short impacts; the table has them as they were."""
    table = f"contact/{contact}/impact/"
    if not analysis.has(table + "peak_time") or not analysis.has(table + "peak_force"):
        return None
    return analysis.read(table + "peak_time"), analysis.read(table + "peak_force")


def shows_contacts(analysis: Analysis, path: str) -> bool:
    """Whether the samples follow the contacts of every case; else the table of impacts stands for them."""
    contact = path.split("/")[1]
    return all(finely_sampled(Motion(analysis, "", place, ""), contact)
               for place in places(analysis))


def draw_peaks(axes, analysis: Analysis, peaks, time_scale, scale) -> Line2D:
    """A stem for every impact; of many their ends alone, which stems would hide. Rows behind the last impact of a case
    are NaN."""
    times, forces = peaks
    for case in cases(analysis):
        at, height = (of_case(times, analysis, case.index) / time_scale.factor,
                      of_case(forces, analysis, case.index) / scale.factor)
        known = np.isfinite(at)
        at, height = at[known], height[known]
        few = len(at) <= MOST_STEMS
        if few:
            axes.vlines(at, 0, height, color=case.colour, linewidth=0.9)
        axes.plot(at, height, "o", fillstyle="none", color=case.colour, markeredgewidth=0.6,
                  markersize=3.2 if few else 1.2)
    return Line2D([], [], color="#555555", marker="o", fillstyle="none", linestyle="",
                  label="peak of an impact")


def motion(analysis: Analysis, owner: str, quantities: list[str]):
    """Of a point or a connection: "point/first.mass"."""
    rows = [(f"{owner}/{quantity}", quantity_label(quantity)) for quantity in quantities]
    group, name = owner.split("/")
    figure = histories(analysis, rows, f"{group.capitalize()} {name}")
    if not analysis.grid and any(parts(analysis, "", contact) for contact in analysis.members("contact")):
        shade_contacts(figure, analysis)
    return figure


def shade_contacts(figure, analysis: Analysis) -> None:
    place = places(analysis)[0]
    time = analysis.read("time")
    handles = shade(figure.axes, Motion(analysis, "", place, ""), time.values, 0.0,
                    scale_for(time.unit, time.values))
    style.legend_beside(figure.axes[0], handles)


def pulses(analysis: Analysis, contact: str, index: tuple):
    """Time, force and gap of the impacts recorded at every time step; NaN between them."""
    group = f"contact/{contact}/pulse/"
    if not analysis.has(group + "time"):
        return np.array([]), np.array([]), np.array([])
    return tuple(of_case(analysis.read(group + name), analysis, index)
                 for name in ("time", "normal_force", "gap"))


def first_pulses(analysis: Analysis, contact: str):
    """Case, time, force and gap of the first recorded impact of every case that has one."""
    shown = []
    for case in cases(analysis):
        time, force, gap = pulses(analysis, contact, case.index)
        if time.size and np.isfinite(time[0]):
            end = np.flatnonzero(~np.isfinite(time))
            last = end[0] if end.size else time.size
            shown.append((case, time[:last], force[:last], gap[:last]))
    return shown


def close_up(analysis: Analysis, contact: str):
    """Force and penetration during the first recorded impact of every case."""
    shown = [(case, time, force, -gap) for case, time, force, gap in first_pulses(analysis, contact)]
    time_scale = scale_for("s", np.concatenate([t - t[0] for _, t, _, _ in shown]))
    figure, panels = style.panels(2)
    for axes, unit, label, k in zip(panels, ["N", "m"], ["Contact force", "Penetration"], [2, 3]):
        scale = scale_for(unit, np.concatenate([entry[k] for entry in shown]))
        for entry in shown:
            axes.plot((entry[1] - entry[1][0]) / time_scale.factor, entry[k] / scale.factor,
                      color=entry[0].colour)
        axes.set_ylabel(scale.label(label))
    start = f", {shown[0][1][0]:.6g} s" if len(shown) == 1 else ""
    panels[0].set_title(f"First impact of contact {contact}{start}")
    panels[-1].set_xlabel(time_scale.label("Time since the contact began"))
    explain(figure, panels, analysis, [entry[0] for entry in shown])
    return figure


def phase_portrait(analysis: Analysis, point: str, displacement: str, velocity: str):
    x = analysis.read(f"point/{point}/{displacement}")
    y = analysis.read(f"point/{point}/{velocity}")
    x_scale, y_scale = scale_for(x.unit, x.values), scale_for(y.unit, y.values)
    figure, (axes,) = style.panels(1, height=3.6)
    draw(axes, analysis, x, y, x_scale, y_scale)
    note(axes, Panel(*[Meaning((f"point/{point}/{quantity}",), array.unit, scale) for quantity, array, scale
                       in ((displacement, x, x_scale), (velocity, y, y_scale))]))
    axes.set_xlabel(x_scale.label(quantity_label(displacement)))
    axes.set_ylabel(y_scale.label(quantity_label(velocity)))
    axes.set_title(f"Point {point}")
    explain(figure, [axes], analysis, cases(analysis))
    return figure
