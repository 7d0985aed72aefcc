"""Designs of an isolator between stops: the linear step, the plane of the unfolding parameters, the set of
possible stops, and response curves of its regions."""

from __future__ import annotations

import functools

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator

from . import style
from .results import Analysis, Results

TYPE = "isolator design"
CHOSEN, CORNERS, REGIONS, LISTED = 1, (2, 3, 4), (5, 6, 7, 8), 9
REGION_NAMES = {5: "I", 6: "II", 7: "III", 8: "IV"}
LEAST_STIFFNESS, JUMP, LINEAR = style.COLOURS[:3]
ALPHAS = (r"$\alpha_1$", r"$\alpha_2$")
FORCE, STIFFNESS = r"$f$, static displacement over clearance", r"$\mu$, stiffness of the stop over isolator"


def figures(results: Results, analysis: Analysis):
    """Name of each figure and what draws it; none of grids of designs."""
    if analysis.axes or not analysis.has("hysteresis/z"):
        return
    for name, draw in (("transmissibility", transmissibility), ("sets", sets), ("region", region),
                       ("plane", plane), ("responses", responses)):
        yield f"{analysis.name}-{name}", functools.partial(draw, analysis)


def values(analysis: Analysis, path: str) -> np.ndarray:
    return np.asarray(analysis.read(path).values, dtype=float)


def number(analysis: Analysis, path: str) -> float:
    return float(values(analysis, path))


def stops(analysis: Analysis, kinds, *names):
    """Columns of the stops of these kinds."""
    wanted = np.isin(values(analysis, "stop/kind"), kinds)
    return [values(analysis, f"stop/{name}")[wanted] for name in names]


def transmissibility(analysis: Analysis):
    zeta, working = number(analysis, "damping_ratio"), number(analysis, "working_ratio")
    ratio = np.geomspace(0.1, max(10, 2 * working), 1000)
    figure, (axes,) = style.panels(1, height=2.8)
    axes.loglog(ratio, transmitted(ratio, zeta), color=LEAST_STIFFNESS, label="isolator")
    axes.plot(working, number(analysis, "transmissibility"), "*", markersize=11,
              color=style.COLOURS[1], markeredgecolor="white", linestyle="none",
              label="working frequency")
    if analysis.has("least_ratio"):
        wanted = number(analysis, "wanted_transmissibility")
        axes.axhline(wanted, color=style.GREY, linewidth=0.7, linestyle=":")
        axes.plot(number(analysis, "least_ratio"), wanted, "o", color=style.COLOURS[0],
                  linestyle="none", label="wanted")
    axes.set_xlabel(r"$\lambda$, excitation over natural frequency")
    axes.set_ylabel("Transmissibility")
    style.legend_beside(axes)
    return figure


def transmitted(ratio, zeta):
    dashpot = 2 * zeta * ratio
    return np.hypot(1, dashpot) / np.hypot(1 - ratio**2, dashpot)


def sets(analysis: Analysis):
    """The transition set, with examples of its regions and the stops of the file."""
    figure, (axes,) = style.panels(1, height=3.6)
    first = values(analysis, "set/alpha_1")
    for name, text, line in (("b2", "$B_2$", "-"), ("b3_plus", "$B_3^+$", "--"),
                             ("b3_minus", "$B_3^-$", "-.")):
        axes.plot(first, values(analysis, f"set/{name}"), line, color=LEAST_STIFFNESS, label=text)
    axes.axvline(0, color=LEAST_STIFFNESS, linewidth=2.5, label="$B_1$", clip_on=False)
    axes.plot(values(analysis, "hysteresis/alpha_1"), values(analysis, "hysteresis/alpha_2"),
              color=JUMP, label="$H$")
    for kind, text in REGION_NAMES.items():
        x, y = stops(analysis, kind, "alpha_1", "alpha_2")
        axes.plot(x, y, ".", color=style.GREY)
        for at in zip(x, y):  # the curves rise: a name on the left of its point stands between them
            axes.annotate(text, at, xytext=(-4, 1), textcoords="offset points", ha="right")
    mark_stops(axes, analysis, "alpha_1", "alpha_2")
    axes.set(xlim=(0, 1), ylim=(-1.15, 1), xlabel=ALPHAS[0], ylabel=ALPHAS[1])
    style.legend_beside(axes)
    return figure


def mark_stops(axes, analysis: Analysis, x: str, y: str) -> None:
    listed = stops(analysis, LISTED, x, y)
    if len(listed[0]) > 0:
        axes.plot(*listed, "s", color=style.COLOURS[3], linestyle="none", label="of the file")
    axes.plot(*stops(analysis, CORNERS, x, y), "o", markerfacecolor="white", color="black",
              linestyle="none", label="corners")
    chosen = stops(analysis, CHOSEN, x, y)
    if len(chosen[0]) > 0:
        axes.plot(*chosen, "*", markersize=11, color=style.COLOURS[1], markeredgecolor="white",
                  linestyle="none", label="chosen", zorder=4)


def possible(analysis: Analysis) -> np.ndarray:
    """Where along the forces a stop can meet all conditions."""
    return (values(analysis, "limit/least_stiffness") <= values(analysis, "limit/largest_stiffness"))


