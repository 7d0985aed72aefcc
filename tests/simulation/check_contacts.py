#!/usr/bin/python3
"""Many contacts in whole runs: what stands in the result files, the fields for ParaView, and the
same answer on one, two and three ranks.

usage: check_contacts.py PROGRAM MPIEXEC
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from vtu_arrays import vtu_arrays  # noqa: E402

PROGRAM, MPIEXEC = sys.argv[1:3]

PLATE = """
subsection Body plate
  set Type = shell
  subsection Geometry
    set Plate     = 0 m, 0 m, 0 m -> 0.6 m, 0 m, 0 m -> 0 m, 0.4 m, 0 m
    set Divisions = 6, 4
  end
  subsection Material
    set Young modulus = 200 GPa
    set Density       = 7800 kg/m^3
  end
  subsection Shell sheet
    set Thickness = 3 mm
  end
  subsection Support plane
    set At  = all
    set Fix = x, y, rz
  end
  subsection Support edges
    set At  = edges
    set Fix = z
  end
  subsection Interface stops
    set Near = 0.2 m, 0.1 m, 0 m, 0.3 m, 0.2 m, 0 m, 0.5 m, 0.3 m, 0 m
  end
  subsection Modes
    set Number        = 4
    set Damping ratio = 0.02
  end
end
subsection Contact stops
  set Between            = plate.stops, base
  set Pairing            = stops
  set Direction          = -z
  set Clearance          = 0.2 mm
  set Stiffness fraction = 3
end
subsection Excitation table
  set Type      = base acceleration
  set Direction = z
  set Amplitude = 20 m/s^2
  set Frequency = 60 Hz
end
subsection Analysis rattle
  set Type = transient
  subsection Transient
    set Duration          = 0.06 s
    set Sampling interval = 0.5 ms
    set Frames            = 121
  end
