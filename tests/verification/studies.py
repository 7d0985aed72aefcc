"""Tables of studies: how a figure depends on the means by which it was computed.

A study runs the shipped files as the checks do, but its table has columns of its own and nothing
in it decides about an exit code.
"""
import argparse
import pathlib

from systems import BEGIN, END, Table


class Study(Table):
    """Rows of any cells under a given head."""

    def __init__(self, script, *head, **more_options):
        parser = argparse.ArgumentParser()
        parser.add_argument("program", help="the vibroimpact program")
        parser.add_argument("source", type=pathlib.Path, help="folder of the source")
        parser.add_argument("--page", type=pathlib.Path, help="page that takes up the table")
        parser.add_argument("--keep", type=pathlib.Path, help="folder that keeps the results")
        for name, choices in more_options.items():
            parser.add_argument("--" + name, choices=choices, required=True)
        self.arguments = parser.parse_args()
        self.arguments.ranks = 1
        self.script = pathlib.Path(script).name
        self.head, self.rows, self.failed = head, [], 0

    def row(self, *cells):
        self.rows.append([cell if isinstance(cell, str) else f"{cell:.7g}" for cell in cells])

    def markdown(self):
        lines = [self.head, ["---"] * len(self.head), *self.rows]
        return "".join("| " + " | ".join(line) + " |\n" for line in lines)

    def finish(self):
        text = self.markdown()
        print(text)
        if self.arguments.page:
            page = self.arguments.page.read_text(encoding="utf-8")
            begin = BEGIN.format(self.script)
            first = page.index(begin) + len(begin)
            last = page.index(END, first)
            self.arguments.page.write_text(page[:first] + "\n" + text + page[last:],
                                           encoding="utf-8")
