#!/usr/bin/env python3
"""Runs parameter files with two programs and lists every difference of what they write.

    . scripts/mpi-environment.sh
    tests/support/compare_runs.py PROGRAM_A PROGRAM_B [FILE...] [--work FOLDER] [--ranks 1,3]

Without files those of params/ and params/verification/. Compared are, as bytes: the datasets of
results.h5 with their shapes, types, attributes and dimension scales; the summaries, the echo
of the parameters, and every table, mesh and picture beside them. What tells when, where and by
which command a run was made is left out. With --work the runs of program A are kept there and used
again. Exit code 1 where anything differs, or a run of B ends otherwise than that of A.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
OF_THE_RUN = {"version", "commit", "command_line", "libraries", "ranks", "processor"}
OF_THE_LIBRARY = {"REFERENCE_LIST", "DIMENSION_LIST"}   # addresses in the file
LEFT_OUT = re.compile(r"^(results\.h5|log\.txt)$|^(journal|bodies)/")
OF_THE_MACHINE = re.compile(r"(?:generated|created|written)[^\n]*\d{4}[^\n]*|File folder *=[^\n]*",
                            re.IGNORECASE)


def plain(value):
    """An attribute or a dataset as something that compares by its bytes."""
    array = np.asarray(value)
    if array.dtype.kind in "OSU":
        return OF_THE_MACHINE.sub("", "\n".join(map(str, array.ravel().tolist())))
    return str(array.dtype), array.shape, array.tobytes()


def attributes(item, without=frozenset()):
    return {f"@{name}": plain(value) for name, value in item.attrs.items() if name not in without}


def scales(dataset):
    return [[scale.name for scale in dimension.values()] for dimension in dataset.dims]


def contents(path):
    """What a result file says, by dataset and aspect."""
    found = {}

    def visit(name, item):
        of = attributes(item, OF_THE_LIBRARY)
        if isinstance(item, h5py.Dataset):
            of |= {"values": plain(item[()]), "scales": scales(item)}
        found[name] = of

    with h5py.File(path) as file:
        root = attributes(file, OF_THE_RUN)
        file.visititems(visit)
    return {"/": root} | found


def differing_values(before, after):
    """How far two datasets of one type and shape are apart, in words."""
    (kind, shape, a), (other_kind, other_shape, b) = before, after
    if (kind, shape) != (other_kind, other_shape):
        return f"{kind}{shape} became {other_kind}{other_shape}"
    if np.dtype(kind).kind not in "fiu":
        return "differs"
    a, b = (np.frombuffer(bytes_, kind).astype(float) for bytes_ in (a, b))
    with np.errstate(all="ignore"):
        largest = np.nanmax(np.abs(a - b), initial=0) / max(np.nanmax(np.abs(a), initial=0), 1e-300)
    return f"{np.sum(~((a == b) | (np.isnan(a) & np.isnan(b))))} of {a.size} values, by {largest:.1e}"


def differences_of_results(before, after):
    a, b = contents(before), contents(after)
    for name in a.keys() | b.keys():
        if name not in a or name not in b:
            yield f"{name}: only {'before' if name in a else 'after'}"
            continue
        for aspect in a[name].keys() | b[name].keys():
            one, other = a[name].get(aspect), b[name].get(aspect)
            if one == other:
                continue
            both = aspect == "values" and None not in (one, other) and isinstance(one, tuple)
            yield f"{name} {aspect}: {differing_values(one, other) if both else 'differs'}"


def files(folder):
    paths = (str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
    return {path for path in paths if not LEFT_OUT.search(path)}


def without_machine(content):
    return OF_THE_MACHINE.sub("", content.decode("latin-1"))


def differences(before, after):
    for path in sorted(files(before) ^ files(after)):
        yield f"{path}: only {'before' if (before / path).exists() else 'after'}"
    for path in sorted(files(before) & files(after)):
        one, other = (without_machine((folder / path).read_bytes()) for folder in (before, after))
        if one != other:
            yield f"{path}: other bytes"
    if all((folder / "results.h5").exists() for folder in (before, after)):
        yield from sorted(differences_of_results(before / "results.h5", after / "results.h5"))


def run(program, file, folder, ranks):
    """Returns the exit code, which stands beside the results, with the messages."""
    code = folder.with_suffix(".code")
    if code.exists():
        return int(code.read_text())
    start = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
    with open(folder.with_suffix(".out"), "w") as printed:
        done = subprocess.run([*start, program, file, "--output", folder.absolute()], stdout=printed,
                              stderr=subprocess.STDOUT, cwd=ROOT, check=False)
    code.write_text(str(done.returncode))
    return done.returncode


def compare(arguments, file, ranks, work):
    """The differences of one file's runs, with the time that both took."""
    name = f"{pathlib.Path(file).stem}-{ranks}"
    begun = time.monotonic()
    folders = [folder / name for folder in work]
    codes = [run(program.absolute(), file, folder, ranks)
             for program, folder in zip((arguments.before, arguments.after), folders)]
    found = [f"exit code {codes[0]} became {codes[1]}"] if codes[0] != codes[1] else []
    return found + list(differences(*folders)), time.monotonic() - begun


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("after", type=pathlib.Path)
    parser.add_argument("files", nargs="*")
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--ranks", default="1")
    parser.add_argument("--show", type=int, default=12, help="differences of a file")
    arguments = parser.parse_args()
    shipped = sorted([*ROOT.glob("params/*.prm"), *ROOT.glob("params/verification/*.prm")])
    differing = 0
    with tempfile.TemporaryDirectory() as temporary:
        after = pathlib.Path(temporary) / "after"
        work = [arguments.work or pathlib.Path(temporary) / "before", after]
        for folder in work:
            folder.mkdir(parents=True, exist_ok=True)
        for file in arguments.files or shipped:
            for ranks in map(int, arguments.ranks.split(",")):
                found, seconds = compare(arguments, file, ranks, work)
                differing += bool(found)
                print(f"{file} on {ranks}: {len(found) or 'no'} differences ({seconds:.0f} s)",
                      *found[:arguments.show], sep="\n  ", flush=True)
    sys.exit(differing > 0)


if __name__ == "__main__":
    main()
