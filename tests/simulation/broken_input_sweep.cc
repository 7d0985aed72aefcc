// Stepped sweeps and frequency responses that cannot be run: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_sweep_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a block before a stop
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = 1 kN/m
  end
end
subsection Body beam
  set Type = beam
  subsection Geometry
    set Line = 0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m
    set Elements = 4
    set Orientation = 0, 1, 0
  end
  subsection Section
    set Shape = rectangle
    set Width = 30 mm
    set Thickness = 0.75 mm
  end
  subsection Material
    set Young modulus = 206 GPa
    set Density = 7850 kg/m^3
  end
  subsection Support root
    set At = start
    set Fix = all
  end
  subsection Point head
    set At = end
  end
  subsection Modes
    set Number = 3
  end
end
subsection Contact stop
  set Between = block.head
  set Clearance = 5 mm
  set Law = linear penalty
  subsection Linear penalty
    set Stiffness = 100 kN/m
  end
end
subsection Excitation shaker
  set Type = force
  set At = block.head
  set Amplitude = 1 N
  set Frequency = 3 Hz
end
subsection Analysis sweep
  set Type = stepped sweep
  subsection Stepped sweep
    set Parameter = Contact/stop/Clearance
    set First = 1 mm
    set Last = 8 mm
    set Points = 3
  end
end
)";

void expect_message(const std::string &from, const std::string &to,
                    const std::vector<std::string> &parts) {
  const std::string message = message_of(changed(sound, from, to));
  EXPECT_FALSE(message.empty());
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

TEST(BrokenInputSweepTest, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputSweepTest, Parameter) {
  expect_message("Contact/stop/Clearance", "Contact/stop/Clearence",
                 {"Clearence", "did you mean 'Clearance'"});
  expect_message("Contact/stop/Clearance", "Contact/wall/Clearance", {"wall", "Contact stop"});
  expect_message("Contact/stop/Clearance", "Analysis/sweep/Stepped sweep/Points",
                 {"Parameter", "outside the analyses"});
  expect_message("Contact/stop/Clearance\n    set First = 1 mm\n    set Last = 8 mm",
                 "Contact/stop/Between\n    set First = block.head\n    set Last = block.head",
                 {"Parameter", "one number as its value"});
  expect_message("Contact/stop/Clearance\n    set First = 1 mm\n    set Last = 8 mm",
                 "Body/beam/Modes/Number\n    set First = 2\n    set Last = 4",
                 {"Body/beam/Modes/Number", "change the number of coordinates"});
}

TEST(BrokenInputSweepTest, Ends) {
  expect_message("set First = 1 mm", "set First = 1 kg", {"1 kg", "length"});
  expect_message("    set First = 1 mm\n", "", {"First", "must be given"});
  expect_message("set Last = 8 mm", "set Last = 0.8 mm", {"Last", "greater than First"});
  expect_message("set Points = 3", "set Points = 3\n    set First frequency = 2 Hz",
                 {"First frequency", "Parameter"});
  expect_message("set Parameter = Contact/stop/Clearance", "set First frequency = 1 Hz",
                 {"First", "when Parameter is not set"});
  expect_message("set First = 1 mm", "set First = 0 mm\n    set Spacing = logarithmic",
                 {"First", "greater than 0"});
}

TEST(BrokenInputSweepTest, StartAndJumps) {
  expect_message("set Points = 3",
                 "set Points = 3\n    set Start = initial conditions\n    set Direction = forward",
                 {"Direction", "Start = initial conditions"});
  expect_message(
      "set Points = 3",
      "set Points = 3\n    set Start = initial conditions\n    set Jump tolerance = 1e-6",
      {"Jump tolerance", "carried over"});
  expect_message("set Points = 3", "set Points = 3\n    set Jump tolerance = 0.5",
                 {"Jump tolerance", "0.1"});
  expect_message("set Points = 3", "set Points = 3\n    set Jump threshold = 0",
                 {"Jump threshold", "greater than 0"});
  expect_message("set Points = 3", "set Points = 3\n    set Minimum settling cycles = 300",
                 {"Minimum settling cycles", "at most Settling cycles"});
  expect_message("set Points = 3", "set Points = 3\n    set Cycles without approach = -1",
                 {"Cycles without approach", "-1", "from 0"});
  expect_message("set Points = 3", "set Points = 3\n    set Cycles without approach = 2.5",
                 {"Cycles without approach", "2.5", "whole number"});
}

TEST(BrokenInputSweepTest, Excitation) {
  expect_message("set Points = 3", "set Points = 3\n    set Excitation = shakr", {"shakr"});
  expect_message("set Type = stepped sweep", "set Type = stepped sweep\n  set Excitations = none",
                 {"periodic excitation"});
}

TEST(BrokenInputSweepTest, FrequencyResponse) {
  const std::string response =
      changed(sound, "set Type = stepped sweep",
              "set Type = frequency response\n  subsection Frequency response\n"
              "    set First frequency = 1 Hz\n    set Last frequency = 9 Hz\n  end");
  EXPECT_EQ(message_of(response), "");
  EXPECT_NE(
      message_of(changed(response, "set Last frequency = 9 Hz", "set Last frequency = 0.9 Hz"))
          .find("greater than First frequency"),
      std::string::npos);
  EXPECT_NE(message_of(changed(response, "subsection Excitation",
                               "subsection Connection mount\n  set Between = block.head\n"
                               "  set Direction = x\n  set Cubic stiffness = 1e6 N/m^3\nend\n"
                               "subsection Excitation"))
                .find("linear model"),
            std::string::npos);
}

} // namespace broken_input_sweep_tests
} // namespace vibroimpact
