#!/usr/bin/python3
"""Normal modes of shells by vibroimpact and by CalculiX: time, peak memory, frequencies.

A square steel plate, clamped along one edge; the same plate turned in space, so that no entry of
its matrices is zero; and a circular cylinder clamped at one end, whose modes come in pairs. The
grid of nodes is the same: quadrilaterals here, S4 there, and S8R whose middle nodes are those of
the grid in between (S4R is no match: it has hourglass modes). Each program does the whole of its
work, from its input file to its results, on one core unless --ranks says otherwise; memory is the
largest sum of resident pages of all its processes, looked at ten times a second. CalculiX is the
Debian package calculix-ccx.

    benchmarks/benchmark_shells.py build/vibroimpact --bodies plate cylinder --elements 40 128

40 elements a side are 10 086 degrees of freedom, 128 are 99 846, 408 are 1 003 686, about as many on
the cylinder. --before names another build, whose phases are shown beside those of the first. The
load of the machine before each run is shown: only on an idle one do elapsed times count, and
processor times are inflated by what shares the caches.
"""
import argparse
import math
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
    {geometry}
    set Divisions = {around}, {along}
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
    set At = {clamped}
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


SLOPE, TURN = 0.7, 0.5
EDGES = ((math.cos(TURN) * math.cos(SLOPE), math.sin(TURN) * math.cos(SLOPE), math.sin(SLOPE)),
         (-math.sin(TURN), math.cos(TURN), 0.0))
RADIUS, LENGTH = 0.3, 1.0


class Body:
    """A grid of nodes: `around` x `along` cells, the first closed where the body is a cylinder."""

    def __init__(self, kind, elements):
        self.kind = kind
        self.closed = kind == "cylinder"
        self.around = 2 * round(0.65 * elements) if self.closed else elements
        self.along = 2 * round(0.39 * elements) if self.closed else elements
        self.columns = self.around if self.closed else self.around + 1

    def node(self, i, j):
        return 1 + j * self.columns + i % self.columns

    def nodes(self):
        return self.columns * (self.along + 1)

    def position(self, node):
        i, j = (node - 1) % self.columns / self.around, (node - 1) // self.columns / self.along
        if self.closed:
            angle = 2 * math.pi * i
            return RADIUS * math.cos(angle), RADIUS * math.sin(angle), LENGTH * j
        if self.kind == "tilted plate":
            return tuple(SIDE * (i * x + j * y) for x, y in zip(*EDGES))
        return SIDE * i, SIDE * j, 0.0

    def is_clamped(self, node):
        return (node - 1) // self.columns == 0 if self.closed else (node - 1) % self.columns == 0

    def geometry(self):
        if self.closed:
            return (f"set Cylinder = 0 m, 0 m, 0 m -> 0 m, 0 m, {LENGTH} m\n"
                    f"    set Radius = {RADIUS} m")
        ends = ((1, 0, 0), (0, 1, 0)) if self.kind == "plate" else EDGES
        return "set Plate = 0 m, 0 m, 0 m -> " + " -> ".join(
            ", ".join(f"{SIDE * x:.15g} m" for x in end) for end in ends)

    def quadrilaterals(self):
        """Corners of the cells of the grid."""
        for j in range(self.along):
            for i in range(self.around):
                yield [self.node(*at) for at in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]

    def serendipity(self):
        """Corners and mid-sides of the cells of twice the size."""
        offsets = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
        for j in range(0, self.along, 2):
            for i in range(0, self.around, 2):
                yield [self.node(i + di, j + dj) for di, dj in offsets]


class Run:
    """Elapsed and processor time [s], peak memory [MB] and frequencies [Hz] of a program, and the
    processor time of its phases."""

    def __init__(self, name, cost, frequencies, load, phases=None):
        self.name, self.frequencies, self.load, self.phases = name, frequencies, load, phases
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


def processor_time(session):
    """Of all processes of a session that still run [s]."""
    ticks = 0
    for process in pathlib.Path("/proc").iterdir():
        try:
            if process.name.isdigit() and os.getsid(int(process.name)) == session:
                fields = (process / "stat").read_text().rsplit(")", 1)[1].split()
                ticks += int(fields[11]) + int(fields[12])
        except (ProcessLookupError, FileNotFoundError):
            pass
    return ticks / os.sysconf("SC_CLK_TCK")


