// Basins that cannot be looked for: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_basins_tests {

using testing::changed;
using testing::message_of;

const std::string model = R"(set Title = a block before a stop
set Variables = x = 0, v = 0
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
subsection Initial condition start
  set At = block.head
  set Displacement = x * 1 mm
  set Velocity = v * 1 mm/s
end
)";

const std::string basins = model + R"(subsection Analysis plane
  set Type = basins
  subsection Basins
    subsection First axis
      set Parameter = Variables/x
      set First = -1
      set Last = 1
      set Cells = 3
    end
    subsection Second axis
      set Parameter = Variables/v
      set First = -2
      set Last = 2
      set Cells = 4
    end
  end
end
)";

const std::string shares = model + R"(subsection Analysis random
  set Type = basin shares
  subsection Basin shares
    set Starts = 5
    subsection Range displacement
      set Parameter = Variables/x
      set First = -1
      set Last = 1
    end
  end
end
)";

void expect_message(const std::string &file, const std::string &from, const std::string &to,
                    const std::vector<std::string> &parts) {
  const std::string message = message_of(changed(file, from, to));
  EXPECT_FALSE(message.empty()) << to;
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

TEST(BrokenInputBasinsTest, TheSoundFilesAreAccepted) {
  EXPECT_EQ(message_of(basins), "");
  EXPECT_EQ(message_of(shares), "");
}

TEST(BrokenInputBasinsTest, Axes) {
  expect_message(basins, "Last = 1\n", "Last = -1\n", {"Last", "greater than First"});
  expect_message(basins, "set Cells = 3", "set Cells = 0", {"Cells = 0", "1"});
  expect_message(basins, "Variables/v", "Variables/x", {"Parameter", "another key"});
  expect_message(basins, "Variables/v", "Variables/y", {"Variables/y"});
  expect_message(basins, "      set Parameter = Variables/x\n", "", {"Parameter", "must be given"});
  expect_message(basins, "set Cells = 3", "set Cells = 3\n      set First frequency = 1 Hz",
                 {"First frequency"});
}

// The first axis, and each range, may change nothing but where motions begin.
TEST(BrokenInputBasinsTest, KeysThatChangeMoreThanStarts) {
  const std::string more = "must change initial conditions only, and these in proportion";
  for (const std::string &file : {basins, shares}) {
    expect_message(file, "set Parameter = Variables/x\n      set First = -1\n      set Last = 1",
                   "set Parameter = Contact/stop/Clearance\n      set First = 4 mm\n"
                   "      set Last = 6 mm",
                   {"test.prm:", "Contact/stop/Clearance", more});
    expect_message(file, "set Parameter = Variables/x\n      set First = -1\n      set Last = 1",
                   "set Parameter = Excitation/shaker/Amplitude\n      set First = 1 N\n"
                   "      set Last = 2 N",
                   {"Excitation/shaker/Amplitude", more});
    expect_message(file, "x * 1 mm", "x * x * 1 mm", {"Variables/x", more});
  }
}

TEST(BrokenInputBasinsTest, Keys) {
  expect_message(basins, "set Type = basins", "set Type = basins\n  set Record = extreme values",
                 {"Record", "no recorders"});
  expect_message(basins, "  subsection Basins", "  subsection Basins\n    set Most periods = 0",
                 {"Most periods = 0"});
  expect_message(basins, "  subsection Basins", "  subsection Basins\n    set Longest period = 0",
                 {"Longest period = 0"});
  expect_message(basins, "  subsection Basins", "  subsection Basins\n    set Coarse cells = 0",
                 {"Coarse cells = 0"});
  expect_message(basins, "  subsection Basins", "  subsection Basins\n    set Nodes = 50",
                 {"Nodes = 50", "Method = motions"});
  expect_message(basins, "  subsection Basins", "  subsection Basins\n    set Check every = 5",
                 {"Check every = 5", "Method = motions"});
  expect_message(basins, "  subsection Basins", "  subsection Basins\n    set Excitation = none",
                 {"none"});
  expect_message(basins, "set Type = basins", "set Type = basins\n  set Excitations = none",
                 {"An analysis of basins must have one periodic excitation"});
}

TEST(BrokenInputBasinsTest, Interpolation) {
  const std::string relaxing = changed(changed(basins, "linear penalty", "kelvin-voigt bumper"),
                                       "subsection Linear penalty\n    set Stiffness = 100 kN/m",
                                       "subsection Kelvin-Voigt bumper\n    set Stiffness = 100 "
                                       "kN/m\n    set Damping constant = 1 N s/m");
  EXPECT_EQ(message_of(relaxing), "");
  expect_message(relaxing, "  subsection Basins",
                 "  subsection Basins\n    set Method = interpolation",
                 {"Method must be motions", "3 states"});
}

TEST(BrokenInputBasinsTest, Shares) {
  expect_message(shares, "set Starts = 5", "set Starts = 0", {"Starts = 0"});
  expect_message(shares, "set Starts = 5", "set Seed = -1", {"Seed = -1"});
  expect_message(shares,
                 "    subsection Range displacement\n      set Parameter = Variables/x\n"
                 "      set First = -1\n      set Last = 1\n    end\n",
                 "", {"Range NAME"});
  expect_message(
      shares, "  subsection Basin shares",
      "  subsection Basin shares\n    subsection Range again\n"
      "      set Parameter = Variables/x\n      set First = 0\n      set Last = 1\n    end",
      {"another key"});
}

} // namespace broken_input_basins_tests
} // namespace vibroimpact
