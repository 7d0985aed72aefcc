"""Runs what the pages of the gallery show and draws their pictures, as docs/gallery/pictures.txt lists them.

Without names of systems all are drawn. Runs that take more than five minutes are made with --long only; --list
names the pictures and draws nothing.
"""

import argparse
import fnmatch
import os
import shlex
import subprocess
import sys
import tempfile
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
LIST = SOURCE / "docs" / "gallery" / "pictures.txt"
DPI = "200"
LONGEST = 300  # seconds of a run that needs no --long


@dataclass
class Run:
    """One run of the program: file and options, and how long it takes on one core [s]."""

    file: str
    options: list[str]
    seconds: float


@dataclass
class Picture:
    """One picture of a figure of a run, with the options of vibroimpact-plot."""

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


def draw(gallery: Gallery, wanted: list[Picture], places: Places, with_long: bool) -> int:
    code = 0
    for name in dict.fromkeys(picture.run for picture in wanted):
        run = gallery.runs[name]
        if run.seconds > LONGEST and not with_long:
            print(f"{name}: takes {run.seconds / 60:.0f} minutes, left out without --long")
            continue
        if execute(name, run, places):
            code = 1
            continue
        batches = defaultdict(list)
        for picture in wanted:
            if picture.run == name:
                batches[tuple(picture.options)].append(picture)
        for options, pictures in batches.items():
            code |= plot(name, options, pictures, places)
    return code


def execute(name: str, run: Run, places: Places) -> int:
    command = [places.build / "vibroimpact", SOURCE / run.file, "--output", places.output / name,
               "--overwrite", *run.options]
    done = subprocess.run(command, check=False, stdout=subprocess.DEVNULL)
    print(f"{name}: {'done' if done.returncode == 0 else f'ended with code {done.returncode}'}",
          flush=True)
    return done.returncode


def plot(run: str, options, pictures, places: Places) -> int:
    """All pictures with the same options in one call; they get their names afterwards."""
    results = places.output / run
    with tempfile.TemporaryDirectory() as folder:
        command = [places.build / "vibroimpact-plot", results, "--output", folder, "--dpi", DPI]
        for picture in pictures:
            command += ["--figure", picture.figure]
        code = subprocess.run([*command, *placed(options)], check=False,
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


def placed(options) -> list:
    """Tables are named from docs/gallery/published."""
    return [LIST.parent / "published" / option if option.endswith(".csv") else option
            for option in options]


def main() -> int:
    parser = argparse.ArgumentParser(prog="draw-gallery.sh", description=__doc__)
    parser.add_argument("systems", metavar="SYSTEM", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--long", action="store_true")
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
    return draw(gallery, wanted, places, options.long)


if __name__ == "__main__":
    sys.exit(main())
