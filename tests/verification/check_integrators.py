#!/usr/bin/python3
"""Every figure of the checks by both integrators: `exact` as the shipped files have it, and adaptive
Runge-Kutta of order 5 throughout, at a tolerance with which its energy balance closes to 1e-12.

The quantities, references and tolerances are those of the check of the system; both integrators must
meet them. Runge-Kutta takes up to a hundred times as long, so that some sweeps are thinned out here,
for both alike. Minutes for each system on an idle machine.

usage: check_integrators.py PROGRAM SOURCE --system NAME [--keep FOLDER] [--ranks N]
"""
import resource
import sys

import numpy

import check_absorber
import check_beams
import check_bilinear
import check_bumpers
import check_electromechanical
import check_isolator
from page_tables import markdown
from systems import Table, arguments_of_checks, shown, signed

HEAD = ("quantity", "reference", "exact", "rk", "exact − reference", "rk − reference",
        "exact − rk")
TIGHT = ("Integration/Method=rk", "Integration/Relative tolerance=1e-12",
         "Integration/Absolute tolerance=1e-17")


class Integrated(Table):
    """The table of a check whose runs all have the same integrator."""

    def __init__(self, arguments, method, *settings):
        super().__init__(__file__, arguments)
        self.method, self.settings = method, settings
        self.seconds = 0

    def folder_of_run(self, file, name, *overrides):
        before = processor_seconds()
        folder = super().folder_of_run(file, f"{name}-{self.method}", *overrides, *self.settings)
        self.seconds += processor_seconds() - before
        return folder


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def isolator(table):
    """The two motions at λ = 1.3, and the response around the folds of each stop; for stops without
    folds the whole curve at fewer frequencies."""
    analyses = table.run("isolator-stop.prm", "isolator", "Analyses=response, motions",
                         *frequencies("response", 1.2, 1.4, 11))["analysis"]
    check_isolator.motions(table, analyses["response"], analyses["motions"])
    for name, stops in check_isolator.STOPS_OF_ANALYSIS.items():
        for stiffness, force, folds in stops:
            first, last = (0.8, 1.8) if folds is None else (folds[1] - 0.02, folds[0] + 0.02)
            run = table.run("isolator-stop.prm", f"{name}-{stiffness}", "Analyses=response",
                            f"Variables/mu={stiffness}", f"Variables/f={force}",
                            *frequencies("response", first, last, 11))
            ends = [run[f"analysis/response/jump_{end}"][:] for end in check_isolator.ENDS]
            check_isolator.jumps(table, ends, f"μ {stiffness}, f {force}", folds)


def frequencies(analysis, first, last, points):
    """Overrides that let a stepped sweep run over fewer frequencies."""
    values = {"First frequency": first, "Last frequency": last, "Points": points}
    return [f"Analysis/{analysis}/Stepped sweep/{key}={value}" for key, value in values.items()]


def bumpers(table):
    """All of the check; the single points are approached in 5 steps from either side, not in 25."""
    sweep = "Analysis/around/Stepped sweep/"
    check_bumpers.points(table, f"{sweep}Points=11")
    check_bumpers.best(table)
    check_bumpers.coexisting(table)
    for gap, stiffness in check_bumpers.CURVES:
        check_bumpers.curve(table, gap, stiffness)


def bilinear(table):
    """All of the check; of the doubled periods the frequencies between which they begin and end."""
    check_bilinear.responses(table)
    check_bilinear.history(table)
    check_bilinear.doublings(table, 0, *frequencies("high", "5.68 Hz", "6 Hz", 65))
    check_bilinear.doublings(table, 2, *frequencies("high", "5.1 Hz", "5.4 Hz", 61))


def electromechanical(table):
    """7 of the 40 clearances; without impacts the frequencies around the peaks."""
    check_electromechanical.clearances(table, grids=((4, 6, 3), (12, 20, 2), (38, 40, 2)))
    check_electromechanical.other_frequency(table)
    check_electromechanical.without_impacts(
        table, grids=((29, 31, 3), (68, 70, 3), (77, 79, 3), (101, 103, 3), (136, 138, 3)))
    check_electromechanical.start_up(table)
    check_electromechanical.time_under_force(table)


SYSTEMS = {"beams": check_beams.check, "isolator": isolator, "bumpers": bumpers,
           "absorber": check_absorber.check, "bilinear": bilinear,
           "electromechanical": electromechanical}


def between(row, other):
    """The difference of two integrators as text, relative to the second unless absolute."""
    if isinstance(row.value, tuple):
        return "same" if row.value == other.value else "different"
    if row.differences is not None:
        difference = numpy.abs(row.differences - other.differences)
        return (f"99 %: {numpy.nanquantile(difference, 0.99):.1e}, "
                f"largest {numpy.nanmax(difference):.1e}")
    difference = row.value - other.value
    if not row.absolute:
        difference /= other.value
    return signed(difference, row.absolute)


def cells(row, other):
    assert row.quantity == other.quantity or row.differences is not None
    return (row.quantity, shown(row.reference, ".10g"), shown(row.value, ".10g"),
            shown(other.value, ".10g"), row.cells()[-1], other.cells()[-1], between(row, other))


def main():
    parser = arguments_of_checks()
    parser.add_argument("--system", choices=SYSTEMS, required=True)
    arguments = parser.parse_args()
    exact, tight = Integrated(arguments, "exact"), Integrated(arguments, "rk", *TIGHT)
    for table in (exact, tight):
        SYSTEMS[arguments.system](table)
    text = markdown([HEAD, *(cells(*rows) for rows in zip(exact.rows, tight.rows, strict=True))])
    text += (f"\nProcessor time of all runs: exact {exact.seconds:.1f} s, rk "
             f"{tight.seconds:.1f} s.\n")
    print(text)
    bad = [row.quantity for table in (exact, tight) for row in table.rows if not row.good()]
    print(f"{len(bad)} of {2 * len(exact.rows)} beyond their tolerances")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
