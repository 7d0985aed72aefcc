#!/usr/bin/python3
"""A gear pair with backlash by other means: matrix exponentials (by eigenvectors) between the instants at which a flank touches or
separates, a period by Newton's method with differences, the fold as the extreme frequency along the branch, the
exponent of an idling pair from a tangent that is carried along.

With p = r_1 a + r_2 b, the angles a and b of pinion and wheel about z, the teeth press with k p on the driving flank where
p > 0 and with k (p + B) on the other one where p < -B; the dashpot c p' acts all the time.
"""
import numpy
import scipy.optimize

from systems import Table

RADII = numpy.array([0.07, 0.1])
INERTIAS = numpy.array([0.008, 0.03])
SHAFTS = numpy.array([20e3, 40e3])
SHAFT_RATIO, MESH_STIFFNESS, MESH_DAMPING, BACKLASH = 0.03, 350e6, 1800.0, 1e-4
DRIVE, FREE, COAST = 1, 0, -1
STEPS = 64  # of a period, between which flanks are looked at


def generator(mode, frequency, torque, fluctuation):
    """Of the state a, b, a', b', 1, sin, cos."""
    matrix = numpy.zeros((7, 7))
    stiffness = numpy.diag(SHAFTS) + (mode != FREE) * MESH_STIFFNESS * numpy.outer(RADII, RADII)
    damping = numpy.diag(2 * SHAFT_RATIO * numpy.sqrt(SHAFTS * INERTIAS)) + MESH_DAMPING * numpy.outer(RADII, RADII)
    constant = torque * numpy.array([1, RADII[1] / RADII[0]]) - (mode == COAST) * MESH_STIFFNESS * BACKLASH * RADII
    matrix[:2, 2:4] = numpy.eye(2)
    matrix[2:4, :2], matrix[2:4, 2:4] = -stiffness / INERTIAS[:, None], -damping / INERTIAS[:, None]
    matrix[2:4, 4] = constant / INERTIAS
    matrix[2, 5] = fluctuation / INERTIAS[0]
    matrix[5, 6], matrix[6, 5] = frequency, -frequency
    return matrix


def mode_of(pressed):
    return DRIVE if pressed > 0 else COAST if pressed < -BACKLASH else FREE


class Phase:
    """exp(A t) by the eigenvectors of A."""

    def __init__(self, matrix, step):
        self.values, self.vectors = numpy.linalg.eig(matrix)
        self.inverse = numpy.linalg.inv(self.vectors)
        self.pressed = RADII @ self.vectors[:2]
        self.whole = self.map(step)

    def map(self, time):
        return ((self.vectors * numpy.exp(self.values * time)) @ self.inverse).real

    def course(self, state):
        """p over time from a state on."""
        amplitudes = self.pressed * (self.inverse @ state)
        return lambda t: (amplitudes @ numpy.exp(self.values * t)).real


class Pair:
    """The motion at one frequency [rad/s]."""

    def __init__(self, frequency, torque, fluctuation, steps=STEPS):
        self.steps, self.step = steps, 2 * numpy.pi / frequency / steps
        self.phases = {mode: Phase(generator(mode, frequency, torque, fluctuation), self.step) for mode in (DRIVE, FREE, COAST)}

    def change(self, mode, state, limit):
        """The first instant at which the flank of the mode separates, or one touches, and where; none before the limit."""
        borders = {DRIVE: [0.0], FREE: [0.0, -BACKLASH], COAST: [-BACKLASH]}[mode]
        pressed = self.phases[mode].course(state)
        grid = numpy.linspace(0, limit, 5)
        values = [pressed(t) for t in grid]
        for (low, high, first, last) in zip(grid, grid[1:], values, values[1:]):
            for border in borders:
                if (first - border) * (last - border) < 0 and not (low == 0 and abs(first - border) < 1e-16):
                    return scipy.optimize.brentq(lambda t, b=border: pressed(t) - b, low, high, xtol=1e-18, rtol=8.9e-16), border
        return None

    def advance(self, state, mode, tangent):
        """A step; returns state, mode and tangent behind it."""
        left = self.step
        while True:
            found = self.change(mode, state, left) if self.may_change(mode, state) else None
            whole = found is None and left == self.step
            passed = self.phases[mode].whole if whole else self.phases[mode].map(left if found is None else found[0])
            state, tangent = passed @ state, passed[:4, :4] @ tangent
            if found is None:
                return state, mode, tangent
            left -= found[0]
            rate = RADII @ state[2:4]
            mode = (DRIVE if rate > 0 else FREE) if found[1] == 0 else (COAST if rate < 0 else FREE)

    def may_change(self, mode, state):
        """Unless the flanks are farther from the next border than the teeth run in a step."""
        end = self.phases[mode].whole @ state
        reach = self.step * (abs(RADII @ state[2:4]) + abs(RADII @ end[2:4])) + 1e-12
        pressed = RADII @ state[:2]
        return min(abs(pressed), abs(pressed + BACKLASH)) <= reach

    def period(self, start, sampled=None):
        """State after a period at the phase zero of the torque, and the tangent."""
        state, tangent = numpy.concatenate([start, [1, 0, 1]]), numpy.eye(4)
        mode = mode_of(RADII @ start[:2])
        for _ in range(self.steps):
            state, mode, tangent = self.advance(state, mode, tangent)
            if sampled is not None:
                sampled.append(RADII @ state[:2])
        return state[:4], tangent


def settled(frequency, start, torque, fluctuation):
    """The periodic motion that a start leads to."""
    pair = Pair(frequency, torque, fluctuation)
    for _ in range(60):
        start, _ = pair.period(start)
    for _ in range(20):
        end, tangent = pair.period(start)
        correction = numpy.linalg.solve(tangent - numpy.eye(4), end - start)
        start = start - correction
        if abs(correction).max() < 1e-15:
            break
    return start


