#!/usr/bin/python3
"""Bodies from matrices in whole runs: the shipped bar against a dense eigen-solution of the same files and against the
same bar of beam elements, on one to three ranks; and against CalculiX itself where it is installed (ccx).

usage: check_given.py PROGRAM MPIEXEC
"""
import pathlib
import re
import shutil
import subprocess
import unittest

import h5py
import numpy as np
from scipy import linalg

from program_runs import ProgramRuns, main

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BAR = (SOURCE / "params" / "bent-bar.prm").read_text(encoding="utf-8").replace("../meshes", str(SOURCE / "meshes"))

# 14 digits, as CalculiX writes them.
LAST_DIGIT = 13

BEAM = """subsection Body bar
  set Type = beam
  subsection Geometry
    set Mesh = bar.msh
    set Orientation = 0, 1, 0
  end
  subsection Section
    set Shape = given
    set Area = 100 mm^2
    set Second moment y = 833.3333333 mm^4
    set Second moment z = 833.3333333 mm^4
    set Torsion constant = 1666.666667 mm^4
  end
  subsection Material
    set Young modulus = 210 GPa
    set Poisson ratio = 0.3
    set Density = 7800 kg/m^3
  end
  subsection Support foot
    set Position = 0 m, 0 m, 0 m
    set Fix = all
  end
  subsection Point tip
    set Position = 0.5 m, 0 m, 0.3 m
  end
"""

DECK_END = """*MATERIAL, NAME=STEEL
*ELASTIC
2.1E11, 0.3
*DENSITY
7800
{section}
*BOUNDARY
ROOT, 1, {last}
*STEP
*FREQUENCY, {how}
*END STEP
"""

MODES_OF_DECK = """set Analyses = modes
subsection Body body
  set Type = matrices
  subsection Geometry
    set Mesh = deck.inp
  end
  subsection Matrices
    set Stiffness = deck.sti
    set Mass = deck.mas
    set Table = deck.dof
  end
  subsection Modes
    set Number = 6
  end
end
subsection Analysis modes
  set Type = modal
end
"""


def symmetric(file, size):
    rows, columns, values = np.loadtxt(file, unpack=True)
    matrix = np.zeros((size, size))
    matrix[rows.astype(int) - 1, columns.astype(int) - 1] = values
    return matrix + np.triu(matrix, 1).T


def half_unit(matrix):
    """Of the last digit of each entry that is not 0."""
    return np.where(matrix == 0, 0, 0.5 * 10.0 ** (np.floor(np.log10(np.abs(matrix) + 1e-300)) - LAST_DIGIT))


def lowest(stiffness, mass, number):
    """Frequencies; the mass may be singular. The stiffness must be regular."""
    values = linalg.eigh(mass, stiffness, eigvals_only=True)[::-1][:number]
    return np.sqrt(1 / values) / (2 * np.pi)


