#!/usr/bin/python3
"""Cost of many contacts between two meshes by two programs, run in turn.

    benchmark_contacts.py BEFORE AFTER [--divisions 12 24 48] [--turns 1]

Two square plates lie above each other, held at their edges; a shaken ground presses them together. Every
node faces one of the other plate. Processor time from start to end of a run and peak memory of its
process, the number of contacts, and the largest relative difference of frequencies, flexibilities and
contact forces between both programs.
"""
import argparse
import os
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

BODY = """
subsection Body {name}
  set Type = shell
  subsection Geometry
    set Plate     = 0 m, 0 m, {height} -> 1 m, 0 m, {height} -> 0 m, 0.8 m, {height}
    set Divisions = {divisions}, {divisions}
  end
  subsection Material
    set Young modulus = 210 GPa
    set Density       = 7800 kg/m^3
  end
  subsection Shell all
    set Thickness = {thickness}
  end
  subsection Support edges
    set At  = edges
    set Fix = pinned
  end
  subsection Interface face
    set At = all
  end
  subsection Modes
    set Number        = 20
    set Damping ratio = 0.01
  end
end
"""
REST = """
subsection Contact faces
  set Between                 = lower.face, upper.face
  set Pairing                 = proximity
  set Search radius           = 5 mm
  set Direction               = z
  set Law                     = kelvin-voigt
  set Least flexibility share = 0
  subsection Kelvin-Voigt
    set Stiffness        = 10 kN/m
    set Damping constant = 1 N s/m
  end
end
subsection Excitation ground
  set Type      = base acceleration
  set Direction = z
  set Amplitude = 60 m/s^2
  set Frequency = 20 Hz
end
subsection Analysis shake
  set Type = transient
  subsection Transient
    set Duration          = {duration} s
    set Sampling interval = 1 ms
    set Listed impacts    = 1
  end
end
"""


def parameters(divisions, duration):
    bodies = [BODY.format(name=name, height=height, thickness=thickness, divisions=divisions)
              for name, height, thickness in (("lower", "0 m", "3 mm"), ("upper", "1 mm", "4 mm"))]
    return "set Analyses = shake\n" + "".join(bodies) + REST.format(duration=duration)


def run(program, file, folder):
    """Processor time [s] and peak memory [GiB] of one run into the folder."""
    process = subprocess.Popen([program, str(file), "--output", str(folder), "--overwrite"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    message = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 3):
        raise SystemExit(f"{program} {file}: {message}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 2**20


def difference(first, second):
    """Largest relative difference of the numbers in both results that are no measure of the program."""
    largest = 0.0

    def compare(name, item):
        nonlocal largest
        counted = re.search("frequency$|flexibility$|contact/.*(force|gap)$", name)
        if counted and isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and item.size:
            a, b = np.nan_to_num(item[()]), np.nan_to_num(second[name][()])
            largest = max(largest, float(np.abs(a - b).max() / max(np.abs(a).max(), 1e-300)))

    first.visititems(compare)
    return largest


def compare(programs, divisions, arguments):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        file = folder / "plates.prm"
        file.write_text(parameters(divisions, arguments.duration), encoding="utf-8")
        used = [[run(program, file, folder / str(i)) for i, program in enumerate(programs)]
                for _ in range(arguments.turns)]
        with h5py.File(folder / "0" / "results.h5") as first, h5py.File(folder / "1" / "results.h5") as second:
            contacts = sum(1 for key in second["analysis/shake/contact"] if key.startswith("faces."))
            away = difference(first, second)
    seconds = [statistics.median(turn[i][0] for turn in used) for i in range(2)]
    memory = [max(turn[i][1] for turn in used) for i in range(2)]
    print(f"| {divisions} | {contacts} | {seconds[0]:.1f} | {seconds[1]:.1f} | {memory[0]:.2f} | {memory[1]:.2f} "
          f"| {away:.0e} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--divisions", type=int, nargs="+", default=[12, 24, 48])
    parser.add_argument("--duration", type=float, default=0.02, help="of the motion [s]")
    parser.add_argument("--turns", type=int, default=1)
    arguments = parser.parse_args()
    os.environ.setdefault("OMPI_MCA_ess_singleton_isolated", "1")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    print("| divisions | contacts | before, s | after, s | before, GiB | after, GiB | difference |")
    print("|---|---|---|---|---|---|---|")
    for divisions in arguments.divisions:
        compare((arguments.before, arguments.after), divisions, arguments)


if __name__ == "__main__":
    main()
