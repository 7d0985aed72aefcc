#!/usr/bin/python3
"""The installed library in another project, the Debian package, and the version that all files name.

usage: check_package.py SOURCE BUILD CMAKE CPACK
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
CMAKE, CPACK = sys.argv[3:5]

FILE = """
subsection Body oscillator
  set Type = lumped
  subsection Mass mass
    set Mass = 1 kg
    set Stiffness = 1 kN/m
  end
end
subsection Analysis modes
  set Type = modal
end
"""


class Package(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def run_command(self, *command, **environment):
        done = subprocess.run([str(part) for part in command], cwd=self.folder, text=True,
                              capture_output=True, check=False, env=os.environ | environment)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def run_program(self, program, **environment):
        (self.folder / "case.prm").write_text(FILE)
        printed = self.run_command(program, "case.prm", "--output", "out", **environment)
        self.assertTrue((self.folder / "out" / "results.h5").exists())
        return printed

    def test_another_project_uses_the_installed_library(self):
        self.run_command(CMAKE, "--install", BUILD, "--prefix", self.folder / "installed")
        consumer = pathlib.Path(__file__).parent / "consumer"
        self.run_command(CMAKE, "-S", consumer, "-B", "build", "-G", "Ninja",
                         f"-DCMAKE_PREFIX_PATH={self.folder / 'installed'}")
        self.run_command(CMAKE, "--build", "build")
        self.assertIn("7 mm = 0.007 m", self.run_program(self.folder / "build" / "consumer"))
        # Nothing that is installed may point back into the tree it was built in.
        for file in self.folder.glob("installed/lib/cmake/vibroimpact/*.cmake"):
            for tree in (SOURCE, BUILD):
                self.assertNotIn(str(tree), file.read_text())

    def test_debian_package(self):
        self.run_command(CPACK, "-G", "DEB", "-B", self.folder / "deb",
                         "--config", BUILD / "CPackConfig.cmake")
        package, = self.folder.glob("deb/vibroimpact_*_*.deb")
        depends = self.run_command("dpkg-deb", "--field", package, "Depends")
        for library in ("libdeal.ii-9", "libpetsc-real3", "libopenmpi3"):
            self.assertIn(library, depends)
        self.run_command("dpkg-deb", "--extract", package, "root")
        usr = self.folder / "root" / "usr"
        self.run_program(usr / "bin" / "vibroimpact")
        self.run_command(usr / "bin" / "vibroimpact-plot", "--help")
        for name in ("copyright", "README.md", "examples/params/impacting-beams.prm",
                     "examples/meshes/frame-three-storeys.msh"):
            self.assertTrue((usr / "share/doc/vibroimpact" / name).exists(), name)

    def test_one_version_everywhere(self):
        version, = re.findall(r"project\(vibroimpact VERSION (\S+)",
                              (SOURCE / "CMakeLists.txt").read_text())
        for file, pattern in (("CITATION.cff", r"^version: (\S+)$"),
                              ("postprocess/pyproject.toml", r'^version = "(\S+)"$'),
                              ("CHANGELOG.md", r"^## (\d\S+)$")):
            named = re.findall(pattern, (SOURCE / file).read_text(), re.MULTILINE)
            self.assertEqual(named[:1], [version], file)

    def test_citation_has_what_the_format_asks_for(self):
        text = (SOURCE / "CITATION.cff").read_text()
        for key in ("cff-version", "message", "title", "authors"):
            self.assertRegex(text, rf"(?m)^{key}:")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
