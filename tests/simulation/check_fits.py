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
STRIP = """
set Variables = young = 150, zeta = 0.02
subsection Body strip
  set Type = beam
  subsection Geometry
    set Line     = 0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m
    set Elements = 40
  end
  subsection Section
    set Width     = 30 mm
    set Thickness = 0.75 mm
  end
  subsection Material
    set Young modulus = young * 1 GPa
    set Poisson ratio = 0.3
    set Density       = 7850 kg/m^3
  end
  subsection Support root
    set At  = start
    set Fix = all
  end
  subsection Support plane
    set At  = all
    set Fix = y, z, rx, rz
  end
  subsection Modes
    set Number        = 3
    set Damping ratio = zeta
  end
end
subsection Analysis modes
  set Type = modal
end
subsection Analysis fit
  set Type = estimate
  subsection Estimate
    subsection Key young
      set Path = Variables/young
      set Lower = 50
      set Upper = 300
    end
    subsection Key zeta
      set Path = Variables/zeta
      set Lower = 0.001
      set Upper = 0.2
    end
    subsection Data frequencies
      set Repeat = modes
      set Quantity = body/strip/frequency
      set File = modes.csv
      set Abscissa column = mode
      set Value column = frequency_hz
      set Relative deviation = 0.005
    end
    subsection Data damping
      set Repeat = modes
      set Quantity = body/strip/damping_ratio
      set File = modes.csv
      set Abscissa column = mode
      set Value column = damping_percent
      set Value unit = %
      set Relative deviation = 0.1
    end
  end
end
"""
# A mass that strikes a stop with a spring and a dashpot.
STRIKE = """
set Variables = k = 8000, c = 3
subsection Body block
  set Type = lumped
  subsection Mass mass
    set Mass = 0.5 kg
  end
end
subsection Contact stop
  set Between = block.mass, stop
  set Direction = x
  set Clearance = 1 mm
  set Law = kelvin-voigt
  subsection Kelvin-Voigt
    set Stiffness = k * 1 N/m
    set Damping constant = c * 1 N s/m
  end
end
subsection Initial condition push
  set At = block.mass
  set Shape = mode
  set Velocity = 0.4 m/s
end
subsection Analysis strike
  set Type = transient
  set Record = history
  subsection History
    set Quantities = normal_force
    set Sampling interval = 5e-5 s
  end
  subsection Transient
    set Duration = 40 ms
  end
end
subsection Analysis fit
  set Type = estimate
  subsection Estimate
    subsection Key stiffness
      set Path = Variables/k
      set Lower = 1000
      set Upper = 50000
    end
    subsection Key damping
      set Path = Variables/c
      set Lower = 0.1
      set Upper = 30
    end
    subsection Data pulse
      set Repeat = strike
      set Quantity = recorded/history/contact/stop/normal_force
      set File = pulse.h5
      set Abscissa column = /transducer/time
      set Abscissa unit = ms
      set Value column = /transducer/force
      set Value unit = kN
    end
  end
end
"""


