#!/usr/bin/python3
"""Cost and energy balance of parameter files by two programs, run in turn.

  benchmark_files.py BEFORE AFTER FILE[:ANALYSES] ... [--turns 3]

Without a file, those of the folder params/ with nonlinear contact laws, springs or rotors. Each run has one
process; processor time from start to end, median of the turns, and the ratio within each turn. The largest
energy residual of all points and the number of points whose balance does not close are those of the results.
"""
import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

SOURCE = Path(__file__).resolve().parent.parent
FILES = ["vibro-impact-absorber.prm", "impacting-beams.prm", "impacting-beams-branches.prm:branch",
         "electromechanical.prm", "impact-identification.prm", "measured-pulses.prm", "restitution-relations.prm",
         "verification/beam-contact.prm", "verification/beam-on-stop.prm", "verification/beam-release.prm"]


def run(program, case, folder):
    """Processor time [s] of one run into the folder."""
    name, _, analyses = case.partition(":")
    path = Path(name) if Path(name).exists() else SOURCE / "params" / name
    command = [program, str(path), "--output", str(folder), "--overwrite"]
    if analyses:
        command += ["--set", f"Analyses={analyses}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 3):
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def balance(folder):
    """Largest energy residual and the number of points whose balance does not close."""
    residuals, unbalanced = [], 0

    def visit(name, item):
        nonlocal unbalanced
        if not isinstance(item, h5py.Dataset) or item.dtype.kind != "f":
            return
        if name.rsplit("/", 1)[-1] == "energy_residual":
            values = np.asarray(item).ravel()
            residuals.extend(values[np.isfinite(values)])
        elif name.rsplit("/", 1)[-1] == "unbalanced":
            unbalanced += int(np.nansum(item))

    with h5py.File(folder / "results.h5") as results:
        results.visititems(visit)
    return max(residuals, default=float("nan")), unbalanced


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("files", nargs="*", default=FILES, metavar="FILE[:ANALYSES]")
    parser.add_argument("--turns", type=int, default=3)
    arguments = parser.parse_args()
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    print("| file | before, s | after, s | times as fast | largest residual before | after | open before | after |\n"
          "|---|---|---|---|---|---|---|---|")
    for case in arguments.files:
        times = {"before": [], "after": []}
        balances = {}
        with tempfile.TemporaryDirectory() as temporary:
            for _ in range(arguments.turns):
                for side in times:
                    folder = Path(temporary) / side
                    times[side].append(run(getattr(arguments, side), case, folder))
                    balances[side] = balance(folder)
        ratio = statistics.median(b / a for b, a in zip(times["before"], times["after"]))
        print(f"| {case} | {statistics.median(times['before']):.2f} | {statistics.median(times['after']):.2f} "
              f"| {ratio:.2f} | {balances['before'][0]:.1e} | {balances['after'][0]:.1e} "
              f"| {balances['before'][1]} | {balances['after'][1]} |", flush=True)


if __name__ == "__main__":
    main()
