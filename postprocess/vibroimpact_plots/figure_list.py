"""Which module draws which type of analysis. A new type is one module and one line here.

A module offers figures(results, analysis), which yields pairs of a name and a figure.
"""

from . import identify, modal, stepped_sweep, transient

FIGURES = {
    "modal": modal.figures,
    "transient": transient.figures,
    "identify": identify.figures,
    "stepped sweep": stepped_sweep.figures,
}
