#!/usr/bin/python3
"""Basins as a user runs them: planes of starts, a key on the second axis, random starts, rigid stops.

usage: check_basins.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

from isolator import isolator
from program_runs import ProgramRuns, main

ISOLATOR = "set Variables = y = 0, w = 0, lambda = 1.3\n" + isolator(
    frequency="lambda * 1 rad/s", keys="set Initial penetration = accept") + """
subsection Initial condition start
  set At = mass.head
  set Displacement = y * 1 m
  set Velocity = w * 1 m/s
end
subsection Analysis plane
  set Type = basins
  subsection Basins
    set Coarse cells = 8
    subsection First axis
      set Parameter = Variables/y
      set First = -3
      set Last = 3
      set Cells = 24
    end
    subsection Second axis
      set Parameter = Variables/w
      set First = -3
      set Last = 3
      set Cells = 20
    end
  end
end
subsection Analysis nodes
  set Type = basins
  subsection Basins
    set Method = interpolation
    set Nodes = 200
    set Check every = 1
    subsection First axis
      set Parameter = Variables/y
      set First = -3
      set Last = 3
      set Cells = 24
    end
    subsection Second axis
      set Parameter = Variables/w
      set First = -3
      set Last = 3
      set Cells = 20
    end
  end
end
subsection Analysis at_rest
  set Type = basins
  subsection Basins
    subsection First axis
      set Parameter = Variables/y
      set First = -3
      set Last = 3
      set Cells = 15
    end
    subsection Second axis
      set Parameter = Variables/lambda
      set First = 1.34
      set Last = 1.38
      set Cells = 4
    end
  end
end
subsection Analysis random
  set Type = basin shares
  subsection Basin shares
    set Starts = 500
    subsection Range displacement
      set Parameter = Variables/y
      set First = -3
      set Last = 3
    end
    subsection Range velocity
      set Parameter = Variables/w
      set First = -3
      set Last = 3
    end
  end
end
subsection Analysis settled
  set Type = steady state
  subsection Steady state
    set Settling cycles = 500
    set Steadiness tolerance = 1e-9
    set Recorded cycles = 1
  end
end
subsection Analysis each
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = settled
    subsection Key y
      set Path = Variables/y
      set Values = {y}
    end
    subsection Key w
      set Path = Variables/w
      set Values = {w}
    end
  end
end
"""

# x'' + 0.1 x' + x = 0.5 cos(t) with a stop at 1 and e = 0.8; nothing starts behind the stop.
RIGID = """
set Variables = y = 0, w = 0
subsection Body mass
  set Type = lumped
  subsection Mass head
    set Mass = 1 kg
    set Stiffness = 1 N/m
    set Damping = 0.1 N s/m
  end
end
subsection Contact stop
  set Between = mass.head
  set Clearance = 1 m
  set Law = newton restitution
  subsection Newton restitution
    set Restitution coefficient = 0.8
  end
end
subsection Excitation push
  set Type = force
  set At = mass.head
  set Amplitude = 0.05 N
  set Frequency = 1 rad/s
end
subsection Initial condition start
  set At = mass.head
  set Displacement = y * 1 m
  set Velocity = w * 1 m/s
end
subsection Analysis plane
  set Type = basins
  subsection Basins
    set Coarse cells = 4
    subsection First axis
      set Parameter = Variables/y
      set First = -2
      set Last = 2
      set Cells = 8
    end
    subsection Second axis
      set Parameter = Variables/w
      set First = -1
      set Last = 1
      set Cells = 4
    end
  end
