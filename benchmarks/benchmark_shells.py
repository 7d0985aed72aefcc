#!/usr/bin/python3
"""Normal modes of one shell mesh by vibroimpact and by CalculiX: time, peak memory, frequencies.

A square steel plate, clamped along one edge, on the same grid of nodes: quadrilaterals here, S4
there, and S8R whose middle nodes are those of the grid in between (S4R is no match: it has
hourglass modes). Each program does the whole of its work, from its input file to its results, on
one core unless --ranks says otherwise; memory is the largest sum of resident pages of all its
processes, looked at ten times a second. CalculiX is the Debian package calculix-ccx.

    benchmarks/benchmark_shells.py build/vibroimpact --elements 40 128

40 elements a side are 10 086 degrees of freedom, 128 are 99 846, 408 are 1 003 686. The load of the
machine before each run is shown: only on an idle one do elapsed times count, and processor times
are inflated by what shares the caches.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time

MODES = 20
SIDE, THICKNESS = 1.0, 0.01
YOUNG, POISSON, DENSITY = 200e9, 0.3, 8000.0

PARAMETERS = """
subsection Body plate
  set Type = shell
  subsection Geometry
    set Plate = 0 m, 0 m, 0 m -> {side} m, 0 m, 0 m -> 0 m, {side} m, 0 m
    set Divisions = {elements}, {elements}
  end
  subsection Material
    set Young modulus = {young} Pa
    set Poisson ratio = {poisson}
    set Density = {density} kg/m^3
  end
  subsection Shell plate
    set Thickness = {thickness} m
  end
  subsection Support left
    set At = left
    set Fix = all
  end
  subsection Modes
    set Number = {modes}
  end
end
subsection Analysis modes
  set Type = modal
end
"""

CALCULIX = """*NODE, NSET=ALL
{nodes}
*ELEMENT, TYPE={kind}, ELSET=PLATE
{elements}
*NSET, NSET=LEFT
{left}
*MATERIAL, NAME=STEEL
*ELASTIC
{young}, {poisson}
*DENSITY
{density}
*SHELL SECTION, ELSET=PLATE, MATERIAL=STEEL
{thickness}
*BOUNDARY
LEFT, 1, 6
*STEP
*FREQUENCY
{modes}
*NODE FILE
U
*END STEP
"""


class Run:
    """Elapsed and processor time [s], peak memory [MB] and frequencies [Hz] of a program."""

    def __init__(self, name, cost, frequencies, load):
        self.name, self.frequencies, self.load = name, frequencies, load
        self.seconds, self.processor, self.memory = cost


def resident(session):
    """Memory of all processes of a session, the ranks under mpirun too [MB]."""
    total = 0
    for process in pathlib.Path("/proc").iterdir():
        if not process.name.isdigit():
            continue
        try:
            if os.getsid(int(process.name)) == session:
                total += int((process / "statm").read_text().split()[1])
        except (ProcessLookupError, FileNotFoundError):
            pass
    return total * os.sysconf("SC_PAGE_SIZE") / 1e6


def measured(command, folder):
    """Elapsed and processor time, and peak memory of a command."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                       OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    start, peak = time.monotonic(), 0
    with open(folder / "log", "w", encoding="utf-8") as log:
        process = subprocess.Popen(command, cwd=folder, env=environment, stdout=log,
                                   stderr=subprocess.STDOUT, start_new_session=True)
        done, status, usage = os.wait4(process.pid, os.WNOHANG)
        while done == 0:
            peak = max(peak, resident(process.pid))
            time.sleep(0.1)
            done, status, usage = os.wait4(process.pid, os.WNOHANG)
    seconds = time.monotonic() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError((folder / "log").read_text(encoding="utf-8")[-2000:])
    return seconds, usage.ru_utime + usage.ru_stime, peak


