"""The solver vibroimpact from Python: run it, open what it wrote, draw its figures.

    import vibroimpact

    results = vibroimpact.run("beams.prm", set={"Contact/heads/Clearance": "7 mm"}, ranks=2)
    force = results["release"]["contact/heads/impact/peak_force"]  # an xarray.DataArray in SI
    results.summary["analysis.release.contact.heads.impacts"]    # Quantity(value=17.0, unit='1')
    vibroimpact.plot(results, figure="release-*")

There is no compiled part: `run` starts the program, `open` reads results.h5 and summary.json, `plot` is
vibroimpact-plot. What the program says of a wrong input is the message of an InputError.
"""

from .drawing import PlotError, plot
from .folder import Quantity, ResultFolder
from .folder import open_folder as open  # pylint: disable=redefined-builtin
from .program import (InputError, PointsFailed, ProgramError, ProgramNotFound, ProgramWarning,
                      RunError, Stopped, check, resume, run)

__all__ = ["InputError", "PlotError", "PointsFailed", "ProgramError", "ProgramNotFound",
           "ProgramWarning", "Quantity", "ResultFolder", "RunError", "Stopped", "check", "open",
           "plot", "resume", "run"]
