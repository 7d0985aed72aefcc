// Designs of isolators that cannot be made: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_isolator_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = an isolator between stops
set Variables = k1 = 200, d = 2
subsection Body isolator
  set Type = lumped
  subsection Mass mass
    set Mass = 2 kg
    set Axis = y
    set Stiffness = 800 N/m
    set Damping = 0.8 N s/m
  end
end
subsection Contact up
  set Between = isolator.mass, stop
  set Direction = y
  set Clearance = d * 1 mm
  set Law = bilinear stop
  subsection Bilinear stop
    set Stiffness = k1 * 1 N/m
    set Damping constant = 16 N s/m
  end
end
subsection Contact down
  set Between = isolator.mass, stop
  set Direction = -y
  set Clearance = d * 0.001 m
  set Law = bilinear stop
  subsection Bilinear stop
    set Stiffness = k1 * 1 N/m
    set Damping constant = 16 N s/m
  end
end
subsection Excitation force
  set Type = force
  set At = isolator.mass
  set Direction = y
  set Amplitude = 0.832 N
  set Frequency = 30 rad/s
end
subsection Analysis curve
  set Type = branch
  subsection Branch
    set First frequency = 10 rad/s
    set Last frequency = 80 rad/s
  end
end
subsection Analysis design
  set Type = isolator design
  subsection Isolator design
    set Working frequency = 55 rad/s
    set Allowed displacement = 2.4 mm
    set First unfolding parameters = 0.7, 0.3
    set Second unfolding parameters = 0, -0.2
  end
end
)";

// Clearances are in mm here, so that the key is not the clearance in SI.
const std::string exact = "  subsection Isolator design\n    set Repeat = curve\n"
                          "    set Stiffness key = Variables/k1\n"
                          "    set Clearance key = Variables/d\n";

TEST(BrokenInputIsolatorTest, TheFileIsSound) { EXPECT_EQ(message_of(sound), ""); }

const std::string in_metres = changed(
    changed(changed(sound, "d * 1 mm", "d * 1 m"), "d * 0.001 m", "d * 1 m"), "d = 2", "d = 0.002");

TEST(BrokenInputIsolatorTest, WithExactBranchesTheFileIsSound) {
  EXPECT_EQ(message_of(changed(in_metres, "  subsection Isolator design\n", exact)), "");
}

struct Mistake {
  std::string from, to;
  std::vector<std::string> words;
};

class BrokenInputIsolatorFile : public ::testing::TestWithParam<Mistake> {};

