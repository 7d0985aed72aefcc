#!/usr/bin/python3
"""What changes when dwell, sweep step, steadiness test and step control of a file are tightened.

Every row is a run of the shipped file with one of them changed; the columns are the largest changes
of the figures that the page of the system reports, in the units of the page.
"""
import math

import numpy

import check_bumpers
from studies import Study
from systems import nearest


def tightened(integration, *sweeps):
    """What was changed, and the overrides that change it. A sweep is its section, dwell, points and
    a tighter steadiness tolerance."""
    def keys(key, value):
        return [f"Analysis/{sweep[0]}/Stepped sweep/{key}={value(sweep)}" for sweep in sweeps]

    return [("dwell doubled", keys("Settling cycles", lambda sweep: 2 * sweep[1])),
            ("step of the sweep halved", keys("Points", lambda sweep: 2 * sweep[2] - 1)),
            ("steadiness test ten times tighter",
             keys("Steadiness tolerance", lambda sweep: sweep[3])),
            ("step control ten times tighter", [f"Integration/Relative tolerance={integration}"])]


def bumpers(study):
    """The points of check_bumpers.py, and the upward curve of one pair of gap and stiffness."""
    def run(name, overrides):
        results = study.run("bumpers.prm", "settling-" + name, "Analyses=points, curve", *overrides)
        points = results["analysis/points"]
        middle = len(points["frequency"]) // 2
        figures = {symbol + ", single points": values[:, middle] for symbol, values in
                   zip(check_bumpers.NAMES, check_bumpers.measures(points))}
        curve = check_bumpers.measures(results["analysis/curve"])[0]
        figures["η_a, curve δ0 0.4, λ 1"] = curve[::(len(curve) - 1) // 159, 0]
        return figures

    return run, tightened("1e-10", ("around", 2000, 51, "1e-9"), ("curve", 400, 160, "1e-7"))


def isolator(study):
    """Both motions at one frequency, and the two jumps."""
    def run(name, overrides):
        response = study.run("isolator-stop.prm", "settling-" + name, "Analyses=response",
                             *overrides)["analysis/response"]
        frequency = response["frequency"][:]
        peak = response["point/isolator.mass/displacement_x/largest"]
        at = nearest(frequency, 1.3)
        ends = [response["jump_" + end][:] for end in ("from", "to")]
        jump = numpy.nanmax((ends[0] + ends[1]) / 2, axis=0)
        return {"large motion at λ = 1.3": peak[at, 0], "small motion at λ = 1.3": peak[at, 1],
                "jump upward": jump[0], "jump downward": jump[1]}

    changes = tightened("1e-11", ("response", 2000, 201, "1e-10"))
    return run, changes + [("bracket of the jumps ten times narrower",
                            ["Analysis/response/Stepped sweep/Jump tolerance=1e-7"])]


def bilinear(study):
    """Amplitudes at 2.4 Hz, and the largest ones over the frequencies that all runs share, in mm."""
    def run(name, overrides):
        gaps = study.run("bilinear-oscillator.prm", "settling-" + name, "Analyses=gaps",
                         *overrides)["analysis/gaps"]
        frequency = gaps["frequency"][:]
        shared = slice(None, None, (len(frequency) - 1) // 250)
        figures = {}
        for number, body in enumerate(("first", "second"), 1):
            path = f"point/{body}.mass/absolute_displacement_x/peak_to_peak"
            amplitude = gaps[path][:][:, shared, 0] * 500
            figures[f"A{number} at 2.4 Hz"] = amplitude[:, nearest(frequency[shared], 2.4)]
            figures[f"largest A{number}"] = amplitude.max(axis=1)
        return figures

    return run, tightened("1e-11", ("response", 600, 251, "1e-8"))


def main():
    systems = {"bumpers": bumpers, "isolator": isolator, "bilinear": bilinear}
    study = Study(__file__, system=list(systems))
    run, changes = systems[study.arguments.system](study)
    shipped = run("shipped", [])
    study.head = ("change", *shipped)
    for number, (change, overrides) in enumerate(changes):
        changed = run(str(number), overrides)
        study.row(change, *(f"{numpy.max(numpy.abs(changed[name] - shipped[name])):.1e}"
                            for name in shipped))
    study.finish()


if __name__ == "__main__":
    main()
