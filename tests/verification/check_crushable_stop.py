#!/usr/bin/python3
"""A stop that crushes beside an independent integration, and one that comes back along a curve of its own, in closed form.

The reference takes the same motion in pieces between the instants at which the stop is reached, its line of unloading meets
the curve, or the motion turns; each piece by an explicit method of order 8 with tolerances of 1e-13.
"""
import numpy
import scipy.integrate
import scipy.optimize

from systems import Table

MASS, STIFFNESS, DAMPING, FORCE, FREQUENCY = 100.0, 4e5, 250.0, 600.0, 9.5
GAP, UNLOADING = 5e-3, 4e6
LOADING = (numpy.array([0, 1e-3, 6e-3, 20e-3]), numpy.array([0, 2e3, 2.4e3, 5e3]))
PAD = (numpy.array([0, 2e-3, 4e-3, 8e-3]), numpy.array([0, 1e3, 3e3, 9e3]))
PAD_BACK = (numpy.array([0, 3e-3, 8e-3]), numpy.array([0, 0.5e3, 4e3]))


def on_curve(u):
    return numpy.interp(u, *LOADING)


class Crushing:
    """Modes: open; elastic, F = K (u - p); crushing along the curve, F = f(u)."""

    def __init__(self):
        self.residual = 0.0

    def force(self, mode, x):
        u = x - GAP
        return 0.0 if mode == "open" else UNLOADING * (u - self.residual) if mode == "elastic" else on_curve(u)

    def rates(self, mode):
        return lambda t, y: [y[1], (FORCE * numpy.sin(2 * numpy.pi * FREQUENCY * t) - DAMPING * y[1] - STIFFNESS * y[0]
                                    - self.force(mode, y[0])) / MASS]

    def events(self, mode):
        """Each with the mode that follows."""
        reach = lambda t, y: y[0] - GAP - self.residual
        if mode == "open":
            return [(reach, 1, "elastic")]
        if mode == "elastic":
            return [(reach, -1, "open"),
                    (lambda t, y: self.force("elastic", y[0]) - on_curve(y[0] - GAP), 1, "crushing")]
        return [(lambda t, y: y[1], -1, "elastic")]

    def motion(self, times):
        """Displacement and residual penetration at the times; pieces end at points of the curve too."""
        t, y, mode = 0.0, numpy.zeros(2), "open"
        seen = numpy.zeros((2, len(times)))
        while t < times[-1]:
            events = self.events(mode)
            stops = [event for event, _, _ in events]
            for event, (_, direction, _) in zip(stops, events):
                event.terminal, event.direction = True, direction
            corner = None
            if mode == "crushing":
                ahead = LOADING[0][LOADING[0] > y[0] - GAP + 1e-15]
                corner = (lambda t, y, at=ahead[0]: y[0] - GAP - at)
                corner.terminal, corner.direction = True, 1
                stops.append(corner)
            piece = scipy.integrate.solve_ivp(self.rates(mode), (t, times[-1]), y, "DOP853", rtol=1e-13, atol=1e-16,
                                              events=stops, dense_output=True, max_step=5e-3)
            inside = (times >= t) & (times <= piece.t[-1])
            states = piece.sol(times[inside])
            seen[0, inside] = states[0]
            u = states[0] - GAP
            seen[1, inside] = u - on_curve(u) / UNLOADING if mode == "crushing" else self.residual
            t, y = piece.t[-1], piece.y[:, -1].copy()
            mode = self.after(mode, events, piece, y)
        return seen

    def after(self, mode, events, piece, y):
        if mode == "crushing":
            u = y[0] - GAP
            self.residual = u - on_curve(u) / UNLOADING
        for (_, _, following), instants in zip(events, piece.t_events):
            if len(instants):
                # Where an untouched stop is reached the line and the curve meet at once.
                return "crushing" if following == "elastic" and mode == "open" and self.residual == 0 else following
        return mode


def check_crush(table, crush):
    times = crush["recorded/history/history_time"][:]
    displacement, residual = Crushing().motion(times)
    found = crush["recorded/history/point/machine.block/displacement_x"][:]
    left = crush["recorded/history/contact/barrier/internal/residual_penetration"][:]
    table.add_curve("displacement over the largest", abs(found - displacement) / abs(displacement).max(), 1e-10)
    table.add_curve("residual penetration over the last", abs(left - residual) / residual[-1], 1e-10)
    table.add("residual penetration at the end [mm]", 1e3 * residual[-1], 1e3 * left[-1], 1e-12)


def area_between(top):
    """Of one impact that turns at a penetration: under the loading curve, less the line and the curve of unloading."""
    def integral(curve, end):
        knots = numpy.append(curve[0][curve[0] < end], end)
        return numpy.trapezoid(numpy.interp(knots, *curve), knots) if hasattr(numpy, "trapezoid") else numpy.trapz(
            numpy.interp(knots, *curve), knots)

    force = numpy.interp(top, *PAD)
    met = scipy.optimize.brentq(lambda w: force - UNLOADING * (top - w) - numpy.interp(w, *PAD_BACK), 0, top, xtol=1e-16)
    back = numpy.interp(met, *PAD_BACK)
    return integral(PAD, top) - (force + back) / 2 * (top - met) - integral(PAD_BACK, met)


def check_pad(table, pad):
    top = pad["contact/cushion/penetration/maximum"][()]
    impacts = pad["contact/cushion/impacts"][()]
    table.add("pad: energy of an impact, area between the curves [J]", area_between(top),
              pad["contact/cushion/dissipated_energy"][()] / impacts, 1e-10)
    table.add("pad: largest force at that penetration [N]", numpy.interp(top, *PAD),
              pad["contact/cushion/normal_force/maximum"][()], 1e-13)


def check(table):
    results = table.run("crushable-stop.prm", "shipped")
    check_crush(table, results["analysis/crush"])
    check_pad(table, results["analysis/pad"])


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
