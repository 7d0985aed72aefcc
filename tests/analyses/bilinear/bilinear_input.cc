// Bilinear approximations that cannot be done: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace bilinear_input_tests {

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
  set Between = block.head, stop
  set Direction = x
  set Clearance = 1 mm
  set Law = newton restitution
  subsection Newton restitution
    set Restitution coefficient = 0
  end
end
subsection Excitation shaker
  set Type = force
  set At = block.head
  set Amplitude = 1 N
  set Frequency = 3 Hz
end
subsection Analysis tied
  set Type = bilinear approximation
  subsection Bilinear approximation
    set First frequency = 1 Hz
    set Last frequency = 9 Hz
    set Points = 9
  end
end
)";

const std::string second_contact = R"(subsection Contact other
  set Between = block.head, stop
  set Direction = -x
  set Clearance = 1 mm
  set Law = newton restitution
  subsection Newton restitution
    set Restitution coefficient = 0
  end
end
)";

const std::string second_force = R"(subsection Excitation other
  set Type = force
  set At = block.head
  set Amplitude = 1 N
  set Frequency = 4 Hz
end
)";

struct Mistake {
  std::string from, to;
  std::vector<std::string> words;
};

class BilinearInputFile : public ::testing::TestWithParam<Mistake> {};

TEST_P(BilinearInputFile, IsRefusedWithAMessage) {
  const auto &[from, to, words] = GetParam();
  const std::string message = message_of(changed(sound, from, to));
  for (const std::string &word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
}

const Mistake mistakes[] = {
    {"subsection Contact",
     second_contact + "subsection Contact",
     {"exactly one contact, but there are 2: other, stop", "Active contacts"}},
    {"  set Type = bilinear approximation",
     "  set Type = bilinear approximation\n  set Active contacts = none",
     {"exactly one contact, but there are 0"}},
    {"subsection Excitation",
     second_force + "subsection Excitation",
     {"the key Excitation where there are several"}},
    {"subsection Excitation",
     second_force + "subsection Excitation",
     {"A bilinear approximation must have one periodic excitation"}},
    {"  set Frequency = 3 Hz", "  set History = constant", {"has no frequency"}},
    {"set Last frequency = 9 Hz", "set Last frequency = 0.9 Hz", {"greater than First frequency"}},
    {"set Points = 9", "set Points = 9\nset Highest order = 200", {"Highest order", "720"}},
    {"set Points = 9", "set Points = 9\nset Cells = 2", {"Cells", "2"}},
    {"  set Type = bilinear approximation",
     "  set Type = bilinear approximation\n  set Record = section",
     {"Record", "no recorders"}},
    {"subsection Contact",
     "subsection Connection mount\n  set Between = block.head\n  set Direction = x\n"
     "  set Cubic stiffness = 1e6 N/m^3\nend\nsubsection Contact",
     {"linear model"}},
};

INSTANTIATE_TEST_SUITE_P(BilinearInput, BilinearInputFile, ::testing::ValuesIn(mistakes));

TEST(BilinearInputTest, TheFileIsSound) { EXPECT_EQ(message_of(sound), ""); }

TEST(BilinearInputTest, OtherExcitationsMustBeConstant) {
  const std::string two =
      changed(changed(sound, "subsection Excitation", second_force + "subsection Excitation"),
              "set Points = 9", "set Points = 9\nset Excitation = shaker");
  const std::string message = message_of(two);
  EXPECT_NE(message.find("beside shaker, but other varies in time"), std::string::npos) << message;
  EXPECT_EQ(message_of(changed(two, "  set Frequency = 4 Hz", "  set History = constant")), "");
}

} // namespace bilinear_input_tests
} // namespace vibroimpact
