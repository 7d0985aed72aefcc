r"""Opens a recorded motion in ParaView: warped, coloured, beams with their cross-sections, contact forces as arrows, stops
and supports.

As a macro: Macros / Import new macro..., choose this file; then open output/NAME/ANALYSIS.pvd, press Apply, and the
macro's button. Without a window:

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
        pvpython paraview_motion.py output/NAME/ANALYSIS.pvd --picture FILE.png [--instant 51]
            [--factor 60] [--field von_mises_stress] [--from X,Y,Z] [--opacity 0.4]

The motion is warped such that the largest displacement is a tenth of the model's size, unless --factor says otherwise, and
coloured by the von Mises stress where it is known, or else by the displacement, on one scale for all instants; --from is
the direction from the model to the eye. Grey is
what has no such value: stops, supports, cross-sections given by constants. A stop meets its node where the gap is zero, at
any factor. ParaView (Debian: paraview python3-paraview xvfb) is needed for this script alone.
"""

import argparse
import sys

from paraview import simple

SHOWN = 0.1  # largest displacement relative to the size of the model
GREY = [0.55, 0.55, 0.55]
RED = [0.78, 0.06, 0.18]
TITLES = {"von_mises_stress": "von Mises stress in Pa", "displacement": "displacement in m", "velocity": "velocity in m/s",
          "contact_force": "contact force in N", "peak_contact_force": "peak contact force in N"}


def extent(source):
    bounds = source.GetDataInformation().GetBounds()
    return max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])


def array(source, name):
    return source.GetPointDataInformation().GetArray(name)


def largest_displacement(source):
    """Over all instants."""
    times = list(source.TimestepValues) or [0.0]
    largest = 0.0
    for time in times:
        source.UpdatePipeline(time)
        largest = max(largest, array(source, "displacement").GetRange(-1)[1])
    return largest


def usual_factor(source):
    largest = largest_displacement(source)
    return SHOWN * extent(source) / largest if largest > 0 else 1.0


def plain(display, colour):
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = colour


def coloured(display, field, view):
    simple.ColorBy(display, ("POINTS", field, "Magnitude"))
    colours = simple.GetColorTransferFunction(field)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.NanColor = GREY
    display.RescaleTransferFunctionToDataRangeOverTime()
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = TITLES.get(field, field.replace("_", " ")), ""
    display.SetScalarBarVisibility(view, True)


def show_forces(warped, size, view):
    if array(warped, "contact_force") is None:
        return
    bodies = simple.Threshold(registrationName="Bodies", Input=warped, Scalars=["POINTS", "body"],
                              ThresholdMethod="Above Upper Threshold", UpperThreshold=0.5)  # stops belong to none
    arrows = simple.Glyph(registrationName="Contact forces", Input=bodies, GlyphType="Arrow")
    arrows.OrientationArray = arrows.ScaleArray = ["POINTS", "contact_force"]
    largest = array(warped, "peak_contact_force").GetRange(-1)[1]
    arrows.ScaleFactor = size / 8 / largest if largest > 0 else 0.0
    arrows.GlyphMode = "All Points"
    plain(simple.Show(arrows, view), RED)


def show_motion(source, view, factor=None, field=None, opacity=1.0):
    """Adds everything to a view; returns what is warped."""
    factor = usual_factor(source) if factor is None else factor
    field = field or ("von_mises_stress" if array(source, "von_mises_stress") else "displacement")
    simple.Hide(source, view)
    source.UpdatePipeline((list(source.TimestepValues) or [0.0])[-1])  # where the peak forces are the largest
    warped = simple.WarpByVector(registrationName="Motion", Input=source, Vectors=["POINTS", "displacement"],
                                 ScaleFactor=factor)
    warped.UpdatePipeline()
    size = extent(warped)
    surfaces = simple.ExtractSurface(registrationName="Bodies, stops and supports", Input=warped)
    display = simple.Show(surfaces, view)
    display.PointSize, display.RenderPointsAsSpheres, display.Opacity = 7, 1, opacity
    coloured(display, field, view)
    show_forces(warped, size, view)
    return warped


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("motion")
    parser.add_argument("--picture", required=True)
    parser.add_argument("--instant", type=int, default=1, help="from 1")
    parser.add_argument("--factor", type=float)
    parser.add_argument("--field")
    parser.add_argument("--opacity", type=float, default=1.0, help="of bodies, to see what stands behind")
    parser.add_argument("--from", dest="eye", default="-2,-4,1.5",
                        type=lambda text: [float(part) for part in text.split(",")])
    return parser.parse_args()


def draw_picture(options):
    simple.LoadPalette("WhiteBackground")
    view = simple.CreateView("RenderView")
    view.ViewSize = [1100, 800]
    source = simple.PVDReader(FileName=options.motion)
    warped = show_motion(source, view, options.factor, options.field, options.opacity)
    view.ViewTime = source.TimestepValues[options.instant - 1]
    warped.UpdatePipeline(view.ViewTime)
    view.CameraViewUp, view.CameraFocalPoint, view.CameraPosition = [0, 0, 1], [0, 0, 0], options.eye
    simple.ResetCamera(view)
    simple.SaveScreenshot(options.picture, view, ImageResolution=view.ViewSize)


def act_as_macro():
    source, view = simple.GetActiveSource(), simple.GetActiveViewOrCreate("RenderView")
    if source is None:
        raise RuntimeError("open NAME.pvd of a result folder and press Apply first")
    show_motion(source, view)
    simple.ResetCamera(view)
    simple.Render(view)


if __name__ == "__main__" and len(sys.argv) > 1:
    draw_picture(parse())
elif simple.GetActiveSource() is not None or __name__ == "__main__":
    act_as_macro()
