"""Tables in pages: short ones stand there whole, long ones as a few rows and a link to all of them as CSV."""
import csv
import re

BEGIN, END = "<!-- table made by {} -->", "<!-- end of table -->"
LONGEST = 20  # rows of a table that stands whole
SHOWN = 8  # rows of a longer one


def markdown(lines):
    """A table whose first line is its head."""
    lines = [lines[0], ("---",) * len(lines[0]), *lines[1:]]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def write_into(path, name, text):
    """Puts a table between the marker lines of a page that name what makes it."""
    page = path.read_text(encoding="utf-8")
    begin = BEGIN.format(name)
    first = page.index(begin) + len(begin)
    text = shortened(path, name, text)
    path.write_text(page[:first] + "\n" + text + page[page.index(END, first):], encoding="utf-8")


def shortened(path, name, text):
    """The text for the page; a long table goes into tables/ beside it."""
    lines = text.splitlines()
    rows = [cells(line) for line in lines if line.startswith("|")]
    if len(rows) - 2 <= LONGEST:
        return text
    head, body = rows[0], rows[2:]
    file = path.parent / "tables" / f"{path.stem}-{slug(name)}.csv"
    file.parent.mkdir(exist_ok=True)
    with open(file, "w", encoding="utf-8", newline="") as stream:
        csv.writer(stream, lineterminator="\n").writerows([head, *body])
    rest = [line for line in lines if not line.startswith("|")]
    link = f"\n{len(body)} rows in all: [tables/{file.name}](tables/{file.name})\n"
    return markdown([head, *telling(head, body)]) + link + "".join(f"{line}\n" for line in rest)


def cells(line):
    """Between blanks: |z| is no two cells."""
    return tuple(cell.strip() for cell in line[1:].removesuffix("|").split(" | "))


def slug(name):
    return re.sub(r"[^a-z0-9]+", "-", name.lower().replace(".py", "")).strip("-")


def telling(head, body):
    """What is beyond a tolerance, then rows with a number of the paper, then the first ones."""
    paper = head.index("paper") if "paper" in head else None
    beyond = [row for row in body if any("**" in cell for cell in row)]
    printed = [row for row in body if paper is not None and row[paper]]
    chosen = list(dict.fromkeys([*beyond, *printed, *body]))[:max(SHOWN, len(beyond))]
    return [row for row in body if row in chosen]
