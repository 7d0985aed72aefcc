#!/usr/bin/python3
"""Searches as a user runs them: exact optima, grids around them, resumed runs, what fails.

usage: check_searches.py PROGRAM MPIEXEC
"""
import os
import signal
import subprocess

import h5py
import numpy as np

from one_frequency import amplitude_at
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
""" + amplitude_at("curve", "f * 1 Hz", "amplitude", "point/block.head/displacement_x/amplitude")
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
# Motions that are integrated for a while.
STRIKES = """
subsection Contact stop
  set Between = block.head, stop
  set Clearance = 10 mm
  set Law = hertz
  subsection Hertz
    set Stiffness = 1e6 N/m^1.5
  end
end
subsection Analysis strikes
  set Type = transient
  set Record = extreme values
  subsection Transient
    set Duration = 500 s
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
PARETO = """
subsection Derived stiffness
  set From = curve
  set Operation = expression
  set Fields = x = amplitude
  set Expression = k + 0 * x / (1 m)
end
subsection Analysis front
  set Type = pareto front
  subsection Pareto front
    set Repeat = curve
    set Evaluations = 300
    subsection Objective amplitude
      set Quantity = amplitude
    end
    subsection Objective cost
      set Quantity = stiffness
    end
    subsection Key stiffness
      set Path = Variables/k
      set Lower = 750
      set Upper = 2000
    end
  end
end
"""
SENSITIVITY = """
subsection Analysis shares
  set Type = sensitivity
  subsection Sensitivity
    set Repeat = curve
    set Samples = 300
    subsection Quantity amplitude
      set Quantity = amplitude
    end
    subsection Key stiffness
      set Path = Variables/k
      set Lower = 500
      set Upper = 900
    end
    subsection Key damping
      set Path = Variables/c
      set Lower = 2
      set Upper = 20
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

    def refused(self, text, *words, ranks=1):
        """Before anything runs: no folder of results is there."""
        self.file.write_text(text, encoding="utf-8")
        for arguments in (("--output", "refused"), ("--check",)):
            done = self.run_program(self.file, *arguments, ranks=ranks)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)
            self.assertEqual(done.stderr.count(words[0]), 1)
        self.assertFalse((self.folder / "refused").exists())

    def test_an_unknown_quantity_is_found_before_anything_runs(self):
        text = MODEL + SEARCH
        for unknown in (text, text + GRID):
            self.refused(unknown.replace("Objective = amplitude", "Objective = amplitud"),
                         "'amplitud' is no field of the analysis curve", "Optimise / Objective",
                         "case.prm:", "did you mean 'amplitude'?", ranks=2)
        self.refused(text.replace("Objective = amplitude",
                                  "Objective = point/block.head/displacement_x/amplitude")
                     .replace("Points = 1", "Points = 3")
                     .replace("Last frequency = f", "Last frequency = 2 * f"),
                     "must be a single number, but goes over frequency", "Optimise / Objective")
        limited = text.replace("    subsection Key", "    set Method = COBYLA\n    subsection "
                               "Constraint low\n      set Quantity = amplitude\n"
                               "      set Upper = 20 mm\n    end\n    subsection Key")
        self.refused(limited.replace("Quantity = amplitude", "Quantity = amplitudes"),
                     "'amplitudes' is no field", "Constraint low / Quantity")
        self.refused(limited.replace("20 mm", "20 N"), "Constraint low / Upper", "20 N")

    def test_a_population_on_all_ranks_and_after_a_kill(self):
        text = (MODEL + SEARCH + GRID).replace("set Starts = 3",
                                               "set Starts = 2\n    set Method = differential evolution")
        search = self.results(text, "--set", "Analyses=search")["search"]
        np.testing.assert_allclose(search["derived/best_objective"][()], best_amplitude(3), rtol=1e-3)
        self.file.write_text(text, encoding="utf-8")
        self.expect_same_bytes()

    def test_a_rank_that_stops_lets_none_wait(self):
        # One rank alone gets the signal. It is in the midst of a motion nearly always, which it leaves at its
        # next step, and the next generation needs what the others do not know of it.
        text = (MODEL + STRIKES + SEARCH).replace("set Starts = 3", "set Method = differential evolution") \
            .replace("Repeat = curve", "Repeat = strikes").replace(
                "Objective = amplitude", "Objective = recorded/point/block.head/displacement_x/maximum")
        self.file.write_text(text, encoding="utf-8")
        process = subprocess.Popen(
            self.command(self.file, "--output", "out", "--set", "Analyses=search", ranks=2),
            cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait_for_journal(self.folder / "out" / "journal", 600, process)
        one = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True,
                             check=True).stdout.split()[1]
        os.kill(int(one), signal.SIGTERM)
        try:
            self.assertEqual(process.wait(timeout=600), 4)
        finally:
            process.kill()

    def test_a_pareto_front(self):
        # Small amplitude needs a stiff spring above the resonance: amplitude against stiffness.
        front = self.results(MODEL + PARETO)["front"]
        k, x = front["front/key/stiffness"][0], front["front/objective/amplitude"][0]
        w = 6 * np.pi
        np.testing.assert_allclose(x, FORCE / np.abs(k - MASS * w ** 2 + 1j * DAMPING * w),
                                   rtol=1e-10)
        np.testing.assert_allclose(front["front/objective/cost"][0], k, rtol=1e-12)
        self.assertTrue(np.all(np.diff(x) >= 0) and np.all(np.diff(k) <= 0))
        # Stiffer than the resonance, a better amplitude always costs more; below the mirror image
        # of the upper end nothing is on the front.
        self.assertGreater(len(k), 40)
        self.expect_same_bytes()

    def test_a_front_by_a_grid_of_limits_is_the_same(self):
        limited = SEARCH.replace("set Sense = maximise", "set Method = COBYLA").replace(
            "    subsection Key", "    subsection Constraint cost\n      set Quantity = stiffness\n"
            "      set Upper = limit\n    end\n    subsection Key").replace("100\n", "750\n")
        limits = [1000, 1300, 1700]
        text = MODEL + PARETO + limited + GRID.replace("Variables/f", "Variables/limit").replace(
            "2, 3, 4", ", ".join(map(str, limits)))
        text = text.replace("f = 3\n", "f = 3, limit = 2000\n", 1)
        analysis = self.results(text)
        k = analysis["front/front/key/stiffness"][0]
        x = analysis["front/front/objective/amplitude"][0]
        order = np.argsort(k)
        found = analysis["grid/derived/best_objective"][:]
        np.testing.assert_allclose(np.interp(limits, k[order], x[order]), found, rtol=0.02)

    def test_sensitivities_of_the_response(self):
        analysis = self.results(MODEL + SENSITIVITY)["shares"]
        rng = np.random.default_rng(7)  # the same indices by brute force
        n, w = 400_000, 6 * np.pi

        def amplitude(k, c):
            return FORCE / np.abs(k - MASS * w ** 2 + 1j * c * w)

        k, c, other_k, other_c = (rng.uniform(low, high, n) for low, high in
                                  ((500, 900), (2, 20), (500, 900), (2, 20)))
        f = amplitude(k, c)
        for name, alone in (("stiffness", amplitude(k, other_c)), ("damping", amplitude(other_k, c))):
            first = np.cov(f, alone)[0, 1] / np.var(f)
            error = analysis[f"first_order_error/amplitude/{name}"][0]
            self.assertLess(abs(analysis[f"first_order/amplitude/{name}"][0] - first), 4 * error)
            self.assertLess(error, 0.1)
        for name, others in (("stiffness", amplitude(other_k, c)), ("damping", amplitude(k, other_c))):
            total = np.mean((f - others) ** 2) / 2 / np.var(f)
            error = analysis[f"total_error/amplitude/{name}"][0]
            self.assertLess(abs(analysis[f"total/amplitude/{name}"][0] - total), 4 * error)
        summary = (self.folder / "out" / "summary.txt").read_text(encoding="utf-8")
        self.assertIn("analysis.shares[1].total.amplitude.stiffness = ", summary)
        self.expect_same_bytes()

    def test_sensitivities_of_the_function_of_ishigami(self):
        # sin x1 + a sin^2 x2 + b x3^4 sin x1 with x from -pi to pi (Ishigami and Homma 1990). The keys are
        # variables that the model does not know.
        a, b = 7, 0.1
        keys = "".join(f"""    subsection Key x{i}
      set Path = Variables/x{i}
      set Lower = -{np.pi!r}
      set Upper = {np.pi!r}
    end
