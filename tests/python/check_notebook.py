#!/usr/bin/python3
"""Runs the cells of a tutorial's notebook and compares what they print with what the notebook shows.

usage: check_notebook.py SOURCE TUTORIAL [--write]

The notebook goes on from the page of the same name: the page's first command and its parameter file come
first. With --write what is printed is stored in the notebook. The cells are plain Python, so that no
notebook server is needed.
"""
import contextlib
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def prepare(source, page):
    """What the first step of the page makes."""
    text = page.read_text(encoding="utf-8")
    pathlib.Path("params").symlink_to(source / "params")
    command, = re.findall(r"(?ms)^```sh\n(.*?)^```$", text)[:1]
    subprocess.run(["sh", "-e", "-c", command], check=True)
    name, = re.findall(r"write into `([^`]+)`", text)[:1]
    parameters, = re.findall(r"(?ms)^```prm\n(.*?)^```$", text)[:1]
    pathlib.Path(name).write_text(parameters, encoding="utf-8")


def printed_by(cell, names):
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile("".join(cell["source"]), "cell", "exec"), names)  # pylint: disable=exec-used
    return printed.getvalue()


def shown_in(cell):
    return "".join(line for output in cell["outputs"] for line in output["text"])


NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def same(printed, shown):
    """The same words, and numbers to a thousandth."""
    pairs = zip(NUMBER.findall(printed), NUMBER.findall(shown))
    return (NUMBER.sub("#", printed) == NUMBER.sub("#", shown)
            and all(abs(float(a) - float(b)) <= 1e-3 * abs(float(b)) for a, b in pairs))


def run_cells(cells, write):
    """The differences; with `write` none, as what is printed is stored."""
    names, differences = {}, []
    for cell in cells:
        printed = printed_by(cell, names)
        if write:
            stream = {"name": "stdout", "output_type": "stream",
                      "text": printed.splitlines(keepends=True)}
            cell["outputs"] = [stream] if printed else []
        elif not same(printed, shown_in(cell)):
            differences.append(f"printed:\n{printed}\nshown:\n{shown_in(cell)}\n")
    return differences


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    page = source / "docs" / "tutorials" / f"{sys.argv[2]}.md"
    file = page.with_suffix(".ipynb")
    notebook = json.loads(file.read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        prepare(source, page)
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        differences = run_cells(cells, "--write" in sys.argv)
        os.chdir(source)
    if "--write" in sys.argv:
        file.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    print("\n".join(differences) or f"{len(cells)} cells ran and print what the notebook shows")
    return 1 if differences or not cells else 0


if __name__ == "__main__":
    sys.exit(main())
