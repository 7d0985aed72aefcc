#!/usr/bin/python3
"""Kills runs at random moments, resumes them on one, two or three ranks until they finish, and
compares every dataset and the summary with those of a run that nobody disturbed, byte for byte.

usage: check_kills.py PROGRAM SOURCE [--kills NUMBER] [--seed NUMBER]
"""
import argparse
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

# Files with their overrides: a sweep, branches through grazes, loci, harmonic balances; of masses, since
# bodies with a mesh are reduced to other last digits on other numbers of ranks.
CASES = [("bumpers.prm", ["Analyses=gap_40", "Analysis curve/Stepped sweep/Points=1001"]),
         ("verification/rigid-branches.prm", []), ("isolator-loci.prm", []),
         ("verification/rigid-grazes.prm", []), ("isolator-branches.prm", ["Analyses=balances"])]


def datasets(folder):
    """Every dataset of a result file as bytes, by path, and the summary."""
    found = {"summary.txt": (folder / "summary.txt").read_bytes()}

    def visit(name, item):
        if isinstance(item, h5py.Dataset):
            values = item[()]
            is_text = getattr(values, "dtype", None) == object
            found[name] = repr(values.tolist()) if is_text else np.asarray(values).tobytes()

    with h5py.File(folder / "results.h5") as file:
        file.visititems(visit)
    return found


def wait_for_session(leader):
    """Until no process of a session is left: ranks outlive a killed mpirun by what they compute."""
    def is_of_it(stat):
        try:
            state, _, _, session = stat.read_text().rsplit(")", 1)[1].split()[:4]
        except OSError:
            return False
        return int(session) == leader and state not in "ZX"

    while any(is_of_it(path) for path in pathlib.Path("/proc").glob("[0-9]*/stat")):
        time.sleep(0.02)


class Runs:
    """Starts the program, and ends it when its time has come."""

    def __init__(self, program, parameters, overrides):
        self.program, self.parameters = program, parameters
        self.overrides = [word for override in overrides for word in ("--set", override)]

    def arguments(self, folder):
        if (folder / "parameters.prm").exists():
            return ["--resume", str(folder)]
        return [str(self.parameters), "--output", str(folder), "--overwrite", *self.overrides]

    def run(self, folder, ranks, limit=None, how=signal.SIGKILL):
        """True when it finished, False when it was killed after `limit` seconds."""
        start = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
        process = subprocess.Popen(start + [self.program, *self.arguments(folder)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                   start_new_session=True)
        try:
            _, errors = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, how)
            process.communicate()
            wait_for_session(process.pid)
            return False
        if process.returncode not in (0, 4):
            raise SystemExit(f"{folder}: exit code {process.returncode}\n{errors}")
        return process.returncode == 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    dice = random.Random(options.seed)
    different = 0
    for file, overrides in CASES:
        runs = Runs(options.program, options.source / "params" / file, overrides)
        different += different_after_kills(file, runs, options.kills // len(CASES), dice)
    sys.exit(1 if different else 0)


def different_after_kills(name, runs, least, dice):
    """How many runs of one file differ that were killed so many times at least."""
    with tempfile.TemporaryDirectory() as temporary:
        whole = pathlib.Path(temporary) / "whole"
        started = time.monotonic()
        runs.run(whole, 1)
        duration = time.monotonic() - started
        expected = datasets(whole)
        kills = episodes = different = 0
        while kills < least:
            folder = pathlib.Path(temporary) / f"cut{episodes}"
            while not runs.run(folder, dice.choice((1, 1, 2, 3)), dice.uniform(0.1, 0.9) * duration,
                               dice.choice((signal.SIGKILL, signal.SIGKILL, signal.SIGTERM))):
                kills += 1
            episodes += 1
            different += datasets(folder) != expected
            print(f"{name}: {kills} kills in {episodes} runs, {different} differ", flush=True)
    return different


if __name__ == "__main__":
    main()
