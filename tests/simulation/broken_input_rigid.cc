// Rigid contacts that cannot be used as given: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_rigid_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Analyses = drop
subsection Body ball
  set Type = lumped
  subsection Mass centre
    set Mass = 2 kg
    set Axis = x
    set Stiffness = 1 kN/m
  end
end
subsection Contact ground
  set Between = ball.centre
  set Direction = x
  set Clearance = 5 mm
  set Law = newton restitution
  subsection Newton restitution
    set Restitution coefficient = 0.5
  end
end
subsection Initial condition start
  set At = ball.centre
  set Displacement = 2 mm
end
subsection Analysis drop
  set Type = transient
  subsection Transient
    set Duration = 1 s
  end
end
)";

void expect_message(const std::string &text, const std::vector<std::string> &parts) {
  const std::string message = message_of(text);
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << " is missing in:\n" << message;
}

TEST(BrokenInputRigidTest, TheFileItselfIsSound) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputRigidTest, CoefficientIsRequiredAndBounded) {
  const std::string line = "set Restitution coefficient = 0.5";
  expect_message(changed(sound, line, ""), {"test.prm", "Restitution coefficient"});
  expect_message(changed(sound, line, "set Restitution coefficient = 1.2"),
                 {"Restitution coefficient", "1.2", "1"});
  expect_message(changed(sound, line, "set Restitution coefficient = -0.1"),
                 {"Restitution coefficient", "-0.1", "0"});
  expect_message(changed(sound, line, "set Restitution coefficient = 0.5 m"),
                 {"Restitution coefficient", "0.5 m"});
}

// Accepting an overlap does not make it possible.
TEST(BrokenInputRigidTest, OverlapAtTheStart) {
  const std::string start = changed(sound, "set Displacement = 2 mm", "set Displacement = 7 mm");
  const std::vector<std::string> parts = {"test.prm", "rigid", "overlapping by 2.0", "clearance"};
  expect_message(start, parts);
  expect_message(
      changed(start, "set Clearance", "set Initial penetration = accept\n  set Clearance"), parts);
}

TEST(BrokenInputRigidTest, NegativeClearanceIsAPrestress) {
  const std::string pressed = changed(sound, "set Clearance = 5 mm", "set Clearance = -5 mm");
  expect_message(pressed, {"Clearance", "-5 mm", "Prestressed"});
  // Declared so, it can start from its equilibrium, but not from rest at zero.
  const std::string declared = changed(pressed, "set Law", "set Prestressed = true\n  set Law");
  expect_message(declared, {"rigid", "overlapping"});
  EXPECT_EQ(message_of(changed(declared, "set At = ball.centre\n  set Displacement = 2 mm",
                               "set Shape = equilibrium")),
            "");
}

} // namespace broken_input_rigid_tests
} // namespace vibroimpact
