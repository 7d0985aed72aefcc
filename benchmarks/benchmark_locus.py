#!/usr/bin/python3
"""Cost of a locus of folds, by the program's own analysis.

  benchmark_locus.py PROGRAM [repetitions]

Follows the folds of the isolator over frequency and stiffness with some 600 points, with and without
recorders, and with half the points: the differences are what a point takes. Processor time, the
least of all repetitions; it decides nothing.
"""
import os
import sys
import tempfile
from pathlib import Path

import h5py

from benchmark_sweep import processor_time

PARAMETERS = Path(__file__).parents[1] / "params" / "isolator-loci.prm"
STEP = "Analysis stiffness/Locus/Longest step"
OPTIONS = ["--set", "Analyses=stiffness", "--set", "Analysis stiffness/Locus/Kinds=fold"]
WAYS = {  # longest step and recorders
    "all": ["0.0045", "extreme values"],
    "half": ["0.009", "extreme values"],
    "bare": ["0.0045", "none"],
}


def measure(program, folder, repetitions):
    """Least seconds and number of points of each way."""
    least, points = {}, {}
    for _ in range(repetitions):
        for way, (step, record) in WAYS.items():
            output = folder / way
            seconds = processor_time([program, *OPTIONS, "--set", f"{STEP}={step}",
                                      "--set", f"Analysis stiffness/Record={record}",
                                      "--output", str(output), "--overwrite", str(PARAMETERS)])
            least[way] = min(seconds, least.get(way, seconds))
            with h5py.File(output / "results.h5") as results:
                points[way] = results["analysis/stiffness/arclength"].size
    return least, points


def main():
    program = os.path.abspath(sys.argv[1])
    repetitions = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    with tempfile.TemporaryDirectory() as name:
        least, points = measure(program, Path(name), repetitions)
    each = (least["all"] - least["half"]) / (points["all"] - points["half"])
    recorders = (least["all"] - least["bare"]) / points["all"]
    print(f"{points['all']} points in {least['all']:.2f} s, start of the program and the branch "
          f"included")
    print(f"{1e3 * each:8.2f} ms per point")
    print(f"{1e3 * recorders:8.2f} ms per point for recorders")


if __name__ == "__main__":
    main()