def peaks(frequency, start, torque, fluctuation):
    """Largest and least p of a period."""
    pressed = []
    Pair(frequency, torque, fluctuation, 8192).period(start, pressed)
    return extreme(numpy.array(pressed)), -extreme(-numpy.array(pressed))


def extreme(values):
    """The top of the parabola through the largest value and its neighbours."""
    i = int(values.argmax())
    low, top, high = values[i - 1], values[i], values[(i + 1) % len(values)]
    return top - (high - low)**2 / (8 * (low - 2 * top + high))


def branch_frequency(rate, guess, torque, fluctuation):
    """State and frequency of the periodic motion whose pinion has this rate at the phase zero, by Newton's method."""
    start, frequency = guess[0].copy(), guess[1]
    start[2] = rate
    for _ in range(12):
        end, tangent = Pair(frequency, torque, fluctuation).period(start)
        change = 1e-6 * frequency
        by_frequency = (Pair(frequency + change, torque, fluctuation).period(start)[0] -
                        Pair(frequency - change, torque, fluctuation).period(start)[0]) / (2 * change)
        jacobian = numpy.column_stack([(tangent - numpy.eye(4))[:, [0, 1, 3]], by_frequency])
        correction = numpy.linalg.solve(jacobian, start - end)
        start[[0, 1, 3]] += correction[:3]
        frequency += correction[3]
        if abs(correction[3]) < 1e-11 * frequency:
            break
    return start, frequency


def exponent(frequency, torque, fluctuation, settling, periods, blocks=20):
    """Largest Lyapunov exponent [1/s] from rest, with its standard error."""
    pair = Pair(frequency, torque, fluctuation)
    state = numpy.zeros(4)
    for _ in range(settling):
        state, _ = pair.period(state)
    scales = numpy.sqrt(numpy.concatenate([INERTIAS * frequency**2, INERTIAS]))  # energy as the norm
    deviation = numpy.ones(4) / scales
    growths = []
    for _ in range(periods):
        state, tangent = pair.period(state)
        deviation = tangent @ deviation
        size = numpy.linalg.norm(scales * deviation)
        growths.append(numpy.log(size))
        deviation = deviation / size
    rates = numpy.array(growths[periods // 10:]) * frequency / (2 * numpy.pi)
    means = numpy.array([block.mean() for block in numpy.array_split(rates, blocks)])
    return rates.mean(), means.std(ddof=1) / numpy.sqrt(blocks)


LOADED, IDLING = (100.0, 40.0), (2.0, 100.0)  # torque and its fluctuation [N m]
IDLING_FREQUENCY = 1500.0  # [Hz]
STARTS = {}  # of the last motions of the sweeps


def check_sweep(table, sweep):
    """In contact on the way up, and with loss of contact on the way down, each from the motion before it."""
    listed = sweep["frequency"][:] * 1e-3
    found = sweep["connection/mesh/elongation/peak_to_peak"][:]
    for column, name, frequencies in ((0, "up", (2.0, 2.2, 2.3, 2.4, 2.5)), (1, "down", (3.0, 2.8, 2.6, 2.4, 2.3, 2.2, 2.1))):
        start = numpy.zeros(4)
        for kilohertz in frequencies:
            frequency = 2e3 * numpy.pi * kilohertz
            start = settled(frequency, start, *LOADED)
            top, low = peaks(frequency, start, *LOADED)
            table.add(f"{name}, {kilohertz:g} kHz: peak-to-peak of the mesh [um]", 1e6 * (top - low),
                      1e6 * found[numpy.argmin(abs(listed - kilohertz)), column], 1e-9)
        STARTS[name] = start


def check_branch(table, branch):
    """The least frequency of the motions that lose contact: along the branch, by the pinion's rate at the phase zero."""
    guess = [STARTS["down"], 2e3 * numpy.pi * 2.1]

    def frequency(rate):
        guess[:] = branch_frequency(rate, guess, *LOADED)
        return guess[1]

    rates = follow(frequency, STARTS["down"][2])
    least = scipy.optimize.minimize_scalar(frequency, bracket=rates, method="brent", options={"xtol": 1e-5})
    table.add("fold [Hz]", least.fun / (2 * numpy.pi), branch["special/frequency"][:].min(), 1e-10)


def follow(frequency, rate):
    """Three rates of which the middle one has the least frequency."""
    change = 0.02 * rate
    values = [frequency(rate)]
    rates = [rate]
    forward = frequency(rate + change)
    if forward > values[0]:
        change = -change
        values = [frequency(rate)]
    else:
        rates.append(rate + change)
        values.append(forward)
    while len(values) < 3 or values[-1] < values[-2]:
        rates.append(rates[-1] + change)
        values.append(frequency(rates[-1]))
    return rates[-3:]


def check_rattle(table, rattle):
    """The exponents differ by chance: each is a mean over some hundred periods of a chaotic motion."""
    mean, error = exponent(2 * numpy.pi * IDLING_FREQUENCY, *IDLING, 200, 600)
    found, other_error = rattle["lyapunov/exponent"][()], rattle["lyapunov/standard_error"][()]
    table.add_whole("idling: exponent is positive, and within three standard errors of the other one", [1, 1],
                    [int(found > 3 * other_error), int(abs(found - mean) < 3 * numpy.hypot(error, other_error))])


def check(table):
    results = table.run("gear-rattle.prm", "shipped")
    check_sweep(table, results["analysis/sweep"])
    check_branch(table, results["analysis/branch"])
    check_rattle(table, results["analysis/rattle"])


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
