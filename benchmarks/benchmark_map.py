#!/usr/bin/python3
"""The map of a mass between two bumpers, as large as wanted, on one rank and on several.

  benchmark_map.py PROGRAM [--gaps 100] [--stiffnesses 60] [--frequencies 150] [--ranks 1 2]
                   [--file FILE] [--set SECTION/KEY=VALUE ...]

Runs the analysis map of params/bumpers-map.prm over gaps x stiffnesses x frequencies x both
directions, once for each number of ranks, and tells points, forcing periods, time, processor time
with all that belongs to the run, memory, and the efficiency of several ranks: time on one over ranks
times time on so many, without the start of the program and the writing of the results, which rank 0
does alone. PROGRAM may be of another version, with the parameter file of that version as --file.
"""
import argparse
import os
import re
import resource
import subprocess
import tempfile
import time
from pathlib import Path

import h5py
import numpy as np

PARAMETERS = Path(__file__).parent.parent / "params/bumpers-map.prm"
GRID = "Analysis map/Parameter grid"


def stiffnesses(count):
    """From 0.1 to 100, with those among them that the derived quantities ask for."""
    numbers = np.logspace(-1, 2, count)
    for wanted in (1, 10):
        numbers[np.abs(numbers - wanted).argmin()] = wanted
    return numbers


def values(numbers):
    return ", ".join(f"{number:.6g}" for number in numbers)


def command(program, ranks, arguments, output):
    grid = ["--set", "Analyses=map",
            "--set", f"{GRID}/Key gap/Values={values(np.linspace(0, 1, arguments.gaps))}",
            "--set", f"{GRID}/Key stiffness/Values="
            + values(stiffnesses(arguments.stiffnesses)),
            "--set", f"Analysis curve/Stepped sweep/Points={arguments.frequencies}"]
    for override in arguments.set:
        grid += ["--set", override]
    launcher = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    return [*launcher, program, *grid, "--output", str(output), "--overwrite",
            str(arguments.file)]


def run(program, ranks, arguments, output):
    """Time, time of the analysis itself as the log has it, processor time, largest memory [MB]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    process = subprocess.run(command(program, ranks, arguments, output), check=True, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    elapsed = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    last = re.findall(r"map: (\d+) of \d+ \(100 %\), ([0-9.e+]+)/s", process.stdout)[-1]
    return elapsed, float(last[0]) / float(last[1]), processor, after.ru_maxrss / 1024


def counts(output):
    with h5py.File(output / "results.h5") as results:
        group = results["analysis/map"]
        settled = group["settling_cycles"]
        return settled.size, np.nansum(settled[()]) + 2 * settled.size, np.sum(group["status"][()] > 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--gaps", type=int, default=100)
    parser.add_argument("--stiffnesses", type=int, default=60)
    parser.add_argument("--frequencies", type=int, default=150)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--file", type=Path, default=PARAMETERS)
    parser.add_argument("--set", action="append", default=[], metavar="SECTION/KEY=VALUE")
    arguments = parser.parse_args()
    program = os.path.abspath(arguments.program)
    alone = None
    with tempfile.TemporaryDirectory() as name:
        output = Path(name) / "map"
        for ranks in arguments.ranks:
            elapsed, analysis, processor, memory = run(program, ranks, arguments, output)
            points, periods, failed = counts(output)
            alone = analysis if ranks == 1 else alone
            efficiency = f", efficiency {alone / (ranks * analysis):.3f}" if alone else ""
            print(f"{ranks} ranks: {points} points, {periods:.0f} forcing periods, {failed} failed; "
                  f"{elapsed:.1f} s in all, {analysis:.1f} s of them the map{efficiency}; "
                  f"{processor:.1f} s of processor time, {1e6 * processor / points:.1f} us per point, "
                  f"{1e6 * processor / periods:.2f} us per period; "
                  f"largest memory of a process {memory:.0f} MB", flush=True)


if __name__ == "__main__":
    main()