def vibroimpact(arguments, elements, folder):
    text = PARAMETERS.format(side=SIDE, elements=elements, young=YOUNG, poisson=POISSON,
                             density=DENSITY, thickness=THICKNESS, modes=MODES)
    (folder / "plate.prm").write_text(text, encoding="utf-8")
    command = [str(arguments.program.resolve()), "plate.prm", "--output", "results"]
    if arguments.ranks > 1:
        command = ["mpirun", "-np", str(arguments.ranks)] + command
    load = os.getloadavg()[0]
    cost = measured(command, folder)
    summary = (folder / "results" / "summary.txt").read_text(encoding="utf-8")
    found = re.findall(r"body\.plate\.frequency\[\d+\] = (\S+)", summary)
    return Run("vibroimpact", cost, [float(value) for value in found], load)


def grid_node(elements, i, j):
    return 1 + j * (elements + 1) + i


def quadrilaterals(elements):
    """Corners of the cells of the grid."""
    for j in range(elements):
        for i in range(elements):
            yield [grid_node(elements, *place)
                   for place in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]


def serendipity(elements):
    """Corners and mid-sides of the cells of twice the size."""
    offsets = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
    for j in range(0, elements, 2):
        for i in range(0, elements, 2):
            yield [grid_node(elements, i + di, j + dj) for di, dj in offsets]


def calculix_input(kind, elements):
    cells = list(quadrilaterals(elements) if kind == "S4" else serendipity(elements))
    used = sorted({node for cell in cells for node in cell})
    step = SIDE / elements
    position = {node: ((node - 1) % (elements + 1), (node - 1) // (elements + 1)) for node in used}
    return CALCULIX.format(
        nodes="\n".join(f"{n}, {position[n][0] * step:.12g}, {position[n][1] * step:.12g}, 0"
                        for n in used),
        kind=kind,
        elements="\n".join(", ".join(map(str, [number, *cell]))
                           for number, cell in enumerate(cells, 1)),
        left="\n".join(str(n) for n in used if position[n][0] == 0),
        young=YOUNG, poisson=POISSON, density=DENSITY, thickness=THICKNESS, modes=MODES)


def calculix(kind, elements, folder):
    (folder / "plate.inp").write_text(calculix_input(kind, elements), encoding="utf-8")
    load = os.getloadavg()[0]
    cost = measured([shutil.which("ccx"), "-i", "plate"], folder)
    rows = re.findall(r"^ +\d+ +\S+ +\S+ +(\S+) +\S+ *$",
                      (folder / "plate.dat").read_text(encoding="utf-8"), re.MULTILINE)
    return Run(f"CalculiX {kind}", cost, [float(row) for row in rows[:MODES]], load)


def compared(elements, runs):
    first = runs[0]
    print(f"\n{elements} x {elements} elements, {6 * (elements + 1)**2} degrees of freedom, "
          f"{MODES} modes\n")
    print("| program | elapsed, s | processor, s | of the first | peak memory, MB | load before |\n"
          "|---|---|---|---|---|---|")
    for run in runs:
        print(f"| {run.name} | {run.seconds:.2f} | {run.processor:.2f} | "
              f"{run.processor / first.processor:.2f} | {run.memory:.0f} | {run.load:.1f} |")
    print("\n| mode | " + " | ".join(run.name + ", Hz" for run in runs) + " |\n|---|"
          + "---|" * len(runs))
    for mode, values in enumerate(zip(*(run.frequencies for run in runs)), 1):
        print(f"| {mode} | " + " | ".join(f"{value:.4f}" for value in values) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path, help="the vibroimpact program")
    parser.add_argument("--elements", type=int, nargs="+", default=[40], help="a side; even")
    parser.add_argument("--against", nargs="*", default=["S4", "S8R"], choices=["S4", "S8R"],
                        help="elements of CalculiX; none to run vibroimpact alone")
    parser.add_argument("--ranks", type=int, default=1, help="processes of vibroimpact")
    arguments = parser.parse_args()
    if arguments.against and not shutil.which("ccx"):
        parser.error("ccx is not installed: Debian package calculix-ccx")
    for elements in arguments.elements:
        runs = []
        for kind in [None, *arguments.against]:
            with tempfile.TemporaryDirectory() as folder:
                runs.append(calculix(kind, elements, pathlib.Path(folder)) if kind
                            else vibroimpact(arguments, elements, pathlib.Path(folder)))
        compared(elements, runs)


if __name__ == "__main__":
    main()
