#!/usr/bin/python3
"""Every command of a tutorial page runs as it is printed, and the summaries have the numbers that the page shows.

usage: check_tutorials.py PROGRAM SOURCE [PAGE]
"""
import pathlib
import re
import subprocess
import sys
import tempfile


BLOCK = re.compile(r"(?ms)^```(sh fails|sh|prm|text|message)\n(.*?)^```$")
SHORTER = re.compile(r"<!-- tested with (.*) -->")
FILE = re.compile(r"([Ww]rite into|[Aa]dd to) `([^`]+)`")


class Page:
    """A page's blocks in their order, in a folder of their own: a file that the text before it says to write or to add to,
    commands that must run ("sh") or end with 1 ("sh fails"), a part of what the last command said, lines of a summary.
    A comment before commands may add options that make them shorter; of the next lines of a summary the names count then."""

    def __init__(self, program, source):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        (self.folder / "params").symlink_to(source / "params")
        self.names = {"vibroimpact": str(program),
                      "vibroimpact-plot": str(source / "postprocess" / "vibroimpact-plot")}
        self.said = ""
        self.missing = []

    def follow(self, text):
        end, shorter, lines = 0, "", []
        for block in BLOCK.finditer(text):
            before, end = text[end:block.start()], block.end()
            kind, content = block.groups()
            if kind.startswith("sh"):
                shorter = "".join(SHORTER.findall(before)) or (shorter if "-plot" in content else "")
            if kind == "prm":
                self.write(before, content)
            elif kind == "message":
                self.missing += [f"not said: {line}" for line in content.splitlines() if line not in self.said]
            elif kind != "text":
                self.command(content, 1 if kind == "sh fails" else 0, shorter)
            else:
                lines += [line.partition(" = ")[0] + " = " if shorter else line
                          for line in content.splitlines() if line]
        self.compare(lines)

    def write(self, before, content):
        how, name = FILE.findall(before)[-1]
        with (self.folder / name).open("a" if how.lower().startswith("add") else "w",
                                       encoding="utf-8") as file:
            file.write(content)

    def command(self, command, wanted, shorter):
        command = re.sub(r"(?m)^(mpirun -np \d+ )?(vibroimpact(?:-plot)?) ",
                         lambda found: (found[1] or "") + self.names[found[2]] + " ", command)
        if shorter and "-plot" not in command:
            command = re.sub(r"(?m)$(?<=.)", " " + shorter.replace("\\", r"\\"), command)
        done = subprocess.run(["sh", "-e", "-c", command], cwd=self.folder, capture_output=True, text=True,
                              check=False)
        self.said = done.stdout + done.stderr
        if done.returncode != wanted:
            self.missing.append(f"{command}: {self.said}")

    def compare(self, lines):
        shown = "\n".join(path.read_text(encoding="utf-8")
                          for path in sorted(self.folder.rglob("summary.txt")))
        self.missing += [line for line in lines if not is_there(line, shown)]


def run(program, source, page):
    followed = Page(program, source)
    followed.follow(page.read_text(encoding="utf-8"))
    return followed.missing


def is_there(line, shown):
    """Values of the summary are shortened on the page, its comments give the same words."""
    name, equals, value = line.partition(" = ")
    if equals and not value:
        return any(other.startswith(line) for other in shown.splitlines())
    if not equals:
        words = re.sub(r"[-\d.]+", "", line)
        return any(re.sub(r"[-\d.]+", "", other) == words for other in shown.splitlines())
    found = [float(other.partition(" = ")[2].split()[0]) for other in shown.splitlines()
             if other.startswith(name + " = ")]
    wanted = float(value.split()[0])
    return any(other == wanted or abs(other - wanted) <= 1e-3 * abs(wanted) for other in found)


if __name__ == "__main__":
    PROGRAM, SOURCE = (pathlib.Path(value).resolve() for value in sys.argv[1:3])
    PAGES = [pathlib.Path(value) for value in sys.argv[3:]] or [
        SOURCE / "docs" / "tutorials" / name for name in (
            "first-model.md", "sections.md", "fit-a-sweep.md", "choose-a-stop.md")]
    FOUND = [line for page in PAGES for line in run(PROGRAM, SOURCE, page)]
    print("\n".join(FOUND) or "all commands ran, all lines are there")
    sys.exit(1 if FOUND else 0)
