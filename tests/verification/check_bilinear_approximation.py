#!/usr/bin/python3
"""The bilinear amplitude approximation against its eight equations solved as they are written, against
periodic orbits and against integration over the sweep."""
import h5py
import numpy
from scipy.optimize import root

from systems import Table, nearest

FILE = "bilinear-approximation.prm"
MASS, DAMPING, STIFFNESS = (1.80, 2.46), (31.14, 19.13), (430.00, 417.78)
# By samples of the motion, which miss the extreme values by parts of 1e-5.
AT_2_4 = {0: (13.3965, 16.0744, 0.2528), 2: (12.8698, 16.4207, 0.1853)}
AMPLITUDE = "point/{}.mass/absolute_displacement_x/peak_to_peak"
BODIES = ("first", "second")
GAPS = ("gap 0", "gap 2 mm", "gap 11 mm, base 11 mm")


class Oscillator:
    """m x'' + c (x' - x0') + k (x - x0) + pull = 0 on a base x0 = X sin(w t + alpha), in closed form."""

    def __init__(self, mass, damping, stiffness, pull, base, angular_frequency):
        self.decay = damping / (2 * mass)
        self.rate = numpy.sqrt(stiffness / mass - self.decay ** 2)
        spring = stiffness + 1j * damping * angular_frequency
        self.response = base * spring / (spring - mass * angular_frequency ** 2)
        self.rest, self.angular_frequency = -pull / stiffness, angular_frequency

    def motion(self, sine, cosine, since, phase):
        """Displacement, velocity and acceleration a time `since` the start of the phase."""
        free = numpy.exp((-self.decay + 1j * self.rate) * since) * (cosine - 1j * sine)
        steady = -1j * self.response * numpy.exp(1j * phase)
        return [float((free * (-self.decay + 1j * self.rate) ** n
                       + steady * (1j * self.angular_frequency) ** n).real)
                + (self.rest if n == 0 else 0) for n in range(3)]


class Equations:
    """Eight unknowns: two coefficients of each open oscillator, two of the tied one, alpha, T_s."""

    def __init__(self, gap, frequency, base=10.0):
        self.gap, self.w = gap, 2 * numpy.pi * frequency
        self.open = [Oscillator(*values, 0, base, self.w)
                     for values in zip(MASS, DAMPING, STIFFNESS)]
        # By the first displacement: the second is less by the gap.
        self.tied = Oscillator(sum(MASS), sum(DAMPING), sum(STIFFNESS), -STIFFNESS[1] * gap, base,
                               self.w)

    def states(self, unknowns):
        o1, o2, o3, o4, s1, s2, alpha, share = unknowns
        contact, period = share * 2 * numpy.pi / self.w, 2 * numpy.pi / self.w
        opening = alpha + self.w * contact
        return ([self.open[0].motion(o1, o2, 0, opening), self.open[1].motion(o3, o4, 0, opening)],
                [self.open[0].motion(o1, o2, period - contact, alpha),
                 self.open[1].motion(o3, o4, period - contact, alpha)],
                self.tied.motion(s1, s2, 0, alpha), self.tied.motion(s1, s2, contact, opening))

    def __call__(self, unknowns):
        opening, closing, start, end = self.states(unknowns)
        return [self.gap + closing[1][0] - closing[0][0],
                start[0] - closing[0][0],
                (sum(MASS) * start[1] - MASS[0] * closing[0][1] - MASS[1] * closing[1][1]) / self.w,
                opening[0][0] - end[0], opening[1][0] + self.gap - end[0],
                (opening[0][1] - end[1]) / self.w, (opening[1][1] - end[1]) / self.w,
                # No force at opening: the open masses have one acceleration.
                (opening[0][2] - opening[1][2]) / self.w ** 2]

    def path(self, unknowns, points=4000):
        """Both displacements over the period."""
        o1, o2, o3, o4, s1, s2, alpha, share = unknowns
        period = 2 * numpy.pi / self.w
        contact, rows = share * period, []
        for time in numpy.linspace(0, period, points):
            phase = alpha + self.w * time
            if time < contact:
                first = self.tied.motion(s1, s2, time, phase)[0]
                rows.append((first, first - self.gap))
            else:
                rows.append((self.open[0].motion(o1, o2, time - contact, phase)[0],
                             self.open[1].motion(o3, o4, time - contact, phase)[0]))
        return numpy.array(rows)

    def solution(self):
        """From random starts, the one whose masses do not overlap and whose contact pushes."""
        random = numpy.random.default_rng(1)
        for _ in range(2000):
            start = numpy.concatenate([random.normal(0, 10, 6), random.uniform(0, 1, 2) * (6.3, 0.5)])
            found = root(self, start, tol=1e-13)
            unknowns = found.x
            if not found.success or not 1e-4 < unknowns[7] < 1 or numpy.abs(found.fun).max() > 1e-9:
                continue
            rows = self.path(unknowns, 400)
            if (self.gap + rows[:, 1] - rows[:, 0]).min() > -1e-6 and self.pushes(unknowns):
                return unknowns
        raise RuntimeError("no solution of the eight equations was found")

    def pushes(self, unknowns):
        """At closing the open masses would go on towards each other, and the tie holds them."""
        _, closing, start, _ = self.states(unknowns)
        first = MASS[0] * start[2] + DAMPING[0] * start[1] + STIFFNESS[0] * start[0]
        alpha, base = unknowns[6], 10.0
        first -= base * (STIFFNESS[0] * numpy.sin(alpha) + DAMPING[0] * self.w * numpy.cos(alpha))
        return closing[0][1] > closing[1][1] and first < 0


