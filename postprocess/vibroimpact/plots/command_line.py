"""vibroimpact-plot [options] RESULTS"""

from __future__ import annotations

import argparse
import fnmatch
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import ResultError

if TYPE_CHECKING:  # --help and wrong options answer without NumPy
    from .results import Analysis, Results

EPILOG = """--figure may be repeated and takes shell patterns: --figure 'response-contact-*'.
--at picks points of an axis by their nearest values, in the unit of the figures or in SI:
--at "Clearance=3 mm, 5 mm" --at frequency=2.4 --at direction=forward.
--overlay may be repeated: --overlay balance --overlay other-results:sweep."""

MOST_DPI = 100  # of animations, which would become large files


def main(arguments=None) -> int:
    options = parse(arguments)
    try:
        return draw(options)
    except (ResultError, OSError) as error:
        print(f"vibroimpact-plot: {error}", file=sys.stderr)
        return 1


def parse(arguments) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="vibroimpact-plot", description="Draws the figures that fit what a run computed.",
        epilog=EPILOG,
    )
    parser.add_argument("results", type=Path, help="result folder, or its results.h5")
    parser.add_argument("--analysis", metavar="NAME", help="only this analysis")
    parser.add_argument("--figure", metavar="PATTERN", action="append",
                        help="only figures whose name matches")
    parser.add_argument("--at", metavar="AXIS=VALUES", action="append", default=[],
                        help="only these points of an axis")
    parser.add_argument("--overlay", metavar="FILE.csv or [FOLDER:]ANALYSIS", action="append",
                        default=[],
                        help="points of a table, drawn over every figure with axes of these names; "
                             "or, over figures of branches, a stepped sweep, a harmonic balance or "
                             "another branch along the same key")
    parser.add_argument("--highlight", metavar="AXIS=VALUE[:NAME]", action="append", default=[],
                        help="this member of a family of curves in red before the others, with NAME in the legend")
    parser.add_argument("--peaks", action="store_true",
                        help="figures with chosen axes: a point at the largest value of each curve")
    parser.add_argument("--below-reference", action="store_true",
                        help="figures with chosen axes: shaded where the highlighted curve is below the reference")
    parser.add_argument("--sections", metavar="FILE.prm", type=Path,
                        help="the sections Figure of this parameter file instead of those stored "
                             "with the results")
    parser.add_argument("--angular", action="store_true", help="frequencies in rad/s")
    parser.add_argument("--dimensionless", action="store_true",
                        help="numbers without units, as with Units = dimensionless in the file")
    parser.add_argument("--list", action="store_true", help="names of the figures, nothing drawn")
    parser.add_argument("--format", choices=["png", "pdf", "svg"], default="png")
    parser.add_argument("--dpi", type=float, default=200, help="of pictures (default: 200)")
    parser.add_argument("--size", type=size, metavar="WxH", help="in inches, such as 6x4")
    parser.add_argument("--jobs", type=positive, metavar="N",
                        help="figures at a time (default: as many as processors)")
    add_animation(parser.add_argument_group("animation", "A motion that was recorded with Frames, "
                                            "as NAME-motion.gif."))
    parser.add_argument("--output", type=Path, metavar="FOLDER",
                        help="where the figures go (default: figures/ in the result folder)")
    return parser.parse_args(arguments)


def add_animation(group) -> None:
    group.add_argument("--animate", metavar="NAME", help="of this analysis, nothing else is drawn")
    group.add_argument("--instant", type=positive, metavar="N",
                       help="only this one of the recorded frames, counted from 1, with arrows of the "
                            "contact forces, as NAME-N.png; with NAME = modes a mode shape")
    group.add_argument("--field", help="that colours it (default: von_mises_stress, where it is "
                                       "known, else displacement)")
    group.add_argument("--factor", type=float, help="of the displacements (default: such that they "
                                                    "are well seen)")
    group.add_argument("--view", type=angles, metavar="AZIMUTH,ELEVATION", default=(-60, 25),
                       help="in degrees (default: -60,25)")
    group.add_argument("--frames", type=positive, default=60, help="at most (default: 60)")
    group.add_argument("--rate", type=positive, default=15, help="frames a second (default: 15)")


