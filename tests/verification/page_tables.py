"""Tables in pages: short ones stand there whole, of long ones the first rows, and all of them as CSV behind a link."""
import csv
import re

BEGIN, END = "<!-- table made by {} -->", "<!-- end of table -->"
LONGEST = 20  # rows of a table that stands whole
SHOWN = 8  # first rows of a longer one


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


def table_in(path, name):
    """The cells of the table that a page has from a script, line by line, without its head; of a long one
    all lines of its CSV, which those on the page must be among."""
    page = path.read_text(encoding="utf-8")
    begin = BEGIN.format(name)
    first = page.index(begin) + len(begin)
    lines = [line for line in page[first:page.index(END, first)].splitlines() if line.startswith("|")]
    shown = [cells(line) for line in lines[2:]]
    file = path.parent / "tables" / f"{path.stem}-{slug(name)}.csv"
    if not file.exists():
        return shown
    with open(file, encoding="utf-8", newline="") as stream:
        rows = [tuple(row) for row in csv.reader(stream)][1:]
    foreign = [row for row in shown if row not in rows]
    if foreign:
        raise ValueError(f"{path} shows what {file.name} does not have: {foreign[0]}")
    return rows


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
    shown = shown_rows(body)
    link = f"\n{len(body) - len(shown)} more of {len(body)} rows: [tables/{file.name}](tables/{file.name})\n"
    return markdown([head, *shown]) + link + "".join(f"{line}\n" for line in rest)


def cells(line):
    """Between blanks: |z| is no two cells."""
    return tuple(cell.strip() for cell in line[1:].removesuffix("|").split(" | "))


def slug(name):
    return re.sub(r"[^a-z0-9]+", "-", name.lower().replace(".py", "")).strip("-")


def shown_rows(body):
    """The first rows, and those behind them that are beyond a tolerance."""
    return body[:SHOWN] + [row for row in body[SHOWN:] if any("**" in cell for cell in row)]
