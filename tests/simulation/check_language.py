#!/usr/bin/python3
"""Files in other words that say the same give the same results, byte for byte.

usage: check_language.py PROGRAM MPIEXEC
"""
import re

import h5py
import numpy

from program_runs import ProgramRuns, datasets, main

MODEL = """
set Variables = gap = 1 mm, k = 2 kN/m
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 1 kg
    set Stiffness = 1 kN/m
    set Damping = 3 N s/m
  end
end
{contacts}
subsection Excitation shaker
  set Type = force
  set At = block.head
  set Amplitude = 5 N
  set Frequency = 5 Hz
end
subsection Analysis motion
  set Type = steady state
  {motion}
  subsection Steady state
    set Settling cycles = 30
    set Recorded cycles = 2
  end
end
"""
RIGHT = """subsection Contact right
  set Between = block.head, stop
  set Clearance = gap
  {mirror}
  subsection Linear penalty
    set Stiffness = k
  end
end
"""
LEFT = RIGHT.replace("Contact right", "Contact left").format(mirror="set Direction = -x")
BOTH = RIGHT.format(mirror="set Mirrored as = left")
PLAIN = """
set Variables = w = 1.5, delta = 0.3
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 1 {kg}
    set Stiffness = 1 {N/m}
    set Damping = 0.1 {N s/m}
  end
end
subsection Contact right
  set Between = block.head, stop
  set Clearance = delta {m}
  set Law = kelvin-voigt
  subsection Kelvin-Voigt
    set Stiffness = 20 {N/m}
    set Damping constant = 0.2 {N s/m}
  end
end
subsection Excitation push
  set Type = force
  set At = block.head
  set Amplitude = 0.5 {N}
  set Frequency = w {rad/s}
end
subsection Analysis curve
  set Type = stepped sweep
  set Record = extreme values, impacts, history, spectrum
  subsection Stepped sweep
    set First frequency = 0.7 {rad/s}
    set Last frequency = 1.9 {rad/s}
    set Points = 5
    set Settling cycles = 30
  end
end
subsection Analysis modes
  set Type = modal
end
subsection Derived resonance
  set From = curve
  set Operation = position of maximum
  set Field = point/block.head/displacement_x/largest
  set Along = frequency
end
subsection Derived ratio
  set From = curve
  set Operation = expression
  set Fields = f = frequency
  set Expression = f / (w {rad/s})
end
"""
GRID = """
subsection Analysis cases
  set Type = parameter grid
  {cases}
  subsection Parameter grid
    set Repeat = motion
    {grid}
  end
end
"""
KEYS = """subsection Key k
      set Path = Variables/k
      set Values = 2 kN/m, 4 kN/m, 5 kN/m
    end
    subsection Key gap
      set Tied to = k
      set Path = Variables/gap
      set Values = 1 mm, 0.5 mm, 0.3 mm
    end
    {more}"""
CASES = "set Cases = Variables/k [kN/m], Variables/gap [mm]; 2, 1; 4, 0.5; 5, 0.6 / 2"


def model(contacts=BOTH, motion="", grid=""):
    return MODEL.format(contacts=contacts, motion=motion) + grid


