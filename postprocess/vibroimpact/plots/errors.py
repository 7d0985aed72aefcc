"""What goes wrong with results; apart from the modules that need NumPy."""


class ResultError(Exception):
    """The results cannot be read or do not hold what was asked for; the message is complete."""
