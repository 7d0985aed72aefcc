"""A motion as an animated picture (GIF), or one instant of it (PNG), from the files that a run writes for ParaView.

Shells and beams, with the sides around their cross-sections, are drawn deformed and coloured; a red point is a node on which a contact force acts. Stops are drawn
where their faces are: node and stop meet where the gap is zero, whatever the displacements are multiplied with.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgb
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from .errors import ResultError
from .labels import Scale, scale_for
from .vtu import Mesh, instants, read_mesh

SHOWN = 0.1  # largest displacement of the picture relative to the size of the bodies
COLOURS = 64
MAP = "viridis"
CONTACT = "#C8102E"
STOP = "#6E6E6E"
MODES = "modes"  # file of the mode shapes, by frequency
MOST_MARKED = 100  # nodes with a contact force; more of them would hide the surface, whose colour can show the force
ARROW = 0.18  # longest arrow of a contact force relative to the size of the bodies
SURFACE = 0.7  # opacity of shells, behind which their stops stand
TITLES = {"displacement": ("Displacement", "m"), "velocity": ("Velocity", "m/s"),
          "von_mises_stress": ("Von Mises stress", "Pa"),
          "von_mises_stress_first_face": ("Von Mises stress, first face", "Pa"),
          "von_mises_stress_second_face": ("Von Mises stress, second face", "Pa"),
          "contact_force": ("Contact force", "N"), "peak_contact_force": ("Peak contact force", "N")}


@dataclass(frozen=True)
class Style:
    """What the command line says."""

    field: str | None = None      # von Mises stress where it is there, else the displacement
    factor: float | None = None   # of the displacements
    view: tuple[float, float] = (-60.0, 25.0)  # azimuth and elevation in degrees
    frames: int = 60
    rate: float = 15.0            # pictures a second
    size: tuple[float, float] = (5.0, 3.6)  # inches
    dpi: float = 100.0
    modes: bool = False           # shapes of modes, without a unit
    arrows: bool = False          # contact forces as arrows, beside the points at which they act


@dataclass(frozen=True)
class Instant:
    time: float
    parts: dict[str, Mesh]  # frame, frame lines, sections, lumped, stops, supports

    def bodies(self) -> list[Mesh]:
        return [mesh for name, mesh in self.parts.items() if name not in ("stops", "supports")]


def animate(results: Path, analysis: str, file: Path, style: Style) -> None:
    """Writes the motion of an analysis as a GIF."""
    motion = read_motion(results, analysis, style.frames)
    field = style.field or usual_field(motion)
    factor = style.factor if style.factor is not None else usual_factor(motion)
    picture = Picture(motion, field, factor, style)
    try:
        write([picture.draw(instant) for instant in motion], file, style.rate)
    finally:
        plt.close(picture.figure)


def still(results: Path, analysis: str, number: int, file: Path, style: Style) -> None:
    """Writes one of the recorded instants of an analysis, counted from 1; colours and axes are those of all. Of
    the modes one, whose size has no meaning."""
    from PIL import Image  # comes with Matplotlib

    motion = read_motion(results, analysis, None)
    if not 1 <= number <= len(motion):
        raise ResultError(f"--instant {number}: {analysis} has the instants 1 to {len(motion)}")
    if analysis == MODES:  # which have nothing in common
        motion, number, style = [motion[number - 1]], 1, replace(style, field="displacement", modes=True)
    picture = Picture(motion, style.field or usual_field(motion),
                      style.factor if style.factor is not None else usual_factor(motion), style)
    Image.fromarray(picture.draw(motion[number - 1])).save(file)
    plt.close(picture.figure)


def read_motion(results: Path, analysis: str, frames: int | None) -> list[Instant]:
    """At most `frames` instants, all without it."""
    pvd = results / f"{analysis}.pvd"
    if not pvd.is_file():
        known = sorted(path.stem for path in results.glob("*.pvd") if path.stem != MODES)
        there = f"; there are: {', '.join(known)}" if known else ": no transient analysis recorded frames"
        raise ResultError(f"{results}: there is no motion {analysis}.pvd{there}")
    every = instants(pvd)
    chosen = np.unique(np.linspace(0, len(every) - 1, min(frames or len(every), len(every))).round().astype(int))
    return [Instant(time, {part_of(path): read_mesh(path) for path in files})
            for time, files in (every[i] for i in chosen)]


def part_of(path: Path) -> str:
    name = path.stem.split("-")
    return " ".join([name[0], *name[2:]])


def usual_field(motion: list[Instant]) -> str:
    has_stress = any("von_mises_stress" in mesh.data for mesh in motion[0].bodies())
    return "von_mises_stress" if has_stress else "displacement"


def usual_factor(motion: list[Instant]) -> float:
    points = np.concatenate([mesh.points for mesh in motion[0].bodies()])
    extent = np.linalg.norm(np.ptp(points, axis=0))
    largest = max(np.linalg.norm(mesh.data["displacement"], axis=1).max()
                  for instant in motion for mesh in instant.bodies())
    return float(SHOWN * extent / largest) if largest > 0 and extent > 0 else 1.0


def largest_force(instant: Instant) -> float:
    forces = [np.linalg.norm(mesh.data["contact_force"], axis=1).max(initial=0.0)
              for mesh in instant.bodies() if "contact_force" in mesh.data]
    return max(forces, default=0.0) or 1.0


def magnitudes(mesh: Mesh, field: str) -> np.ndarray:
    """At the points; NaN where the field is not known."""
    if field not in mesh.data:
        return np.full(len(mesh.points), np.nan)
    data = mesh.data[field]
    return np.linalg.norm(data, axis=1) if data.ndim == 2 else data


class Picture:
    """One figure that all instants are drawn into, with the same axes and colours."""

    def __init__(self, motion: list[Instant], field: str, factor: float, style: Style):
        known = sorted({name for mesh in motion[0].bodies() for name in mesh.data} & set(TITLES))
        if field not in known:
            raise ResultError(f"there is no field {field}; there are: {', '.join(known)}")
        self.field, self.factor, self.style = field, factor, style
        self.draws_lines = True  # where results have no sides of beams
        title, unit = TITLES[field]
        every = np.concatenate([magnitudes(mesh, field) for instant in motion for mesh in instant.bodies()])
        self.scale = scale_for(unit, every[np.isfinite(every)])
        if style.modes:
            title, self.scale = "Displacement / its largest value", Scale(np.nanmax(every) or 1.0, "")
        self.colours = ScalarMappable(Normalize(0, max(np.nanmax(every) / self.scale.factor, 1e-300)), MAP)
        self.figure = plt.figure(figsize=style.size, dpi=style.dpi, layout="none")
        self.axes = self.figure.add_axes([-0.02, -0.12, 0.9, 1.2], projection="3d", azim=style.view[0],
                                         elev=style.view[1], computed_zorder=False)
        bar = self.figure.add_axes([0.87, 0.25, 0.02, 0.5])
        self.figure.colorbar(self.colours, cax=bar, label=self.scale.label(title))
        self.set_limits(motion)

    def set_limits(self, motion: list[Instant]) -> None:
        moved = np.concatenate([mesh.moved(self.factor) for instant in motion for mesh in instant.parts.values()])
        low, high = moved.min(axis=0), moved.max(axis=0)
        self.extent = np.linalg.norm(high - low)
        room = np.maximum(high - low, 1e-3 * max((high - low).max(), 1e-12))
        for name, start, length in zip("xyz", low, room):
            getattr(self.axes, f"set_{name}lim")(start, start + length)
        self.axes.set_box_aspect(room, zoom=1.0)

    def draw(self, instant: Instant):
        """The picture as it is drawn, in red, green and blue."""
        for artist in [*self.axes.collections, *self.axes.lines, *self.figure.texts]:
            artist.remove()
        self.axes.set_axis_off()
        self.draws_lines = "sections" not in instant.parts
        self.arrows_of = largest_force(instant) if self.style.arrows else None
        for name, mesh in instant.parts.items():
            getattr(self, {"stops": "draw_stops", "supports": "draw_supports"}.get(name, "draw_body"))(mesh)
        self.figure.text(0.03, 0.94, f"Mode at {instant.time:.4g} Hz" if self.style.modes else
                         f"t = {instant.time:.4f} s,  displacements × {self.factor:.3g}", fontsize=9)
        self.figure.canvas.draw()
        return np.asarray(self.figure.canvas.buffer_rgba())[:, :, :3].copy()

    def draw_body(self, mesh: Mesh) -> None:
        places = mesh.moved(self.factor)
        values = magnitudes(mesh, self.field) / self.scale.factor
        for corners in (2, 3, 4) if self.draws_lines else (3, 4):
            cells = np.array([cell for cell in mesh.cells if len(cell) == corners])
            if len(cells):
                self.draw_cells(places[cells], values[cells].mean(axis=1))
        if not mesh.cells:
            self.axes.scatter(*places.T, s=60, c=self.colours.to_rgba(values), depthshade=False, zorder=2)
        if "contact_force" in mesh.data:
            touched = places[np.linalg.norm(mesh.data["contact_force"], axis=1) > 0]
            if len(np.unique(touched, axis=0)) > MOST_MARKED:
                return
            self.axes.scatter(*touched.T, s=22, c=CONTACT, depthshade=False, zorder=3)
            if self.arrows_of is not None and len(touched):
                forces = mesh.data["contact_force"]
                self.draw_arrows(touched, forces[np.linalg.norm(forces, axis=1) > 0])

    def draw_arrows(self, places: np.ndarray, forces: np.ndarray) -> None:
        """The largest force of the instant ARROW of the bodies long."""
        lengths = forces * (ARROW * self.extent / self.arrows_of)
        self.axes.quiver(*places.T, *lengths.T, color=CONTACT, linewidth=1.2, arrow_length_ratio=0.2, zorder=4)

    def draw_cells(self, places: np.ndarray, values: np.ndarray) -> None:
        colours = self.colours.to_rgba(values)
        if places.shape[1] == 2:
            self.axes.add_collection3d(Line3DCollection(places, colors=colours, linewidths=4, zorder=2))
        else:
            self.axes.add_collection3d(Poly3DCollection(places, facecolors=colours, edgecolors=colours,
                                                        linewidths=0.3, alpha=SURFACE, zorder=2))

    def draw_stops(self, mesh: Mesh) -> None:
        acting = mesh.data["contact_state"] > 1.5
        places = mesh.moved(self.factor)
        cells = np.array(mesh.cells)
        colours = [CONTACT if acting[cell[0]] else STOP for cell in cells]
        self.axes.add_collection3d(Poly3DCollection(places[cells], facecolors=colours, edgecolors=colours,
                                                    zorder=1))

    def draw_supports(self, mesh: Mesh) -> None:
        self.axes.scatter(*mesh.moved(self.factor).T, s=3, c=STOP, marker="^", depthshade=False, zorder=1)


def write(images: list[np.ndarray], file: Path, rate: float) -> None:
    """With one palette for all pictures, so that what does not move takes no room."""
    from PIL import Image  # comes with Matplotlib

    pictures = [Image.fromarray(image) for image in images]
    sample = Image.fromarray(np.concatenate([*images[:: max(1, len(images) // 6)], patch(images[0].shape)]))
    palette = sample.quantize(COLOURS, dither=Image.Dither.NONE)
    flat = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    for picture in flat:
        picture.putpalette(with_white_ground(picture))
    flat[0].save(file, save_all=True, append_images=flat[1:], duration=round(1000 / rate), loop=0, optimize=True)


def patch(shape) -> np.ndarray:
    """Red enough for the palette to have it, although few points are red."""
    return np.full((shape[0] // 10, *shape[1:]), np.round(255 * np.array(to_rgb(CONTACT))), dtype=np.uint8)


def with_white_ground(picture) -> list[int]:
    """The palette in which the colour of the corner, which nothing is drawn on, is white itself."""
    shades = np.array(picture.getpalette()).reshape(-1, 3)
    shades[picture.getpixel((0, 0))] = 255
    return shades.ravel().tolist()
