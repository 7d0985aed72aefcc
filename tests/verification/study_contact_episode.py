#!/usr/bin/python3
"""Whole contacts in one step, apart from the program: a free mass on a Hertz stop, force = weight times polynomial.

Mass, approach speed and stiffness are one. The table has the relative error of the duration against the closed
form by the number of nodes, with the weight and without; the figure shows one contact and those errors.
"""
import math

import numpy as np
from scipy.optimize import fsolve
from scipy.special import gamma, roots_jacobi

import study_figures
from studies import Study

EXPONENT = 1.5
NODES = (4, 6, 8, 10, 12, 16)


class Shape:
    """Forces x^power (1 - x)^power times a polynomial, by their values at Gauss nodes of that weight on [0, 1]."""

    def __init__(self, power, count):
        self.power = power
        self.nodes = (roots_jacobi(count, power, power)[0] + 1) / 2
        self.factors = [1 / np.prod(node - np.delete(self.nodes, j)) for j, node in enumerate(self.nodes)]
        # Of every weighted Lagrange polynomial: the integral of (X - y) times it from 0 to X, at all nodes and at 1.
        self.twice_integrated = np.array([self.moments(node) for node in self.nodes] + [self.moments_at_end()])

    def lagrange(self, at):
        columns = [factor * np.prod([at - other for other in np.delete(self.nodes, j)], axis=0)
                   for j, factor in enumerate(self.factors)]
        return np.array(columns) / ((self.nodes * (1 - self.nodes)) ** self.power)[:, None]

    def functions(self, at):
        return (at * (1 - at)) ** self.power * self.lagrange(at)

    def moments(self, target):
        """y = target s: the root at the start and the factor (1 - s) are the weight of a Gauss rule."""
        points, weights = roots_jacobi(80, 1, self.power)
        s, weights = (points + 1) / 2, weights / 2 ** (self.power + 2)
        return target ** (self.power + 2) * self.lagrange(target * s) @ (weights * (1 - target * s) ** self.power)

    def moments_at_end(self):
        points, weights = roots_jacobi(40, self.power + 1, self.power)
        return self.lagrange((points + 1) / 2) @ (weights / 2 ** (2 * self.power + 2))


def closed_duration():
    part = 1 / (EXPONENT + 1)
    deepest = ((EXPONENT + 1) / 2) ** part
    return 2 * math.sqrt(math.pi) * part * gamma(part) / gamma(0.5 + part) * deepest


def solve(shape):
    """Forces at the nodes and duration: f = u^n at the nodes and u = 0 at the end."""
    def residual(unknowns):
        forces, duration = unknowns[:-1], unknowns[-1]
        positions = np.append(shape.nodes, 1)
        penetration = duration * positions - duration**2 * shape.twice_integrated @ forces
        return np.append(forces - np.abs(penetration[:-1]) ** EXPONENT, penetration[-1])

    deepest = ((EXPONENT + 1) / 2) ** (1 / (EXPONENT + 1))
    guess = (deepest * np.sin(np.pi * shape.nodes)) ** EXPONENT
    unknowns = fsolve(residual, np.append(guess, closed_duration()), xtol=1e-13)
    return unknowns[:-1], unknowns[-1]


def error(power, count):
    return abs(solve(Shape(power, count))[1] / closed_duration() - 1)


def draw(study, errors):
    figure, (force_panel, error_panel), colours = study_figures.panels(study, 2, share_x=False)
    shape = Shape(EXPONENT, 8)
    forces, _ = solve(shape)
    x = np.linspace(0, 1, 400)
    force_panel.plot(x, forces @ shape.functions(x), color=colours[0], label="force")
    force_panel.plot(x, 0.25**EXPONENT * forces @ shape.lagrange(x), "--", color=colours[1],
                     label="its polynomial times the weight at 1/2")
    force_panel.plot(shape.nodes, forces, "o", color=colours[0], label="values at 8 nodes")
    force_panel.set_xlabel("time since the touch, of the duration")
    force_panel.set_ylabel("force")
    force_panel.legend(loc="lower center")
    for colour, label, of in zip(colours, ("weighted polynomial", "polynomial"), errors):
        error_panel.semilogy(NODES, of, "o-", color=colour, label=label)
    error_panel.set_xlabel("nodes")
    error_panel.set_ylabel("error of the duration")
    error_panel.legend()
    figure.tight_layout()
    study_figures.save(study, figure, "whole-contact.png")


def main():
    study = Study(__file__, "nodes", "weighted polynomial", "polynomial")
    errors = [[error(power, count) for count in NODES] for power in (EXPONENT, 0)]
    for count, *of in zip(NODES, *errors):
        study.row(str(count), *(f"{value:.0e}" for value in of))
    draw(study, errors)
    study.finish()


if __name__ == "__main__":
    main()
