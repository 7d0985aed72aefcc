"""vibroimpact-plot starts without NumPy, and its package can be installed: check_plot_package.py POSTPROCESS"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

POSTPROCESS = Path(sys.argv[1]).resolve()
del sys.argv[1:]
REFUSED = "raise ImportError('not wanted')\n"


def run(*arguments, **environment):
    return subprocess.run(arguments, capture_output=True, text=True, check=False,
                          env=os.environ | environment)


class Start(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        for module in ("numpy", "h5py", "matplotlib"):
            (self.folder / f"{module}.py").write_text(REFUSED)

    def test_help_needs_no_library(self):
        done = run(POSTPROCESS / "vibroimpact-plot", "--help", PYTHONPATH=str(self.folder))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("--overlay", done.stdout)

    def test_wrong_options_need_no_library(self):
        done = run(POSTPROCESS / "vibroimpact-plot", "results", "--size", "6",
                   PYTHONPATH=str(self.folder))
        self.assertEqual(done.returncode, 2)
        self.assertIn("two numbers are wanted", done.stderr)


class Package(unittest.TestCase):
    def test_import_leaves_the_backend_to_the_caller(self):
        program = ("import matplotlib; import vibroimpact.plots.figure_list;"
                   "print(matplotlib.rcParams._get_backend_or_none())")
        done = run(sys.executable, "-B", "-c", program, PYTHONPATH=str(POSTPROCESS), MPLBACKEND="")
        self.assertEqual((done.stdout.strip(), done.stderr), ("None", ""))

    def test_pip_installs_it_with_its_command(self):
        with tempfile.TemporaryDirectory() as folder:
            source, target = Path(folder, "source"), Path(folder, "target")
            shutil.copytree(POSTPROCESS, source, ignore=shutil.ignore_patterns("__pycache__"))
            done = run(sys.executable, "-m", "pip", "install", "--quiet", "--no-deps",
                       "--no-index", "--no-build-isolation", "--target", target, source)
            self.assertEqual(done.returncode, 0, done.stderr)
            modules = {file.relative_to(POSTPROCESS)
                       for file in POSTPROCESS.glob("vibroimpact/**/*.py")}
            self.assertLessEqual(modules, {file.relative_to(target)
                                           for file in target.glob("vibroimpact/**/*.py")})
            done = run(target / "bin" / "vibroimpact-plot", "--help", PYTHONPATH=str(target))
            self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
