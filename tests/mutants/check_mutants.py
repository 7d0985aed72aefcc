#!/usr/bin/python3
"""Spoilt parameter files, meshes and records: each ends in time with an exit code that fits, one
message and no trace of a library; none takes more than its share of memory.

    check_mutants.py FORK_SERVER TREE [--checks N] [--runs N] [--seed S] [--jobs J] [--keep FOLDER]

N mutants of the shipped files go through --check, others through short runs of these files. Prints
what went wrong and, at the end, how many ended with which code; exit code 1 if anything was wrong.
"""
import argparse
import collections
import concurrent.futures
import pathlib
import re
import shutil
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import mutants  # noqa: E402
from fork_server import ForkServer  # noqa: E402

SECONDS, MEGABYTES = 20, 6000
TRACE = re.compile(r"PETSC ERROR|SLEPC ERROR|HDF5-DIAG|[Ss]tack ?trace|[Bb]acktrace|terminate called|"
                   r"Abort|\[0\]|std::|bad_alloc|basic_string|vector::|what\(\)|MPI_ERR")
CAPS = {"Points": 2, "Settling cycles": 6, "Recorded cycles": 2,
        "Samples per period": 50, "Samples per cycle": 16, "Maximum samples": 100}


def shortened(content):
    """The same file with few points, few periods and no long motion, for a short run."""
    text = content.decode()
    for key, most in CAPS.items():
        text = re.sub(rf"(set {key} *= *)(\d+)$",
                      lambda found, most=most: found[1] + str(min(int(found[2]), most)), text,
                      flags=re.MULTILINE)
    text = re.sub(r"(set Duration *= *)\d{3,} s$", r"\g<1>10 s", text, flags=re.MULTILINE)
    return text.encode()


def wrong(done, codes):
    """What is wrong with how a run ended, or nothing."""
    if done.timed_out and done.code == 4 and 3 in codes:
        return ""  # a long run that was asked for, and that stops when it is asked to
    if done.timed_out:
        return f"no end within {SECONDS} s of processor time"
    if done.signal:
        return f"ended by signal {done.signal}"
    if done.code not in codes:
        return f"exit code {done.code}"
    if TRACE.search(done.stdout + done.stderr):
        return "the trace of a library"
    messages = [line for line in done.stderr.splitlines() if line and not line.startswith(" ")]
    if done.code == 1 and not messages:
        return "no message"
    if done.code == 1 and len(messages) > 1 and "Everything else was written." not in messages:
        return "more than one message"
    if done.code != 1 and messages:
        return "a message beside a result"
    if len(done.stderr) > 3000:
        return f"a message of {len(done.stderr)} letters"
    if done.code == 3 and "points failed" not in done.stdout:
        return "points failed without a word"
    return ""


class Trial:
    """Runs mutants one after the other; `check` says whether by --check or short."""

    def __init__(self, server, sources, check, keep):
        self.server, self.sources, self.check, self.keep = server, sources, check, keep

    def __call__(self, seed):
        mutant = (mutants.mutant(self.sources, f"check {seed}") if self.check else
                  mutants.mutant(self.sources, f"run {seed}", mutants.GENTLE, shortened))
        with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
            for name, content in mutant.files.items():
                file = pathlib.Path(folder) / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(content)
            how = ["--check"] if self.check else ["--output", "out"]
            done = self.server.run([f"params/{mutant.name}", *how], folder, SECONDS, MEGABYTES)
            problem = wrong(done, (0, 1) if self.check else (0, 1, 3))
            if problem and self.keep:
                kept = pathlib.Path(self.keep) / f"{'check' if self.check else 'run'}-{seed}"
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(folder, kept)
        return seed, mutant, done, problem


def run_all(trials, seeds, workers):
    """Each worker has a server and every so many-th seed."""
    def work(number):
        return [report(trials[number](seed)) for seed in seeds[number::workers]]

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        return [done for part in pool.map(work, range(workers)) for done in part]


def report(result):
    seed, mutant, done, problem = result
    if problem:
        said = (done.stderr or done.stdout).strip()[-300:].replace("\n", " | ")
        print(f"{mutant.name}, seed {seed}: {problem}\n  {'; '.join(mutant.changes)}\n"
              f"  after {done.seconds:.1f} s: {said}", flush=True)
    return result


def summary(kind, results):
    codes = collections.Counter("none" if done.code < 0 else done.code for _, _, done, _ in results)
    slowest = max(results, key=lambda result: result[2].seconds)
    print(f"{len(results)} {kind}: " +
          ", ".join(f"exit code {code}: {count}" for code, count in sorted(codes.items(), key=str)) +
          f"; longest {slowest[2].seconds:.1f} s ({slowest[1].name}, seed {slowest[0]}); most memory "
          f"{max(done.peak_megabytes for _, _, done, _ in results):.0f} MB; wrong: "
          f"{sum(bool(problem) for *_, problem in results)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("server")
    parser.add_argument("tree", type=pathlib.Path)
    parser.add_argument("--checks", type=int, default=40)
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", help="folder for the files of mutants that went wrong")
    parser.add_argument("--without", action="append", default=[], help="a file to leave out")
    options = parser.parse_args()
    sources = [source for source in sorted((options.tree / "params").rglob("*.prm"))
               if source.name not in options.without and source.parent.name not in ("figures", "models")]
    failed = False
    servers = [ForkServer(options.server) for _ in range(options.jobs)]
    for check, count in ((True, options.checks), (False, options.runs)):
        if count == 0:
            continue
        trials = [Trial(server, sources, check, options.keep) for server in servers]
        results = run_all(trials, range(options.seed, options.seed + count), options.jobs)
        summary("mutants through --check" if check else "short runs of mutants", results)
        failed = failed or any(problem for *_, problem in results)
    for server in servers:
        server.__exit__()
    sys.exit(failed)


if __name__ == "__main__":
    main()
