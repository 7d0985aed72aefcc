"""Runs what the pages of the gallery show and draws their pictures, as docs/gallery/pictures.txt lists them.

Without names of systems all are drawn, as many runs at a time as there are processors. --list names the pictures and
draws nothing, --draw-only draws from earlier runs.
"""

import argparse
import fnmatch
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
LIST = SOURCE / "docs" / "gallery" / "pictures.txt"
DPI = "200"
OVER = "RUN/"  # before the name of a run in an option


@dataclass
class Run:
    """One run of the program: file and options, and how long it takes on one core [s]."""

    file: str
    options: list[str]
    seconds: float


@dataclass
class Picture:
    """One picture of a figure of a run, with the options of vibroimpact-plot; the figure ANALYSIS.pvd is an
    instant of a motion."""

    system: str
    name: str
    run: str
    figure: str
    options: list[str] = field(default_factory=list)


@dataclass
class Gallery:
    """`others`: pictures that something else makes, and what."""

    runs: dict[str, Run]
    pictures: list[Picture]
    others: dict[str, str]


def read(file: Path = LIST) -> Gallery:
    gallery = Gallery({}, [], {})
    system = ""
    for line in file.read_text().splitlines():
        words = shlex.split(line, comments=True)
        if not words:
            continue
        if words[0] == "system":
            system = words[1]
        elif words[0] == "run":
            gallery.runs[words[1]] = Run(words[3], words[4:], float(words[2]))
        elif words[0] == "by":
            gallery.others |= {name: words[1] for name in words[2:]}
        else:
            gallery.pictures.append(Picture(system, words[0], words[1], words[2], words[3:]))
    return gallery


@dataclass
class Places:
    """Folders of the programs, of the runs, and of the pictures."""

    build: Path
    output: Path
    images: Path


def draw(gallery: Gallery, wanted: list[Picture], places: Places, options) -> int:
    """Longest runs first, so that none is alone at the end."""
    chosen = {name: gallery.runs[name] for name in dict.fromkeys(
        name for picture in wanted for name in [picture.run, *overlaid(picture)])}
    places.output.mkdir(parents=True, exist_ok=True)
    places.images.mkdir(parents=True, exist_ok=True)

    def run_and_draw(name: str) -> int:
        if not options.draw_only and execute(name, chosen[name], places):
            return 1
        return draw_run(name, [picture for picture in wanted if picture.run == name and not overlaid(picture)], places)

    with ThreadPoolExecutor(options.jobs) as workers:
        code = max(workers.map(run_and_draw, sorted(chosen, key=lambda name: -chosen[name].seconds)), default=0)
    last = [picture for picture in wanted if overlaid(picture)]
    return max([code, *(draw_run(name, [picture for picture in last if picture.run == name], places)
                        for name in dict.fromkeys(picture.run for picture in last))])


def overlaid(picture: Picture) -> list[str]:
    """Runs that a picture shows over its own, as RUN:ANALYSIS."""
    return [option.removeprefix(OVER).partition(":")[0] for option in picture.options if option.startswith(OVER)]


def draw_run(name: str, pictures: list[Picture], places: Places) -> int:
    batches = defaultdict(list)
    for picture in pictures:
        batches[tuple(picture.options)].append(picture)
    return max((plot(name, options, batch, places) for options, batch in batches.items()), default=0)


def execute(name: str, run: Run, places: Places) -> int:
    begin = time.monotonic()
    command = [places.build / "vibroimpact", parameters(name, run, places), "--output",
               places.output / name, "--overwrite",
               *[option.replace("SOURCE", str(SOURCE)) for option in run.options]]
    done = subprocess.run(command, check=False, stdout=subprocess.DEVNULL, cwd=SOURCE)
    print(f"{name}: {'done' if done.returncode == 0 else f'ended with code {done.returncode}'}"
          f" after {time.monotonic() - begin:.0f} s", flush=True)
    return done.returncode


def parameters(name: str, run: Run, places: Places) -> Path:
    """The file of a run, or what a tutorial page says to write into one."""
    file = SOURCE / run.file
    if file.suffix != ".md":
        return file
    written = places.output / f"{name}.prm"
    written.write_text(re.search(r"(?ms)^```prm\n(.*?)^```$", file.read_text())[1])
    return written


def plot(run: str, options, pictures, places: Places) -> int:
    """All pictures with the same options in one call; they get their names afterwards."""
    results = places.output / run
    if pictures[0].figure.endswith(".pvd"):
        return max(draw_instant(results, picture.figure.removesuffix(".pvd"), options, picture.name, places)
                   for picture in pictures)
    with tempfile.TemporaryDirectory() as folder:
        command = [places.build / "vibroimpact-plot", results, "--output", folder, "--dpi", DPI]
        for picture in pictures:
            command += ["--figure", picture.figure]
        code = subprocess.run([*command, *placed(options, places)], check=False,
                              stdout=subprocess.DEVNULL).returncode
        for picture in pictures:
            drawn = Path(folder, f"{picture.figure}.png")
            if drawn.is_file():
                (places.images / f"{picture.name}.png").write_bytes(drawn.read_bytes())
                print(f"  {picture.name}", flush=True)
            else:
                code = 1
                print(f"  {picture.name}: {run} has no figure {picture.figure}",
                      file=sys.stderr)
    return code


def draw_instant(results: Path, motion: str, options, name: str, places: Places) -> int:
    with tempfile.TemporaryDirectory() as folder:
        command = [places.build / "vibroimpact-plot", results, "--animate", motion, "--output", folder, "--dpi", DPI]
        code = subprocess.run([*command, *options], check=False, stdout=subprocess.DEVNULL).returncode
        for drawn in Path(folder).glob("*.png"):
            (places.images / f"{name}.png").write_bytes(drawn.read_bytes())
            print(f"  {name}", flush=True)
    return code


def placed(options, places: Places) -> list:
    """Tables are named from docs/gallery/published, other runs from the folder of all."""
    return [LIST.parent / "published" / option if option.endswith(".csv") else
            option.replace(OVER, f"{places.output}/") for option in options]


def main() -> int:
    parser = argparse.ArgumentParser(prog="draw-gallery.sh", description=__doc__)
    parser.add_argument("systems", metavar="SYSTEM", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--draw-only", action="store_true")
    parser.add_argument("--jobs", metavar="N", type=int, default=os.cpu_count(),
                        help="runs at a time (default: as many as processors)")
    parser.add_argument("--picture", metavar="PATTERN", default="*", help="only these")
    parser.add_argument("--images", type=Path, default=LIST.parent / "images")
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--output", type=Path, default=SOURCE / "output" / "gallery")
    options = parser.parse_args()
    gallery = read()
    known = list(dict.fromkeys(picture.system for picture in gallery.pictures))
    unknown = [name for name in options.systems if name not in known]
    if unknown:
        parser.error(f"{unknown[0]} is no system; there are: {', '.join(known)}")
    wanted = [picture for picture in gallery.pictures
              if (not options.systems or picture.system in options.systems)
              and fnmatch.fnmatch(picture.name, options.picture)]
    if options.list:
        print("\n".join(picture.name for picture in wanted))
        return 0
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    places = Places(*[path.resolve() for path in (options.build, options.output, options.images)])
    return draw(gallery, wanted, places, options)


if __name__ == "__main__":
    sys.exit(main())