""" for i in (1, 2, 3))
        text = MODEL.replace("f = 3\n", "f = 3, x1 = 0, x2 = 0, x3 = 0\n", 1) + f"""
subsection Derived ishigami
  set From = curve
  set Operation = expression
  set Fields = x = amplitude
  set Expression = sin(x1) + {a} * sin(x2)^2 + {b} * x3^4 * sin(x1) + 0 * x / (1 m)
end
subsection Analysis shares
  set Type = sensitivity
  subsection Sensitivity
    set Repeat = curve
    set Samples = 300
    subsection Quantity y
      set Quantity = ishigami
    end
{keys}  end
end
"""
        shares = self.results(text, "--set", "Analyses=shares")["shares"]
        alone = (1 + b * np.pi ** 4 / 5) ** 2 / 2, a ** 2 / 8, 0
        together = b ** 2 * np.pi ** 8 * (1 / 18 - 1 / 50)  # of x1 and x3
        variance = sum(alone) + together
        totals = alone[0] + together, alone[1], together
        self.assertLess(abs(shares["mean/y"][0] - a / 2), 4 * (variance / 300) ** 0.5)
        np.testing.assert_allclose(shares["deviation/y"][0], variance ** 0.5, rtol=0.1)
        for i, (first, total) in enumerate(zip(alone, totals), 1):
            for name, exact in (("first_order", first / variance), ("total", total / variance)):
                error = shares[f"{name}_error/y/x{i}"][0]
                self.assertLess(abs(shares[f"{name}/y/x{i}"][0] - exact), 4 * error + 1e-12)
                self.assertLess(error, 0.15)

    def test_same_bytes_on_all_ranks_and_after_a_kill(self):
        self.file.write_text(MODEL + SEARCH + GRID, encoding="utf-8")
        self.expect_same_bytes()


if __name__ == "__main__":
    main()
