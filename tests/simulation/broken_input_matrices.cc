// Bodies from matrices that cannot be used as given: what the message says in a whole file.
#include "support/broken_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_matrices_tests {

using testing::changed;
using testing::expect_messages;

const std::string meshes = std::string(VIBROIMPACT_SOURCE_DIR) + "/meshes/bent-bar";

const std::string sound = "set Analyses = shapes\n"
                          "subsection Body bar\n"
                          "  set Type = matrices\n"
                          "  subsection Geometry\n"
                          "    set Mesh = " +
                          meshes +
                          ".inp\n"
                          "  end\n"
                          "  subsection Matrices\n"
                          "    set Stiffness = " +
                          meshes +
                          ".sti\n"
                          "    set Mass = " +
                          meshes +
                          ".mas\n"
                          "    set Table = " +
                          meshes +
                          ".dof\n"
                          "    set Unit system = mm t s\n"
                          "  end\n"
                          "  subsection Support foot\n"
                          "    set At = FOOT\n"
                          "    set Fix = all\n"
                          "  end\n"
                          "  subsection Point tip\n"
                          "    set Node = 9\n"
                          "  end\n"
                          "  subsection Modes\n"
                          "    set Number = 2\n"
                          "  end\n"
                          "end\n"
                          "subsection Analysis shapes\n"
                          "  set Type = modal\n"
                          "end\n";

TEST(BrokenInputMatricesTest, MessagesNameTheKeyAndWhatIsAllowed) {
  const std::string modes = "  subsection Modes\n";
  const std::vector<testing::BrokenFile> cases = {
      {"no mass", "    set Mass = " + meshes + ".mas\n", "", {"Mass", "must be given"}},
      {"no file", "bent-bar.sti", "nowhere.sti", {"Stiffness", "there is none at", "nowhere.sti"}},
      {"no table", "bent-bar.dof", "nowhere.dof", {"Table", "there is none at", "nowhere.dof"}},
      {"another table", "bent-bar.dof", "bent-bar.sti", {"Table", "line 1 of bent-bar.sti"}},
      {"another matrix", "bent-bar.sti", "bent-bar.dof", {"Stiffness", "line 1 of bent-bar.dof"}},
      {"another mesh", "bent-bar.inp", "portal-frame.msh", {"Mesh", "input deck with nodes"}},
      {"unknown units", "mm t s", "mm g s", {"Unit system", "mm kg ms"}},
      {"unknown node", "Node = 9", "Node = 10", {"Point tip", "Node", "they go from 1 to 9"}},
      {"node 0", "Node = 9", "Node = 0", {"Node"}},
      {"two places", "Node = 9", "Node = 9\n    set At = TIP", {"only one of"}},
      {"unknown set", "At = FOOT", "At = foot", {"Support foot", "At", "FOOT"}},
      {"a line",
       "    set Mesh = ",
       "    set Elements = 3\n    set Mesh = ",
       {"Elements", "must not be set when Type = matrices"}},
      {"divisions",
       "    set Mesh = ",
       "    set Divisions = 3, 3\n    set Mesh = ",
       {"Divisions", "must not be set when Type = matrices"}},
      {"a material",
       modes,
       "  subsection Material\n    set Density = 3 kg/m^3\n  end\n" + modes,
       {"when there is a subsection Material"}},
      {"viscous damping",
       "set Number = 2",
       "set Damping model = viscous\n    set Viscous constant = 1 N s/m",
       {"Damping model", "must not be viscous when Type = matrices"}},
      {"too many modes", "Number = 2", "Number = 1000", {"Number", "must not exceed"}},
      {"another type", "Type = matrices", "Type = shell", {"when there is a subsection Matrices"}}};
  expect_messages(sound, cases);
}

TEST(BrokenInputMatricesTest, GivenDampingIsTheOnlyOne) {
  const std::string damped =
      changed(sound, "    set Unit", "    set Damping = " + meshes + ".mas\n    set Unit");
  expect_messages(damped, {{"two dampings",
                            "Number = 2",
                            "Number = 2\n    set Damping ratio = 0.1",
                            {"Damping ratio", "must not be set when Matrices / Damping is set"}}});
}

TEST(BrokenInputMatricesTest, ANodeByNumberNeedsNumberedNodes) {
  const std::string beam = "set Analyses = shapes\nsubsection Body bar\n  subsection Geometry\n"
                           "    set Line = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m\n  end\n"
                           "  subsection Section\n    set Width = 10 mm\n"
                           "    set Thickness = 10 mm\n  end\n  subsection Material\n"
                           "    set Young modulus = 200 GPa\n    set Density = 8000 kg/m^3\n  end\n"
                           "  subsection Point tip\n    set At = end\n  end\nend\n"
                           "subsection Analysis shapes\n  set Type = modal\nend\n";
  expect_messages(beam, {{"a node", "At = end", "Node = 3", {"Point tip", "Node", "matrices"}}});
}

} // namespace broken_input_matrices_tests
} // namespace vibroimpact
