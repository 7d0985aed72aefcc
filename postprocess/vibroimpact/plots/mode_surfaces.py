"""Mode shapes of shells: flat bodies as maps of the displacement across them, others in space.

Lengths are in metres, shapes are scaled: only their form has a meaning.
"""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from . import style
from .labels import scale_for, with_unit
from .results import Body

MOST_MODES = 9
COLUMNS = 3
SIGNED = "RdBu_r"
HELD = 1e-6  # of the largest displacement
FLAT = 1e-6  # thickness of the cloud of nodes relative to its extent
DRAWN = 0.1  # largest displacement of a drawn mode, relative to the extent of the body
MOST_EDGES = 2500  # surfaces of a mesh whose edges are drawn


@dataclass(frozen=True)
class Shell:
    """The mesh of a body and its modes."""

    nodes: np.ndarray     # node, axis [m]
    surfaces: np.ndarray  # surface, corner; -1 behind the third of a triangle
    lines: np.ndarray     # line, end: stiffeners
    frequency: np.ndarray  # mode [Hz]
    shapes: np.ndarray    # node, axis, mode: displacements

    @property
    def corners(self) -> list[np.ndarray]:
        return [nodes[nodes >= 0] for nodes in self.surfaces]

    @property
    def extent(self) -> float:
        return float(np.linalg.norm(np.ptp(self.nodes, axis=0)))

    def title(self, mode: int) -> str:
        return f"Mode {mode + 1}: {with_unit(f'{self.frequency[mode]:.4g}', 'Hz')}"


def shell_of(body: Body) -> Shell:
    lines = body.read("lines").values if body.has("lines") else np.empty((0, 2), int)
    return Shell(body.read("nodes").values, body.read("surfaces").values, lines,
                 body.read("frequency").values, body.read("shapes").values[:, :3, :])


def shapes_of(body: Body):
    shell = shell_of(body)
    plane = plane_of(shell.nodes)
    shown = min(len(shell.frequency), MOST_MODES)
    figure = in_space(shell, shown) if plane is None else in_plane(shell, plane, shown)
    all_modes = len(shell.frequency)
    which = "" if shown == all_modes else f", the first {shown} of {all_modes} modes"
    figure.suptitle(f"Body {body.name}{which}", x=0.02, ha="left", fontsize=10)
    return figure


@dataclass(frozen=True)
class Plane:
    """Unit vectors of a plane, and what the coordinates along the first two are called."""

    axes: np.ndarray  # first, second, normal
    names: tuple[str, str]
    origin: np.ndarray


def plane_of(nodes: np.ndarray):
    """The plane that holds all nodes; None when there is none."""
    middle = nodes.mean(axis=0)
    _, sizes, directions = np.linalg.svd(nodes - middle, full_matrices=False)
    if sizes[2] > FLAT * sizes[0]:
        return None
    normal = directions[2] * np.sign(directions[2][np.argmax(np.abs(directions[2]))])
    along = int(np.argmin(np.abs(normal)))
    if np.abs(normal).max() > 1 - FLAT:
        first, second = (i for i in range(3) if i != int(np.argmax(np.abs(normal))))
        unit = np.eye(3)
        return Plane(np.array([unit[first], unit[second], normal]),
                     tuple("xyz"[i] for i in (first, second)), np.zeros(3))
    first = np.eye(3)[along] - normal[along] * normal
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    corner = nodes[np.argmin(nodes @ (first + second))]
    return Plane(np.array([first, second, normal]), ("Along the plane", "Across it"), corner)


def in_plane(shell: Shell, plane: Plane, shown: int):
    """Colours tell the displacement across the plane; a mode within it is drawn deformed."""
    places = (shell.nodes - plane.origin) @ plane.axes[:2].T
    scale = scale_for("m", places)
    aspect = np.ptp(places[:, 1]) / np.ptp(places[:, 0])
    columns = COLUMNS if aspect > 0.35 else 2 if aspect > 0.15 else 1
    width = style.WIDTH / min(columns, shown)
    figure, panels = style.panel_grid(shown, columns, height=max(0.9, 0.75 * width * aspect + 0.35))
    for mode, axes in enumerate(panels):
        draw_in_plane(axes, shell, plane, places / scale.factor, mode)
        axes.set_title(shell.title(mode))
        axes.set_aspect("equal")
        axes.grid(False)
        axes.yaxis.set_major_locator(MaxNLocator(4))
    style.label_grid(panels, scale.label(plane.names[0]), scale.label(plane.names[1]))
    colour_bar(figure, panels, "Displacement across / its largest value", SIGNED, -1)
    return figure


def draw_in_plane(axes, shell: Shell, plane: Plane, places: np.ndarray, mode: int) -> None:
    shape = shell.shapes[:, :, mode] @ plane.axes.T
    across = np.abs(shape[:, 2]).max()
    within = np.linalg.norm(shape[:, :2], axis=1).max()
    if across >= within:
        height = shape[:, 2] / shape[np.argmax(np.abs(shape[:, 2])), 2]
        triangles = triangles_of(shell.corners)
        axes.tripcolor(places[:, 0], places[:, 1], triangles, height, shading="gouraud",
                       cmap=SIGNED, vmin=-1, vmax=1, rasterized=True)
        if height.min() < -HELD:
            axes.tricontour(inner_triangles(shell, places, height), height, levels=[0],
                            colors=style.GREY, linewidths=0.6)
        outline, colour = places, style.GREY
    else:
        outline = places + DRAWN * np.linalg.norm(np.ptp(places, axis=0)) * shape[:, :2] / within
        colour = "black"
        axes.add_collection(LineCollection(borders(shell, places), colors=style.GREY,
                                           linewidths=0.5, linestyles="--"))
        axes.add_collection(PolyCollection([outline[c] for c in shell.corners], facecolors="none",
                                           edgecolors="#BBBBBB", linewidths=0.2))
    axes.add_collection(LineCollection(borders(shell, outline), colors=colour, linewidths=0.7))
    axes.add_collection(LineCollection([outline[line] for line in shell.lines], colors="black",
                                       linewidths=1.2))
    axes.autoscale_view()


