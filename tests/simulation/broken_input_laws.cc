// Contact laws that cannot be used as given: the message says where, which key, and what is
// allowed.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_laws_tests {

using testing::changed;
using testing::message_of;

std::string with_law(const std::string &law, const std::string &section) {
  return R"(set Analyses = drop
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Axis = x
  end
end
subsection Contact stop
  set Between = block.head
  set Direction = x
  set Clearance = 5 mm
  set Law = )" +
         law + "\n" + section + R"(
end
subsection Analysis drop
  set Type = transient
  subsection Transient
    set Duration = 1 s
  end
end
)";
}

void expect_message(const std::string &text, const std::vector<std::string> &parts) {
  const std::string message = message_of(text);
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << " is missing in:\n" << message;
}

struct Sample {
  std::string law, section;
  std::vector<std::string> required;
};

const std::vector<Sample> samples = {
    {"kelvin-voigt",
     R"(  subsection Kelvin-Voigt
    set Stiffness = 80 kN/m
    set Damping constant = 160 N s/m
  end)",
     {"Stiffness = 80 kN/m"}},
    {"kelvin-voigt bumper",
     R"(  subsection Kelvin-Voigt bumper
    set Stiffness = 80 kN/m
    set Damping constant = 160 N s/m
  end)",
     {"Stiffness = 80 kN/m", "Damping constant = 160 N s/m"}},
    {"bilinear stop",
     R"(  subsection Bilinear stop
    set Stiffness = 80 kN/m
    set Damping constant = 160 N s/m
  end)",
     {"Stiffness = 80 kN/m"}},
    {"tsuji",
     R"(  subsection Tsuji
    set Stiffness = 1e10 N/m^1.5
    set Restitution coefficient = 0.8
    set Effective mass = 2 kg
  end)",
     {"Restitution coefficient = 0.8"}},
    {"kuwabara-kono",
     R"(  subsection Kuwabara-Kono
    set Stiffness = 1e10 N/m^1.5
    set Dissipation time = 2 us
  end)",
     {"Dissipation time = 2 us"}},
    {"hunt-crossley",
     R"(  subsection Hunt-Crossley
    set Stiffness = 1e10 N/m^1.5
    set Restitution coefficient = 0.8
    set Relation = flores
  end)",
     {"Restitution coefficient = 0.8"}},
};

TEST(BrokenInputLawsTest, TheSamplesAreSound) {
  for (const Sample &sample : samples)
    EXPECT_EQ(message_of(with_law(sample.law, sample.section)), "") << sample.law;
}

TEST(BrokenInputLawsTest, MissingKeys) {
  for (const Sample &sample : samples)
    for (const std::string &line : sample.required) {
      const std::string key = line.substr(0, line.find(" ="));
      const std::string text = with_law(sample.law, sample.section);
      const std::string message = message_of(changed(text, "set " + line, ""));
      EXPECT_NE(message, "") << sample.law << ": " << line;
      if (key != "Restitution coefficient") { // there one of two keys is asked for
        EXPECT_NE(message.find(key), std::string::npos) << message;
      }
    }
}

TEST(BrokenInputLawsTest, ValuesOutOfRange) {
  for (const Sample &sample : samples) {
    const std::string text = with_law(sample.law, sample.section);
    expect_message(changed(text, "Stiffness = ", "Stiffness = -"), {"test.prm:", "Stiffness"});
  }
  const auto text = [](std::size_t i) { return with_law(samples[i].law, samples[i].section); };
  expect_message(changed(text(1), "160 N s/m", "0 N s/m"), {"Damping constant"});
  expect_message(changed(text(3), "coefficient = 0.8", "coefficient = 1.2"),
                 {"Restitution coefficient"});
  expect_message(changed(text(3), "1e10 N/m^1.5", "1e10 N/m"), {"Stiffness"});
}

// Radii and materials give the k of n = 3/2; with another exponent it must be given.
TEST(BrokenInputLawsTest, AnotherExponentNeedsItsStiffness) {
  for (const std::string side : {"a", "b"}) {
    const std::string text = with_law("hertz", "  subsection Hertz\n    set Radius " + side +
                                                   " = 10 mm\n    set Young modulus a = 200 GPa\n"
                                                   "    set Young modulus b = 200 GPa\n"
                                                   "    set Exponent = 1.5\n  end");
    EXPECT_EQ(message_of(text), "") << side;
    expect_message(changed(text, "Exponent = 1.5", "Exponent = 2"), {"Exponent = 2", "Stiffness"});
  }
}

TEST(BrokenInputLawsTest, UnknownNames) {
  const std::string text = with_law(samples[5].law, samples[5].section);
  expect_message(changed(text, "= flores", "= florez"), {"Relation", "florez", "flores"});
  expect_message(changed(text, "= hunt-crossley", "= hunt-crosley"), {"Law", "hunt-crossley"});
}

TEST(BrokenInputLawsTest, TwoDampingsAtOnce) {
  const std::string text = with_law(samples[3].law, samples[3].section);
  expect_message(changed(text, "set Effective", "set Damping coefficient = 0.1\n    set Effective"),
                 {"Damping coefficient", "must not be set when Restitution coefficient is set"});
}

} // namespace broken_input_laws_tests
} // namespace vibroimpact
