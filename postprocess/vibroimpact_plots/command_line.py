"""vibroimpact-plot [--analysis NAME] [--format png|pdf] [--output FOLDER] RESULTS"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from .results import Analysis, ResultError, Results


def main(arguments=None) -> int:
    options = parse(arguments)
    try:
        draw(options)
    except (ResultError, OSError) as error:
        print(f"vibroimpact-plot: {error}", file=sys.stderr)
        return 1
    return 0


def parse(arguments) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="vibroimpact-plot", description="Draws the figures that fit what a run computed."
    )
    parser.add_argument("results", type=Path, help="result folder, or its results.h5")
    parser.add_argument("--analysis", metavar="NAME", help="only this analysis")
    parser.add_argument("--format", choices=["png", "pdf"], default="png")
    parser.add_argument("--output", type=Path, metavar="FOLDER",
                        help="where the figures go (default: figures/ in the result folder)")
    return parser.parse_args(arguments)


def draw(options: argparse.Namespace) -> None:
    with Results(options.results) as results:
        chosen = chosen_analyses(results, options.analysis)
        # Matplotlib takes a second to load; a wrong name should not have to wait for it.
        import matplotlib.pyplot as plt

        from .figure_list import FIGURES
        from .style import SETTINGS

        folder = options.output or results.folder / "figures"
        folder.mkdir(parents=True, exist_ok=True)
        with plt.rc_context(SETTINGS):
            for analysis in chosen:
                if analysis.type not in FIGURES:
                    print(f"{analysis.name}: no figures for a {analysis.type} analysis yet")
                    continue
                for name, figure in FIGURES[analysis.type](results, analysis):
                    file = folder / f"{name}.{options.format}"
                    enter_in_list(results.folder, file)
                    figure.savefig(file)
                    plt.close(figure)
                    print(file)


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


def enter_in_list(folder: Path, file: Path) -> None:
    """A run that overwrites the results removes their figures too: see src/output/written_files.h."""
    written = folder / "journal" / "written_files.txt"
    if not written.parent.is_dir() or folder.resolve() not in file.resolve().parents:
        return
    entry = str(file.resolve().relative_to(folder.resolve()))
    known = written.read_text().splitlines() if written.is_file() else []
    if entry not in known:
        with written.open("a") as stream:
            stream.write(entry + "\n")