def positive(text: str) -> int:
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text}: a whole number greater than 0 is wanted")
    return int(text)


def angles(text: str) -> tuple[float, float]:
    azimuth, _, elevation = text.partition(",")
    try:
        return float(azimuth), float(elevation)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text}: two angles are wanted, such as -60,25") from None


def size(text: str) -> tuple[float, float]:
    width, _, height = text.partition("x")
    try:
        values = float(width), float(height)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text}: two numbers are wanted, such as 6x4") from None
    if min(values) < 1:
        raise argparse.ArgumentTypeError(f"{text}: too small for a figure")
    return values


def draw_animation(options: argparse.Namespace) -> int:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    from .animation import Style, animate, still
    from .files import enter_in_list
    from .style import SETTINGS

    results = options.results if options.results.is_dir() else options.results.parent
    folder = options.output or results / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / (f"{options.animate}-{options.instant}.png" if options.instant else f"{options.animate}-motion.gif")
    style = Style(options.field, options.factor, options.view, options.frames, options.rate,
                  options.size or Style.size, options.dpi if options.instant else min(options.dpi, MOST_DPI),
                  arrows=bool(options.instant))
    with plt.rc_context(SETTINGS):
        if options.instant:
            still(results, options.animate, options.instant, file, style)
        else:
            animate(results, options.animate, file, style)
    enter_in_list(results, file)
    print(file)
    return 0


def draw(options: argparse.Namespace) -> int:
    if options.animate:
        return draw_animation(options)
    from .choice import choose, highlight
    from .results import Emphasis, Results

    with Results(options.results) as results, ExitStack() as others:
        if options.sections:
            results.take_figures(options.sections)
        chosen = chosen_analyses(results, options.analysis)
        for analysis in chosen:
            choose(analysis, options.at)
            highlight(analysis, options.highlight)
        # Matplotlib takes a second to load; a wrong name should not have to wait for it.
        import matplotlib

        matplotlib.use("Agg")  # the program draws into files; who imports the package chooses
        import matplotlib.pyplot as plt

        from . import table_points
        from .files import draw_all
        from .labels import SHOWN
        from .overlays import attach
        from .style import SETTINGS

        results.emphasis = Emphasis(tuple(options.highlight), options.peaks, options.below_reference)
        tables = [table_points.read(Path(name)) for name in options.overlay
                  if name.endswith(".csv")]
        attach(results, chosen, [name for name in options.overlay if not name.endswith(".csv")],
               others)
        SHOWN.update(angular=options.angular or options.dimensionless, units=not (results.dimensionless or options.dimensionless))
        with plt.rc_context(SETTINGS):
            wanted = [entry for analysis in chosen
                      for entry in wanted_figures(results, analysis, options.figure)]
            if options.figure and not wanted:
                raise ResultError(f"{results.file}: no figure is called "
                                  + " or ".join(options.figure) + "; --list tells the names")
            if options.list:
                print("\n".join(name for name, _ in wanted))
                return 0
            return draw_all(results, wanted, tables, options)


def wanted_figures(results: Results, analysis: Analysis, patterns):
    """Names and functions of the figures that match a pattern, or of all."""
    from .figure_list import figures

    found = list(figures(results, analysis))
    if not found and not patterns:
        print(f"{analysis.name}: no figure; the numbers of this {analysis.type} analysis are in summary.txt and results.h5")
    return [(name, function) for name, function in found
            if not patterns or any(fnmatch.fnmatch(name, pattern) for pattern in patterns)]


def chosen_analyses(results: Results, name) -> list[Analysis]:
    analyses = results.analyses()
    if name is None:
        if not analyses:
            raise ResultError(f"{results.file}: holds no analysis")
        return analyses
    chosen = [analysis for analysis in analyses if analysis.name == name]
    if not chosen:
        known = ", ".join(analysis.name for analysis in analyses)
        raise ResultError(f"{results.file}: there is no analysis {name}; there are: {known}")
    return chosen
