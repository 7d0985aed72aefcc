"""Starts the program, on one or more ranks, and turns what it says into values and exceptions."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path

from .folder import ResultFolder, open_folder

# Of the program, see vibroimpact --help.
ALL_DONE, BAD_INPUT, POINTS_FAILED, STOPPED = 0, 1, 3, 4


class ProgramError(Exception):
    """The program did not do what was asked; the message is its own."""


class ProgramNotFound(ProgramError):
    """There is no program vibroimpact where it was looked for."""


class InputError(ProgramError):
    """The input cannot be used; the message says where and why."""


class RunError(ProgramError):
    """The run broke off; `resume` goes on with what is kept."""


class Stopped(ProgramError):
    """A signal has stopped the run; `resume` goes on with what is kept."""


class ProgramWarning(UserWarning):
    """A doubt of the program about the input or the results."""


class PointsFailed(ProgramWarning):
    """Some points of a sweep or grid failed: `status` and `reason` of the analysis say which and why."""


def run(file, set: Mapping | None = None, *, output=None, overwrite=False, ranks=1, program=None,
        echo=False, petsc: Sequence[str] = ()) -> ResultFolder:  # pylint: disable=redefined-builtin
    """Runs a parameter file and opens the results.

    `set` maps paths of keys to values: texts as in the file ("7 mm"), numbers in SI, or lists of them.
    `output` is the result folder, by default output/ and the name of the file; one that holds results is
    refused unless `overwrite`. With `echo`, what the program prints is printed as it comes. `petsc`
    are options of PETSc. `program` is its path; by default $VIBROIMPACT_PROGRAM, else the one that
    this package came with, else the one on the search path.
    """
    folder = Path(output) if output is not None else Path("output") / Path(file).stem
    arguments = [file, "--output", folder, *(["--overwrite"] if overwrite else []),
                 *assignments(set), *(["--petsc", *petsc] if petsc else [])]
    return finished(start(arguments, ranks, program, echo), folder)


def resume(folder, *, ranks=1, program=None, echo=False) -> ResultFolder:
    """Goes on where the run in this folder stopped, and opens the results."""
    return finished(start(["--resume", folder], ranks, program, echo), Path(folder))


def check(file, set: Mapping | None = None, *,
          program=None) -> str:  # pylint: disable=redefined-builtin
    """Reads and checks a parameter file without running it; returns what the run would cost."""
    done = start([file, "--check", *assignments(set)], 1, program, False)
    raise_error(done)
    return done.stdout


def assignments(values: Mapping | None) -> list[str]:
    """--set PATH=VALUE for each of them."""
    return [part for path, value in (values or {}).items()
            for part in ("--set", f"{path}={value_text(value)}")]


def value_text(value) -> str:
    """As it stands in a parameter file; a number with all its digits."""
    if isinstance(value, (str, Path)):
        return str(value)
    if isinstance(value, bool) or type(value).__name__ == "bool_":
        return "true" if value else "false"
    if hasattr(value, "__iter__"):
        return ", ".join(value_text(item) for item in value)
    if hasattr(value, "__index__"):
        return str(int(value))
    return repr(float(value))


def find_program(program=None) -> str:
    """The path of the program; see run()."""
    wanted = program or os.environ.get("VIBROIMPACT_PROGRAM")
    if wanted:
        found = shutil.which(wanted)
        if not found:
            raise ProgramNotFound(f"{wanted}: there is no such program")
        return found
    here = Path(__file__).resolve().parents
    # In a source tree that is built in build/, and beside an installed share/vibroimpact.
    for place in (here[2] / "build" / "vibroimpact", here[3] / "bin" / "vibroimpact"):
        if place.is_file() and os.access(place, os.X_OK):
            return str(place)
    found = shutil.which("vibroimpact")
    if not found:
        raise ProgramNotFound("the program vibroimpact was not found: neither $VIBROIMPACT_PROGRAM "
                              "nor the search path names it")
    return found


def environment() -> dict[str, str]:
    """What Open MPI needs as root, in containers, and with more ranks than cores; what is set comes
    first."""
    wanted = {"OMPI_MCA_rmaps_base_oversubscribe": "1", "OPENBLAS_NUM_THREADS": "1",
              "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
    if os.geteuid() == 0:
        wanted |= {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return wanted | dict(os.environ)


def start(arguments, ranks: int, program, echo: bool) -> subprocess.CompletedProcess:
    """Until the program ends. An interrupt is handed on to it, so that it keeps its points."""
    if ranks < 1:
        raise ValueError(f"ranks must be at least 1, but is {ranks}")
    command = [*launcher(ranks), find_program(program), *map(str, arguments)]
    with tempfile.TemporaryFile("w+") as errors:  # a second pipe could fill while the first is read
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, text=True,
                              stdin=subprocess.DEVNULL, env=environment()) as process:
            try:
                printed = read_lines(process, echo)
            except KeyboardInterrupt:
                process.send_signal(signal.SIGINT)
                process.communicate()
                raise
        errors.seek(0)
        return subprocess.CompletedProcess(command, process.returncode, printed, errors.read())


def launcher(ranks: int) -> list[str]:
    """mpirun for several ranks, without its own remarks on how processes ended."""
    if ranks == 1:
        return []
    if not shutil.which("mpirun"):
        raise ProgramNotFound(f"mpirun is needed for {ranks} ranks, but is not on the search path")
    return ["mpirun", "-q", "-np", str(ranks)]


def read_lines(process: subprocess.Popen, echo: bool) -> str:
    lines = []
    for line in process.stdout:
        lines.append(line)
        if echo:
            sys.stdout.write(line)
    return "".join(lines)


def finished(done: subprocess.CompletedProcess, folder: Path) -> ResultFolder:
    """The results, with the program's warnings as warnings of Python."""
    raise_error(done)
    for text in warnings_in(done.stdout):
        kind = PointsFailed if "points failed" in text else ProgramWarning
        warnings.warn(text, kind, stacklevel=3)
    return open_folder(folder)


def warnings_in(printed: str) -> list[str]:
    """Each begins with "warning: "; indented lines behind it belong to it."""
    found = re.findall(r"^warning: (.*(?:\n +.*)*)$", printed, re.MULTILINE)
    return [text.rstrip() for text in found]


def raise_error(done: subprocess.CompletedProcess) -> None:
    """What the exit code says; the message is on the error output, of a stopped run the last line."""
    if done.returncode in (ALL_DONE, POINTS_FAILED):
        return
    if done.returncode == STOPPED:
        raise Stopped(done.stdout.strip().rpartition("\n")[2])
    # Without /sys the library that looks for the processors remarks on that.
    message = re.sub(r"^\[hwloc.*\n?", "", done.stderr, flags=re.MULTILINE).strip()
    if not message:  # the program gives a reason; what ends without one is not the program's input
        raise RunError(f"{done.args[0]} ended with code {done.returncode} and without a message\n"
                       + done.stdout.strip())
    raise (InputError if done.returncode == BAD_INPUT else RunError)(message)