TEST_P(BrokenInputIsolatorFile, IsRefusedWithAMessage) {
  const auto &[from, to, words] = GetParam();
  const std::string message = message_of(changed(sound, from, to));
  ASSERT_NE(message, "");
  for (const std::string &word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
}

const std::string line = "set Allowed displacement = 2.4 mm";

const Mistake mistakes[] = {
    {"set Working frequency = 55 rad/s", "", {"Isolator design / Working frequency", "must be"}},
    {"set Working frequency = 55 rad/s",
     "set Working frequency = 19 rad/s",
     {"test.prm:49", "Working frequency", "greater than the natural frequency of 20"}},
    {"set Working frequency = 55 rad/s",
     "set Working frequency = 55",
     {"Working frequency", "rad/s"}},
    {line, "", {"Isolator design / Allowed displacement", "must be given"}},
    {line, "set Allowed displacement = 0 mm", {"test.prm:50", "greater than 0"}},
    {line, "set Allowed displacement = 2.4 N", {"test.prm:50", "Allowed displacement", "2.4 N"}},
    {line, line + "\nset Transmissibility = 1", {"Transmissibility", "less than 1"}},
    {line, line + "\nset Transmissibility = 0", {"Transmissibility", "greater than 0"}},
    {line, line + "\nset Margin = -0.1", {"Margin", "from 0 to 10"}},
    {line, line + "\nset Prefer = softest", {"Prefer", "least stiffness", "largest clearance"}},
    {line, line + "\nset Jump limit = cusp", {"Jump limit", "averaged response"}},
    {line, line + "\nset Unfolding frequency ratio = 0", {"Unfolding frequency ratio", "greater"}},
    {line, line + "\nset Points = 1", {"Points", "2"}},
    {line, line + "\nset Excitation = shaker", {"shaker"}},
    {"parameters = 0.7, 0.3", "parameters = 0.7, -0.3", {"First unfolding", "greater than 0"}},
    {"parameters = 0.7, 0.3", "parameters = 0.7", {"Second unfolding", "1 values, as many as"}},
    {"parameters = 0, -0.2",
     "parameters = 0, 0.14",
     {"Second unfolding", "0.132338", "alpha_1 = 0.3", "no force"}},
    {line,
     line + "\nset Stiffness key = Variables/k1",
     {"Stiffness key", "when Repeat is not set"}},
    {line, line + "\nset Clearance key = Variables/d", {"Clearance key", "when Repeat is not set"}},
    {line, line + "\nset Repeat = curv", {"Repeat", "did you mean 'curve'"}},
    {line, line + "\nset Repeat = design", {"Repeat", "does not evaluate another one"}},
    {line, line + "\nset Repeat = curve", {"Stiffness key", "must be given"}},
    {"  subsection Isolator design\n",
     "  set Excitations = force\n" + exact,
     {"Analysis design / Excitations", "in the analysis curve"}},
    {"  subsection Isolator design\n", exact, {"Variables/d", "the clearance of both stops in m"}},
    {"subsection Mass mass",
     "subsection Mass other\nset Mass = 1 kg\nend\nsubsection Mass mass",
     {"one coordinate", "has 2"}},
    {"set Stiffness = 800 N/m", "", {"stiffness must be greater than 0 N/m"}},
    {"set Direction = -y", "set Direction = y", {"opposite sides", "up and down"}},
    {"d * 0.001 m", "d * 0.002 m", {"two equal stops", "up and down"}},
    {"d = 2", "d = 0", {"clearance greater than 0 m"}},
    {"set Damping = 0.8 N s/m", "set Damping = 5 N s/m", {"must be below 0.273", "0.3125"}},
    {"set Direction = y\n  set Amplitude",
     "set Direction = x\n  set Amplitude",
     {"amplitude along the motion"}},
};

INSTANTIATE_TEST_SUITE_P(BrokenInputIsolator, BrokenInputIsolatorFile,
                         ::testing::ValuesIn(mistakes));

TEST(BrokenInputIsolatorTest, OneHarmonicForceIsNeeded) {
  const std::string alone = changed(sound, "set Title", "set Analyses = design\nset Title");
  const std::string two = message_of(changed(
      alone, "subsection Analysis curve",
      "subsection Excitation more\nset Type = force\nset At = isolator.mass\nset Direction = y\n"
      "set Amplitude = 1 N\nset Frequency = 3 Hz\nend\nsubsection Analysis curve"));
  EXPECT_NE(two.find("one excitation, a harmonic force, but this model has 2"), std::string::npos)
      << two;
  const std::string base = message_of(changed(
      changed(alone, "set Type = force\n  set At = isolator.mass", "set Type = base displacement"),
      "0.832 N", "1 mm"));
  EXPECT_NE(base.find("a harmonic force; the excitation force is none"), std::string::npos) << base;
}

TEST(BrokenInputIsolatorTest, BothStopsAreNeeded) {
  const std::string one = changed(sound, "set Type = isolator design",
                                  "set Type = isolator design\n  set Active contacts = up");
  EXPECT_NE(message_of(one).find("two contacts"), std::string::npos) << message_of(one);
  const std::string other = changed(sound, "    set Damping constant = 16 N s/m\n", "");
  EXPECT_NE(message_of(other).find("two equal stops"), std::string::npos) << message_of(other);
}

TEST(BrokenInputIsolatorTest, TheKeysChangeTheStopsAndNothingElse) {
  const auto with = [](const std::string &from, const std::string &to) {
    return message_of(
        changed(changed(in_metres, "  subsection Isolator design\n", exact), from, to));
  };
  const std::string same = with("Clearance key = Variables/d", "Clearance key = Variables/k1");
  EXPECT_NE(same.find("another key than Stiffness key"), std::string::npos) << same;
  const std::string wrong = with("key = Variables/k1", "key = Body/isolator/Mass/mass/Mass");
  EXPECT_NE(wrong.find("the stiffness of both stops in N/m"), std::string::npos) << wrong;
  const std::string more = with("set Mass = 2 kg", "set Mass = k1 / 100 * 1 kg");
  EXPECT_NE(more.find("changes nothing but the stops"), std::string::npos) << more;
  const std::string text = with("key = Variables/k1", "key = Title");
  EXPECT_NE(text.find("one number as its value"), std::string::npos) << text;
  const std::string half = with("set Stiffness = k1 * 1 N/m", "set Stiffness = 200 N/m");
  EXPECT_NE(half.find("two equal stops"), std::string::npos) << half;
}

TEST(BrokenInputIsolatorTest, TheRepeatedAnalysisIsABranchOverTheFrequency) {
  const std::string file = changed(in_metres, "  subsection Isolator design\n", exact);
  const std::string other =
      message_of(changed(file, "  set Type = branch\n", "  set Type = steady state\n"));
  EXPECT_NE(other.find("of the type branch"), std::string::npos) << other;
  const std::string over = message_of(
      changed(file, "    set First frequency = 10 rad/s\n    set Last frequency = 80",
              "    set Parameter = Variables/k1\n    set First = 1\n    set Last = 900 #"));
  EXPECT_NE(over.find("without the key Parameter"), std::string::npos) << over;
}

TEST(BrokenInputIsolatorTest, TheRepeatedBranchRecordsDisplacements) {
  const std::string file = changed(in_metres, "  subsection Isolator design\n", exact);
  const auto with = [&](const std::string &lines) {
    return message_of(changed(file, "  set Type = branch\n", "  set Type = branch\n" + lines));
  };
  EXPECT_EQ(with("set Record = impacts, extreme values\n"), "");
  for (const char *lines :
       {"set Record = impacts\n", "subsection Extreme values\nset Quantities = velocity\nend\n"})
    EXPECT_NE(with(lines).find("records extreme values of displacements"), std::string::npos)
        << with(lines);
}

} // namespace broken_input_isolator_tests
} // namespace vibroimpact
