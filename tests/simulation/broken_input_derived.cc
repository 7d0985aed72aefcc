// Derived quantities that cannot be used: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_derived_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Variables = stiffness = 1 kN/m
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = stiffness
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
subsection Analysis map
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = curve
    subsection Key spring
      set Path = Variables/stiffness
      set Values = 1 kN/m, 2 kN/m
    end
  end
end
subsection Derived peak
  set From = map
  set Operation = maximum
  set Field = point/block.head/displacement_x/largest
  set Along = frequency, direction
end
subsection Derived forward
  set From = map
  set Operation = select
  set Field = point/block.head/displacement_x/largest
  set Where = direction = forward, spring = 2 kN/m
end
subsection Derived resonance
  set From = map
  set Operation = position of maximum
  set Field = forward
  set Along = frequency
  set Refine = parabola
end
subsection Derived ratio
  set From = map
  set Operation = expression
  set Fields = a = peak, k = stiffness
  set Expression = a * k / (2 N)
  set Unit = 1
end
subsection Derived where
  set From = map
  set Operation = crossing
  set Field = peak
  set Along = stiffness
  set Level = 3 mm
end
)";

void expect_message(const std::string &from, const std::string &to,
                    const std::vector<std::string> &parts) {
  const std::string message = message_of(changed(sound, from, to));
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

TEST(BrokenInputDerived, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputDerived, UnknownAnalysis) {
  expect_message("set From = map", "set From = mapp",
                 {"test.prm:", "Derived peak", "From = mapp", "'map'"});
  expect_message("  set From = map\n", "", {"Derived peak", "From", "must be given"});
}

TEST(BrokenInputDerived, UnknownOperation) {
  expect_message("= position of maximum", "= position of top",
                 {"Operation", "position of top", "position of maximum"});
}

TEST(BrokenInputDerived, KeysAnOperationNeeds) {
  expect_message("  set Along = frequency, direction\n", "", {"Derived peak", "Along", "given"});
  expect_message("  set Field = forward\n", "", {"Derived resonance", "Field", "given"});
  expect_message("= position of maximum", "= value at maximum", {"Derived resonance", "At"});
  expect_message("  set Where = direction = forward, spring = 2 kN/m\n", "", {"Where", "given"});
  expect_message("  set Fields = a = peak, k = stiffness\n", "", {"Fields", "given"});
  expect_message("  set Level = 3 mm\n", "", {"Derived where", "Level"});
  expect_message("  set Level = 3 mm\n", "  set Level = 3 mm\n  set Other = peak\n",
                 {"Other", "must not be set when Level is set"});
}

TEST(BrokenInputDerived, KeysItHasNoUseFor) {
  expect_message("set Level = 3 mm", "set Level = 3 mm\n  set Unit = mm",
                 {"Unit = mm", "crossing"});
}

TEST(BrokenInputDerived, Axes) {
  expect_message("Along = frequency, direction", "Along = frequncy, direction",
                 {"Along", "frequncy", "frequency"});
  expect_message("Along = frequency, direction", "Along = stiffness, spring", {"Along", "once"});
  expect_message("Along = stiffness", "Along = stiffness, frequency", {"Along", "one axis"});
  expect_message("Along = stiffness", "Along = direction", {"Along", "numbers"});
  expect_message("Where = direction = forward", "Where = direction = up",
                 {"Where", "up", "forward, backward"});
  expect_message("spring = 2 kN/m", "spring = 3 kN/m", {"Where", "3 kN/m", "2000 N/m"});
  expect_message("spring = 2 kN/m", "spring = 2 mm", {"Where", "2 mm"});
}

TEST(BrokenInputDerived, Expressions) {
  expect_message("Fields = a = peak, k = stiffness", "Fields = a = peak", {"Expression", "'k'"});
  expect_message("Expression = a * k", "Expression = a * stiffness",
                 {"Expression", "'stiffness'", "Fields"});
  expect_message("Expression = a * k", "Expression = a * (k", {"Expression", "'('"});
  expect_message("Fields = a = peak", "Fields = N = peak", {"Fields", "'N' is a unit"});
  expect_message("Unit = 1", "Unit = furlong", {"Unit", "furlong"});
  expect_message("Level = 3 mm", "Level = 3 furlong", {"Level", "furlong"});
}

} // namespace broken_input_derived_tests
} // namespace vibroimpact
