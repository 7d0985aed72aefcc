"""The figures of vibroimpact-plot from Python."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path


class PlotError(Exception):
    """Figures could not be drawn; the message is that of vibroimpact-plot."""


def plot(results, **options) -> list[Path]:
    """Draws the figures that fit the results, and returns their files.

    `results` is a ResultFolder or the path of one. The keywords are the options of vibroimpact-plot:
    a text or number, True, or a list where an option may be repeated; `size` a pair in inches:

        plot(results, analysis="sweep", figure=["*-force", "*-gap"], format="svg", size=(6, 4))
    """
    folder = getattr(results, "folder", results)
    # A process of its own leaves backend and settings of this one alone.
    done = subprocess.run(
        [sys.executable, "-m", "vibroimpact.plots", str(folder), *arguments(options)], text=True,
        capture_output=True, check=False, env=os.environ | {"PYTHONPATH": search_path()})
    if done.returncode != 0:
        raise PlotError(done.stderr.strip())
    return [Path(line) for line in done.stdout.splitlines() if Path(line).is_file()]


def arguments(options: dict) -> list[str]:
    """As on the command line."""
    found: list[str] = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if name == "size":
            found += [option, "x".join(str(length) for length in value)]
        elif value is True:
            found.append(option)
        elif value is not False:
            values = value if isinstance(value, (list, tuple)) else [value]
            found += [part for item in values for part in (option, str(item))]
    return found


def search_path() -> str:
    here = str(Path(__file__).resolve().parents[1])
    return os.pathsep.join([here, *filter(None, [os.environ.get("PYTHONPATH")])])
