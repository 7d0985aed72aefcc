#!/usr/bin/python3
"""Fits as a user runs them: synthetic sweeps with known values, with and without noise, resumed runs,
data that cannot be used.

usage: check_fits.py PROGRAM MPIEXEC
"""
import h5py
import numpy as np

from one_frequency import amplitude_at
from program_runs import ProgramRuns, main

MASS, DAMPING, STIFFNESS, BASE = 1.8, 31.14, 430.0, 0.01
MODEL = """
set Variables = weight = 1.8, c = 25, k = 386.72
subsection Body first
  set Type = lumped
  subsection Mass mass
    set Mass = weight * 1 kg
    set Stiffness = k * 1 N/m
    set Damping = c * 1 N s/m
  end
end
subsection Excitation table
  set Type = base displacement
  set Amplitude = 10 mm
  set Frequency = 2 Hz
end
subsection Analysis curve
  set Type = frequency response
  subsection Frequency response
    set First frequency = 0.9 Hz
    set Last frequency = 6.1 Hz
    set Points = 521
  end
end
"""
FIT = """
subsection Analysis fit
  set Type = estimate
  subsection Estimate
    subsection Key damping
      set Path = Variables/c
      set Lower = 1
      set Upper = 100
      set Start = 25
    end
    subsection Key stiffness
      set Path = Variables/k
      set Lower = 100
      set Upper = 1000
      set Start = 386.72
    end
    subsection Data sweep
      set Repeat = curve
      set Quantity = point/first.mass/absolute_displacement_x/amplitude
      set File = data.csv
      set Abscissa column = frequency
      set Value column = amplitude
      set Value unit = mm
    end
  end
end
"""
MASS_KEY = """    subsection Key mass
      set Path = Variables/weight
      set Lower = 0.5
      set Upper = 3
      set Start = 1.84
    end
"""


def amplitude(frequency, mass=MASS, damping=DAMPING, stiffness=STIFFNESS):
    """Of the absolute displacement [m]."""
    w = 2 * np.pi * frequency
    spring = stiffness + 1j * damping * w
    return BASE * np.abs(spring / (spring - mass * w ** 2))


FREQUENCY = np.linspace(1, 6, 26)