end
"""


def centres(first, last, count):
    return first + (np.arange(count) + 0.5) * (last - first) / count


Y, W = centres(-3, 3, 24), centres(-3, 3, 20)


class Basins(ProgramRuns):
    def setUp(self):
        super().setUp()
        values = {"y": ", ".join(map(repr, Y[::6].tolist())),
                  "w": ", ".join(map(repr, W[::5].tolist()))}
        self.file.write_text(ISOLATOR.format(**values))

    def run_all(self, out, *more, ranks=1):
        done = self.run_program(self.file, "--output", out, *more, ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return h5py.File(out / "results.h5")

    def test_ranks_and_resume_give_the_same_bytes(self):
        self.expect_same_bytes()

    def test_cells_lead_where_the_motions_settle(self):
        with self.run_all(self.folder / "out") as file:
            cells = file["analysis/plane/cell/attractor"][()]
            states = file["analysis/plane/attractors/state"][0]
            np.testing.assert_allclose(file["analysis/plane/Variables.y"][()].ravel()[:24], Y)
            settled = file["analysis/each/state"][()]
            for i, j in np.ndindex(settled.shape[:2]):
                end = states[int(cells[5 * j, 6 * i])]
                np.testing.assert_allclose(settled[i, j], end, atol=1e-7)
            # A motion inside the stops has the closed form, 0.52 / (1 - l^2 + 0.02 i l).
            response = 0.52 / (1 - 1.3**2 + 0.026j)
            np.testing.assert_allclose(states[0], [response.imag, 1.3 * response.real], atol=1e-9)
            np.testing.assert_allclose(file["analysis/plane/attractors/largest_multiplier"][0, 0],
                                       np.exp(-0.01 * 2 * np.pi / 1.3), rtol=1e-9)
            # Its place in the plane is its state.
            np.testing.assert_allclose(file["analysis/plane/attractors/first_axis"][0],
                                       states[:, 0], atol=1e-12)
            np.testing.assert_allclose(file["analysis/plane/attractors/second_axis"][0],
                                       states[:, 1], atol=1e-12)
            # Shares of a row, and of all, add up; interpolation agrees on this coarse grid.
            share = file["analysis/plane/attractors/share"][()]
            np.testing.assert_allclose(share[:, 0], (cells == 0).mean(axis=1))
            np.testing.assert_allclose(share.sum(axis=1), 1)
            nodes = file["analysis/nodes"]
            np.testing.assert_array_equal(nodes["cell/attractor"][()], cells)
            self.assertEqual(nodes["checked_cells"][()].sum(), cells.size)
            self.assertEqual(nodes["wrong_cells"][()].sum(), 0)

    def test_another_key_on_the_second_axis_and_random_starts(self):
        with self.run_all(self.folder / "out", "--set", "Analyses=at_rest, random") as file:
            # 1.345, 1.355, 1.365, 1.375: two motions up to the fold, one above it.
            states = file["analysis/at_rest/attractors/state"][()]
            self.assertEqual(np.isfinite(states[:, :, 0]).sum(axis=1).tolist(), [2, 2, 1, 1])
            cells = file["analysis/at_rest/cell/attractor"][()]
            self.assertEqual([len(np.unique(row)) for row in cells], [2, 2, 1, 1])
            share = file["analysis/random/attractors/share"][()]
            error = file["analysis/random/attractors/share_error"][()]
            # 0.08785 by a grid of 640 000 cells
            self.assertLess(abs(share[0] - 0.08785), 4 * np.sqrt(0.08785 * 0.91215 / 500))
            np.testing.assert_allclose(error, np.sqrt(share * (1 - share) / 500))

    def test_nothing_starts_behind_a_rigid_stop(self):
        self.file.write_text(RIGID)
        with self.run_all(self.folder / "out") as file:
            cells = file["analysis/plane/cell/attractor"][()]
            behind = centres(-2, 2, 8) > 1
            self.assertTrue((cells[:, behind] == -2).all())
            self.assertTrue((cells[:, ~behind] == 0).all())
            np.testing.assert_allclose(file["analysis/plane/no_motion_share"][()], 0.25)
            # Resonance: 0.05 / 0.1 cannot reach the stop.
            np.testing.assert_allclose(file["analysis/plane/attractors/state"][0, 0],
                                       [-0.5, 0], atol=1e-9)


if __name__ == "__main__":
    main()
