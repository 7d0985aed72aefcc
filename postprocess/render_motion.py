r"""Renders instants of a recorded motion to PNG, off screen, with ParaView's Python.

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
        pvpython render_motion.py output/NAME ANALYSIS FRAME[,FRAME...] [--scale 100]
            [--from X,Y,Z] [--field peak_contact_force] [--largest 500] [--opacity 0.4]
            [--zoom 1.2] [--folder FOLDER]

Frames count from 1. The motion is warped by --scale and coloured by the length of --field,
contact_force unless given; red arrows are the contact forces. --from is the direction from the body
to the eye. Beams are drawn as tubes. ParaView (Debian: paraview python3-paraview xvfb) is needed for this script alone.
"""

import argparse
from pathlib import Path

from paraview import simple

TITLES = {"contact_force": " in N", "peak_contact_force": " in N", "displacement": " in m",
          "contact_gap": " in m"}


def parse():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    parser.add_argument("analysis")
    parser.add_argument("frames", type=lambda text: [int(part) for part in text.split(",")])
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--from", dest="eye", default="-2,-4,1.5",
                        type=lambda text: [float(part) for part in text.split(",")])
    parser.add_argument("--field", default="contact_force")
    parser.add_argument("--largest", type=float, help="end of the colour scale")
    parser.add_argument("--opacity", type=float, default=1.0, help="of shells")
    parser.add_argument("--zoom", type=float, default=1.2)
    parser.add_argument("--folder", type=Path)
    return parser.parse_args()


def size_of(source):
    source.UpdatePipeline()
    bounds = source.GetDataInformation().GetBounds()
    return max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])


def show_forces(source, view, options):
    """An arrow for each contact force, the largest an eighth of the picture long."""
    largest = source.GetPointDataInformation()["contact_force"].GetRange(-1)[1]
    if largest == 0:
        return
    arrows = simple.Glyph(Input=source, GlyphType="Arrow")
    arrows.OrientationArray = arrows.ScaleArray = ["POINTS", "contact_force"]
    arrows.ScaleFactor = size_of(source) / 8 / (options.largest or largest)
    arrows.GlyphMode = "All Points"
    display = simple.Show(arrows, view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.85, 0.1, 0.1]


def show(file, view, options):
    reader = simple.XMLUnstructuredGridReader(FileName=[str(file)])
    source = simple.WarpByVector(Input=reader, Vectors=["POINTS", "displacement"],
                                 ScaleFactor=options.scale)
    size = size_of(source)
    show_forces(source, view, options)
    surfaces = holds_surfaces(reader)
    if not surfaces:
        source = simple.Tube(Input=simple.ExtractSurface(Input=source))
        source.Radius = 0.005 * size
        source.NumberofSides = 12
    display = simple.Show(source, view)
    if surfaces:
        display.SetRepresentationType("Surface With Edges")
        display.EdgeColor = [0.6, 0.6, 0.6]
        display.Opacity = options.opacity
    colour(display, view, options)


def colour(display, view, options):
    simple.ColorBy(display, ("POINTS", options.field, "Magnitude"))
    colours = simple.GetColorTransferFunction(options.field)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    if options.largest:
        colours.RescaleTransferFunction(0, options.largest)
    else:
        display.RescaleTransferFunctionToDataRange(False)
    bar = simple.GetScalarBar(colours, view)
    bar.Title = options.field.replace("_", " ") + TITLES.get(options.field, "")
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    display.SetScalarBarVisibility(view, True)


def render(options, frame, picture):
    view = simple.CreateView("RenderView")
    view.ViewSize = [1100, 800]
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesLabelColor = [0, 0, 0]
    stem = options.results / options.analysis / f"frame-{frame:05d}"
    lines = stem.with_name(stem.name + "-lines.vtu")
    show(stem.with_suffix(".vtu"), view, options)
    if lines.exists():
        show(lines, view, options)
    view.CameraViewUp = [0, 0, 1]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = options.eye
    simple.ResetCamera(view)
    view.GetActiveCamera().Zoom(options.zoom)
    simple.SaveScreenshot(str(picture), view, ImageResolution=view.ViewSize)
    simple.Delete(view)


def holds_surfaces(reader):
    cell = reader.GetClientSideObject().GetOutput().GetCell(0)
    return cell.GetCellDimension() == 2


def main():
    options = parse()
    folder = options.folder or options.results / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    for frame in options.frames:
        picture = folder / f"{options.analysis}-frame-{frame:05d}.png"
        render(options, frame, picture)
        print(picture)


if __name__ == "__main__":
    main()
