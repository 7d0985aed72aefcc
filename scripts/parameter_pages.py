#!/usr/bin/env python3
"""The pages of docs/parameters: what the program prints about its keys, a page for each section, with an example.

    parameter_pages.py PROGRAM ROOT           writes the pages anew
    parameter_pages.py PROGRAM ROOT --check   exit code 1 and the differences where they are out of date
    parameter_pages.py --self-test

The examples are parts of the files docs/parameters/examples/*.prm, which can be run. The first line of each names the
sections that it is shown for: `# Example for: Body, Body / Geometry`.
"""

import difflib
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path("docs") / "parameters"
FIRST_LINE = "# Example for: "
INDEX = "README.md"
SYMBOL = 5  # the cell of a row
GREEK = dict(zip(("alpha beta gamma delta varepsilon epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau varphi phi omega "
                  "Delta Omega").split(), "αβγδεεζηθκλμνξρστφφωΔΩ"))
GREEK_NAME = re.compile(r"\\?\b(" + "|".join(GREEK) + r")(?![A-Za-z])")


def title_of(heading):
    """Of a section in examples and names of files: 'Body / Point' for 'Body NAME / Point NAME'."""
    return heading.replace(" NAME", "")


def file_of(heading):
    return re.sub(r"[^a-z]+", "-", title_of(heading).lower()) + ".md"


def with_letters(printed):
    """Greek letters for their names in the column of symbols."""
    lines = printed.split("\n")
    for number, line in enumerate(lines):
        cells = re.split(r"(?<!\\)\|", line)
        if line.startswith("| `") and len(cells) > SYMBOL:
            cells[SYMBOL] = GREEK_NAME.sub(lambda name: GREEK[name[1]], cells[SYMBOL])
            lines[number] = "|".join(cells)
    return "\n".join(lines)


def sections(printed):
    """What stands before all sections, and the text of each of the first two levels by its heading."""
    parts = re.split(r"(?m)^##(?:#)? (?!#)(.*)\n", printed)
    return parts[0], dict(zip(parts[1::2], parts[2::2]))


def indented(text):
    for line in text.splitlines():
        yield (len(line) - len(line.lstrip())) // 2, line


def kind_of(line):
    """'Body' for the line 'subsection Body beam' where Body is a kind; whole names where it is none."""
    return line.strip().removeprefix("subsection ").partition("#")[0].strip()


def is_kind(line, wanted):
    name = kind_of(line)
    return line.strip().startswith("subsection ") and (name == wanted or name.rpartition(" ")[0] == wanted)


def block(lines, wanted, depth):
    """The lines of the first section of a kind at a depth, from its first line to its `end`."""
    begin = next((i for i, (level, line) in enumerate(lines) if level == depth and is_kind(line, wanted)), None)
    if begin is None:
        return []
    end = next(i for i in range(begin, len(lines)) if lines[i] == (depth, "  " * depth + "end"))
    return lines[begin:end + 1]


def part(text, title):
    """The lines of an example that a section is shown by: all of it, and the keys of what it stands in."""
    outer, _, inner = title.partition(" / ")
    lines = list(indented(text))
    if not inner:
        return [line for _, line in block(lines, outer, 0)]
    for begin, (level, line) in enumerate(lines):
        if level == 0 and is_kind(line, outer):
            around = block(lines[begin:], outer, 0)
            found = block(around, inner, 1)
            if found:
                keys = [own for depth, own in around[1:-1] if depth == 1 and own.strip().startswith("set ")]
                return [around[0][1], *keys, *[own for _, own in found], "end"]
    return []


def examples(folder):
    """The name and the lines of the example of each section."""
    found = {}
    for file in sorted((folder / "examples").glob("*.prm")):
        text = file.read_text(encoding="utf-8")
        first = text.partition("\n")[0]
        if not first.startswith(FIRST_LINE):
            raise SystemExit(f"{file}: its first line must be '{FIRST_LINE}SECTION, SECTION...'")
        for title in first.removeprefix(FIRST_LINE).split(", "):
            if title in found:
                raise SystemExit(f"{file}: {title} is shown by {found[title][0]} already")
            found[title] = file.name, part(text, title)
            if not found[title][1]:
                raise SystemExit(f"{file}: it has no section {title}")
    return found


def page(heading, text, inner, shown):
    name, lines = shown
    inner_headings = re.sub(r"(?m)^####", "##", text)
    parts = [f"# {heading}\n", inner_headings.strip("\n") + "\n"]
    if inner:
        parts.append("\n".join(f"- [{other}]({file_of(f'{heading} / {other}')})" for other in inner) + "\n")
    example = "\n".join(lines)
    parts.append(f"## Example\n\n```prm\n{example}\n```\n\nFrom [{name}](examples/{name}), which can be run.\n")
    parts.append("[All sections](README.md)\n")
    return "\n".join(parts)


