// Connections, rotors and equilibria that cannot be used: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_model_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a machine on a shaken floor
subsection Body casing
  set Type = lumped
  subsection Mass frame
    set Mass = 100 kg
    set Axis = y
    set Stiffness = 150 kN/m
  end
end
subsection Body rotor
  set Type = rotor
  subsection Rotor
    set At = casing.frame
    set Mass = 40 kg
    set Inertia = 5 kg m^2
    set Eccentricity = 2 mm
  end
  subsection Motor
    set Starting torque = 100 N m
    set Slope = 8 N m s
    set Time constant = 0.1 s
  end
end
subsection Connection mount
  set Between = casing.frame
  set Direction = y
  set Cubic stiffness = 6e10 N/m^3
  set Damping = 1500 N s/m
end
subsection Initial condition rest
  set Shape = equilibrium
end
subsection Analysis motion
  set Type = transient
  subsection Transient
    set Duration = 1 s
    set Sampling interval = 0.01 s
  end
end
)";

void expect_message(const std::string &from, const std::string &to,
                    const std::vector<std::string> &parts) {
  const std::string message = message_of(changed(sound, from, to));
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

TEST(BrokenInputModelTest, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputModelTest, Connections) {
  expect_message("Between = casing.frame", "Between = casing.fram", {"Between", "casing.frame"});
  expect_message("Between = casing.frame", "Between = casing.frame, casing.frame",
                 {"Between", "casing.frame", "listed twice"});
  expect_message("Between = casing.frame", "Between = base, casing.frame",
                 {"Between", "two different points"});
  expect_message("Direction = y", "Direction = x", {"Direction", "can move"});
  expect_message("Direction = y", "Direction = 0, 0, 0", {"Direction"});
  expect_message("6e10 N/m^3", "6e10 N/m", {"Cubic stiffness", "N/m^3"});
  expect_message("Damping = 1500 N s/m", "Damping = -1 N s/m", {"Damping"});
  expect_message("  set Cubic stiffness = 6e10 N/m^3\n  set Damping = 1500 N s/m\n", "",
                 {"mount", "does nothing"});
}

// The end of a sweep of the dashpot.
TEST(BrokenInputModelTest, AConnectionMayBeZeroWhereThatIsGiven) {
  EXPECT_EQ(
      message_of(changed(sound, "  set Cubic stiffness = 6e10 N/m^3\n  set Damping = 1500 N s/m\n",
                         "  set Damping = 0 N s/m\n")),
      "");
}

TEST(BrokenInputModelTest, Rotors) {
  expect_message("    set At = casing.frame\n", "", {"Rotor", "At"});
  expect_message("set At = casing.frame", "set At = rotor.shaft", {"At", "rotor.shaft"});
  expect_message("Mass = 40 kg", "Mass = 0 kg", {"Rotor", "Mass"});
  expect_message("    set Inertia = 5 kg m^2\n", "", {"Inertia"});
  expect_message("Eccentricity = 2 mm", "Second direction = x",
                 {"Second direction", "perpendicular"});
  expect_message("Slope = 8 N m s", "Slope = 0 N m s", {"Slope"});
  expect_message("    set Time constant = 0.1 s\n", "", {"Time constant"});
  expect_message("  subsection Motor",
                 "  subsection Mass disc\n    set Mass = 1 kg\n  end\n  subsection Motor",
                 {"rotor", "there is a subsection Mass"});
  expect_message("set Axis = y", "set Axis = y, y", {"Axis", "listed twice"});
  expect_message("set Axis = y", "set Axis = w", {"Axis", "'w'"});
}

TEST(BrokenInputModelTest, Equilibria) {
  expect_message("set Shape = equilibrium", "set Shape = equilibrium\n  set Velocity = 1 m/s",
                 {"Velocity", "must not be set when Shape"});
  expect_message("subsection Initial condition rest",
                 "subsection Initial condition other\n  set Shape = free equilibrium\nend\n"
                 "subsection Initial condition rest",
                 {"Shape", "one initial condition only"});
}

} // namespace broken_input_model_tests
} // namespace vibroimpact