def measured(command, folder, marks=()):
    """Elapsed and processor time and peak memory of a command, and the processor time when each of
    the marks has come in what it prints."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                       OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    start, peak, looks, reached = time.monotonic(), 0, 0, {}
    with open(folder / "log", "w", encoding="utf-8") as log:
        process = subprocess.Popen(command, cwd=folder, env=environment, stdout=log,
                                   stderr=subprocess.STDOUT, start_new_session=True)
        done, status, usage = os.wait4(process.pid, os.WNOHANG)
        while done == 0:
            if looks % 10 == 0:
                peak = max(peak, resident(process.pid))
            looks += 1
            if len(reached) < len(marks):
                text = (folder / "log").read_text(encoding="utf-8")
                for mark in marks:
                    if mark in text and mark not in reached:
                        reached[mark] = processor_time(process.pid)
            time.sleep(0.01)
            done, status, usage = os.wait4(process.pid, os.WNOHANG)
    seconds = time.monotonic() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError((folder / "log").read_text(encoding="utf-8")[-2000:])
    total = usage.ru_utime + usage.ru_stime
    return (seconds, total, peak), [reached.get(mark) for mark in marks] + [total]


PHASES = ("start, mesh, matrices", "modes", "shapes, stress", "results")
MARKS = (": modes of", ": static solutions", "1 of 1")


def vibroimpact(name, program, ranks, body, folder):
    text = PARAMETERS.format(geometry=body.geometry(), around=body.around, along=body.along,
                             clamped="bottom" if body.closed else "left", young=YOUNG,
                             poisson=POISSON, density=DENSITY, thickness=THICKNESS, modes=MODES)
    (folder / "plate.prm").write_text(text, encoding="utf-8")
    command = [str(program.resolve()), "plate.prm", "--output", "results"]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks)] + command
    load = os.getloadavg()[0]
    cost, ends = measured(command, folder, MARKS)
    summary = (folder / "results" / "summary.txt").read_text(encoding="utf-8")
    found = re.findall(r"body\.plate\.frequency\[\d+\] = (\S+)", summary)
    known = None not in ends  # bodies that take no seconds print no stages
    phases = [end - begin for begin, end in zip([0] + ends, ends)] if known else None
    return Run(name, cost, [float(value) for value in found], load, phases)


def calculix_input(kind, body):
    cells = list(body.quadrilaterals() if kind == "S4" else body.serendipity())
    used = sorted({node for cell in cells for node in cell})
    return CALCULIX.format(
        nodes="\n".join(", ".join([str(n)] + [f"{x:.12g}" for x in body.position(n)])
                        for n in used),
        kind=kind,
        elements="\n".join(", ".join(map(str, [number, *cell]))
                           for number, cell in enumerate(cells, 1)),
        left="\n".join(str(n) for n in used if body.is_clamped(n)),
        young=YOUNG, poisson=POISSON, density=DENSITY, thickness=THICKNESS, modes=MODES)


def calculix(kind, body, folder):
    (folder / "plate.inp").write_text(calculix_input(kind, body), encoding="utf-8")
    load = os.getloadavg()[0]
    cost, _ = measured([shutil.which("ccx"), "-i", "plate"], folder)
    rows = re.findall(r"^ +\d+ +\S+ +\S+ +(\S+) +\S+ *$",
                      (folder / "plate.dat").read_text(encoding="utf-8"), re.MULTILINE)
    return Run(f"CalculiX {kind}", cost, [float(row) for row in rows[:MODES]], load)


def compared(body, runs):
    first = runs[0]
    print(f"\n{body.kind}, {body.around} x {body.along} elements, {6 * body.nodes()} degrees of "
          f"freedom, {MODES} modes\n")
    print("| program | elapsed, s | processor, s | of the first | peak memory, MB | load before |\n"
          "|---|---|---|---|---|---|")
    for run in runs:
        print(f"| {run.name} | {run.seconds:.2f} | {run.processor:.2f} | "
              f"{run.processor / first.processor:.2f} | {run.memory:.0f} | {run.load:.1f} |")
    if first.phases:
        print("\n| processor, s | " + " | ".join(PHASES) + " |\n|---|" + "---|" * len(PHASES))
        for run in runs:
            if run.phases:
                print(f"| {run.name} | " + " | ".join(f"{phase:.2f}" for phase in run.phases) + " |")
    print("\n| mode | " + " | ".join(run.name + ", Hz" for run in runs) + " |\n|---|"
          + "---|" * len(runs))
    for mode, values in enumerate(zip(*(run.frequencies for run in runs)), 1):
        print(f"| {mode} | " + " | ".join(f"{value:.4f}" for value in values) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path, help="the vibroimpact program")
    parser.add_argument("--before", type=pathlib.Path, help="another build to compare with")
    parser.add_argument("--bodies", nargs="+", default=["plate"],
                        choices=["plate", "tilted plate", "cylinder"])
    parser.add_argument("--elements", type=int, nargs="+", default=[40], help="a side; even")
    parser.add_argument("--against", nargs="*", default=["S4", "S8R"], choices=["S4", "S8R"],
                        help="elements of CalculiX; none to run vibroimpact alone")
    parser.add_argument("--ranks", type=int, default=1, help="processes of vibroimpact")
    arguments = parser.parse_args()
    if arguments.against and not shutil.which("ccx"):
        parser.error("ccx is not installed: Debian package calculix-ccx")
    programs = [("vibroimpact", arguments.program)]
    if arguments.before:
        programs.append(("before", arguments.before))
    for kind in arguments.bodies:
        for elements in arguments.elements:
            body, runs = Body(kind, elements), []
            for name, program in programs:
                with tempfile.TemporaryDirectory() as folder:
                    runs.append(vibroimpact(name, program, arguments.ranks, body,
                                            pathlib.Path(folder)))
            for shell in arguments.against:
                with tempfile.TemporaryDirectory() as folder:
                    runs.append(calculix(shell, body, pathlib.Path(folder)))
            compared(body, runs)


if __name__ == "__main__":
    main()