def check(table):
    folder = table.folder_of_run(FILE, "bilinear-approximation",
                                 "Analyses=approximations,instants,orbits,rigid,elastic")
    results = h5py.File(folder / "results.h5")["analysis"]
    equations(table, results["instants"])
    orbits(table, results["approximations"], results["orbits"])
    sweeps(table, results)


def equations(table, instants):
    for case, gap in ((0, 0), (1, 2)):
        system = Equations(gap, 2.4)
        unknowns = system.solution()
        rows = system.path(unknowns)
        for mass, body in enumerate(BODIES):
            value = 500 * instants[AMPLITUDE.format(body)][case, 0]
            table.add(f"A{mass + 1} in mm at 2.4 Hz, gap {gap} mm, eight equations",
                      numpy.ptp(rows[:, mass]) / 2, value, 1e-6)
            table.add(f"A{mass + 1} in mm at 2.4 Hz, gap {gap} mm", AT_2_4[gap][mass], value, 1e-5)
        share = instants["contact/tied/contact_fraction"][case, 0]
        table.add(f"T_s/T at 2.4 Hz, gap {gap} mm, eight equations", unknowns[7], share, 1e-9)
        table.add(f"T_s/T at 2.4 Hz, gap {gap} mm", AT_2_4[gap][2], share, 5e-5,
                  paper=0.4 if gap else None, absolute=True)


def orbits(table, approximation, orbit):
    """The same motions by settling and Newton's method, with their multipliers."""
    frequency = approximation["frequency"][:]
    places = [nearest(frequency, value / (2 * numpy.pi))  # axes of keys are in SI
              for value in orbit["Excitation.table.Frequency"][:]]
    for case in (0, 1):
        for body in BODIES:
            difference = (approximation[AMPLITUDE.format(body)][case][places]
                          / orbit[AMPLITUDE.format(body)][case] - 1)
            table.add(f"amplitude of the {body} mass, {GAPS[case]}, largest relative difference from "
                      f"{len(places)} periodic orbits", 0, numpy.abs(difference).max(), 1e-11,
                      absolute=True)
        largest = numpy.hypot(orbit["multiplier_real"][case], orbit["multiplier_imaginary"][case])
        difference = approximation["largest_multiplier"][case][places] - largest.max(axis=1)
        table.add(f"largest multiplier, {GAPS[case]}, largest difference from these", 0,
                  numpy.abs(difference).max(), 1e-10, absolute=True)


def sweeps(table, results):
    """Beside integration with the same contact and with the contact spring of the paper."""
    approximation, rigid, elastic = (results[name] for name in
                                     ("approximations", "rigid", "elastic"))
    frequency = approximation["frequency"][:]
    for case, name in enumerate(GAPS):
        exists = approximation["status"][case] == 0
        stable = exists & (approximation["stable"][case] == 1)
        # Within the jump of the sweep two motions exist.
        alone = stable & (approximation["admissible_solutions"][case] == 1)
        table.add_whole(f"frequencies with an approximation, of these stable, {name}",
                        (251, 251 if case != 1 else 234), (exists.sum(), stable.sum()))
        for mass, body in enumerate(BODIES):
            value = approximation[AMPLITUDE.format(body)][case]
            difference = value / rigid[AMPLITUDE.format(body)][case, :, 0] - 1
            difference[~alone] = numpy.nan
            table.add_curve(f"A{mass + 1} relative to integration, {name}", difference, 1e-6)
            off = numpy.abs(value / elastic[AMPLITUDE.format(body)][case, :, 0] - 1)
            print(f"A{mass + 1}, {name}: off the contact spring by {off.max():.2g} at "
                  f"{frequency[off.argmax()]:.2f} Hz, median {numpy.median(off):.2g}, at 2.4 Hz "
                  f"{off[nearest(frequency, 2.4)]:.2g}")


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
