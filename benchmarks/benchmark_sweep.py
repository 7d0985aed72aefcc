#!/usr/bin/python3
"""Cost of stepped sweeps inside a grid, by the program's own analyses, and where it goes.

  benchmark_sweep.py PROGRAM [repetitions]

Runs sweep.prm in four ways on one process: nothing computed (only the start of the program), as it
is, with the recorded window but without any recorder, and with twice as long a window. The
differences are what the parts take. Processor time, the least of all repetitions; it decides
nothing.
"""
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

PARAMETERS = Path(__file__).with_name("sweep.prm")
RECORD = "Analysis curve/Record"
WINDOW = "Analysis curve/Stepped sweep/Recorded cycles"
WAYS = {
    "start": ["--check"],
    "all": [],
    "bare": ["--set", f"{RECORD}=none"],
    "long": ["--set", f"{WINDOW}=4"],
}


def processor_time(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(program, folder, repetitions):
    least = {}
    for _ in range(repetitions):
        for way, options in WAYS.items():
            output = folder / way
            options = options if way == "start" else [*options, "--output", str(output), "--overwrite"]
            seconds = processor_time([program, *options, str(PARAMETERS)])
            least[way] = min(seconds, least.get(way, seconds))
    return least


def periods(folder):
    """Points, forcing periods settled and recorded, bytes of the results."""
    with h5py.File(folder / "results.h5") as results:
        settling = results["analysis/map/settling_cycles"][()]
    size = sum(path.stat().st_size for path in folder.iterdir() if path.is_file())
    return settling.size, settling.sum(), 2 * settling.size, size


def main():
    program = os.path.abspath(sys.argv[1])
    repetitions = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        least = measure(program, folder, repetitions)
        points, settled, recorded, size = periods(folder / "all")
    work = 1e6 * (least["all"] - least["start"])
    one_window = 1e6 * (least["long"] - least["all"])  # two more periods per point, watched
    recorders = 1e6 * (least["all"] - least["bare"])
    print(f"{points} points, {settled:.0f} periods settled, {recorded} recorded, "
          f"{size / points:.0f} bytes per point; start of the program {least['start']:.2f} s")
    print(f"{work / points:8.1f} us per point")
    print(f"{work / (settled + recorded):8.2f} us per forcing period")
    print(f"{one_window / recorded:8.2f} us per recorded period, with recorders")
    print(f"{recorders / points:8.1f} us per point for recorders: watching, their fields, storing them")
    print(f"{(work - one_window) / points:8.1f} us per point for settling and all that is done once")


if __name__ == "__main__":
    main()