def line_of(heading, text):
    """A line of the index: the name of the section and its first sentence."""
    outer, _, inner = heading.partition(" / ")
    sentence = re.match(r"\n*(?![|#])(.*?[.:;])(?: |\n|$)", text)
    words = sentence.group(1).rstrip(".:;") + "." if sentence else ""
    return f"{'  ' if inner else ''}- [{inner or outer}]({file_of(heading)}): {words}"


def index(head, texts):
    """The text before the sections, with a line for each section instead of the printed list of them."""
    before, _, after = head.partition("\nSections:\n")
    own_keys = after[after.index("| Key |"):]
    listed = "\n".join(line_of(heading, text) for heading, text in texts.items())
    return f"{before.rstrip()}\n\n## Sections\n\n{listed}\n\n## Outside all sections\n\n{own_keys.rstrip()}\n"


def pages(printed, folder):
    head, texts = sections(printed)
    shown = examples(folder)
    titles = {title_of(heading) for heading in texts}
    wrong = [f"no example for {title}" for title in sorted(titles - shown.keys())]
    wrong += [f"an example for {title}, which is no section" for title in sorted(shown.keys() - titles)]
    if wrong:
        raise SystemExit("\n".join(wrong))
    made = {INDEX: index(head, texts)}
    for heading, text in texts.items():
        inner = [other.partition(" / ")[2] for other in texts if other.startswith(heading + " / ")]
        made[file_of(heading)] = page(heading, text, inner, shown[title_of(heading)])
    return made


def print_declarations(program):
    command = [*program, "--print-parameters", "markdown"]
    return with_letters(subprocess.run(command, check=True, capture_output=True, encoding="utf-8").stdout)


def differences(made, folder):
    """Between the pages and those of a folder; empty where they are the same."""
    kept = {file.name: file.read_text(encoding="utf-8") for file in folder.glob("*.md")}
    lines = []
    for name in sorted(made.keys() | kept.keys()):
        lines += difflib.unified_diff(kept.get(name, "").splitlines(), made.get(name, "").splitlines(),
                                      f"{folder / name}", "made of what the program prints", lineterm="")
    return lines


def write(made, folder):
    for file in folder.glob("*.md"):
        if file.name not in made:
            file.unlink()
    for name, text in made.items():
        (folder / name).write_text(text, encoding="utf-8")


SAMPLE = """# Parameters

Numbers.

Sections:

- [Body NAME](#body-name)

| Key |
|---|
| `Title` |

## Body NAME

A body. It moves.

| Key |
|---|
| `Type` |

### Body NAME / Point NAME

A node: named.

#### Body NAME / Point NAME / Inner

Deep.
"""
EXAMPLE = """# Example for: Body, Body / Point
subsection Body beam
  set Type = beam # of steel
  subsection Support foot
    set At = start
  end
  subsection Point tip
    set At = end
  end
end
"""


def self_test():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "examples").mkdir()
        (folder / "examples" / "beam.prm").write_text(EXAMPLE, encoding="utf-8")
        made = pages(SAMPLE, folder)
        missing = differences(made, folder)
        (folder / "old.md").write_text("Old\n", encoding="utf-8")
        write(made, folder)
        fresh = differences(made, folder)
        (folder / "body.md").write_text("Old\n", encoding="utf-8")
        stale = differences(made, folder)
    point = made["body-point.md"]
    row = with_letters("| `Mu` | a \\| b | 1 | | \\mu_s, nu_b, k_\\theta | mu |")
    good = [row == "| `Mu` | a \\| b | 1 | | μ_s, ν_b, k_θ | mu |", sorted(made) == ["README.md", "body-point.md", "body.md"], missing, not fresh, stale,
            "## Outside all sections\n\n| Key |\n|---|\n| `Title` |\n" in made[INDEX],
            "- [Body NAME](body.md): A body.\n  - [Point NAME](body-point.md): A node.\n" in made[INDEX],
            "\nsubsection Body beam\n  set Type = beam # of steel\n  subsection Point tip\n    set At = end\n  end\nend\n"
            in point, "\n## Body NAME / Point NAME / Inner\n" in point]
    print("pages are made, and stale ones found" if all(good) else f"self-test: {good}")
    return 0 if all(good) else 1


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    if len(sys.argv) < 3 or sys.argv[3:] not in ([], ["--check"]):
        sys.exit(__doc__)
    folder = Path(sys.argv[2]) / FOLDER
    made = pages(print_declarations([sys.argv[1]]), folder)
    if not sys.argv[3:]:
        write(made, folder)
        return 0
    lines = differences(made, folder)
    if lines:
        lines += ["", "docs/parameters is out of date; refresh it by",
                  f"  scripts/parameter_pages.py {sys.argv[1]} {sys.argv[2]}"]
    print("\n".join(lines) or "up to date")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
