#!/usr/bin/python3
"""A map with everything that can be derived from it, as a user runs it.

usage: check_derived.py PROGRAM MPIEXEC
"""

import h5py
import numpy as np

from program_runs import ProgramRuns, datasets, main

# A mass between two soft bumpers, from which the response curves bend over.
FILE = """
set Variables = gap = 0.4, stiffness = 1
subsection Body oscillator
  set Type = lumped
  subsection Mass mass
    set Mass = 1 kg
    set Stiffness = 1 N/m
    set Damping = 0.2 N s/m
  end
end
subsection Contact right
  set Between = oscillator.mass, base
  set Direction = x
  set Clearance = gap * 1 m
  set Law = kelvin-voigt bumper
  subsection Kelvin-Voigt bumper
    set Stiffness = stiffness * 1 N/m
    set Damping constant = 1 N s/m
  end
end
subsection Contact left
  set Between = oscillator.mass, base
  set Direction = -x
  set Clearance = gap * 1 m
  set Law = kelvin-voigt bumper
  subsection Kelvin-Voigt bumper
    set Stiffness = stiffness * 1 N/m
    set Damping constant = 1 N s/m
  end
end
subsection Excitation ground
  set Type = base acceleration
  set Amplitude = 0.2 m/s^2
  set Frequency = 1 rad/s
end
subsection Analysis curve
  set Type = stepped sweep
  set Record = extreme values
  subsection Extreme values
    set Quantities = displacement
  end
  subsection Stepped sweep
    set First frequency = 0.1 rad/s
    set Last frequency = 3 rad/s
    set Points = 30
    set Settling cycles = 60
    set Recorded cycles = 2
  end
end
subsection Analysis map
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = curve
    subsection Key clearance
      set Path = Variables/gap
      set Values = 0.3, 0.35, 0.4, 0.6, 0.8, 1
    end
    subsection Key spring
      set Path = Variables/stiffness
      set Values = 0.1, 1, 10, 100
    end
  end
end
"""
FIELD = "point/oscillator.mass/displacement_x/peak_to_peak"
DERIVED = f"""
subsection Derived upward
  set From = map
  set Operation = select
  set Field = {FIELD}
  set Where = direction = forward
end
subsection Derived peak
  set From = map
  set Operation = maximum
  set Field = upward
  set Along = frequency
end
subsection Derived resonance
  set From = map
  set Operation = position of maximum
  set Field = upward
  set Along = frequency
  set Refine = parabola
end
subsection Derived resonance-ratio
  set From = map
  set Operation = expression
  set Fields = f = resonance
  set Expression = f / (1 rad/s)
end
subsection Derived softest-peak
  set From = map
  set Operation = position of minimum
  set Field = peak
  set Along = stiffness
end
subsection Derived width
  set From = map
  set Operation = hysteresis width
  set Field = {FIELD}
  set Along = frequency
end
subsection Derived onset
  set From = map
  set Operation = crossing
  set Field = width
  set Along = spring
  set Level = 0.001 Hz
end
subsection Derived large
  set From = map
  set Operation = band
  set Field = upward
  set Along = frequency
  set Level = 1 m
end
subsection Derived jump
  set From = map
  set Operation = locus of jump
  set Field = upward
  set Along = frequency
  set Threshold = 0.2 m
end
subsection Derived lines
  set From = map
  set Operation = contour
  set Field = peak
  set Levels = 0.5 m, 1 m
end
"""
NAMES = ["upward", "peak", "resonance", "resonance-ratio", "softest-peak", "width",
         "onset", "large", "jump", "lines"]


class Derived(ProgramRuns):
    def setUp(self):
        super().setUp()
        self.file.write_text(FILE + DERIVED)

    def run_map(self, out, *arguments, ranks=1):
        return self.run_program(self.file, "--output", out, "--set", "Analyses=map", *arguments,
                                ranks=ranks)

    def test_ranks_give_the_same_bytes(self):
        whole = self.folder / "ranks1"
        for ranks in (1, 2, 3):
            out = self.folder / f"ranks{ranks}"
            done = self.run_map(out, ranks=ranks)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = datasets(out)
            for name in NAMES:
                self.assertIn(f"analysis/map/derived/{name}", found)
            self.assertEqual(found, datasets(whole))
            self.assertEqual((out / "summary.txt").read_text(),
                             (whole / "summary.txt").read_text())

    def test_quantities_agree_with_the_arrays(self):
        out = self.folder / "out"
        self.assertEqual(self.run_map(out).returncode, 0)
        with h5py.File(out / "results.h5") as file:
            analysis = file["analysis/map"]
            derived = analysis["derived"]
            upward = analysis[FIELD][:, :, :, 0]
            np.testing.assert_array_equal(derived["upward"], upward)
            np.testing.assert_array_equal(derived["peak"], upward.max(axis=2))
            np.testing.assert_allclose(derived["resonance-ratio"],
                                       2 * np.pi * derived["resonance"][:], rtol=1e-14)
            best = analysis["Variables.stiffness"][:][upward.max(axis=2).argmin(axis=1)]
            np.testing.assert_array_equal(derived["softest-peak"], best)
            attributes = derived["softest-peak"].attrs
            self.assertEqual(attributes["axis"], "Variables.stiffness")
            self.assertEqual(attributes["operation"], "position of minimum")
            self.assertEqual(derived["resonance-ratio"].attrs["unit"], "1")
            self.assertEqual([d.label for d in derived["peak"].dims],
                             ["Variables.gap", "Variables.stiffness"])
            np.testing.assert_array_equal(derived["peak"].dims[0][0], analysis["Variables.gap"])
            self.assertEqual([d.label for d in derived["large"].dims][2:],
                             ["interval_large", "bound"])
            self.assertEqual(derived["lines"].attrs["axes"], "Variables.gap Variables.stiffness")
            self.assertEqual(derived["lines"].shape[1], 3)
            # Without contact, in the last gap, nothing bends over; stiff bumpers bend it farthest.
            width = derived["width"][:]
            self.assertTrue((width[5] == 0).all() and width[2, 3] > width[2, 1])
            differs = np.abs(np.diff(analysis[FIELD][:], axis=3)[..., 0]) \
                > 0.01 * analysis[FIELD][:].max(axis=3)
            shares = np.gradient(analysis["frequency"][:])
            shares[[0, -1]] /= 2
            np.testing.assert_allclose(width, differs @ shares, rtol=1e-12)
            steps = np.abs(np.diff(upward, axis=2))
            middles = (analysis["frequency"][1:] + analysis["frequency"][:-1]) / 2
            jumps = np.where(steps.max(axis=2) > 0.2, middles[steps.argmax(axis=2)], np.nan)
            np.testing.assert_array_equal(derived["jump"], jumps)
        self.assertIn("analysis.map.derived.peak[6,4] = ", (out / "summary.txt").read_text())

    def test_a_field_that_is_not_there_is_told_and_costs_nothing_else(self):
        self.file.write_text((FILE + DERIVED).replace("= upward", "= downward", 1))
        for ranks in (1, 2):
            out = self.folder / f"ranks{ranks}"
            done = self.run_map(out, ranks=ranks)
            self.assertEqual(done.returncode, 1)
            self.assertIn("Derived peak / Field = downward", done.stderr)
            self.assertIn(FIELD, done.stderr)
            with h5py.File(out / "results.h5") as file:
                self.assertIn("resonance", file["analysis/map/derived"])
                self.assertNotIn("peak", file["analysis/map/derived"])
                self.assertEqual((file["analysis/map/status"][:] == 0).sum(), 6 * 4 * 30 * 2)


if __name__ == "__main__":
    main()
