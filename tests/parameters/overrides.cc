#include "sample.h"

#include <gtest/gtest.h>

#include <tuple>

namespace vibroimpact::parameters {
namespace overrides_tests {

double clearance(const ParameterSet &set) {
  return set.root().instance("Contact", "heads").quantity("Clearance");
}

TEST(Overrides, a_path_is_written_with_slash_or_blank) {
  for (const char *path : {"Contact/heads/Clearance", "Contact heads/Clearance"}) {
    const auto set = parse_prm(sample_text, {{path, "7 mm", "--set"}});
    EXPECT_EQ(clearance(*set), 0.007);
    EXPECT_TRUE(set->root().instance("Contact", "heads").given("Clearance"));
  }
}

TEST(Overrides, top_level_and_nested_keys) {
  const auto set = parse_prm(sample_text, {{"Title", "new", "--set"},
                                           {"Body/left/Geometry/Elements", "7", "--set"},
                                           {"Body left/Point/head/Mass", "1 kg", "--set"},
                                           {"Body/right/Modes/Damping ratio", "2 %", "--set"}});
  const Values root = set->root();
  EXPECT_EQ(root.text("Title"), "new");
  EXPECT_EQ(root.instance("Body", "left").subsection("Geometry").integer("Elements"), 7);
  EXPECT_EQ(root.instance("Body", "left").instance("Point", "head").quantity("Mass"), 1);
  EXPECT_TRUE(root.instance("Body", "right").subsection_given("Modes"));
}

std::string warnings_of(const std::string &path, const std::string &value) {
  ::testing::internal::CaptureStdout();
  parse_prm(sample_text, {{path, value, "--set"}});
  return ::testing::internal::GetCapturedStdout();
}

TEST(Overrides, a_number_without_the_unit_of_the_one_before_is_warned_of) {
  EXPECT_EQ(warnings_of("Variables/L", "1"),
            "warning: --set Variables/L = 1 has no unit and is taken as 1 m, but replaces 0.3 m\n");
  EXPECT_EQ(warnings_of("Contact/heads/Clearance", "2 * 3"),
            "warning: --set Contact/heads/Clearance = 2 * 3 has no unit and is taken as 6 m, but "
            "replaces 5 mm\n");
  for (const char *good : {"0", "1 mm", "L"})
    EXPECT_EQ(warnings_of("Contact/heads/Clearance", good), "") << good;
  EXPECT_EQ(warnings_of("Variables/lambda", "3"), "");
  EXPECT_EQ(warnings_of("Title", "1"), "");
}

TEST(Overrides, with_leaves_the_original_as_it_is) {
  const auto original = parse_prm(sample_text);
  const auto changed = original->with({{"Contact/heads/Clearance", "7 mm", "Analysis grid"}});
  EXPECT_EQ(clearance(*original), 0.005);
  EXPECT_EQ(clearance(*changed), 0.007);
  EXPECT_EQ(clearance(*changed->with({{"Contact/heads/Clearance", "8 mm", "grid"}})), 0.008);
  EXPECT_EQ(clearance(*changed), 0.007);
  const auto elements = [](const ParameterSet &set) {
    return set.root().instance("Body", "left").subsection("Geometry").integer("Elements");
  };
  const long before = elements(*original);
  EXPECT_EQ(elements(*original->with({{"Variables/lambda", "3", "grid"}})), 30);
  EXPECT_EQ(elements(*original), before);
  EXPECT_NE(before, 30);
}

TEST(Overrides, a_variable_changes_all_that_uses_it) {
  const auto set = parse_prm(sample_text);
  for (const auto &changed : {set->with({{"Variables/lambda", "3", "grid"}}),
                              parse_prm(sample_text, {{"Variables/lambda", "3", "--set"}})}) {
    EXPECT_EQ(changed->root().instance("Contact", "heads").quantity("Stiffness"), 3000);
    const Values left = changed->root().instance("Body", "left");
    EXPECT_EQ(left.subsection("Geometry").integer("Elements"), 30);
    EXPECT_EQ(changed->root().text("Variables"), "lambda = 3, L = 0.3 m, twice = 2 * L");
  }
}

TEST(Overrides, a_variable_changes_later_variables) {
  const auto set = parse_prm(sample_text)->with({{"Variables/L", "50 cm", "grid"}});
  const Values geometry = set->root().instance("Body", "left").subsection("Geometry");
  EXPECT_EQ(geometry.quantities("Start"), (std::vector<double>{0, 0.01, 1}));
  EXPECT_EQ(geometry.part("Section", "L", dimension::length), 0.5);
}

// Only what depends on the changed variable is evaluated anew, also over other variables; names
// that begin alike are others.
TEST(Overrides, a_variable_changes_what_depends_on_it_near_and_far) {
  const std::string text = "set Variables = a = 2, ab = 3 * a, far = ab + 1, other = 7\n"
                           "subsection Contact heads\n"
                           "  set Clearance = far * 1 mm\n"
                           "  set Stiffness = other * 1 kN/m\n"
                           "end\n";
  const auto original = parse_prm(text);
  EXPECT_DOUBLE_EQ(clearance(*original), 0.007);
  for (const auto &[path, value, expected] :
       {std::tuple("Variables/a", "4", 0.013), std::tuple("Variables/ab", "9", 0.010),
        std::tuple("Variables/other", "1", 0.007), std::tuple("Variables/far", "a", 0.002)}) {
    const auto changed = original->with({{path, value, "grid"}});
    EXPECT_DOUBLE_EQ(clearance(*changed), expected) << path;
    EXPECT_EQ(changed->echo(), parse_prm(text, {{path, value, "grid"}})->echo());
    EXPECT_EQ(changed->root().fingerprint(),
              parse_prm(text, {{path, value, "grid"}})->root().fingerprint());
  }
  const auto twice = original->with({{"Variables/a", "4", "grid"}})
                         ->with({{"Variables/other", "2", "grid"}, {"Variables/ab", "5", "grid"}});
  EXPECT_DOUBLE_EQ(clearance(*twice), 0.006);
  EXPECT_EQ(twice->root().instance("Contact", "heads").quantity("Stiffness"), 2000);
}

TEST(Overrides, all_variables_at_once) {
  const auto set =
      parse_prm(sample_text)->with({{"Variables", "lambda = 5, L = 1 m, twice = 3 m", "--set"}});
  EXPECT_EQ(set->root().instance("Contact", "heads").quantity("Stiffness"), 5000);
}

std::string message(const std::string &path, const std::string &value) {
  return error_of([&] { parse_prm(sample_text)->with({{path, value, "--set"}}); });
}

TEST(Overrides, a_wrong_value_names_the_override) {
  const std::string expected =
      "--set Contact/heads/Clearance=5 kg\n  '5 kg' is a mass [kg]; a length [m] is expected "
      "(greater than or equal to 0), for example 0 m.";
  EXPECT_EQ(message("Contact/heads/Clearance", "5 kg"), expected);
  EXPECT_EQ(error_of([] {
              parse_prm(sample_text, {{"Contact/heads/Clearance", "5 kg", "--set"}});
            }),
            expected);
}

TEST(Overrides, unknown_paths_are_refused_with_a_suggestion) {
  EXPECT_EQ(message("Contact/heads/Clearence", "1 m"),
            "--set Contact/heads/Clearence=1 m\n  there is no key 'Clearence' here; did you mean "
            "'Clearance'?");
  EXPECT_EQ(message("Contact/head/Clearance", "1 m"),
            "--set Contact/head/Clearance=1 m\n  there is no 'Contact head'; the file has: Contact "
            "heads.");
  EXPECT_EQ(
      message("Contct/heads/Clearance", "1 m"),
      "--set Contct/heads/Clearance=1 m\n  there is no subsection 'Contct' here; did you mean "
      "'Contact NAME'?");
  EXPECT_EQ(message("Body/right/Point/tip/Mass", "1 kg"),
            "--set Body/right/Point/tip/Mass=1 kg\n  there is no 'Point tip'; the file has no "
            "subsection 'Point NAME'.");
  EXPECT_EQ(message("Excitation", "1"),
            "--set Excitation=1\n  'Excitation' is a subsection; the name "
            "of a key is missing after it.");
  EXPECT_EQ(message("Contact/heads", "1"), "--set Contact/heads=1\n  the name of a key is missing "
                                           "after 'heads'.");
  EXPECT_EQ(message("", "1"), "--set =1\n  a path is missing; write SECTION/KEY.");
  EXPECT_EQ(message("Variables/lamda", "1"),
            "--set Variables/lamda=1\n  there is no variable 'lamda'; did you mean 'lambda'?");
}

TEST(Overrides, a_variable_that_breaks_a_key_is_refused_at_the_key) {
  EXPECT_EQ(message("Variables/lambda", "-1").substr(0, 70),
            "params/beams.prm:10: Body left / Geometry / Elements = 10 * lambda\n  '");
  EXPECT_EQ(
      message("Variables/lambda", "2 *"),
      "--set Variables/lambda=2 *\n  '2 *' cannot be computed: check its operators and commas.");
}

TEST(Overrides, a_value_that_the_echo_could_not_hold_is_refused) {
  EXPECT_EQ(message("Title", "a # b"), "--set Title=a # b\n  a value may not hold '#' or a line "
                                       "break, nor end in '\\'.");
}

TEST(Overrides, are_split_at_the_first_equals_sign) {
  const Override split = split_override("Variables = a = 2", "--set");
  EXPECT_EQ(split.path, "Variables");
  EXPECT_EQ(split.value, "a = 2");
  EXPECT_EQ(split.origin, "--set");
  EXPECT_EQ(
      error_of([] { split_override("Title", "--set"); }),
      "--set Title\n  PATH=VALUE is expected, for example \"Contact/stop/Clearance=0.7 mm\".");
}

} // namespace overrides_tests
} // namespace vibroimpact::parameters
