#!/usr/bin/python3
"""Judges random models by two methods and counts the verdicts.

usage: check_random_models.py PROGRAM (--models NUMBER [--first SEED] | --seeds SEED... | --files FILE...)
                              [--processes NUMBER] [--limit SECONDS] [--report FILE]

PROGRAM (tests/random_models) judges one model after the other and prints a line each. One that needs
more processor time than the limit does not end; one that ends its process has crashed; the next
process goes on behind it. Verdicts:

  agree           histories differ by less than 1e-6
  sensitive       they differ, and so do those of one method when the model changes by 1e-9
  converge        they differ, by less than 1e-3, and ten times less with a hundredth of the tolerances
  failed          by both methods, with a reason
  refused         not a model that can be run; the generator should make few of these
  failed-default, failed-rk, wrong, no end, crashed: mistakes of the program

Exit code 1 when there is a mistake, or too many refused models to say anything.
"""
import argparse
import collections
import concurrent.futures
import os
import select
import subprocess
import sys
import tempfile

MISTAKES = ("failed-default", "failed-rk", "wrong", "no end", "crashed")
TICKS = os.sysconf("SC_CLK_TCK")


def processor_time(process):
    """Seconds that a running process has used; None when it is gone."""
    try:
        with open(f"/proc/{process.pid}/stat", encoding="ascii") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / TICKS
    except (OSError, IndexError):
        return None


class Batch:
    """Models first, ..., first + number - 1, in as many processes as it takes."""

    def __init__(self, program, first, number, files, limit, report):
        self.program, self.files, self.limit, self.report = program, files, limit, report
        self.next, self.end = first, first + number
        self.lines = []

    def run(self):
        with tempfile.TemporaryDirectory() as folder:
            while self.next < self.end:
                self.run_process(folder)
        return self.lines

    def run_process(self, folder):
        process = subprocess.Popen(
            [self.program, folder, str(self.next), str(self.end - self.next), *self.files],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, bufsize=1,
            env={**os.environ, "OMPI_MCA_ess_singleton_isolated": "1"})
        since = 0.0
        while self.next < self.end:
            ready, _, _ = select.select([process.stdout], [], [], 0.5)
            if ready:
                line = process.stdout.readline()
                if not line:
                    self.note("crashed", f"exit code {process.wait()}")
                    return
                self.add(line.rstrip("\n").split("\t", 4))
                since = processor_time(process) or since
            elif (processor_time(process) or 0.0) - since > self.limit:
                process.kill()
                process.wait()
                self.note("no end", f"more than {self.limit} s of processor time")
                return
        process.wait()

    def note(self, word, detail):
        self.add([str(self.next), word, "nan", "nan", detail])

    def add(self, line):
        self.lines.append(line)
        self.report.write("\t".join(line) + "\n")
        self.report.flush()
        self.next += 1


def judge(options, report):
    """The lines of all models, sorted by seed; the report gets each as it is found."""
    if options.files:
        parts = [(place, 1) for place in range(len(options.files))]
    elif options.seeds:
        parts = [(seed, 1) for seed in options.seeds]
    else:
        part = max(1, min(100, options.models // options.processes))
        end = options.first + options.models
        parts = [(first, min(part, end - first)) for first in range(options.first, end, part)]
    batches = [Batch(options.program, first, number, options.files or [], options.limit, report)
               for first, number in parts]
    with concurrent.futures.ThreadPoolExecutor(options.processes) as pool:
        lines = [line for found in pool.map(Batch.run, batches) for line in found]
    return sorted(lines, key=lambda line: int(line[0]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    which = parser.add_mutually_exclusive_group(required=True)
    which.add_argument("--models", type=int)
    which.add_argument("--seeds", type=int, nargs="+")
    which.add_argument("--files", nargs="+")
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--report")
    options = parser.parse_args()
    with open(options.report or os.devnull, "w", encoding="utf-8") as report:
        lines = judge(options, report)
    counts = collections.Counter(line[1] for line in lines)
    for line in lines:
        if line[1] in MISTAKES:
            print(f"model {line[0]}: {line[1]}: {line[4]}")
    print(", ".join(f"{counts[word]} {word}" for word in sorted(counts)))
    longest = max((float(line[2]), line[0]) for line in lines)
    print(f"longest motion by the default method: {longest[0]:.3g} s (model {longest[1]})")
    refused = counts["refused"] > 0.05 * len(lines)
    if refused:
        print("more than 5 % of the models are refused: the generator no longer fits the keys")
    return 1 if refused or any(counts[word] for word in MISTAKES) else 0


if __name__ == "__main__":
    sys.exit(main())
