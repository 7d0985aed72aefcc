"""Which modules draw figures. A new kind of figure is one module and one line here.

A module offers figures(results, analysis), which looks at what an analysis holds and yields, for
each figure that fits, its name and a function without arguments that draws it.
"""

from . import (
    basins,
    bifurcation,
    branches,
    campbell,
    chosen_figures,
    circular_gaps,
    cycles,
    derivatives,
    derived_curves,
    fits,
    friction,
    fronts,
    histories,
    identify,
    isolator,
    loci,
    maps,
    modal,
    portraits,
    relative_motion,
    response_curves,
    searches,
    shares,
    spectra,
    time_frequency,
    transient,
)

KINDS = [modal, transient, identify, response_curves, bifurcation, histories, cycles, friction, circular_gaps,
         portraits, relative_motion, spectra, time_frequency, maps, derivatives, derived_curves]
# Analyses whose fields are of their own kind.
OWN = {**{name: [branches] for name in branches.TYPES}, loci.TYPE: [loci],
       searches.TYPE: [searches, derived_curves],
       fits.TYPE: [fits, derived_curves],
       fronts.TYPE: [fronts], shares.TYPE: [shares],
       isolator.TYPE: [isolator],
       campbell.TYPE: [campbell],
       **{name: [basins] for name in basins.TYPES}}


def figures(results, analysis):
    """Names and functions of all figures of an analysis."""
    kinds = OWN.get(analysis.type, KINDS)
    for kind in kinds:
        yield from kind.figures(results, analysis)
    yield from chosen_figures.figures(results, analysis)
