#!/usr/bin/python3
"""Fixed-step Runge-Kutta against located contact: the casing's motion at a clearance of 5 mm.

The classical Runge-Kutta method of order four steps over the instants at which the impact element
meets the casing and leaves it, as a plain integration of the equations does; vibroimpact ends a
step there. Both start from rest; the peak-to-peak displacement of the casing is taken from 20 s to
40 s. Takes about three minutes.
usage: study_fixed_step.py PROGRAM SOURCE [--page FILE] [--keep FOLDER]
"""
import math

import study_figures
from studies import Study

STEPS = (1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5)
TOLERANCES = ("1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-11")
CYCLES = 325  # periods of the baseplate before the window, and in it: 20 s

CASING, ROTOR, ELEMENT = 100.0, 40.0, 15.0
ECCENTRICITY, INERTIA = 2e-3, 5.0
LINEAR, CUBIC, SUSPENSION, DAMPING = 1.5e5, 6e10, 8e4, 1500.0
CONTACT_STIFFNESS, CONTACT_DAMPING, CLEARANCE = 5e8, 1e5, 5e-3
TORQUE, SLOPE, TIME_CONSTANT = 100.0, 8.0, 0.1
AMPLITUDE, RATE, OMEGA, GRAVITY = 1e-3, 1.0, 102.0, 9.81
CUT = CYCLES * 2 * math.pi / OMEGA
END = 2 * CUT


def rest():
    """Where casing and element hang: the only real root of the cubic, by Cardano's formula."""
    p = LINEAR / (3 * CUBIC)
    q = (CASING + ROTOR + ELEMENT) * GRAVITY / (2 * CUBIC)
    root = math.sqrt(q * q + p**3)
    casing = (root - q)**(1 / 3) - (root + q)**(1 / 3)
    return casing, casing - ELEMENT * GRAVITY / SUSPENSION


def contact_force(relative, closing):
    """On the element: one of two no-tension stops, above or below."""
    if relative > CLEARANCE:
        return min(0.0, -CONTACT_STIFFNESS * (relative - CLEARANCE) - CONTACT_DAMPING * closing)
    if relative < -CLEARANCE:
        return max(0.0, -CONTACT_STIFFNESS * (relative + CLEARANCE) - CONTACT_DAMPING * closing)
    return 0.0


def rates(t, y, element, angle, v, v_element, speed, torque,
          sin=math.sin, cos=math.cos, exp=math.exp):
    """Time derivatives of the seven states; called 10^8 times, so nothing is looked up twice."""
    decay, phase = exp(-RATE * t), OMEGA * t
    base = AMPLITUDE * (1 - decay) * sin(phase)
    base_rate = AMPLITUDE * (RATE * decay * sin(phase) + (1 - decay) * OMEGA * cos(phase))
    elongation, relative = y - base, element - y
    on_element = contact_force(relative, v_element - v) - SUSPENSION * relative
    unbalance = ROTOR * ECCENTRICITY
    coupling = unbalance * cos(angle)
    mass, inertia = CASING + ROTOR, INERTIA + unbalance * ECCENTRICITY
    on_casing = (unbalance * speed * speed * sin(angle) - DAMPING * (v - base_rate) - on_element
                 - (CUBIC * elongation * elongation + LINEAR) * elongation - mass * GRAVITY)
    on_rotor = torque - GRAVITY * coupling
    determinant = mass * inertia - coupling * coupling
    return (v, v_element, speed, (inertia * on_casing - coupling * on_rotor) / determinant,
            on_element / ELEMENT - GRAVITY,
            (mass * on_rotor - coupling * on_casing) / determinant,
            (TORQUE - SLOPE * speed - torque) / TIME_CONSTANT)


def runge_kutta_step(t, h, x):
    half, sixth = h / 2, h / 6
    k1 = rates(t, *x)
    k2 = rates(t + half, *[a + half * k for a, k in zip(x, k1)])
    k3 = rates(t + half, *[a + half * k for a, k in zip(x, k2)])
    k4 = rates(t + h, *[a + h * k for a, k in zip(x, k3)])
    return [a + sixth * (p + 2 * (q + r) + s) for a, p, q, r, s in zip(x, k1, k2, k3, k4)]


def travel(h):
    """Peak-to-peak displacement of the casing in mm; nan when the motion grows past a metre."""
    x = [*rest(), 1.5 * math.pi, 0.0, 0.0, 0.0, 0.0]
    lowest, highest, first = math.inf, -math.inf, round(CUT / h)
    for n in range(round(END / h)):
        x = runge_kutta_step(n * h, h, x)
        if not abs(x[0]) < 1:
            return math.nan
        if n >= first:
            lowest, highest = min(lowest, x[0]), max(highest, x[0])
    return (highest - lowest) * 1e3


def located(study, tolerance):
    """The same with vibroimpact, and its time steps."""
    motion = study.run("electromechanical.prm", f"located-{tolerance}", "Analyses=motion",
                       f"Integration/Relative tolerance={tolerance}",
                       f"Analysis/motion/Stepped sweep/Settling cycles={CYCLES}",
                       f"Analysis/motion/Stepped sweep/Recorded cycles={CYCLES}")["analysis/motion"]
    casing = motion["point/machine.casing/absolute_displacement_y/peak_to_peak"][0, 0]
    return casing * 1e3, motion["steps"][0, 0]


def draw(study, points):
    """Peak-to-peak over the number of time steps, both ways."""
    figure, (axes,), colours = study_figures.panels(study, 1)
    for (name, curve), colour, marker in zip(points.items(), colours, "os"):
        axes.plot(*zip(*curve), marker + "-", color=colour, label=name)
    axes.set_xscale("log")
    axes.set_xlabel("Time steps in 40 s")
    axes.set_ylabel("Casing,\npeak-to-peak (mm)")
    study_figures.legend(axes)
    study_figures.save(study, figure, "electromechanical-fixed-step.png")


def main():
    study = Study(__file__, "method", "step or tolerance", "time steps",
                  "peak-to-peak of the casing, mm")
    fixed, adaptive = [], []
    for h in STEPS:
        found = travel(h)
        study.row("Runge-Kutta, fixed step", f"{h:g} s", f"{END / h:.0f}",
                  "diverges" if math.isnan(found) else f"{found:.4f}")
        fixed.append((END / h, found))
    for tolerance in TOLERANCES:
        found, steps = located(study, tolerance)
        study.row("vibroimpact, contact located", tolerance, f"{steps:.0f}", f"{found:.4f}")
        adaptive.append((steps, found))
    draw(study, {"fixed step": fixed, "contact located": adaptive})
    study.finish()


if __name__ == "__main__":
    main()