class OneSystemInOtherWords(ProgramRuns):
    def results(self, text, name, *arguments):
        self.file.write_text(text)
        done = self.run_program(self.file, "--output", name, *arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return datasets(self.folder / name)

    def test_a_mirrored_contact_is_the_second_section_written_out(self):
        out = self.results(model(RIGHT.format(mirror="") + LEFT), "two")
        self.assertEqual(self.results(model(), "one"), out)
        self.assertIn("analysis/motion/contact/left/normal_force/maximum", out)

    def test_a_key_of_the_section_changes_both_contacts(self):
        change = ["--set", "Contact/right/Clearance=0.8 mm"]
        both = self.results(model(RIGHT.format(mirror="") + LEFT), "two", *change, "--set",
                            "Contact/left/Clearance=0.8 mm")
        self.assertEqual(self.results(model(), "one", *change), both)

    def test_a_mirrored_contact_can_be_chosen_alone(self):
        alone = self.results(model(LEFT), "alone")
        chosen = self.results(model(motion="set Active contacts = left"), "chosen")
        self.assertEqual(chosen, alone)

    def test_like_is_the_section_written_out(self):
        left = "subsection Contact left\n  set Like = right\n  set Direction = -x\nend\n"
        written = self.results(model(RIGHT.format(mirror="") + LEFT), "written")
        self.assertEqual(self.results(model(left + RIGHT.format(mirror="")), "like").keys(),
                         written.keys())
        self.assertEqual(self.results(model(RIGHT.format(mirror="") + left), "same"), written)

    def test_values_of_one_analysis_are_overrides(self):
        values = ["Variables/gap=0.4 mm", "Contact/right/Linear penalty/Stiffness=3 kN/m",
                  "Analysis/motion/Steady state/Recorded cycles=3", "Body/block/Mass/head/Mass=2 kg"]
        sets = [word for value in values for word in ("--set", value)]
        overridden = self.results(model(), "set", *sets)
        inside = self.results(model(motion="set With = " + ", ".join(values)), "with")
        bodies = [path for path in inside if path.startswith("body/")]
        self.assertNotEqual({path: inside[path] for path in bodies},
                            {path: overridden[path] for path in bodies})
        for path in overridden:
            if not path.startswith(("body/", "contact/")):
                self.assertEqual(inside[path], overridden[path], path)

    def test_other_analyses_do_not_see_them(self):
        second = MODEL[MODEL.index("subsection Analysis motion"):].replace("motion", "second", 1)
        both = self.results(model() + second.format(motion="set With = Variables/gap = 0.4 mm"),
                            "both")
        plain = self.results(model(), "plain")
        self.assertEqual({path: both[path] for path in plain}, plain)
        field = "contact/right/gap/minimum"
        self.assertNotEqual(both["analysis/second/" + field], both["analysis/motion/" + field])

    def test_a_list_goes_on_behind_its_commas(self):
        one = self.results(model(motion="set With = Analysis/motion/Record = extreme values, impacts, "
                                        "Variables/gap = 1 mm"), "one")
        self.assertEqual(one, self.results(model(motion="set Record = extreme values, impacts"), "two"))

    def test_cases_are_tied_keys(self):
        keys = self.results(model(grid=GRID.format(cases="", grid=KEYS.format(more=""))), "keys")
        cases = self.results(model(grid=GRID.format(cases="", grid=CASES)), "cases")
        self.assertEqual(cases, keys)

    def test_cases_in_a_file_stay_with_the_results(self):
        keys = self.results(model(grid=GRID.format(cases="", grid=CASES)), "inline")
        table = self.folder / "table.csv"
        table.write_text("# measured\nVariables/k [kN/m], Variables/gap [mm]\n2, 1\n\n4, 0.5\n"
                         "5, 0.6 / 2 # last\n")
        file = self.results(model(grid=GRID.format(cases="", grid="set Cases = table.csv")), "file")
        self.assertEqual(file, keys)
        table.unlink()
        for arguments in ([self.folder / "file/parameters.prm", "--output", "again"],
                          ["--resume", "file"]):
            done = self.run_program(*arguments)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(datasets(self.folder / "again"), keys)
        self.assertEqual(datasets(self.folder / "file"), keys)

    def test_values_of_a_grid_are_equal_values_of_a_tied_key(self):
        tied = """subsection Key mass
      set Tied to = k
      set Path = Body/block/Mass/head/Mass
      set Values = 2 kg, 2 kg, 2 kg
    end"""
        keys = self.results(model(grid=GRID.format(cases="", grid=KEYS.format(more=tied))), "keys")
        constant = GRID.format(cases="set With = Body/block/Mass/head/Mass = 2 kg",
                               grid=KEYS.format(more=""))
        self.assertEqual(self.results(model(grid=constant), "with"), keys)

    def test_the_same_bytes_on_any_ranks_and_after_a_kill(self):
        self.file.write_text(model(grid=GRID.format(
            cases="set With = Variables/gap = 0.6 mm, Analysis/motion/Steady state/Settling cycles = "
                  "3000, Analysis/motion/Steady state/Settling method = transient",
            grid="set Cases = Variables/k [kN/m]; " + "; ".join(str(2 + i) for i in range(12)))))
        self.expect_same_bytes()


def with_units(text):
    """`{N}` as `* 1 N`, or without units."""
    return re.sub(r"\s*\{([^}]*)\}", r" * 1 \1", text)


class WithoutUnits(ProgramRuns):
    def test_the_results_are_those_in_si_without_units_and_with_angular_frequencies(self):
        texts = {"SI": with_units(PLAIN),
                 "plain": "set Units = dimensionless\n" + re.sub(r"\s*\{[^}]*\}", "", PLAIN)}
        printed = {}
        for name, text in texts.items():
            self.file.write_text(text)
            done = self.run_program(self.file, "--output", name)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            printed[name] = self.run_program(self.file, "--check").stdout
        self.assertIn("from 0.159155 Hz", printed["SI"])
        self.assertIn("from 1 to 1,", printed["plain"])
        self.compare_datasets()
        summary = (self.folder / "plain/summary.txt").read_text()
        self.assertIn("body.block.frequency[1] = 1 [1]", summary)
        self.assertEqual(set(re.findall(r" = \S+ \[(.*?)\]", summary)), {"1"})
        for arguments in ([self.folder / "plain/parameters.prm", "--output", "again"],
                          ["--resume", "plain"]):
            done = self.run_program(*arguments)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(datasets(self.folder / "again"), datasets(self.folder / "plain"))

    def compare_datasets(self):
        found = set()
        with h5py.File(self.folder / "SI/results.h5") as si, \
                h5py.File(self.folder / "plain/results.h5") as plain:
            def compare(name, item):
                if not isinstance(item, h5py.Dataset):
                    return
                other, unit = plain[name], str(item.attrs["unit"])
                found.add(unit)
                self.assertEqual(str(other.attrs["unit"]), "1", name)
                self.assertNotIn("[", other.attrs["description"], name)
                if unit == "Hz":
                    numpy.testing.assert_allclose(other[()], 2 * numpy.pi * item[()], rtol=4e-16)
                else:
                    ours, theirs = numpy.asarray(other[()]), numpy.asarray(item[()])
                    texts = theirs.dtype == object
                    self.assertEqual(ours.tolist() if texts else ours.tobytes(),
                                     theirs.tolist() if texts else theirs.tobytes(), name)
            si.visititems(compare)
            self.assertIn("angular", plain["analysis/curve/frequency"].attrs["description"])
        self.assertTrue({"Hz", "m", "N", "s", "kg", "N/m", "1"} <= found, found)


if __name__ == "__main__":
    main()
