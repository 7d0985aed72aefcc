#!/usr/bin/python3
"""Nonlinear modes of a cantilever by other means: its own beam elements; with the cubic spring a harmonic balance that converges to rounding,
on the rigid stop the closed form of motions with one impact in a period.
"""
import numpy
import scipy.linalg
import scipy.optimize

from systems import Table

LENGTH, SIDE, MODULUS, DENSITY, ELEMENTS = 0.7, 0.014, 205e9, 7800.0, 20
CUBIC, CLEARANCE = 6e9, 1e-3
HARMONICS = numpy.arange(1, 30, 2)
SAMPLES = 256


def beam_modes(modes):
    """Angular frequencies and tip displacements of the lowest modes, of unit mass: cubic elements, consistent mass."""
    length = LENGTH / ELEMENTS
    bending, line = MODULUS * SIDE**4 / 12, DENSITY * SIDE**2
    stiffness = bending / length**3 * numpy.array([[12, 6 * length, -12, 6 * length], [6 * length, 4 * length**2, -6 * length, 2 * length**2],
                                                   [-12, -6 * length, 12, -6 * length], [6 * length, 2 * length**2, -6 * length, 4 * length**2]])
    mass = line * length / 420 * numpy.array([[156, 22 * length, 54, -13 * length], [22 * length, 4 * length**2, 13 * length, -3 * length**2],
                                              [54, 13 * length, 156, -22 * length], [-13 * length, -3 * length**2, -22 * length, 4 * length**2]])
    whole = numpy.zeros((2, 2 * ELEMENTS + 2, 2 * ELEMENTS + 2))
    for element in range(ELEMENTS):
        at = slice(2 * element, 2 * element + 4)
        whole[0, at, at] += stiffness
        whole[1, at, at] += mass
    # The lowest frequencies belong to the largest 1 / omega^2, which keep all digits.
    inverse, shapes = scipy.linalg.eigh(whole[1, 2:, 2:], whole[0, 2:, 2:])
    frequencies = 1 / numpy.sqrt(inverse[:-modes - 1:-1])
    return frequencies, frequencies * shapes[-2, :-modes - 1:-1]


class CubicBackbone:
    """Tip displacement sum of u_h cos(h w t): u_h = -G_h F_h, F of the spring, G of the beam."""

    def __init__(self, frequencies, tip):
        self.frequencies, self.tip = frequencies, tip
        angle = 2 * numpy.pi * numpy.arange(SAMPLES) / SAMPLES
        self.cosines = numpy.cos(numpy.outer(angle, HARMONICS))
        self.last = numpy.zeros(HARMONICS.size + 1)  # series over the linear amplitude, frequency over the linear one
        self.last[[0, -1]] = 1, 1 + 1e-4

    def force(self, series):
        return 2 / SAMPLES * self.cosines.T @ (CUBIC * (self.cosines @ series) ** 3)

    def coordinates(self, series, frequency):
        """Of the modes; that of the first one makes up the displacement of the tip, since it is near its resonance."""
        found = -self.tip[:, None] * self.force(series) / (self.frequencies[:, None] ** 2 - (HARMONICS * frequency) ** 2)
        found[0] = (series - self.tip[1:] @ found[1:]) / self.tip[0]
        return found

    def energy(self, series, frequency):
        start = self.coordinates(series, frequency).sum(axis=1)
        return 0.5 * ((self.frequencies * start) ** 2).sum() + CUBIC * (self.tip @ start) ** 4 / 4

    def at(self, energy):
        """Frequency [rad/s] and largest displacement of the tip at an energy, from the last one on."""
        amplitude = self.tip[0] * numpy.sqrt(2 * energy) / self.frequencies[0]
        frequency = self.frequencies[0]

        def residual(unknown):
            series, w = unknown[:-1] * amplitude, unknown[-1] * frequency
            # In parts of the modal stiffness at the tip, since the gain of the first harmonic has no bound.
            gain = ((self.tip**2)[:, None] / (self.frequencies[:, None] ** 2 - (HARMONICS * w) ** 2)).sum(axis=0)
            left = (series / gain + self.force(series)) / (abs(amplitude) * (frequency / self.tip[0]) ** 2)
            return numpy.append(left, self.energy(series, w) / energy - 1)

        self.last = scipy.optimize.root(residual, self.last, tol=1e-13).x
        series, w = self.last[:-1] * amplitude, self.last[-1] * frequency
        return w, self.largest(series)

    def largest(self, series):
        """Of the displacement over a period."""
        def shortfall(angle):
            return -abs(series @ numpy.cos(HARMONICS * angle))

        best = numpy.argmax(abs(self.cosines @ series)) * 2 * numpy.pi / SAMPLES
        return -scipy.optimize.minimize_scalar(shortfall, bounds=(best - 0.03, best + 0.03), method="bounded", options={"xatol": 1e-10}).fun


