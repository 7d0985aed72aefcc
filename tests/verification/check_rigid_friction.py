#!/usr/bin/python3
"""Rigid sides with friction: a thrown block and a shaken one against closed forms and values of code_aster, and a drifting one
against phases of slip and stick whose changes are located by bisection.
"""
import numpy
import scipy.optimize

from systems import Table

# Acceleration of the table: work rate between 4 and 12 s, closed, and as printed by code_aster (V5.01.104).
SHAKEN = [(15, 15.26709959, 15.2671), (1.5, 0.4090624510, 0.409062), (1.01, 2.261641213e-4, 2.26164e-4), (0.99, 0, 0)]


def thrown(times):
    """Place of the block: flights between impacts that each take mu (1 + e) of the approach speed, then slip to rest."""
    mu, e, g, speed, height, mass = 0.2, 0.6, 9.81, 8, 0.5, 2.5
    start, place, approach = 0, 0, numpy.sqrt(2 * g * height)
    flight = approach / g
    legs = []
    while flight > 1e-13:
        legs.append((start, place, speed, 0))
        start, place = start + flight, place + speed * flight
        speed -= mu * (1 + e) * approach
        approach, flight = e * approach, 2 * e * approach / g
    stop = start + speed / (mu * g)
    legs += [(start, place, speed, -mu * g), (stop, place + speed**2 / (2 * mu * g), 0, 0)]
    places = []
    for time in times:
        begin, at, rate, slowing = [leg for leg in legs if leg[0] <= time][-1]
        places.append(at + rate * (time - begin) + slowing * (time - begin) ** 2 / 2)
    return numpy.array(places), stop, mass * 8**2 / 2


def check_throw(table):
    motion = table.run("verification/rigid-friction.prm", "throw", "Analyses=throw")["analysis/throw"]
    time, place = motion["time"][:], motion["point/thrown.block/displacement_x"][:]
    exact, stop, energy = thrown(time)
    table.add_curve("thrown block: displacement", place - exact, 1e-9)
    table.add("thrown block: energy that friction takes", energy, motion["recorded/contact/ground/friction/energy"][()], 1e-10)
    table.add("thrown block: share of the time in stick", 1 - stop / 5,
              motion["recorded/contact/ground/friction/stick_fraction"][()], 1e-9)


def check_shake(table):
    for acceleration, rate, printed in SHAKEN:
        work = []
        for until in (4, 12):
            run = table.run("verification/rigid-friction.prm", f"shake-{acceleration:g}-{until}", "Analyses=shake",
                            f"Variables/a={acceleration} m/s^2", f"Variables/until={until} s")
            work.append(until * run["analysis/shake/recorded/contact/table/friction/work_rate"][()])
        table.add(f"shaken block, {acceleration:g} m/s^2: work rate of 4 to 12 s", rate, (work[1] - work[0]) / 8, 1e-9, printed,
                  absolute=rate == 0)


class Slope:
    """v' = a + b sin w t for each of slip forward (1), backward (-1) and, as what would hold it, stick (0)."""
    w, mu = 10 * numpy.pi, 0.3
    along, across = 9.81 * numpy.array((0.1, 1)) / numpy.hypot(0.1, 1)
    moves, presses = 8 * numpy.array((2, 1)) / numpy.hypot(2, 1)

    def forces(self, sigma):
        return self.along - sigma * self.mu * self.across, -self.moves - sigma * self.mu * self.presses

    def pull(self, time, sigma):
        constant, factor = self.forces(sigma)
        return constant + factor * numpy.sin(self.w * time)

    def rate(self, sigma, start, speed, time):
        constant, factor = self.forces(sigma)
        return speed + constant * (time - start) - factor / self.w * (numpy.cos(self.w * time) - numpy.cos(self.w * start))

    def way(self, sigma, start, speed, time):
        constant, factor = self.forces(sigma)
        since = time - start
        return (speed * since + constant * since**2 / 2
                - factor / self.w * ((numpy.sin(self.w * time) - numpy.sin(self.w * start)) / self.w
                                     - numpy.cos(self.w * start) * since))

    def direction(self, time):
        """Of the slip that begins there; 0: the block sticks."""
        return 1 if self.pull(time, 1) > 0 else -1 if self.pull(time, -1) < 0 else 0

    def end(self, sigma, start, speed):
        """When slip comes to rest, or stick to its limit."""
        step = 1e-4
        if sigma == 0:
            margin = lambda time: min(self.pull(time, -1), -self.pull(time, 1))
        else:
            margin = lambda time: sigma * self.rate(sigma, start, speed, time)
        time = start + step
        while margin(time) > 0:
            time += step
        return scipy.optimize.brentq(margin, time - step if time - step > start else start + 1e-9, time, xtol=1e-15)

    def places(self, times):
        start, place, sigma = 0, 0, self.direction(0)
        places = []
        for time in times:
            while (end := self.end(sigma, start, 0)) <= time:
                place += self.way(sigma, start, 0, end) if sigma else 0
                left, start = sigma, end
                if left:
                    sigma = self.direction(start)
                else:
                    sigma = 1 if -self.pull(start, 1) < self.pull(start, -1) else -1
            places.append(place + (self.way(sigma, start, 0, time) if sigma else 0))
        return numpy.array(places)


def check_drift(table):
    motion = table.run("verification/rigid-friction.prm", "drift", "Analyses=drift")["analysis/drift"]
    time, place = motion["time"][:], motion["point/drifting.block/displacement_x"][:]
    exact = Slope().places(time)
    table.add_curve("drifting block: displacement", place - exact, 1e-10)
    table.add("drifting block: way in a period", exact[-1] - exact[-2], place[-1] - place[-2], 1e-10)


def check(table):
    check_throw(table)
    check_shake(table)
    check_drift(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
