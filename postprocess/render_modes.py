r"""Renders every mode shape of a result folder to a PNG, off screen, with ParaView's Python.

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
        pvpython render_modes.py output/NAME [FOLDER]

FOLDER is output/NAME/figures unless given. The undeformed body (of shells, its mesh) is drawn in grey,
the mode coloured by its displacement; the files are scaled so that a factor of 1 shows the mode well. ParaView (Debian:
paraview python3-paraview xvfb) is needed for this script alone.
"""

import sys
from pathlib import Path

from paraview import simple


def holds_surfaces(reader):
    return reader.GetClientSideObject().GetOutput().GetCell(0).GetCellDimension() == 2


def tube(source, radius):
    result = simple.Tube(Input=simple.ExtractSurface(Input=source))
    result.Radius = radius
    result.NumberofSides = 12
    return result


def render(mode: Path, picture: Path) -> None:
    reader = simple.XMLUnstructuredGridReader(FileName=[str(mode)])
    warped = simple.WarpByVector(Input=reader, Vectors=["POINTS", "displacement"], ScaleFactor=1)
    reader.UpdatePipeline()  # until then the bounds are empty
    bounds = reader.GetDataInformation().GetBounds()
    size = max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])

    view = simple.CreateView("RenderView")
    view.ViewSize = [1000, 800]
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesLabelColor = [0, 0, 0]
    surfaces = holds_surfaces(reader)
    at_rest = simple.FeatureEdges(Input=simple.ExtractSurface(Input=reader)) if surfaces else reader
    undeformed = simple.Show(tube(at_rest, 0.004 * size), view)
    undeformed.AmbientColor = undeformed.DiffuseColor = [0.7, 0.7, 0.7]
    undeformed.ColorArrayName = ["POINTS", ""]
    deformed = simple.Show(warped if surfaces else tube(warped, 0.012 * size), view)
    simple.ColorBy(deformed, ("POINTS", "displacement", "Magnitude"))
    deformed.RescaleTransferFunctionToDataRange(False)

    view.CameraViewUp = [0, 0, 1]
    view.CameraPosition = [bounds[0] - 2 * size, bounds[2] - 4 * size, bounds[4] + 1.5 * size]
    view.CameraFocalPoint = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
                             (bounds[4] + bounds[5]) / 2]
    simple.ResetCamera(view)
    simple.SaveScreenshot(str(picture), view, ImageResolution=view.ViewSize)
    simple.Delete(view)


def main() -> int:
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    results = Path(sys.argv[1])
    modes = sorted((results / "modes").glob("*-mode-*.vtu"))
    if not modes:
        print(f"{results}: there are no mode files in {results / 'modes'}", file=sys.stderr)
        return 1
    folder = Path(sys.argv[2]) if len(sys.argv) == 3 else results / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    for mode in modes:
        picture = folder / f"{mode.stem}.png"
        render(mode, picture)
        print(picture)
    return 0


if __name__ == "__main__":
    sys.exit(main())
