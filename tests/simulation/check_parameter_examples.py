#!/usr/bin/python3
"""The examples of docs/parameters are accepted without a warning, and a mistake in any of them is found.

usage: check_parameter_examples.py FORK_SERVER TREE
"""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from fork_server import ForkServer  # noqa: E402

SERVER, TREE = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
EXAMPLES = sorted((TREE / "docs" / "parameters" / "examples").glob("*.prm"))


def complaint(server, file, folder):
    """What the program has against a file; empty where it has nothing."""
    done = server.run([file, "--check"], folder, seconds=120)
    if done.code == 0 and not done.timed_out and "warning:" not in done.stderr + done.stdout:
        return ""
    return f"{file.name}: exit code {done.code}\n{done.stderr}"


class ParameterExamples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(ForkServer(SERVER))
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))

    def test_there_are_examples(self):
        self.assertTrue(EXAMPLES)

    def test_each_is_accepted(self):
        for file in EXAMPLES:
            with self.subTest(file.name):
                self.assertEqual(complaint(self.server, file, self.folder), "")

    def test_a_misspelt_key_in_each_is_found(self):
        for file in EXAMPLES:
            text = file.read_text(encoding="utf-8").replace("../../../", f"{TREE}/")
            key = re.findall(r"(?m)^ +set (.*?) *=", text)[-1]
            broken = self.folder / file.name
            broken.write_text(text.replace(f"set {key}", f"set {key}s"), encoding="utf-8")
            with self.subTest(file.name):
                self.assertIn(f"{key}s", complaint(self.server, broken, self.folder))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
