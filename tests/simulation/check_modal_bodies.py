#!/usr/bin/python3
"""Bodies that are given by their modes: those a run has exported, against the bodies they came from;
modes with the errors of a test; and what the modes left out add, by residual flexibility.

usage: check_modal_bodies.py PROGRAM MPIEXEC
"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

PROGRAM = sys.argv[1]
MPIEXEC = sys.argv[2]

BEAM = """
subsection Body NAME
  subsection Geometry
    set Line = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m
    set Elements = 20
  end
  subsection Section
    set Shape = circle
    set Diameter = 20 mm
  end
  subsection Material
    set Young modulus = 210 GPa
    set Density = 7850 kg/m^3
  end
  subsection Support root
    set At = start
    set Fix = all
  end
  subsection Support plane
    set At = all
    set Fix = x, z, rx, ry
  end
  subsection Point tip
    set At = end
  end
  subsection Point middle
    set Position = 0.5 m, 0 m, 0 m
    set Mass = 0.2 kg
  end
  subsection Modes
    set Number = MODES
MORE  end
end
"""

GIVEN = """
subsection Body NAME
  set Type = modes
  subsection Modal data
    set File = FILE
MORE  end
POINTSend
"""

MOTION = """
subsection Contact stop
  set Between = NAME.tip, stop
  set Direction = -y
  set Clearance = 0.2 mm
  set Law = LAW
end
subsection Excitation push
  set Type = force
  set At = NAME.tip
  set Direction = -y
  set Amplitude = 40 N
  set History = constant
end
subsection Analysis push
  set Type = transient
  subsection Transient
    set Duration = 0.02 s
    set Sampling interval = 0.1 ms
  end
end
"""

SPRING = ("kelvin-voigt\n  subsection Kelvin-Voigt\n    set Stiffness = 1e6 N/m\n"
          "    set Damping constant = 20 N s/m\n  end")
BASE = """
subsection Excitation shake
  set Type = base acceleration
  set Direction = y
  set Amplitude = 30 m/s^2
  set Frequency = 20 Hz
