"""Tables of studies: how a figure depends on the means by which it was computed.

A study runs the shipped files as the checks do, but its table has columns of its own and nothing
in it decides about an exit code.
"""
import re
import sys

from page_tables import markdown, table_in, write_into
from systems import Table, arguments_of_checks

NUMBER = re.compile(r"[-+]?\d+(?:\.(\d+))?(?:e[-+]?\d+)?")


class Study(Table):
    """Rows of any cells under a given head."""

    def __init__(self, script, *head, **more_options):
        parser = arguments_of_checks()
        for name, choices in more_options.items():
            parser.add_argument("--" + name, choices=choices, required=True)
        super().__init__(script, parser.parse_args())
        self.head = head

    def row(self, *cells):
        self.rows.append([cell if isinstance(cell, str) else f"{cell:.7g}" for cell in cells])

    def finish(self):
        text = markdown([self.head, *self.rows])
        print(text)
        if self.arguments.page:
            write_into(self.arguments.page, self.script, text)
        if self.arguments.compare:
            stale = self.stale_rows()
            print("\n".join(stale))
            sys.exit(1 if stale else 0)

    def stale_rows(self):
        """Lines of the page to compare that are not what was computed now."""
        shown_now = table_in(self.arguments.compare, self.script)
        lines = [[cell.strip() for cell in row] for row in self.rows]
        if len(shown_now) != len(lines):
            return [f"{self.arguments.compare}: {len(shown_now)} instead of {len(lines)} lines"]
        return [f"{self.arguments.compare}: {old} instead of {new}"
                for old, new in zip(shown_now, lines)
                if not all(map(same_cell, old, new))]


def same_cell(old, new):
    """The same words, and numbers to a hundredth or to two units of their last digit."""
    pairs = zip(NUMBER.finditer(old), NUMBER.finditer(new))
    return (NUMBER.sub("#", old) == NUMBER.sub("#", new)
            and all(abs(float(a[0]) - float(b[0])) <= max(0.01 * abs(float(b[0])), last_unit(b))
                    for a, b in pairs))


def last_unit(number):
    """Two units of the last decimal; nothing for whole numbers and powers of ten."""
    return 2 * 10.0**-len(number[1]) if number[1] and "e" not in number[0] else 0
