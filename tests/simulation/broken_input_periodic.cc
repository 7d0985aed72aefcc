// Periodic orbits that cannot be looked for: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a block before a stop
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = 1 kN/m
    set Damping = 3 N s/m
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
subsection Analysis orbit
  set Type = periodic orbit
  subsection Periodic orbit
    set State = 0.001, 0.02
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

TEST(BrokenInputPeriodicTest, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputPeriodicTest, State) {
  expect_message("0.001, 0.02", "0.001", {"test.prm:27", "State = 0.001", "2 numbers"});
  expect_message("0.001, 0.02", "0.001, 0.02, 0", {"State", "2 numbers"});
  expect_message("set State = 0.001, 0.02", "set State = 0.001, 0.02\n    set Settling cycles = 3",
                 {"Settling cycles = 3", "nothing with a State"});
  expect_message("0.001, 0.02", "0.001, fast", {"State", "fast"});
}

TEST(BrokenInputPeriodicTest, Multiple) {
  expect_message("set State = 0.001, 0.02", "set Period multiple = -1", {"Period multiple", "-1"});
  expect_message("set State = 0.001, 0.02", "set Period multiple = 1.5", {"Period multiple"});
}

TEST(BrokenInputPeriodicTest, Excitation) {
  expect_message("set Type = periodic orbit", "set Type = periodic orbit\n  set Excitations = none",
                 {"A periodic orbit needs one periodic excitation"});
  expect_message("set State = 0.001, 0.02", "set Excitation = shakr", {"shakr", "active"});
  const std::string second =
      "subsection Excitation hum\n  set Type = force\n  set At = block.head\n"
      "  set Amplitude = 1 N\n  set Frequency = 4 Hz\nend\n"
      "subsection Analysis orbit";
  const std::string both = changed(sound, "subsection Analysis orbit", second);
  EXPECT_NE(message_of(both).find("the key Excitation"), std::string::npos);
  const std::string message =
      message_of(changed(both, "set State", "set Excitation = shaker\n    set State"));
  EXPECT_NE(message.find("hum does not repeat itself after the period of shaker"),
            std::string::npos)
      << message;
}

TEST(BrokenInputPeriodicTest, Ramp) {
  expect_message("set Frequency = 3 Hz",
                 "set Frequency = 3 Hz\n  set History = ramped harmonic\n"
                 "  subsection Ramp\n    set Rate = 1 1/s\n  end",
                 {"shaker does not repeat itself"});
}

} // namespace
} // namespace vibroimpact
