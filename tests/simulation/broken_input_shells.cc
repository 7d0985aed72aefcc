// Bodies of shells that cannot be used as given: what the message says in a whole file.
#include "support/broken_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_shells_tests {

using testing::changed;
using testing::expect_messages;
using testing::message_of;

const std::string sound = R"(set Analyses = shapes
subsection Body plate
  set Type = shell
  subsection Geometry
    set Plate = 0 m, 0 m, 0 m -> 2 m, 0 m, 0 m -> 0 m, 1 m, 0 m
    set Divisions = 4, 2
  end
  subsection Material
    set Young modulus = 200 GPa
    set Density = 8000 kg/m^3
  end
  subsection Shell deck
    set Thickness = 10 mm
  end
  subsection Stiffener rib
    set On = bottom
    set Width = 5 mm
    set Thickness = 40 mm
  end
  subsection Support left
    set At = left
    set Fix = all
  end
  subsection Point corner
    set Near = 2 m, 1 m, 0 m
  end
  subsection Load wind
    set Pressure = 2 kPa
  end
  subsection Modes
    set Attachments = corner.z
  end
end
subsection Analysis shapes
  set Type = modal
end
)";

TEST(BrokenInputShellsTest, MessagesNameTheKeyAndWhatIsAllowed) {
  const std::vector<testing::BrokenFile> cases = {
      {"negative thickness", "Thickness = 10 mm", "Thickness = -1 mm", {"Shell deck", "Thickness"}},
      {"thickness in kilograms", "Thickness = 10 mm", "Thickness = 1 kg", {"Thickness", "1 kg"}},
      {"no divisions", "Divisions = 4, 2", "Divisions = 0, 2", {"Divisions"}},
      {"half a division", "Divisions = 4, 2", "Divisions = 4, 1.5", {"Divisions", "whole"}},
      {"flat plate", "0 m, 1 m, 0 m\n", "3 m, 0 m, 0 m\n", {"Plate", "parallel"}},
      {"unknown edge", "At = left", "At = west", {"Support left", "left", "right", "edges"}},
      {"unknown line", "On = bottom", "On = keel", {"Stiffener rib", "On", "bottom"}},
      {"no section", "    set Width = 5 mm\n", "", {"Stiffener rib", "Width"}},
      {"unknown attachment", "corner.z", "corner.rz", {"Attachments", "corner.rz", "did you mean"}},
      {"unknown reduction",
       "corner.z",
       "corner.z\n    set Reduction = fixed",
       {"Reduction", "fixed"}},
      {"attachment of nowhere", "corner.z", "tip.z", {"Attachments", "tip.z"}},
      {"load without supports",
       "  subsection Support left\n    set At = left\n    set Fix = all\n  end\n",
       "",
       {"must have supports against every rigid motion"}},
      {"no load",
       "    set Pressure = 2 kPa\n",
       "",
       {"Load wind", "Acceleration or Pressure must be set"}},
      {"too many modes",
       "  subsection Modes\n",
       "  subsection Modes\n    set Number = 1000\n",
       {"Modes", "Number", "must not exceed"}},
      {"no mesh file",
       "    set Plate = 0 m, 0 m, 0 m -> 2 m, 0 m, 0 m -> 0 m, 1 m, 0 m\n"
       "    set Divisions = 4, 2\n",
       "    set Mesh = nowhere.msh\n",
       {"Mesh", "nowhere.msh"}},
      {"cross-section of a beam body",
       "  subsection Material\n",
       "  subsection Section\n    set Width = 1 mm\n  end\n  subsection Material\n",
       {"when there is a subsection Section"}}};
  expect_messages(sound, cases);
}

TEST(BrokenInputShellsTest, AFixedInterfaceMustBeFree) {
  const std::string fixed =
      changed(sound, "corner.z\n", "corner.z\n    set Reduction = fixed interface\n");
  EXPECT_EQ(message_of(fixed), "");
  for (const std::string &message :
       {message_of(changed(fixed, "Near = 2 m, 1 m", "Near = 0 m, 1 m")),
        message_of(changed(fixed, "    set Attachments = corner.z\n", ""))}) {
    EXPECT_NE(message.find("Attachments"), std::string::npos) << message;
    EXPECT_NE(message.find("that no support holds"), std::string::npos) << message;
  }
}

} // namespace broken_input_shells_tests
} // namespace vibroimpact
