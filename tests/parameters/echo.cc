// The echo read again is the same set; equal physics has equal fingerprints.
#include "sample.h"

#include <gtest/gtest.h>

namespace vibroimpact::parameters {
namespace echo_tests {

TEST(Echo, read_again_gives_the_same_echo_values_and_given_flags) {
  const auto set = parse_prm(sample_text, {{"Contact/heads/Clearance", "7 mm", "--set"},
                                           {"Variables/lambda", "4", "--set"}});
  const auto again = parse_prm(set->echo());
  EXPECT_EQ(again->echo(), set->echo());
  EXPECT_EQ(again->root().fingerprint(), set->root().fingerprint());
  const Values left = again->root().instance("Body", "left");
  EXPECT_FALSE(left.given("Type"));
  EXPECT_FALSE(left.subsection_given("Modes"));
  EXPECT_TRUE(left.subsection_given("Geometry"));
  EXPECT_TRUE(again->root().instance("Contact", "heads").given("Clearance"));
}

TEST(Echo, holds_defaults_overrides_and_values_as_written) {
  const std::string echo = parse_prm("subsection Contact heads\n set Clearance = 5   mm\nend\n",
                                     {{"Contact/heads/Stiffness", "2 kN/m", "--set"}})
                               ->echo();
  const std::string expected = R"(
subsection Contact heads
  set Between         =  # default
  set Clearance       = 5 mm
  set Stiffness       = 2 kN/m
  set Hertz stiffness =  # default
  set Prestressed     = false  # default
end
)";
  EXPECT_NE(echo.find(expected), std::string::npos) << echo;
  EXPECT_NE(echo.find("\nsubsection Excitation  # default\n  set Frequency = 3 Hz  # default\n"),
            std::string::npos)
      << echo;
}

TEST(Echo, long_values_are_wrapped_and_read_back) {
  std::string names = "name0";
  for (int i = 1; i < 60; ++i)
    names += ", name" + std::to_string(i);
  const auto set = parse_prm("set Bodies = " + names + "\n");
  const std::string echo = set->echo();
  EXPECT_EQ(parse_prm(echo)->root().names("Bodies"), set->root().names("Bodies"));
  for (std::size_t begin = 0, end = 0; (end = echo.find('\n', begin)) != std::string::npos;
       begin = end + 1)
    EXPECT_LE(end - begin, 100U);
}

TEST(Echo, a_changed_value_counts_as_given_in_spite_of_the_mark) {
  const auto set =
      parse_prm("subsection Excitation # default\n set Frequency = 4 Hz # default\nend\n");
  EXPECT_TRUE(set->root().subsection("Excitation").given("Frequency"));
  EXPECT_TRUE(set->root().subsection_given("Excitation"));
}

TEST(Echo, of_json_is_prm) {
  const auto set = parse_json(R"({"Title": "a", "Body left": {"Point head": {"Mass": "2 g"}}})");
  EXPECT_EQ(parse_prm(set->echo())->echo(), set->echo());
}

TEST(Echo, fingerprint_is_in_si_and_without_the_sections_own_name) {
  const auto set =
      parse_prm("subsection Body a\n subsection Point p\n  set Mass = 1 kg\n end\nend\n"
                "subsection Body b\n subsection Point p\n  set Mass = 1000 g\n end\nend\n"
                "subsection Body c\n subsection Point p\n  set Mass = 1 g\n end\nend\n");
  const Values root = set->root();
  const std::string print = root.instance("Body", "a").fingerprint();
  EXPECT_EQ(print, root.instance("Body", "b").fingerprint());
  EXPECT_NE(print, root.instance("Body", "c").fingerprint());
  EXPECT_EQ(print, "Type = beam\n"
                   "Geometry/Elements = 40\n"
                   "Geometry/Section = \n"
                   "Geometry/Start = 0, 0, 0\n"
                   "Modes/Damping ratio = 0.01\n"
                   "Point p/Mass = 1\n");
}

TEST(Echo, fingerprint_sees_variables_in_texts) {
  const auto set = parse_prm(sample_text);
  const auto changed = set->with({{"Variables/L", "0.5 m", "grid"}});
  const auto section = [](const ParameterSet &of) {
    const std::string print = of.root().instance("Body", "left").fingerprint();
    const std::size_t begin = print.find("Geometry/Section");
    return print.substr(begin, print.find('\n', begin) - begin);
  };
  EXPECT_EQ(section(*set), "Geometry/Section = rectangle, 30 mm, L / 400; L = 0.29999999999999999");
  EXPECT_EQ(section(*changed), "Geometry/Section = rectangle, 30 mm, L / 400; L = 0.5");
}

} // namespace echo_tests
} // namespace vibroimpact::parameters