def pulse(time, stiffness=10e3, damping=5.0, mass=0.5, speed=0.4, start=2.5e-3):
    """Force of a mass in a spring and a dashpot [N] from `start` on, none where it would pull."""
    decay = damping / (2 * mass)
    rate = np.sqrt(stiffness / mass - decay ** 2)
    since = np.maximum(time - start, 0)
    depth = speed / rate * np.exp(-decay * since) * np.sin(rate * since)
    velocity = (speed * np.exp(-decay * since) * np.cos(rate * since) - decay * depth)
    force = stiffness * depth + damping * velocity
    end = np.flatnonzero((force < 0) & (time > start))[0]
    return np.where((time >= start) & (np.arange(len(time)) < end), force, 0)


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

    def test_natural_frequencies_and_damping(self):
        """Young's modulus 206 GPa by the closed form of a clamped-free beam, damping about 1 %."""
        beta = np.array([1.875104069, 4.694091133, 7.854757438])
        density, thickness, length = 7850, 0.75e-3, 0.3
        wave = np.sqrt(206e9 * thickness ** 2 / 12 / density) / length ** 2
        rows = [f"{mode},{value:.12g},{damping}" for mode, value, damping in
                zip((1, 2, 3), beta ** 2 * wave / (2 * np.pi), (1.1, 1.0, 0.9))]
        (self.folder / "modes.csv").write_text(
            "\n".join(["mode,frequency_hz,damping_percent", *rows]), encoding="utf-8")
        fit = self.results(STRIP)["fit"]
        self.assertAlmostEqual(fit["derived/best_young"][()], 206, delta=2e-3)
        # sum ((z - d) / (0.1 d))^2 is smallest at z = sum(1/d) / sum(1/d^2).
        parts = 1 / np.array([1.1, 1.0, 0.9])
        self.assertAlmostEqual(100 * fit["derived/best_zeta"][()],
                               parts.sum() / (parts ** 2).sum(), delta=1e-4)
        # Counted in known deviations: each of three values with 10 %.
        error = 0.1 / (parts ** 2).sum() ** 0.5
        self.assertAlmostEqual(100 * fit["derived/standard_error_zeta"][()] / error, 1, delta=1e-3)

    def test_a_force_pulse_from_hdf5(self):
        time = np.arange(0, 39e-3, 5e-5)
        with h5py.File(self.folder / "pulse.h5", "w") as file:
            file["transducer/time"] = 1e3 * time
            file["transducer/force"] = 1e-3 * pulse(time)
        fit = self.results(STRIKE)["fit"]
        self.assertAlmostEqual(fit["derived/best_stiffness"][()] / 10e3, 1, delta=1e-3)
        self.assertAlmostEqual(fit["derived/best_damping"][()] / 5, 1, delta=1e-2)

    def test_data_that_cannot_be_used(self):
        self.write_data()
        cases = {
            ("column = amplitude", "column = amplitud"): ["Data sweep / Value column", "amplitude"],
            ("set File = data.csv", "set File = dat.csv"): ["Data sweep / File", "can be read"],
            ("set File = data.csv", ""): ["Data sweep / File", "when Value is not given"],
            ("set Repeat = curve", "set Repeat = fit"): ["Data sweep / Repeat", "evaluate another"],
            ("set Start = 25", "set Start = 0.5"): ["Key damping / Start", "from Lower to Upper"],
            ("set File = data.csv", "set Value = 3 mm"): ["Data sweep / Abscissa column", "Value"],
            ("subsection Data sweep", "subsection Data sweep\nset Weight = 0"): ["Weight", "0"],
            ("set Start = 25", "set Start = 250"): ["Key damping / Start", "from Lower to Upper"],
            ("subsection Data sweep", "subsection Data sweep\nset Standard deviation = 1 mm\n"
             "set Relative deviation = 0.1"): ["Relative deviation", "Standard deviation"],
        }
        for (old, new), parts in cases.items():
            self.run_file((MODEL + FIT).replace(old, new), code=1)
            for part in parts:
                self.assertIn(part, self.done.stderr)
        self.write_data(frequency=FREQUENCY[:1])
        self.run_file(MODEL + FIT, code=1)
        self.assertIn("two samples at least", self.done.stderr)
        few = FIT[:FIT.index("    subsection Data")] + """    subsection Data sweep
      set Repeat = curve
      set Quantity = peak/point/first.mass/absolute_displacement_x/amplitude
      set Value = 14 mm
    end
  end
end
"""
        self.run_file(MODEL + few, code=1)
        self.assertIn("there are 1 data and 2 keys", self.done.stderr)

    def refused(self, text, *words):
        """Before anything runs: no folder of results is there."""
        self.file.write_text(text, encoding="utf-8")
        for arguments in (("--output", "refused"), ("--check",)):
            done = self.run_program(self.file, *arguments, ranks=2)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)
            self.assertEqual(done.stderr.count(words[0]), 1)
        self.assertFalse((self.folder / "refused").exists())

    def test_data_that_do_not_fit_the_quantity_are_refused_before_anything_runs(self):
        self.write_data()
        text = MODEL + FIT
        self.refused(text.replace("Value unit = mm", "Value unit = kg"), "Data sweep / Value unit",
                     "kg", "case.prm:")
        self.refused(text.replace("Value unit = mm", "Value unit = mm\n      set Abscissa unit = s"),
                     "Data sweep / Abscissa unit", "s")
        self.refused(text.replace("Value unit = mm",
                                  "Value unit = mm\n      set Standard deviation = 1 N"),
                     "Data sweep / Standard deviation", "1 N")
        self.refused(text.replace("x/amplitude", "x/amplitud"), "Data sweep / Quantity",
                     "is no field of the analysis curve", "did you mean")
        weight = """set Value unit = mm
    end
    subsection Data weight
      set Repeat = scales
      set Quantity = x
      set Value = 1.8 kg
    end"""
        single = text.replace("set Value unit = mm\n    end", weight) + amplitude_at(
            "scales", "1 Hz", "x", "point/first.mass/absolute_displacement_x/amplitude")
        self.refused(single, "Data weight / Value", "1.8 kg")
        self.refused(single.replace("Quantity = x", "Quantity = y"), "Data weight / Quantity",
                     "'y' is no field")
        self.refused(single.replace("Quantity = x\n      set Value = 1.8 kg",
                                    "Quantity = x\n      set File = data.csv"),
                     "Data weight / Quantity", "along one axis")
        self.write_data(frequency=FREQUENCY + 1)
        self.refused(text, "which goes from 0.9 to 6.1 Hz", "Data sweep / Abscissa column")

    def test_same_bytes_on_all_ranks_and_after_a_kill(self):
        self.write_data(noise=0.1)
        self.file.write_text(MODEL + FIT.replace("  subsection Estimate\n",
                                                 "  subsection Estimate\n    set Starts = 5\n"),
                             encoding="utf-8")
        self.expect_same_bytes()


if __name__ == "__main__":
    main()
