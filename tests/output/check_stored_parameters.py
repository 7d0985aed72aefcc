"""What the figures read of the parameters that a run stored: check_stored_parameters.py POSTPROCESS"""

import sys
import unittest
from pathlib import Path

POSTPROCESS = Path(sys.argv[1]).resolve()
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path.insert(0, str(POSTPROCESS))

from vibroimpact.plots import parameters_text  # noqa: E402


class StoredParameters(unittest.TestCase):
    def test_a_mirrored_contact_has_the_sides_of_its_section_and_the_opposite_direction(self):
        parameters = parameters_text.sections("subsection Contact right\n  set Between = a.b, stop\n"
                                              "  set Direction = -y\n  set Mirrored as = left\nend\n")
        for contact, sign in (("right", -1), ("left", 1)):
            self.assertEqual(parameters_text.contact_sides(parameters, contact), ["a.b"])
            self.assertEqual(parameters_text.direction_of(parameters, contact), ("y", sign))

    def test_the_columns_of_a_table_behind_the_first_change_with_it(self):
        parameters = parameters_text.sections("subsection Analysis a\n  subsection Parameter grid\n"
                                              "    set Cases = Variables/k [N/m], Variables/b [rad/s],"
                                              " Variables/c; \\\n  1, 2, 3; 4, 5, 6;\n  end\nend\n")
        self.assertEqual(parameters_text.followers(parameters, "a", "Variables/k"),
                         [("Variables/b", ["2 rad/s", "5 rad/s"]), ("Variables/c", ["3", "6"])])


if __name__ == "__main__":
    unittest.main()