def solid_deck(elements=(4, 2, 1), sides=(0.08, 0.04, 0.03)):
    """A block of quadratic bricks, clamped at x = 0."""
    numbers = {}
    lines = []
    corners = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    places = corners + [tuple((corners[a][i] + corners[b][i]) // 2 for i in range(3)) for a, b in edges]
    for cell in np.ndindex(*elements):
        nodes = [numbers.setdefault(tuple(2 * c + p for c, p in zip(cell, place)), len(numbers) + 1)
                 for place in places]
        lines.append(f"{len(lines) + 1}, " + ", ".join(map(str, nodes[:10])) + ",\n" + ", ".join(map(str, nodes[10:])))
    return deck_text(numbers, [s / (2 * n) for s, n in zip(sides, elements)], "C3D20", lines)


def plate_deck(elements=(4, 2), sides=(0.2, 0.1)):
    """A plate of quadratic shells, clamped at x = 0."""
    numbers = {}
    lines = []
    places = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
    for cell in np.ndindex(*elements):
        nodes = [numbers.setdefault(tuple(2 * c + p for c, p in zip(cell, place)) + (0,), len(numbers) + 1)
                 for place in places]
        lines.append(f"{len(lines) + 1}, " + ", ".join(map(str, nodes)))
    return deck_text(numbers, [s / (2 * n) for s, n in zip(sides, elements)] + [0], "S8R", lines)


def frame_deck(elements=4, height=0.3, length=0.5):
    """An upright and a beam of quadratic beams, clamped at its foot."""
    numbers = {(0, 0, i): i + 1 for i in range(2 * elements + 1)}
    numbers |= {(i, 0, 2 * elements): 2 * elements + 1 + i for i in range(1, 2 * elements + 1)}
    lines = [f"{e + 1}, {2 * e + 1}, {2 * e + 2}, {2 * e + 3}" for e in range(2 * elements)]
    text = deck_text(numbers, [length / (2 * elements), 0, height / (2 * elements)], "B32R", lines)
    return re.sub(r"(NSET=ROOT\n)(\d+\n)+", r"\g<1>1\n", text)


def deck_text(numbers, steps, kind, elements):
    text = "*NODE, NSET=ALL\n"
    for place, number in numbers.items():
        text += f"{number}, " + ", ".join(f"{p * s:.10g}" for p, s in zip(place, steps)) + "\n"
    text += f"*ELEMENT, TYPE={kind}, ELSET=BODY\n" + "\n".join(elements) + "\n*NSET, NSET=ROOT\n"
    return text + "".join(f"{number}\n" for place, number in numbers.items() if place[0] == 0)


class ShippedBar(ProgramRuns):
    def frequencies(self, out):
        with h5py.File(out / "results.h5") as file:
            return file["body/bar/frequency"][()]

    def impact(self, out):
        summary = (out / "summary.txt").read_text(encoding="utf-8")
        return {key: float(value) for key, value in
                re.findall(r"shaking\.contact\.stop\.impact\[1\]\.(\w+) = (\S+)", summary)}

    def run_bar(self, text, name, ranks=1):
        self.file.write_text(text, encoding="utf-8")
        out = self.folder / name
        done = self.run_program(self.file, "--output", out, ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return out

    def test_frequencies_are_those_of_the_files(self):
        out = self.run_bar(BAR, "given")
        table = (SOURCE / "meshes" / "bent-bar.dof").read_text(encoding="utf-8").split()
        free = np.array([not row.startswith("1.") for row in table])
        # To SI: t/s^2 = 1000 N/m, t = 1000 kg for displacements; the two rotations of the knee are
        # rows of nodes of their own and scaled alike in both.
        matrices = [symmetric(SOURCE / "meshes" / f"bent-bar.{end}", len(table))[np.ix_(free, free)]
                    for end in ("sti", "mas")]
        # The dense solution has an error of round-off times the condition of K, 1e-16 1e8.
        np.testing.assert_allclose(self.frequencies(out)[:6], lowest(*matrices, 6), rtol=1e-6)

    def test_it_is_the_bar_of_beam_elements(self):
        nodes = [(0, 0, 0.3 * i / 12) for i in range(13)] + [(0.5 * i / 20, 0, 0.3) for i in range(1, 21)]
        (self.folder / "bar.msh").write_text(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + f"{len(nodes)}\n"
            + "".join(f"{i + 1} {x} {y} {z}\n" for i, (x, y, z) in enumerate(nodes))
            + f"$EndNodes\n$Elements\n{len(nodes) - 1}\n"
            + "".join(f"{i} 1 2 1 1 {i} {i + 1}\n" for i in range(1, len(nodes))) + "$EndElements\n", encoding="utf-8")
        given = self.run_bar(BAR, "given")
        body = BAR[BAR.index("subsection Body"):BAR.index("  subsection Modes")]
        beams = self.run_bar(BAR.replace(body, BEAM), "beams")
        # Two quadratic elements for a side are too stiff by 1 %. CalculiX makes the knee rigid over half a thickness,
        # 1.7 and 1 % of the sides, and frequencies go with the square of these. The section of a single brick does
        # not warp: its torsion constant is the polar moment of area, which the beams are given too.
        np.testing.assert_allclose(self.frequencies(given)[:2], self.frequencies(beams)[:2], rtol=0.035)
        first, other = self.impact(given), self.impact(beams)
        self.assertAlmostEqual(first["time"] / other["time"], 1, delta=0.02)
        self.assertAlmostEqual(first["approach_speed"] / other["approach_speed"], 1, delta=0.05)

    def test_ranks_and_resumed_runs_agree(self):
        outs = [self.run_bar(BAR, f"ranks{ranks}", ranks) for ranks in (1, 2, 3)]
        for out in outs[1:]:
            np.testing.assert_allclose(self.frequencies(out), self.frequencies(outs[0]), rtol=1e-8)
            for key, value in self.impact(outs[0]).items():
                self.assertAlmostEqual(self.impact(out)[key], value, delta=1e-6 * abs(value), msg=key)
        shutil.rmtree(outs[0] / "journal")
        done = self.run_program("--resume", outs[0])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        np.testing.assert_allclose(self.frequencies(outs[0]), self.frequencies(outs[1]), rtol=1e-8)


@unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx, Debian package calculix-ccx) is not installed")
class CalculiX(ProgramRuns):
    def compare(self, deck, section, last):
        for name, how in (("deck", "SOLVER=MATRIXSTORAGE"), ("own", "STORAGE=YES\n6")):
            (self.folder / f"{name}.inp").write_text(deck + DECK_END.format(section=section, last=last, how=how),
                                                     encoding="utf-8")
            subprocess.run(["ccx", name], cwd=self.folder, capture_output=True, check=True)
        self.file.write_text(MODES_OF_DECK, encoding="utf-8")
        done = self.run_program(self.file, "--output", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with h5py.File(self.folder / "out" / "results.h5") as file:
            made = file["body/body/frequency"][()]
        # Behind a header of 16 bytes stand the eigenvalues in full.
        values = np.frombuffer((self.folder / "own.eig").read_bytes()[16:16 + 8 * 6])
        return made / (np.sqrt(values) / (2 * np.pi)) - 1

    def digits(self):
        """Bound of what half a unit in the last digit of each entry of K and M makes of the frequencies, relative, to
        first order: |phi|^T (dK + lambda dM) |phi| / 2 lambda."""
        size = len((self.folder / "deck.dof").read_text(encoding="utf-8").split())
        stiffness, mass = (symmetric(self.folder / f"deck.{end}", size) for end in ("sti", "mas"))
        values, shapes = linalg.eigh(mass, stiffness)
        bounds = []
        for value, shape in zip(values[::-1][:6], shapes.T[::-1][:6]):
            shape = np.abs(shape) / np.sqrt(value)
            bounds.append(shape @ (half_unit(stiffness) * value + half_unit(mass)) @ shape / 2)
        return np.array(bounds)

    def test_a_block_has_the_frequencies_of_calculix(self):
        errors = self.compare(solid_deck(), "*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL", 3)
        np.testing.assert_array_less(np.abs(errors), 1e-8)

    # CalculiX makes solids of shells and beams, whose stiff parts hide the soft ones from 14 digits.
    def test_a_plate_has_them_as_far_as_its_digits_tell(self):
        errors = self.compare(plate_deck(), "*SHELL SECTION, ELSET=BODY, MATERIAL=STEEL\n0.002", 6)
        np.testing.assert_array_less(np.abs(errors), 1e-8 + self.digits())

    def test_a_frame_has_them_as_far_as_its_digits_tell(self):
        errors = self.compare(frame_deck(), "*BEAM SECTION, ELSET=BODY, MATERIAL=STEEL, SECTION=RECT\n0.01, 0.01\n"
                              "0, 1, 0", 6)
        np.testing.assert_array_less(np.abs(errors), 1e-8 + self.digits())


if __name__ == "__main__":
    main()
