// Sections "Figure" that cannot be used: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_figures_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Variables = base = 2 mm
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = 1 kN/m
  end
end
subsection Excitation push
  set Type = force
  set At = block.head
  set Amplitude = 2 N
  set Frequency = 3 Hz
end
subsection Analysis curve
  set Type = stepped sweep
  subsection Stepped sweep
    set First frequency = 1 Hz
    set Last frequency = 4 Hz
    set Points = 4
  end
end
subsection Analysis free
  set Type = frequency response
  subsection Frequency response
    set First frequency = 1 Hz
    set Last frequency = 4 Hz
    set Points = 4
  end
end
subsection Figure resonance
  set From = curve
  set Reference = free
  subsection Horizontal
    set Quantity = frequency
    set Range = 0, 2
  end
  subsection Vertical
    set Quantity = point/block.head/displacement_x/amplitude
    set Divide by = base / 2
    set Label = $\eta$
  end
end
)";

void expect_message(const std::string &from, const std::string &to,
                    const std::vector<std::string> &parts) {
  const std::string message = message_of(changed(sound, from, to));
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

TEST(BrokenInputFigures, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputFigures, UnknownAnalyses) {
  expect_message("From = curve", "From = curves", {"Figure resonance", "From = curves", "'curve'"});
  expect_message("  set From = curve\n", "", {"Figure resonance", "From", "must be given"});
  expect_message("Reference = free", "Reference = fre", {"Reference = fre", "'free'"});
  expect_message("Divide by = base / 2", "Divide by largest of = fre",
                 {"Vertical", "Divide by largest of = fre", "'free'"});
}

TEST(BrokenInputFigures, AxesWithoutAQuantity) {
  expect_message("    set Quantity = frequency\n", "",
                 {"Figure resonance / Horizontal / Quantity", "must be given"});
}

TEST(BrokenInputFigures, DivisorsAndRangesThatCannotBe) {
  expect_message("base / 2", "0 * base", {"Vertical", "Divide by", "must not be 0"});
  expect_message("set Divide by = base / 2",
                 "set Divide by = base / 2\n    set Divide by largest of = free",
                 {"Divide by", "when Divide by largest of is set"});
  expect_message("Range = 0, 2", "Range = 2, 0", {"Range = 2, 0", "greater"});
  expect_message("Range = 0, 2", "Range = 2", {"Range = 2", "two numbers"});
}

} // namespace broken_input_figures_tests
} // namespace vibroimpact
