#!/usr/bin/python3
"""Every parameter file in params/ runs, and vibroimpact-plot draws what it computes.

usage: check_shipped_figures.py PROGRAM SOURCE [--part K/N | --complete] [NAME...]

The files that take longer are shortened by the overrides below, as --set would; --complete runs them as they are. --part
2/4 takes the second of four shares of the files.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

# Fewer points, evaluations and periods: every kind of analysis and figure is still there.
SHORTER = {
    "absorber-design": ["Analyses=bounded", "Analysis/motion/Steady state/Settling cycles=20",
                        "Analysis/motion/Steady state/Recorded cycles=10",
                        "Analysis/bounded/Optimise/Most evaluations=8"],
    "bilinear-oscillator": ["Analyses=modes, motions"],
    "bolted-joint": ["Analyses=modes, response", "Analysis/sweep/Stepped sweep/Points=4"],
    "bumper-design": ["Analyses=best", "Analysis/curve/Stepped sweep/Points=11",
                      "Analysis/best/Optimise/Most evaluations=4"],
    "bumpers-map": ["Analyses=folds", "Analysis/bracketed/Stepped sweep/Points=7",
                    "Analysis/folds/Parameter grid/Key gap/Values=0.4, 0.7",
                    "Analysis/folds/Parameter grid/Key stiffness/Values=1, 2, 5"],
    "bumpers": ["Analyses=modes, start, start_free"],
    "capsule": ["Analysis/sweep/Stepped sweep/Points=5"],
    "choose-a-stop": ["Analysis/best/Optimise/Most evaluations=30", "Analysis/compromise/Pareto front/Evaluations=120",
                      "Analysis/motion/Transient/Duration=4 s"],
    "damped-buildings": ["Analysis/slip_loads/Parameter grid/Key load/Points=3"],
    "electromechanical": ["Analyses=history", "Analysis/history/Transient/Duration=1 s"],
    "impact-identification": ["Analyses=record, pulse"],
    "impacting-beams": ["Analyses=modes, release"],
    "impacting-beams-branches": ["Analyses=sweep", "Analysis/sweep/Stepped sweep/Points=11"],
    "isolator-basins": ["Analyses=plane", "Analysis/plane/Basins/First axis/Cells=20",
                        "Analysis/plane/Basins/Second axis/Cells=20"],
    "rattling-plates": [*(f"Body {body}/Interface face/Grid points=10, 6" for body in ("lower", "upper")),
                        "Analysis/rattle/Transient/Frames=3"],
    "steam-generator-tube": ["Variables/modes=16", "Analysis/clearances/Stepped sweep/Points=2",
                             "Analysis/clearances/Stepped sweep/Recorded cycles=3", "Analysis/record/Transient/Duration=0.1 s"],
    "tube-wear": ["Analysis/sweep/Stepped sweep/Points=3", "Analysis/sweep/Stepped sweep/Recorded cycles=10"],
    "vibro-impact-absorber": ["Analyses=linear, close_motion", "Analysis/linear/Stepped sweep/Settling cycles=50",
                              "Analysis/close_motion/Steady state/Settling cycles=50"],
}


def failures(program, source, file, overrides):
    """What went wrong with one file; empty when nothing did."""
    with tempfile.TemporaryDirectory() as folder:
        results = pathlib.Path(folder, "results")
        run = [program, file, "--output", results, *(word for each in overrides for word in ("--set", each))]
        plot = [source / "postprocess" / "vibroimpact-plot", results, "--dpi", "40"]
        for command in (run, plot):
            done = subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
            if done.returncode != 0:
                return [f"{file.name}: {' '.join(map(str, command))} ends with {done.returncode}: {done.stderr[-2000:]}"]
        if not done.stdout.strip() or not list((results / "figures").glob("*.png")):
            return [f"{file.name}: no figure was drawn"]
        empty = [path.name for path in (results / "figures").iterdir() if path.stat().st_size == 0]
        return [f"{file.name}: empty figures {empty}"] if empty else []


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--part", default="1/1")
    parser.add_argument("--complete", action="store_true")
    options = parser.parse_args()
    program, source = options.program.resolve(), options.source.resolve()
    files = sorted(source.glob("params/*.prm"))
    unknown = set(SHORTER) - {file.stem for file in files}
    wrong = [f"there is no params/{name}.prm" for name in sorted(unknown)]
    part, parts = map(int, options.part.split("/"))
    for file in [file for file in files if not options.names or file.stem in options.names][part - 1::parts]:
        begin = time.monotonic()
        wrong += failures(program, source, file, [] if options.complete else SHORTER.get(file.stem, []))
        print(f"{file.name}: {time.monotonic() - begin:.1f} s", flush=True)
    print("\n".join(wrong) or "all figures were drawn")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
