#!/usr/bin/python3
"""Searches as a user runs them: exact optima, grids around them, resumed runs, what fails.

usage: check_searches.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

from program_runs import ProgramRuns, main

# |X| = F / |k - m w^2 + i c w| is largest at k = m w^2 and is F / (c w) there; at k = 0 it is
# F / |m w^2 - i c w|. The response is exact, without contacts.
MASS, DAMPING, FORCE = 2.0, 3.0, 5.0
MODEL = """
set Variables = k = 900, c = 3, f = 3
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = k * 1 N/m
    set Damping = c * 1 N s/m
  end
end
subsection Excitation shaker
  set Type = force
  set At = block.head
  set Amplitude = 5 N
  set Frequency = f * 1 Hz
end
subsection Analysis curve
  set Type = frequency response
  subsection Frequency response
    set First frequency = f * 1 Hz
    set Last frequency = f * 1 Hz
    set Points = 1
  end
end
subsection Derived amplitude
  set From = curve
  set Operation = maximum
  set Field = point/block.head/displacement_x/amplitude
  set Along = frequency
end
"""
SEARCH = """
subsection Analysis search
  set Type = optimise
  subsection Optimise
    set Repeat = curve
    set Objective = amplitude
    set Sense = maximise
    set Tolerance = 1e-7
    set Starts = 3
    set Most evaluations = 100
    subsection Key stiffness
      set Path = Variables/k
      set Lower = 100
      set Upper = 2000
    end
  end
end
"""
GRID = """
subsection Analysis grid
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = search
    subsection Key frequency
      set Path = Variables/f
      set Values = 2, 3, 4
    end
  end
end
"""


def best_stiffness(frequency):
    return MASS * (2 * np.pi * frequency) ** 2


def best_amplitude(frequency, damping=DAMPING):
    return FORCE / (damping * 2 * np.pi * frequency)


class Searches(ProgramRuns):
    def results(self, text, *options, code=0):
        self.file.write_text(text, encoding="utf-8")
        self.done = self.run_program(self.file, "--output", "out", "--overwrite", *options)
        self.assertEqual(self.done.returncode, code, self.done.stdout + self.done.stderr)
        return self.enterContext(h5py.File(self.folder / "out" / "results.h5"))["analysis"]

    def test_the_optimum_is_the_resonance(self):
        search = self.results(MODEL + SEARCH)["search"]
        np.testing.assert_allclose(search["derived/best_stiffness"][()], best_stiffness(3), rtol=1e-4)
        np.testing.assert_allclose(search["derived/best_objective"][()], best_amplitude(3), rtol=1e-8)
        np.testing.assert_allclose(search["objective"][:, 0], best_amplitude(3), rtol=1e-8)
        summary = (self.folder / "out" / "summary.txt").read_text(encoding="utf-8")
        self.assertIn("analysis.search.derived.best_stiffness = ", summary)
        self.assertIn("analysis.search[3,1].search.evaluations = ", summary)
        # every evaluation is the closed form at its own stiffness
        k, x = search["key/stiffness"][()], search["objective"][()]
        w = 6 * np.pi
        exact = FORCE / np.abs(k - MASS * w ** 2 + 1j * DAMPING * w)
        np.testing.assert_allclose(x[np.isfinite(x)], exact[np.isfinite(x)], rtol=1e-10)

    def test_the_cost_is_known_beforehand(self):
        self.file.write_text(MODEL + SEARCH + GRID, encoding="utf-8")
        done = self.run_program(self.file, "--check")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("analysis search: 303 points", done.stdout)
        self.assertIn("analysis grid: 909 points", done.stdout)

    def test_a_grid_repeats_the_search(self):
        grid = self.results(MODEL + SEARCH + GRID)["grid"]
        frequency = grid["Variables.f"][:]
        np.testing.assert_allclose(grid["derived/best_stiffness"][:], best_stiffness(frequency),
                                   rtol=1e-4)
        np.testing.assert_allclose(grid["derived/best_objective"][:], best_amplitude(frequency),
                                   rtol=1e-8)

    def test_a_search_over_a_grid_and_worst_cases_agree(self):
        # Least largest amplitude at 2.5 and 3.5 Hz: equal distances from both resonances.
        cases = "    subsection Worst over f\n      set Path = Variables/f\n" \
                "      set Values = 2.5, 3.5\n    end\n"
        text = (MODEL + SEARCH).replace("set Sense = maximise\n", "").replace(
            "    subsection Key", cases + "    subsection Key")
        worst = self.results(text, "--set", "Analysis/search/Optimise/Starts=1")["search"]
        w = 2 * np.pi * np.array([2.5, 3.5])
        stiffness = worst["derived/best_stiffness"][()]
        amplitudes = FORCE / np.abs(stiffness - MASS * w ** 2 + 1j * DAMPING * w)
        np.testing.assert_allclose(worst["case_objective"][0, 0], amplitudes, rtol=1e-10)
        over = """
