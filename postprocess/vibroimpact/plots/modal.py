"""Mode shapes of every body with a mesh: of beams against the length along them, of shells as
surfaces."""

from __future__ import annotations

import functools

import numpy as np

from . import mode_surfaces, style
from .labels import scale_for, with_unit
from .results import Analysis, Body, Results

MOST_MODES = 7
WIDEST, THINNER = 2.6, 0.3  # a shape is seen below those that coincide with it


def figures(results: Results, analysis: Analysis):
    """One figure per body: name and what draws it."""
    if analysis.type != "modal":
        return
    for body in results.bodies():
        if body.has("shapes"):
            draw = mode_surfaces.shapes_of if body.has("surfaces") else shapes_of
            yield f"{analysis.name}-{body.name}", functools.partial(draw, body)


def shapes_of(body: Body):
    length = length_along(body.read("nodes").values, body.read("lines").values)
    scale = scale_for("m", length)
    figure, (axes,) = style.panels(1, height=2.6)
    frequency = body.read("frequency").values
    damping = body.read("damping_ratio").values
    shapes = body.read("shapes").values  # node, component, mode
    for mode in range(min(len(frequency), MOST_MODES)):
        shape, component = leading_component(shapes[:, :, mode])
        x, y = curve(length / scale.factor, shape, body.read("lines").values)
        axes.plot(
            x, y, color=style.COLOURS[mode], linewidth=WIDEST - mode * THINNER,
            label=f"{mode + 1}: {with_unit(f'{frequency[mode]:.4g}', 'Hz')}, {100 * damping[mode]:.3g} %, {component}",
        )
    axes.set_xlabel(scale.label("Length along the body"))
    axes.set_ylabel("Mode shape / its largest value")
    axes.set_title(f"Body {body.name}")
    style.legend_beside(axes, title="Mode: frequency, damping ratio")
    return figure


def length_along(nodes: np.ndarray, lines: np.ndarray) -> np.ndarray:
    """Distance of every node from the first node of the first line, along the lines [m].

    On a frame that branches, all branches are measured from that node.
    """
    distance = np.full(len(nodes), np.nan)
    distance[lines[0, 0]] = 0.0
    neighbours: dict[int, list[int]] = {}
    for a, b in lines:
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    reached = [lines[0, 0]]
    for node in reached:
        for other in neighbours[node]:
            if np.isnan(distance[other]):
                distance[other] = distance[node] + np.linalg.norm(nodes[other] - nodes[node])
                reached.append(other)
    return distance


def leading_component(shape: np.ndarray):
    """The displacement with the largest value, scaled to 1; a rotation where nothing moves."""
    names = ["$u_x$", "$u_y$", "$u_z$", r"$\theta_x$", r"$\theta_y$", r"$\theta_z$"]
    largest = np.abs(shape).max(axis=0)
    moves = largest[:3].max() > 1e-6 * largest[3:].max()
    component = int(np.argmax(largest[:3])) if moves else 3 + int(np.argmax(largest[3:]))
    values = shape[:, component]
    return values / values[np.argmax(np.abs(values))], names[component]


def curve(length: np.ndarray, shape: np.ndarray, lines: np.ndarray):
    """Points of a line through the elements, with a gap where one does not follow the other."""
    x, y, last = [], [], None
    for a, b in lines:
        if a != last:
            x += [np.nan, length[a]]
            y += [np.nan, shape[a]]
        x.append(length[b])
        y.append(shape[b])
        last = b
    return np.array(x), np.array(y)
