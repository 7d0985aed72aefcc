"""Which modules draw figures. A new kind of figure is one module and one line here.

A module offers figures(results, analysis), which looks at what an analysis holds and yields, for
each figure that fits, its name and a function without arguments that draws it.
"""

from . import (
    bifurcation,
    cycles,
    derived_curves,
    histories,
    identify,
    maps,
    modal,
    portraits,
    response_curves,
    spectra,
    time_frequency,
    transient,
)

KINDS = [modal, transient, identify, response_curves, bifurcation, histories, cycles, portraits,
         spectra, time_frequency, maps, derived_curves]


def figures(results, analysis):
    """Names and functions of all figures of an analysis."""
    for kind in KINDS:
        yield from kind.figures(results, analysis)