subsection Analysis both
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = curve
    subsection Key f
      set Path = Variables/f
      set Values = 2.5, 3.5
    end
  end
end
subsection Derived amplitudes
  set From = both
  set Operation = maximum
  set Field = point/block.head/displacement_x/amplitude
  set Along = Variables.f, frequency
end
"""
        text = (MODEL + over + SEARCH).replace("set Sense = maximise\n", "").replace(
            "Repeat = curve\n    set Objective = amplitude",
            "Repeat = both\n    set Objective = amplitudes")
        both = self.results(text, "--set", "Analysis/search/Optimise/Starts=1")["search"]
        np.testing.assert_array_equal(both["objective"][0], worst["objective"][0])

    def test_a_constraint_on_another_quantity(self):
        # The softest spring whose amplitude is at most 20 mm, above the resonance.
        limit = "set Method = COBYLA\n    subsection Constraint small\n" \
                "      set Quantity = amplitude\n      set Upper = 20 mm\n    end\n"
        text = (MODEL + SEARCH).replace("set Sense = maximise\n", limit).replace(
            "Objective = amplitude", "Objective = stiffness").replace("Lower = 100", "Lower = 720")
        text += """
subsection Derived stiffness
  set From = curve
  set Operation = expression
  set Fields = x = amplitude
  set Expression = k + 0 * x / (1 m)
end
"""
        search = self.results(text)["search"]
        w = 6 * np.pi
        exact = MASS * w ** 2 + np.sqrt((FORCE / 0.02) ** 2 - (DAMPING * w) ** 2)
        np.testing.assert_allclose(search["derived/best_stiffness"][()], exact, rtol=1e-5)
        self.assertTrue(np.all(search["search/active/small"][:, 0] == 1))

    def test_what_the_model_refuses_is_a_failed_evaluation(self):
        # 1 / (k - 700)^2 as clearance is refused near 700 only, inside the box.
        text = (MODEL + SEARCH).replace("set Damping = c * 1 N s/m",
                                        "set Damping = (abs(k - 700) - 20) * 1 N s/m")
        search = self.results(text, code=3)["search"]
        self.assertTrue(np.all(search["status"][:, 0] == 0))
        failed = search["status"][()] == 1
        self.assertTrue(np.any(failed))
        self.assertTrue(np.all(np.abs(search["key/stiffness"][()][failed] - 700) <= 20))
        self.assertIn("Damping", search["reason"].asstr()[()][failed][0])

    def test_an_unknown_quantity_ends_the_search_at_once(self):
        text = (MODEL + SEARCH).replace("Objective = amplitude", "Objective = amplitud")
        search = self.results(text, code=3)["search"]
        reason = search["reason"].asstr()[0, 0]
        self.assertIn("'amplitud' is no field of the analysis curve", reason)
        self.assertIn("did you mean 'amplitude'?", reason)
        text = (MODEL + SEARCH).replace("Objective = amplitude",
                                        "Objective = point/block.head/displacement_x/amplitude")
        text = text.replace("Points = 1", "Points = 3").replace("Last frequency = f", "Last frequency = 2 * f")
        search = self.results(text, code=3)["search"]
        self.assertIn("is no single number but goes over frequency", search["reason"].asstr()[0, 0])

    def test_same_bytes_on_all_ranks_and_after_a_kill(self):
        self.file.write_text(MODEL + SEARCH + GRID, encoding="utf-8")
        self.expect_same_bytes()


if __name__ == "__main__":
    main()