def impact_energy(frequency, frequencies, tip):
    """Of the motion with one impact in a period on the rigid stop."""
    half = numpy.pi / frequency
    impulse = 2 * CLEARANCE / (tip**2 / (frequencies * numpy.tan(frequencies * half))).sum()
    amplitudes = tip * impulse / (2 * frequencies * numpy.sin(frequencies * half))
    return 0.5 * ((amplitudes * frequencies) ** 2).sum(), abs(impulse) * (tip**2).sum() / 2


SHOWN = (1e-4, 5e-4, 5e-3)  # energies [J]
TIP = "point/beam.tip/displacement_y/largest"


def check_backbone(table, mode, frequencies, tip):
    """All points by the harmonic balance, and some with their values."""
    energies, found, amplitudes = (mode[name][:] for name in ("energy", "frequency", TIP))
    balance = CubicBackbone(frequencies, tip)
    reference = numpy.array([balance.at(energy) for energy in energies])
    table.add_curve("cubic spring: frequency by energy, relative", 2 * numpy.pi * found / reference[:, 0] - 1, 1e-10)
    table.add_curve("tip displacement, relative", amplitudes / reference[:, 1] - 1, 1e-10)
    for energy in SHOWN:
        near = numpy.argmin(abs(energies - energy))
        frequency, amplitude = reference[near]
        table.add(f"{1e3 * energies[near]:.4g} mJ: frequency [Hz]", frequency / (2 * numpy.pi), found[near], 1e-10)
        table.add("tip displacement [mm]", 1e3 * amplitude, 1e3 * amplitudes[near], 1e-10)
    fold = mode["special/kind"][:] == 13
    energy, frequency = (mode["special/" + name][:][fold][0] for name in ("energy", "frequency"))
    balance.at(energy)
    top = scipy.optimize.minimize_scalar(lambda change: -balance.at(energy * (1 + change))[0], bounds=(-0.01, 0.01), method="bounded",
                                         options={"xatol": 1e-7})
    table.add("internal resonance: largest frequency [Hz]", -top.fun / (2 * numpy.pi), frequency, 1e-10)
    table.add("its energy [mJ]", 1e3 * energy * (1 + top.x), 1e3 * energy, 1e-6)


def check_impacts(table, mode, frequencies, tip):
    """Motions with one impact in a period, from the grazing energy on."""
    energies, found, counts = (mode[key][:] for key in ("energy", "frequency", "contact/stop/impacts"))
    one = counts == 1
    known = numpy.array([impact_energy(2 * numpy.pi * frequency, frequencies, tip)[0] if single else numpy.nan
                         for frequency, single in zip(found, one)])
    table.add_curve("rigid stop: energy of motions with one impact, relative", energies / known - 1, 1e-9)
    grazing = mode["special/energy"][:][mode["special/kind"][:] == 6][0]
    table.add("grazing energy [mJ]", 1e3 * (frequencies[0] * CLEARANCE / tip[0]) ** 2 / 2, 1e3 * grazing, 1e-10)


def check(table):
    results = table.run("nonlinear-modes.prm", "shipped")
    check_backbone(table, results["analysis/backbone"], *beam_modes(3))
    check_impacts(table, results["analysis/impacts"], *beam_modes(2))
    table.add("damping ratio at 1 uJ", 0.01, results["analysis/resonance/damping_ratio"][0], 1e-3)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
