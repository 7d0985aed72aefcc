"""What tests of whole runs share: a folder for each test, and the program started in it, on one or
more ranks. Usage of such a test: check_NAME.py PROGRAM MPIEXEC [PART/PARTS] [--slow]
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy as np


def datasets(folder):
    """Every dataset of a result file as bytes, by path."""
    found = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset):
            values = item[()]
            found[name] = values.tobytes() if isinstance(values, np.ndarray) else repr(values)
            if getattr(values, "dtype", None) == object:
                found[name] = repr(values.tolist())

    with h5py.File(folder / "results.h5") as file:
        file.visititems(visit)
    return found


class InAFolder(unittest.TestCase):
    """`file` is where a test writes the parameter file."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.file = self.folder / "case.prm"


class ProgramRuns(InAFolder):
    def command(self, *arguments, ranks=1):
        program, mpiexec = sys.argv[1:3]
        start = [mpiexec, "-n", str(ranks)] if ranks > 1 else []
        return start + [program, *map(str, arguments)]

    def run_program(self, *arguments, ranks=1):
        return subprocess.run(self.command(*arguments, ranks=ranks), cwd=self.folder,
                              capture_output=True, text=True, check=False)

    def wait_for_journal(self, folder, size, process):
        """Until that many bytes of finished points are kept, or the run is over."""
        while process.poll() is None:
            if folder.is_dir() and sum(j.stat().st_size for j in folder.iterdir()) >= size:
                return
            time.sleep(0.005)

    def expect_same_bytes(self):
        """Of the parameter file on one, two and three ranks, and of a run that is killed when 30 %
        of its points are kept and goes on with two."""
        whole = self.folder / "ranks1"
        for ranks in (1, 2, 3):
            out = self.folder / f"ranks{ranks}"
            done = self.run_program(self.file, "--output", out, ranks=ranks)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual(datasets(out), datasets(whole))
            self.assertRegex(done.stdout, r": (\d+) of \1 \(100 %\), .*took ")
        kept = sum(journal.stat().st_size for journal in (whole / "journal").iterdir())
        out = self.folder / "cut"
        process = subprocess.Popen(self.command(self.file, "--output", out), cwd=self.folder,
                                   stdout=subprocess.DEVNULL)
        self.wait_for_journal(out / "journal", 0.3 * kept, process)
        process.send_signal(signal.SIGKILL)
        process.wait()
        done = self.run_program("--resume", out, ranks=2)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(datasets(out), datasets(whole))


def slow(test):
    """Marks a test that takes long for what it alone would notice: run with --slow only."""
    test.slow = True
    return test


def is_slow(test):
    return getattr(getattr(test, test.id().rsplit(".", 1)[-1], None), "slow", False)


def tests_of(suite):
    """Of a suite of suites, one by one."""
    for test in suite:
        yield from tests_of(test) if isinstance(test, unittest.TestSuite) else [test]


def main():
    """The quick tests of the script, with --slow the others; or of its parts one: "2/5" runs the
    second of five, and so on."""
    os.environ.setdefault("OMPI_MCA_rmaps_base_oversubscribe", "1")
    wanted = "--slow" in sys.argv
    given = [argument for argument in sys.argv[3:] if argument != "--slow"]
    part, parts = map(int, given[0].split("/")) if given else (1, 1)
    loaded = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
    every = [test for test in tests_of(loaded) if is_slow(test) == wanted]
    done = unittest.TextTestRunner().run(unittest.TestSuite(every[part - 1::parts]))
    sys.exit(not (done.wasSuccessful() and done.testsRun > 0))