end
"""
NODES = {"stops.1": (0.2, 0.1, 0), "stops.2": (0.3, 0.2, 0), "stops.3": (0.5, 0.3, 0)}


class ManyContacts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        (cls.path / "plate.prm").write_text(PLATE, encoding="utf-8")
        cls.output = {ranks: cls.run_on(ranks) for ranks in (1, 2, 3)}
        cls.results = h5py.File(cls.path / "out-1" / "results.h5")
        cls.analysis = cls.results["analysis/rattle"]

    @classmethod
    def tearDownClass(cls):
        cls.results.close()
        cls.folder.cleanup()

    @classmethod
    def run_on(cls, ranks):
        launcher = [] if ranks == 1 else [MPIEXEC, "-n", str(ranks)]
        done = subprocess.run([*launcher, PROGRAM, str(cls.path / "plate.prm"), "--output",
                               str(cls.path / f"out-{ranks}")],
                              capture_output=True, text=True, check=False)
        if done.returncode:
            raise AssertionError(done.stdout + done.stderr)
        return done.stdout + done.stderr

    def force(self, name):
        return self.analysis[f"contact/{name}/normal_force"][:]

    def summary(self, name):
        text = (self.path / "out-1" / "summary.txt").read_text(encoding="utf-8")
        return float(re.search(rf"^{re.escape(name)} = (\S+) ", text, re.MULTILINE).group(1))

    def test_contacts_of_the_model(self):
        names = [name.decode() for name in self.results["contact/contact"][:]]
        self.assertEqual(names, list(NODES))
        np.testing.assert_array_equal(self.results["contact/clearance"][:], 2e-4)

    def test_share_of_flexibility_by_hand(self):
        # Kept modes have mass 1: sum of phi^2 / omega^2 at the node. The whole flexibility is what
        # the stiffness of the contacts is three times the inverse of.
        body = self.results["body/plate"]
        points = [name.decode() for name in body["point"][:]]
        stiffness = body["stiffness"][:]
        for c, name in enumerate(NODES):
            row = body["point_rows"][points.index(name), 2]
            kept = np.sum(row**2 / stiffness)
            force, gap = self.force(name), self.analysis[f"contact/{name}/gap"][:]
            closed = force > 0.1 * force.max()
            if not closed.any():
                continue
            whole = 3 / np.mean(-force[closed] / gap[closed])
            share = self.results["contact/flexibility_share"][c]
            self.assertAlmostEqual(share, kept / whole, delta=1e-6)
            self.assertAlmostEqual(share, self.summary(f"contact.{name}.flexibility_share"),
                                   delta=1e-10)

    def test_impact_error_of_the_contacts(self):
        body = self.results["body/plate"]
        points = [name.decode() for name in body["point"][:]]
        for c, name in enumerate(NODES):
            row = np.abs(body["point_rows"][points.index(name), 2])
            highest = body["frequency"][:][row > 1e-6 * row.max()].max()
            self.assertAlmostEqual(self.results["contact/shortest_period"][c] * highest, 1)
            error = self.results["contact/impact_error"][c]
            self.assertGreater(error, 0)
            self.assertAlmostEqual(error, self.summary(f"contact.{name}.impact_error"), delta=1e-10)

    def test_one_warning_names_the_contacts(self):
        for output in self.output.values():
            lines = [line for line in output.splitlines() if "static flexibility" in line]
            self.assertEqual(len(lines), 1, output)
            self.assertIn("warning", lines[0])
            shares = self.results["contact/flexibility_share"][:]
            for name, share in zip(NODES, shares):
                named = f"{name} ({np.floor(1000 * share) / 10:g} %)" in lines[0]
                self.assertEqual(named, bool(share < 0.9), lines[0])

    def test_group_sums(self):
        impacts = [self.analysis[f"contact/{name}/impact/peak_force"][:] for name in NODES]
        self.assertGreater(sum(len(i) for i in impacts), 3)
        self.assertEqual(self.summary("analysis.rattle.group.stops.impacts"),
                         sum(len(i) for i in impacts))
        self.assertEqual(self.summary("analysis.rattle.group.stops.contacts"), 3)
        self.assertAlmostEqual(self.summary("analysis.rattle.group.stops.peak_force"),
                               max(i.max() for i in impacts if len(i)), delta=1e-6)

    def test_fields_on_the_mesh(self):
        time = self.analysis["time"][:]
        forces = {name: self.force(name) for name in NODES}
        seen = set()
        peak = np.zeros(3)
        for frame in range(len(time)):
            arrays = vtu_arrays(self.path / "out-1" / "rattle" / f"frame-{frame + 1:05d}.vtu")
            places = arrays["Points"]
            pushed = np.zeros(len(places), bool)
            for c, (name, node) in enumerate(NODES.items()):
                at = np.linalg.norm(places - np.array(node), axis=1) < 1e-6
                self.assertEqual(at.sum(), 4)
                pushed |= at
                # The plate lies above: the stop pushes it up.
                np.testing.assert_allclose(arrays["contact_force"][at, 2], forces[name][frame],
                                           rtol=1e-5, atol=1e-6 * forces[name].max())
                np.testing.assert_allclose(arrays["contact_gap"][at],
                                           self.analysis[f"contact/{name}/gap"][frame], rtol=1e-5,
                                           atol=1e-12)
                now = arrays["peak_contact_force"][at].max()
                self.assertGreaterEqual(now, peak[c])
                self.assertGreaterEqual(now * (1 + 1e-6), forces[name][:frame + 1].max())
                peak[c] = now
                if forces[name][frame] > 0:
                    seen.add(name)
            for field in ("contact_force", "contact_gap", "peak_contact_force"):
                self.assertEqual(np.abs(arrays[field][~pushed]).max(), 0)
        self.assertGreaterEqual(len(seen), 2)

    def test_every_number_of_ranks_gives_the_same(self):
        for ranks in (2, 3):
            with h5py.File(self.path / f"out-{ranks}" / "results.h5") as other:
                for name in NODES:
                    expected = self.analysis[f"contact/{name}/gap"][:]
                    np.testing.assert_allclose(
                        other[f"analysis/rattle/contact/{name}/gap"][:], expected,
                        atol=1e-6 * np.abs(expected).max())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
