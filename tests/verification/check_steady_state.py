#!/usr/bin/python3
"""Stepped sweeps with Newton's method, at once and where the transient takes long, beside the same that
wait for it: which branch they follow, how near their values are, and how many periods they take.

usage: check_steady_state.py PROGRAM SOURCE [--all] [--page FILE] [--keep FOLDER] [--ranks N]

The mass between two bumpers, each pair of gap and stiffness forward and backward; the transient
settles to 1e-9. --all: 84 lines of 240 points at a damping of 0.1 and 18 of 150 at 0.02; a few
of them otherwise.
"""
import itertools

import numpy

from systems import Table, arguments_of_checks

EXCURSION = "point/oscillator.mass/displacement_x/peak_to_peak"
SAME = 1e-6
# damping: gaps, stiffnesses, frequencies, largest share of the periods of the transient
ALL = {0.1: ((0, 0.0657506, 0.1989975, 0.3, 0.4, 0.55, 0.7), (0.1, 1, 5, 10, 50, 100), 240, 0.5),
       0.02: ((0.0657506, 0.4, 0.7), (0.1, 1, 10), 150, 0.12)}
FEW = {0.1: ((0.0657506, 0.4), (1, 10, 100), 80, 0.5), 0.02: ((0.4,), (1, 10), 60, 0.12)}


def sweeps(damping, method):
    """Arrays of all sweeps, over pairs and the points in the order in which they were computed."""
    gaps, stiffnesses, points, _ = cases[damping]
    pairs = list(itertools.product(gaps, stiffnesses))
    sweep = "Analysis curve/Stepped sweep"
    cases_of_grid = "; ".join(f"{gap}, {stiffness}" for gap, stiffness in pairs)
    results = table.run(
        "bumpers.prm", f"{method}-{damping}", "Analyses=gap_40", f"Variables/xi={damping}",
        "Analysis gap_40/With=",
        f"Analysis gap_40/Parameter grid/Cases=Variables/delta0, Variables/lambda; {cases_of_grid}",
        f"{sweep}/First frequency=0.25 rad/s", f"{sweep}/Last frequency=5 rad/s",
        f"{sweep}/Spacing=logarithmic", f"{sweep}/Points={points}",
        f"{sweep}/Settling cycles=3000", f"{sweep}/Steadiness tolerance=1e-9",
        f"{sweep}/Settling method={method}")["analysis/gap_40"]
    return {name: numpy.concatenate((results[name][:, :, 0], results[name][:, :, 1][:, ::-1]), axis=1)
            for name in (EXCURSION, "steady", "settling_cycles", "period_multiple")}


def after(points_before):
    """Points behind such points."""
    return numpy.concatenate((numpy.ones((len(points_before), 1), bool),
                              points_before[:, :-1]), axis=1)


arguments = arguments_of_checks()
arguments.add_argument("--all", action="store_true", help="all lines")
table = Table(__file__, arguments.parse_args())
cases = ALL if table.arguments.all else FEW
for damping, (gaps, stiffnesses, points, share) in cases.items():
    waited = sweeps(damping, "transient")
    for method, least in (("Newton", share), ("automatic", 1)):
        found = sweeps(damping, method)
        settled = [sweep["steady"] == 1 for sweep in (waited, found)]
        both = settled[0] & settled[1]
        differences = numpy.abs(found[EXCURSION] / waited[EXCURSION] - 1)
        same = both & (differences <= SAME)
        # Behind an aperiodic motion, or one of several periods, the two begin with different states.
        alike = after(same & (found["period_multiple"] == 1))
        lines = (f"{2 * len(gaps) * len(stiffnesses)} lines of {points} points, damping {damping}, "
                 f"{method}")
        table.add_whole(f"{lines}: points at which they part", [0],
                        [int((alike & both & ~same).sum())])
        table.add_whole(f"{lines}: points that only waiting settles", [0],
                        [int((alike & settled[0] & ~settled[1]).sum())])
        table.add(f"{lines}: largest difference of an excursion", 0, differences[same].max(), 1e-7,
                  absolute=True)
        # By waiting a slow approach may look like a repetition after several periods.
        multiples = waited["period_multiple"][same] % found["period_multiple"][same]
        table.add_whole(f"{lines}: points whose multiple of waiting is none of its own", [0],
                        [int(multiples.sum())])
        periods = [float(sweep["settling_cycles"][both].mean()) for sweep in (waited, found)]
        table.add_whole(f"{lines}: fewer than {least} times the periods", [1],
                        [int(periods[1] < least * periods[0])])
        print(f"{lines}: {periods[0]:.1f} periods by waiting, {periods[1]:.1f}; "
              f"{(~settled[0]).sum()} and {(~settled[1]).sum()} points not steady, "
              f"{(both & ~same).sum()} different")
table.finish()
