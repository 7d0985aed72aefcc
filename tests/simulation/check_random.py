#!/usr/bin/python3
"""Ensembles of random motions on several ranks, and supports that move differently.

usage: check_random.py PROGRAM MPIEXEC
"""
import cmath
import math

import h5py
import numpy as np

from program_runs import ProgramRuns, main

ENSEMBLE = """
set Units = dimensionless
set Variables = member = 1
set Analyses = ensemble
subsection Body mass
  set Type = lumped
  subsection Mass head
    set Mass = 1
    set Stiffness = 1
    set Damping = 0.1
  end
end
subsection Connection spring
  set Between = mass.head, ground
  set Stiffness = 0.5
  set Damping = 0.05
end
subsection Contact stop
  set Between = mass.head
  set Clearance = 0.5
  subsection Linear penalty
    set Stiffness = 10
  end
end
subsection Coherence field
  set Decay = 0.2
  set Speed = 2
  set Wave velocity = 5
end
subsection Excitation west
  set Type = base acceleration
  set Bodies = mass
  set History = random
  subsection Random
    set Density = 0.1
    set Highest frequency = 6
    set Duration = 60
    set Member = member
    set Coherence = field
    set Place = 0, 0, 0
  end
end
subsection Excitation east
  set Like = west
  set Bodies =
  set Connections = spring
  subsection Random
    set Place = 3, 0, 0
  end
end
subsection Analysis motion
  set Type = steady state
  set Record = statistics, level crossings, impacts
  subsection Level crossings
    set Levels = 0, 0.5
  end
  subsection Steady state
    set Settling time = 10
    set Recorded time = 50
  end
end
subsection Analysis ensemble
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = motion
    subsection Key member
      set Path = Variables/member
      set First = 1
      set Last = 7
      set Points = 7
    end
  end
end
subsection Derived force
  set From = ensemble
  set Operation = mean
  set Field = contact/stop/normal_force/mean
  set Along = member
end
subsection Derived error
  set Like = force
  set Operation = standard error
end
"""

MASS, INERTIA, ARMS, STIFFNESSES, DAMPINGS = 2.0, 0.7, (-1.0, 1.5), (3.0, 5.0), (2.0, 1.5)
OMEGA, TIME = 1.7, 60.0
# A rigid bar on two springs, and the same on bases of their own.
BAR = f"""
set Units = dimensionless
subsection Body bar
  set Type = lumped
  subsection Mass centre
    set Mass = {MASS}
    set Axis = y, rz
    set Rotary inertia = {INERTIA}
  end
  subsection Point left
    set At = centre
    set Arm = {ARMS[0]}, 0, 0
  end
  subsection Point right
    set At = centre
    set Arm = {ARMS[1]}, 0, 0
  end
end
subsection Body standing
  set Like = bar
end
subsection Connection left
  set Between = bar.left, ground
  set Direction = y
  set Stiffness = {STIFFNESSES[0]}
  set Damping = {DAMPINGS[0]}
end
subsection Connection right
  set Between = bar.right, ground
  set Direction = y
  set Stiffness = {STIFFNESSES[1]}
  set Damping = {DAMPINGS[1]}
end
subsection Connection left_standing
  set Like = left
  set Between = standing.left, base
end
subsection Connection right_standing
  set Like = right
  set Between = standing.right, base
end
subsection Excitation first
  set Type = base displacement
  set Direction = y
  set Connections = left
  set Amplitude = 0.3
  set Frequency = {OMEGA}
end
subsection Excitation second
  set Like = first
  set Connections = right
  set Amplitude = SECOND
  set Phase = PHASE
end
subsection Excitation base
  set Like = first
  set Connections =
  set Bodies = standing
end
subsection Analysis motion
  set Type = steady state
  subsection Steady state
    set Settling time = {TIME - 10}
    set Recorded time = 10
    set Excitation = first
  end
end
"""
CUBIC = "  set Stiffness = 3.0\n"


class Random(ProgramRuns):
    def test_an_ensemble_is_the_same_on_any_number_of_ranks(self):
        self.file.write_text(ENSEMBLE)
        self.expect_same_bytes()

    def final_state(self, text):
        """Displacements and rates of the bar, then of the one that stands on a base, relative to it."""
        self.file.write_text(text)
        done = self.run_program(self.file, "--output", self.folder / "out", "--overwrite")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "out" / "results.h5") as file:
            state = file["analysis/motion/state"][()].reshape(2, 2, 2)
        return state[:, 0], state[:, 1]

    def test_a_bar_on_two_moving_supports_in_closed_form(self):
        bar, _ = self.final_state(BAR.replace("SECOND", "0.5").replace("PHASE", "1.1"))
        rows = [np.array([1, arm]) for arm in ARMS]
        dynamic = -OMEGA**2 * np.diag([MASS, INERTIA]).astype(complex)
        load = np.zeros(2, dtype=complex)
        for row, k, c, motion in zip(rows, STIFFNESSES, DAMPINGS, (0.3, cmath.rect(0.5, 1.1))):
            dynamic += (k + 1j * OMEGA * c) * np.outer(row, row)
            load += (k + 1j * OMEGA * c) * row * motion
        amplitude = np.linalg.solve(dynamic, load) * cmath.exp(1j * OMEGA * TIME)
        # The slowest free vibration has decayed by exp(-0.6 * 60).
        np.testing.assert_allclose(bar, [amplitude.imag, (1j * OMEGA * amplitude).imag], rtol=0, atol=1e-12)

    def test_equal_motions_are_those_of_one_base(self):
        base = np.array([0.3 * math.sin(OMEGA * TIME), 0])
        rate = np.array([0.3 * OMEGA * math.cos(OMEGA * TIME), 0])
        for spring in (CUBIC, CUBIC + "  set Cubic stiffness = 2\n"):
            text = BAR.replace("SECOND", "0.3").replace("PHASE", "0").replace(CUBIC, spring)
            bar, standing = self.final_state(text)
            tolerance = 1e-12 if spring == CUBIC else 1e-8  # of the steps
            np.testing.assert_allclose(bar, standing + [base, rate], rtol=0, atol=tolerance)


if __name__ == "__main__":
    main()