def inner_triangles(shell: Shell, places: np.ndarray, height: np.ndarray) -> Triangulation:
    """Without those along a held border, which nodal lines would follow."""
    held = np.zeros(len(places), bool)
    held[[node for side in border_sides(shell) for node in side]] = True
    held &= np.abs(height) < HELD
    triangles = triangles_of(shell.corners)
    return Triangulation(*places.T, triangles, mask=held[triangles].sum(axis=1) > 1)


def in_space(shell: Shell, shown: int):
    """Deformed and coloured by the length of the displacement; the border at rest is grey."""
    columns = min(COLUMNS, shown)
    rows = -(-shown // columns)
    size = style.WIDTH / columns
    figure, panels = plt.subplots(rows, columns, figsize=(style.WIDTH, 0.6 + 0.95 * size * rows),
                                  squeeze=False, subplot_kw={"projection": "3d"})
    for unused in panels.flat[shown:]:
        unused.remove()
    panels = list(panels.flat[:shown])
    for mode, axes in enumerate(panels):
        draw_in_space(axes, shell, mode)
        axes.set_title(shell.title(mode), loc="center")
    name_axes(panels[0], shell)
    colour_bar(figure, panels, "Displacement / its largest value", style.SEQUENCE, 0)
    return figure


def draw_in_space(axes, shell: Shell, mode: int) -> None:
    shape = shell.shapes[:, :, mode]
    moved = np.linalg.norm(shape, axis=1)
    largest = moved.max() if moved.max() > 0 else 1.0
    deformed = shell.nodes + DRAWN * shell.extent * shape / largest
    corners = shell.corners
    colours = plt.get_cmap(style.SEQUENCE)([moved[c].mean() / largest for c in corners])
    faces = Poly3DCollection([deformed[c] for c in corners], facecolors=colours,
                             edgecolors="#00000030" if len(corners) <= MOST_EDGES else "none",
                             linewidths=0.2)
    faces.set_rasterized(True)
    axes.add_collection3d(faces)
    axes.add_collection3d(Line3DCollection(borders(shell, shell.nodes), colors=style.GREY,
                                           linewidths=0.6))
    axes.add_collection3d(Line3DCollection([deformed[line] for line in shell.lines],
                                           colors="black", linewidths=1.0))
    frame(axes, shell.nodes)


def frame(axes, nodes: np.ndarray) -> None:
    """Equal scales along all axes, without the box of Matplotlib."""
    middle = (nodes.max(axis=0) + nodes.min(axis=0)) / 2
    half = np.maximum(np.ptp(nodes, axis=0), 0.3 * np.ptp(nodes, axis=0).max()) / 2
    half += DRAWN / 2 * np.linalg.norm(np.ptp(nodes, axis=0))
    for setter, centre, length in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), middle, half):
        setter(centre - length, centre + length)
    axes.set_box_aspect(half, zoom=0.95)
    for setter in (axes.set_xticks, axes.set_yticks, axes.set_zticks):
        setter([])
    axes.set_axis_off()
    axes.view_init(elev=22, azim=-55)


def name_axes(axes, shell: Shell) -> None:
    """Arrows along x, y and z beside the body."""
    start = shell.nodes.min(axis=0) - np.array([0.1, 0.1, 0]) * shell.extent
    for direction, name in zip(np.eye(3), "xyz"):
        end = start + 0.15 * shell.extent * direction
        axes.plot(*np.array([start, end]).T, color="black", linewidth=0.8)
        axes.text(*(end + 0.04 * shell.extent * direction), f"${name}$", fontsize=8, ha="center",
                  va="center")


def triangles_of(corners: list[np.ndarray]) -> np.ndarray:
    """Quadrilaterals cut in two."""
    return np.array([nodes[[0, i, i + 1]] for nodes in corners for i in range(1, len(nodes) - 1)])


def border_sides(shell: Shell) -> list[tuple[int, int]]:
    """Sides of one surface alone; of a closed body without any, none."""
    count: dict[tuple[int, int], int] = {}
    for nodes in shell.corners:
        for a, b in zip(nodes, np.roll(nodes, -1)):
            side = (int(min(a, b)), int(max(a, b)))
            count[side] = count.get(side, 0) + 1
    return [side for side, times in count.items() if times == 1]


def borders(shell: Shell, places: np.ndarray) -> list[np.ndarray]:
    return [places[list(side)] for side in border_sides(shell)]


def colour_bar(figure, panels, label: str, colours: str, lowest: float) -> None:
    figure.colorbar(ScalarMappable(Normalize(lowest, 1), plt.get_cmap(colours)), ax=panels,
                    label=label, pad=0.02, shrink=0.8, aspect=30)