class Fits(ProgramRuns):
    def write_data(self, name="data.csv", noise=0.0, seed=0, frequency=FREQUENCY):
        values = 1e3 * amplitude(frequency)
        values += noise * np.random.default_rng(seed).standard_normal(len(values))
        rows = [f"{x:.17g},{y:.17g}" for x, y in zip(frequency, values)]
        (self.folder / name).write_text("\n".join(["# made", "frequency,amplitude", *rows]),
                                        encoding="utf-8")

    def run_file(self, text, code=0):
        self.file.write_text(text, encoding="utf-8")
        self.done = self.run_program(self.file, "--output", "out", "--overwrite")
        self.assertEqual(self.done.returncode, code, self.done.stdout + self.done.stderr)

    def results(self, text, code=0):
        self.run_file(text, code)
        return self.enterContext(h5py.File(self.folder / "out" / "results.h5"))["analysis"]

    def test_known_values_are_found(self):
        self.write_data()
        fit = self.results(MODEL + FIT)["fit"]
        self.assertAlmostEqual(fit["derived/best_damping"][()], DAMPING, delta=1e-3)
        self.assertAlmostEqual(fit["derived/best_stiffness"][()], STIFFNESS, delta=1e-2)

    def test_the_cost_is_known_beforehand(self):
        self.write_data()
        self.file.write_text(MODEL + FIT, encoding="utf-8")
        done = self.run_program(self.file, "--check")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("analysis fit: 205 points", done.stdout)

    def test_the_scale_of_mass_damping_and_stiffness_is_free(self):
        self.write_data(noise=0.05)
        text = (MODEL + FIT).replace("    subsection Data", MASS_KEY + "    subsection Data")
        fit = self.results(text)["fit"]
        m, c, k = (fit[f"derived/best_{name}"][()] for name in ("mass", "damping", "stiffness"))
        self.assertAlmostEqual(k / m / (STIFFNESS / MASS), 1, delta=0.02)
        self.assertAlmostEqual(c / m / (DAMPING / MASS), 1, delta=0.02)
        direction = fit["direction"][0, 0, 2]
        np.testing.assert_allclose(np.abs(direction), 3 ** -0.5, rtol=1e-3)
        self.assertTrue(np.isinf(fit["standard_error/mass"][0, 0]))
        words = fit["reason"].asstr()[0, 0]
        self.assertIn("leave free: damping, stiffness, mass as 1 : 1 : 1", words.replace("0.99", "1"))
        self.assertIn(words, (self.folder / "out" / "summary.txt").read_text(encoding="utf-8"))

    def test_two_hundred_noisy_sweeps(self):
        """The estimates are centred on the true values, and their intervals hold these as often as
        they say, within four standard errors of 200 draws."""
        seeds = range(200)
        for seed in seeds:
            self.write_data(f"s{seed}.csv", noise=0.3, seed=seed)
        self.write_data()
        names = ", ".join(f"s{seed}.csv" for seed in seeds)
        grid = f"""
subsection Analysis many
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = fit
    subsection Key file
      set Path = Analysis/fit/Estimate/Data sweep/File
      set Values = {names}
    end
  end
end
set Analyses = many
"""
        many = self.results(MODEL + FIT + grid)["many"]
        for name, true in (("damping", DAMPING), ("stiffness", STIFFNESS)):
            best = many[f"derived/best_{name}"][:]
            error = many[f"derived/standard_error_{name}"][:]
            self.assertTrue(np.all(np.isfinite(best)))
            spread = best.std(ddof=1)
            self.assertLess(abs(best.mean() - true), 4 * spread / 200 ** 0.5)
            self.assertAlmostEqual(np.sqrt(np.mean(error ** 2)) / spread, 1, delta=4 * 400 ** -0.5)
            low = many[f"interval_lower/{name}"][:, 0, 0]
            high = many[f"interval_upper/{name}"][:, 0, 0]
            covered = np.mean((low <= true) & (true <= high))
            self.assertLess(abs(covered - 0.95), 4 * (0.95 * 0.05 / 200) ** 0.5)

    def test_curve_and_single_value_together(self):
        self.write_data()
        text = (MODEL + FIT).replace("    subsection Data", MASS_KEY + "    subsection Data", 1)
        text = text.replace("set Value unit = mm\n    end", """set Value unit = mm
    end
    subsection Data weight
      set Repeat = scales
      set Quantity = mass_now
      set Value = 1.8
    end""")
        text += amplitude_at("scales", "1 Hz", "x",
                             "point/first.mass/absolute_displacement_x/amplitude") + """
subsection Derived mass_now
  set From = scales
  set Operation = expression
  set Fields = x = x
  set Expression = weight + 0 * x / (1 m)
end
"""
        fit = self.results(text)["fit"]
        for name, true in (("mass", MASS), ("damping", DAMPING), ("stiffness", STIFFNESS)):
            self.assertAlmostEqual(fit[f"derived/best_{name}"][()] / true, 1, delta=1e-4)

    def test_data_that_cannot_be_used(self):
        self.write_data()
        cases = {
            ("column = amplitude", "column = amplitud"): ["Data sweep / Value column", "amplitude"],
            ("set File = data.csv", "set File = dat.csv"): ["Data sweep / File", "can be read"],
            ("set File = data.csv", ""): ["Data sweep / File", "Value must be given"],
            ("set Repeat = curve", "set Repeat = fit"): ["Data sweep / Repeat", "evaluate another"],
            ("set Start = 25", "set Start = 0.5"): ["Key damping / Start", "from Lower to Upper"],
            ("set File = data.csv", "set Value = 3 mm"): ["Data sweep / Abscissa column", "Value"],
            ("subsection Data sweep", "subsection Data sweep\nset Weight = 0"): ["Weight", "0"],
        }
        for (old, new), parts in cases.items():
            self.run_file((MODEL + FIT).replace(old, new), code=1)
            for part in parts:
                self.assertIn(part, self.done.stderr)
        self.write_data(frequency=FREQUENCY[:1])
        self.run_file(MODEL + FIT, code=1)
        self.assertIn("two samples at least", self.done.stderr)
        # What only an outcome shows, is the reason of the points.
        self.write_data(frequency=FREQUENCY + 1)
        reason = self.results(MODEL + FIT, code=3)["fit"]["reason"].asstr()[0, 0]
        self.assertIn("which goes from 0.9 to 6.1 Hz", reason)
        self.write_data()
        text = (MODEL + FIT).replace("Value unit = mm", "Value unit = kg")
        self.assertIn("Value unit", self.results(text, code=3)["fit"]["reason"].asstr()[0, 0])

    def test_same_bytes_on_all_ranks_and_after_a_kill(self):
        self.write_data(noise=0.1)
        self.file.write_text(MODEL + FIT.replace("  subsection Estimate\n",
                                                 "  subsection Estimate\n    set Starts = 5\n"),
                             encoding="utf-8")
        self.expect_same_bytes()


if __name__ == "__main__":
    main()
