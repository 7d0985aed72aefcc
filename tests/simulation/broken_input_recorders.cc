// Recorders and responses that cannot be used: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_recorders_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a shaken block
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Axis = x
    set Stiffness = 1 kN/m
  end
end
subsection Excitation ground
  set Type = base acceleration
  set Amplitude = 2 m/s^2
  set Frequency = 3 Hz
end
subsection Analysis answer
  set Type = steady state
  set Record = extreme values, statistics, impacts, energy, forces, quasi static, history
  subsection Steady state
    set Settling cycles = 20
    set Recorded cycles = 2
  end
  subsection Extreme values
    set Points = block.head
    set Quantities = displacement, acceleration
  end
  subsection History
    set Samples per period = 50
  end
end
)";

void expect_message(const std::string &from, const std::string &to,
                    const std::vector<std::string> &parts) {
  const std::string message = message_of(changed(sound, from, to));
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

TEST(BrokenInputRecordersTest, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputRecordersTest, NamesOfRecorders) {
  expect_message("statistics,", "statistic,", {"Record", "statistic", "statistics"});
  expect_message("statistics,", "extreme values,", {"Record", "listed twice"});
  expect_message("statistics,", "none,", {"Record", "none"});
  expect_message("Type = steady state", "Type = modal", {"Record", "no recorders"});
}

TEST(BrokenInputRecordersTest, WhatIsWatched) {
  expect_message("Points = block.head", "Points = block.heat",
                 {"Points", "block.heat", "block.head"});
  expect_message("= displacement, acceleration", "= displacment",
                 {"Quantities", "displacment", "displacement"});
  expect_message("quasi static, history",
                 "stresses\n  subsection Stresses\n    set Points = block.head\n  end",
                 {"Stresses", "Points", "cross-section", "block.head"});
  expect_message("Samples per period = 50", "Samples per period = 1", {"Samples per period"});
  expect_message("Samples per period = 50", "Sampling interval = 0 s", {"Sampling interval"});
}

TEST(BrokenInputRecordersTest, Windows) {
  expect_message("Settling cycles = 20", "Settling cycles = 20\n    set Settling time = 1 s",
                 {"Settling time", "Settling cycles"});
  expect_message("Recorded cycles = 2", "Recorded cycles = 2\n    set Recorded time = 1 s",
                 {"Recorded time", "Recorded cycles"});
  expect_message("Recorded cycles = 2", "Recorded cycles = 0", {"Recorded cycles"});
  expect_message("Settling cycles = 20", "Settling cycles = 2\n    set Minimum settling cycles = 3",
                 {"Minimum settling cycles = 3", "at most Settling cycles"});
  expect_message("Settling cycles = 20", "Settling cycles = 20\n    set Settling method = soon",
                 {"Settling method", "soon", "automatic", "transient", "Newton"});
  expect_message("Recorded cycles = 2", "Excitation = grund", {"grund", "period"});
  expect_message("set Frequency = 3 Hz", "set History = constant", {"period"});
}

} // namespace broken_input_recorders_tests
} // namespace vibroimpact
