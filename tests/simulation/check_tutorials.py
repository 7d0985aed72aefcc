#!/usr/bin/python3
"""Every command of a tutorial page runs as it is printed, and the summaries have the numbers that the page shows.

usage: check_tutorials.py PROGRAM SOURCE [PAGE]
"""
import pathlib
import re
import subprocess
import sys
import tempfile


def blocks(text, kind):
    """The code blocks of a kind, in the order of the page."""
    return re.findall(rf"(?ms)^```{kind}\n(.*?)^```$", text)


def run(program, source, page):
    text = page.read_text(encoding="utf-8")
    folder = pathlib.Path(tempfile.mkdtemp())
    (folder / "params").symlink_to(source / "params")
    names = {"vibroimpact": str(program), "vibroimpact-plot":
             str(source / "postprocess" / "vibroimpact-plot")}
    files = re.findall(r"write into `([^`]+)`", text)
    missing = []
    for command in blocks(text, "sh"):
        command = re.sub(r"(?m)^(vibroimpact(?:-plot)?) ", lambda found: names[found[1]] + " ", command)
        done = subprocess.run(["sh", "-e", "-c", command], cwd=folder, capture_output=True, text=True,
                              check=False)
        if done.returncode:
            missing.append(f"{command}: {done.stdout}{done.stderr}")
        if files:  # after the first command has made the folder
            (folder / files.pop(0)).write_text(blocks(text, "prm")[0], encoding="utf-8")
    shown = "\n".join(path.read_text(encoding="utf-8") for path in sorted(folder.rglob("summary.txt")))
    for block in blocks(text, "text"):
        missing += [line for line in block.splitlines() if line and not is_there(line, shown)]
    return missing


def is_there(line, shown):
    """Values of the summary are shortened on the page, its comments give the same words."""
    name, equals, value = line.partition(" = ")
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
        SOURCE / "docs" / "tutorials" / "fit-a-sweep.md"]
    FOUND = [line for page in PAGES for line in run(PROGRAM, SOURCE, page)]
    print("\n".join(FOUND) or "all commands ran, all lines are there")
    sys.exit(1 if FOUND else 0)