end
"""


class Folder(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def run_text(self, name, text, ranks=1, succeeds=True):
        """The folder of results, and what was said."""
        (self.folder / f"{name}.prm").write_text(text)
        command = [PROGRAM, f"{name}.prm", "--output", name, "--overwrite"]
        if ranks > 1:
            command = [MPIEXEC, "-n", str(ranks)] + command
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode == 0, succeeds, said)
        return self.folder / name, said

    def beam(self, modes, more="", name="beam", ranks=1):
        text = BEAM.replace("MODES", str(modes)).replace("MORE", more).replace("NAME", name)
        return self.run_text(f"{name}-{modes}", text + self.motion(name, SPRING), ranks)[0]

    @staticmethod
    def motion(name, law):
        return MOTION.replace("NAME", name).replace("LAW", law)

    def given(self, file, more="", points="", name="beam"):
        return (GIVEN.replace("FILE", str(file)).replace("MORE", more).replace("POINTS", points)
                .replace("NAME", name))


def history(folder, name="beam"):
    with h5py.File(folder / "results.h5") as file:
        group = file["analysis/push"]
        found = {}
        group.visititems(lambda path, item: found.update({path: item[...]})
                         if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" else None)
    # Pulses are recorded at steps, whose places depend on rounding.
    return {path: values for path, values in found.items()
            if "/pulse/" not in path and ("displacement" in path or "velocity" in path
                                          or "/impact/" in path or path.endswith("normal_force"))}


def peak(folder):
    """Of the first impact."""
    with h5py.File(folder / "results.h5") as file:
        return float(file["analysis/push/contact/stop/impact/peak_force"][0])


class Exported(Folder):
    def compare(self, expected, folder, bound):
        one, other = history(expected), history(folder)
        self.assertEqual(set(one), set(other))
        self.assertTrue(any("impact" in path for path in one))
        for path in one:
            size = np.nanmax(np.abs(one[path]))
            own = bound
            # Force falls off with the square of the time from its peak: of its rounding, the time has the root.
            if path.endswith("peak_time"):
                own = np.sqrt(np.finfo(float).eps)
            # At a contact change the velocity bends, whose instant is known to 1e-12 s.
            if "velocity" in path and bound > 0:
                own = 10 * bound
            np.testing.assert_allclose(other[path], one[path], rtol=0, atol=own * size,
                                       err_msg=path)

    def test_the_results_of_a_run_give_the_same_impacts_on_any_number_of_ranks(self):
        original = self.beam(8, "    set Damping ratio = 0.01, 0.02\n    set Attachments = tip.y\n"
                                "    set Attachment damping ratio = 0.3\n")
        for ranks in (1, 2, 3):
            text = self.given(original / "results.h5") + self.motion("beam", SPRING)
            folder, said = self.run_text(f"again-{ranks}", text, ranks)
            self.compare(original, folder, 1e-15)
            self.assertNotIn("warning", said)

    def test_a_table_gives_the_same_impacts(self):
        original = self.beam(8, "    set Damping ratio = 0.01, 0.02\n")
        folder, said = self.run_text(
            "table", self.given(original / "modes/beam.csv") + self.motion("beam", SPRING))
        self.compare(original, folder, 1e-10)
        self.assertIn("nothing is known but that of the given modes: beam.tip", said)

    def test_dampers_that_couple_modes_are_kept(self):
        original = self.beam(6, "    set Damping model = viscous\n    set Viscous constant = 8 N s/m\n")
        with h5py.File(original / "results.h5") as file:
            damping = file["body/beam/damping"][...]
        self.assertGreater(np.abs(damping - np.diag(np.diag(damping))).max(), 0.01)
        folder, _ = self.run_text(
            "coupled", self.given(original / "results.h5") + self.motion("beam", SPRING))
        self.compare(original, folder, 1e-10)

    def test_the_base_moves_them_in_the_same_way(self):
        body = BEAM.replace("MODES", "6").replace("MORE", "").replace("NAME", "beam")
        original, _ = self.run_text("shaken", body + self.motion("beam", SPRING) + BASE)
        for file in ("results.h5", "modes/beam.csv"):
            folder, _ = self.run_text("shaken-again", self.given(original / file)
                                      + self.motion("beam", SPRING) + BASE)
            self.compare(original, folder, 1e-10)

    def test_an_export_of_an_export_is_the_same(self):
        original = self.beam(5)
        folder, _ = self.run_text("again",
                                  self.given(original / "results.h5") + self.motion("beam", SPRING))
        with h5py.File(original / "results.h5") as a, h5py.File(folder / "results.h5") as b:
            for name in a["body/beam"]:
                if a["body/beam"][name].dtype.kind == "f":
                    np.testing.assert_allclose(b["body/beam"][name][...], a["body/beam"][name][...],
                                               rtol=1e-12, atol=1e-14, err_msg=name)
        self.assertTrue((folder / "modes.pvd").exists())


def as_measured(source, target, modes, seed):
    """The first modes with the errors of a test: 0.2 % in frequencies, 2 % of the largest component
    in shapes, four digits; scaled to a unit largest component."""
    rows = [row for row in csv.reader(source.read_text().splitlines()) if not row[0].startswith("#")]
    heads = rows[0]
    values = np.array(rows[1:1 + modes], dtype=float)
    random = np.random.default_rng(seed)
    shapes = [i for i, head in enumerate(heads) if head.endswith(".y") and "participation" not in head]
    frequency, ratio, mass = (heads.index(name) for name in ("frequency", "damping ratio", "modal mass"))
    lines = ["mode,frequency,damping ratio,modal mass," + ",".join(heads[i] for i in shapes)]
    for j, row in enumerate(values):
        shape = row[shapes]
        size = np.abs(shape).max()
        noisy = shape + 0.02 * size * random.standard_normal(len(shape))
        largest = np.abs(noisy).max()
        lines.append(",".join([str(j + 1), f"{row[frequency] * (1 + 0.002 * random.standard_normal()):.4g}",
                               f"{row[ratio]:.3g}", f"{row[mass] / size**2:.4g}"]
                              + [f"{value / largest:.4g}" for value in noisy]))
    target.write_text("\n".join(lines) + "\n")


class Measured(Folder):
    SCALED = "    set Normalisation = unit largest component\n"

    def setUp(self):
        super().setUp()
        self.whole = self.beam(20, "    set Damping ratio = 0.01\n")
        self.table = self.folder / "measured.csv"
        with h5py.File(self.whole / "results.h5") as file:
            group = file["body/beam"]
            tip = [name.decode() for name in group["point"][...]].index("tip")
            self.flexibility = group["point_flexibility"][tip, 1, 1]
            self.kept = np.cumsum(group["point_rows"][tip, 1] ** 2 / group["stiffness"][...])

    def impact(self, name, more="", point=""):
        points = f"  subsection Point tip\n    set {point}\n  end\n" if point else ""
        return self.run_text(name, self.given(self.table, self.SCALED + more, points)
                             + self.motion("beam", SPRING))

    def test_residual_flexibility_mends_the_first_impact(self):
        attached = "    set Attachments = tip.y\n"
        for seed in range(3):
            as_measured(self.whole / "modes/beam.csv", self.table, 3, seed)
            plain, said = self.impact("plain")
            self.assertIn("nothing is known but that of the given modes: beam.tip (", said)
            # A tenth of it more, as a fit to measured receptances may give.
            residual = 1.1 * (self.flexibility - self.kept[2])
            mended, said = self.impact("mended", attached,
                                       f"Residual flexibility = 0 m/N, {residual} m/N, 0 m/N")
            self.assertNotIn("warning", said)
            errors = [peak(folder) / peak(self.whole) - 1 for folder in (plain, mended)]
            print(f"peak force {peak(self.whole):.4g} N; 3 modes as measured {errors[0]:+.1%}, "
                  f"with residual flexibility {errors[1]:+.1%}")
            self.assertLess(abs(errors[1]), abs(errors[0]) / 3)

    def test_a_static_test_says_how_much_is_missing(self):
        as_measured(self.whole / "modes/beam.csv", self.table, 1, 0)
        stiffness = f"Static stiffness = 0 N/m, {0.85 / self.flexibility} N/m, 0 N/m"
        _, said = self.impact("known", "", stiffness)
        self.assertIn("carry less of the static flexibility than Least flexibility share", said)
        self.assertNotIn("nothing is known", said)

    def test_a_difference_of_the_size_of_its_errors_is_named(self):
        as_measured(self.whole / "modes/beam.csv", self.table, 3, 0)
        stiffness = f"Static stiffness = 0 N/m, {0.96 / self.flexibility} N/m, 0 N/m"
        _, said = self.impact("small", "    set Attachments = tip.y\n", stiffness)
        self.assertIn("of the static flexibility at tip.y", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
