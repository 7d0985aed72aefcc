"""Tables of studies: how a figure depends on the means by which it was computed.

A study runs the shipped files as the checks do, but its table has columns of its own and nothing
in it decides about an exit code.
"""
from page_tables import markdown, write_into
from systems import Table, arguments_of_checks


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