def region(analysis: Analysis):
    """The possible stops in the plane of the unfolding parameters."""
    figure, (axes,) = style.panels(1, height=3.6)
    cusps = [values(analysis, f"hysteresis/{name}") for name in ("alpha_1", "alpha_2")]
    least = [values(analysis, f"limit/least_stiffness_{name}") for name in ("alpha_1", "alpha_2")]
    first = np.linspace(0, 1, 400) ** 2
    curvature = values(analysis, "set/largest_force")[-1] / values(analysis, "set/alpha_1")[-1] ** 2
    axes.plot(first, curvature * first**2, "-.", color=LINEAR, label=r"(a) $f_\mathrm{max}$")
    axes.plot(*least, "--", color=LEAST_STIFFNESS, label="(b) allowed displacement")
    axes.plot(*cusps, color=JUMP, label="(c) $H$")
    corners = [number(analysis, f"corner/{name}/alpha_1")
               for name in ("resonance_and_jump", "linear_and_resonance", "linear_and_jump")]
    if np.isfinite(corners).all():
        shade(axes, cusps, least, first, curvature, corners)
    mark_stops(axes, analysis, "alpha_1", "alpha_2")
    axes.set(xlim=(0, 0.5), ylim=(-4, 0.3), xlabel=ALPHAS[0], ylabel=ALPHAS[1])
    style.legend_beside(axes)
    return figure


def shade(axes, cusps, least, first, curvature, corners) -> None:
    """Along (b), back along the parabola (a), and along H."""
    right = np.argsort(least[0])
    right = right[(least[0][right] >= corners[0]) & (least[0][right] <= corners[1])]
    left = first[(first <= corners[1]) & (first >= corners[2])][::-1]
    above = (cusps[0] >= corners[2]) & (cusps[0] <= corners[0])
    x = np.concatenate([least[0][right], left, cusps[0][above]])
    y = np.concatenate([least[1][right], curvature * left**2, cusps[1][above]])
    axes.fill(x, y, color=style.COLOURS[4], alpha=0.25, linewidth=0, label="possible stops")


def plane(analysis: Analysis):
    """The same in the plane of force and stiffness."""
    figure, (axes,) = style.panels(1, height=3.6)
    force, least, most, first = (values(analysis, f"limit/{name}") for name in
                                 ("force", "least_stiffness", "largest_stiffness",
                                  "first_jump_stiffness"))
    axes.axvline(number(analysis, "largest_force"), color=LINEAR, linestyle="-.",
                 label=r"(a) $f_\mathrm{max}$")
    axes.plot(force, least, "--", color=LEAST_STIFFNESS, label="(b) allowed displacement")
    axes.plot(force, most, color=JUMP, label="(c) no jump")
    axes.plot(force, first, ":", color=JUMP, label="first jump\nby averaging")
    axes.fill_between(force, least, most, where=possible(analysis), color=style.COLOURS[4],
                      alpha=0.25, linewidth=0, label="possible stops")
    axes.axvline(number(analysis, "present/force"), color=style.GREY, linewidth=0.7,
                 linestyle=":", label="clearance of the file")
    mark_stops(axes, analysis, "force", "stiffness")
    axes.set(xscale="log", yscale="log", ylim=(0.05, 50), xlabel=FORCE, ylabel=STIFFNESS)
    axes.set_xlim(right=1.1 * number(analysis, "largest_force"))
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter("")
    style.legend_beside(axes)
    return figure


def responses(analysis: Analysis):
    """Amplitude over frequency for an example of each region."""
    figure, panels = style.panel_grid(4, columns=2, share=False)
    for axes, (kind, text) in zip(panels, REGION_NAMES.items()):
        row = int(np.flatnonzero(values(analysis, "stop/kind") == kind)[0])
        response(axes, analysis, row)
        force, stiffness = (values(analysis, f"stop/{name}")[row]
                            for name in ("force", "stiffness"))
        axes.set_title(f"{text}: $f$ = {force:.3g}, $\\mu$ = {stiffness:.3g}")
        axes.set(xlabel=r"$\lambda$", ylabel=r"max $|y|$ / clearance")
    entries = [Line2D([], [], color=style.COLOURS[1], linestyle=":", label="expansion"),
               Line2D([], [], color=style.COLOURS[2], linestyle="--", label="averaging")]
    if analysis.has("stop/exact/stable"):
        entries += [Line2D([], [], color="black", label="exact, stable"),
                    Line2D([], [], color="black", linestyle=(0, (2, 1.5)), label="exact, unstable")]
    figure.get_layout_engine().set(rect=(0, 0.06, 1, 0.94))
    figure.legend(handles=entries, loc="lower center", ncols=len(entries))
    return figure


def response(axes, analysis: Analysis, row: int) -> None:
    def curve(group, name):
        return values(analysis, f"stop/{group}/{name}")[row]

    if analysis.has("stop/exact/stable"):
        ratio, amplitude = curve("exact", "frequency_ratio"), curve("exact", "amplitude")
        stable = curve("exact", "stable") == 1
        axes.plot(ratio, np.where(stable, amplitude, np.nan), color="black")
        axes.plot(ratio, np.where(stable, np.nan, amplitude), color="black",
                  linestyle=(0, (2, 1.5)))
    ratio, amplitude = curve("averaged", "frequency_ratio"), curve("averaged", "amplitude")
    axes.plot(ratio, amplitude, "--", color=style.COLOURS[2])
    axes.plot(curve("expansion", "frequency_ratio"), 1 / curve("expansion", "z"), ":",
              color=style.COLOURS[1])
    shown = np.concatenate([ratio, curve("expansion", "frequency_ratio")])
    width = np.nanmax(shown) - np.nanmin(shown)
    axes.set_xlim(max(0, np.nanmin(shown) - 0.2 * width), np.nanmax(shown) + 0.2 * width)
    axes.set_ylim(0, 1.1 * np.nanmax(np.concatenate([amplitude, 1 / curve("expansion", "z")])))
