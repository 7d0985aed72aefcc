// Names of the version before: read as the present ones wherever a name may stand, with one warning
// for each that says where it stands.
#include "sample.h"

#include <gtest/gtest.h>

namespace vibroimpact::parameters {
namespace former_names_tests {

std::shared_ptr<const Section> declarations() {
  auto file = std::make_shared<Section>("Sample", "A file for tests.");
  Section &analysis = file->named_subsection("Analysis", "An analysis.");
  analysis.choice("Type", "modal", {"modal", "steady state"}, "What it is.")
      .names("Record", "", "What is kept.")
      .text("Path", "", "Of a key.");
  analysis.subsection("Steady state", "Of that type.").text("Tied to", "", "A name.");
  return file;
}

struct Read {
  std::shared_ptr<const ParameterSet> set;
  std::string printed;
};

Read read(const std::string &text, bool json = false, const std::vector<Override> &overrides = {}) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const auto set =
      ParameterSet::parse(declarations(), text, json ? "old.json" : "old.prm", json, overrides);
  const std::string printed =
      ::testing::internal::GetCapturedStdout() + ::testing::internal::GetCapturedStderr();
  return {set, printed};
}

int warnings(const Read &read) {
  int count = 0;
  for (std::size_t at = read.printed.find("is now called"); at != std::string::npos;
       at = read.printed.find("is now called", at + 1))
    ++count;
  return count;
}

constexpr const char *old_file = R"(subsection Analysis a
  set Type   = response
  set Record = impacts, excursions
  set Path   = Analysis/a/Response/Follows
  subsection Response
    set Follows = b
  end
end
subsection Analysis b
  set Type = response
end
)";

TEST(FormerNames, are_read_as_the_present_ones) {
  const Values a = read(old_file).set->root().instance("Analysis", "a");
  EXPECT_EQ(a.choice("Type"), "steady state");
  EXPECT_EQ(a.names("Record"), (std::vector<std::string>{"impacts", "extreme values"}));
  EXPECT_EQ(a.text("Path"), "Analysis/a/Steady state/Tied to");
  EXPECT_EQ(a.subsection("Steady state").text("Tied to"), "b");
}

TEST(FormerNames, warn_once_each_at_the_first_place) {
  const Read found = read(old_file);
  EXPECT_EQ(warnings(found), 4) << found.printed;
  for (const char *sentence :
       {"old.prm:2: Analysis a / Type: 'response' is now called 'steady state'; the next version "
        "no longer reads "
        "the former name.",
        "old.prm:3: Analysis a / Record: 'excursions' is now called 'extreme values'",
        "old.prm:4: Analysis a / Path: 'Response' is now called 'Steady state'",
        "old.prm:4: Analysis a / Path: 'Follows' is now called 'Tied to'"})
    EXPECT_NE(found.printed.find(sentence), std::string::npos) << found.printed;
}

TEST(FormerNames, are_read_in_overrides_and_json) {
  const Read found = read(
      R"({"Analysis a": {"Response": {"Follows": "b"}}})", true,
      {{"Analysis/a/Response/Follows", "c", "--set"}, {"Analysis/a/Type", "response", "--set"}});
  EXPECT_EQ(found.set->root().instance("Analysis", "a").subsection("Steady state").text("Tied to"),
            "c");
  EXPECT_EQ(found.set->root().instance("Analysis", "a").choice("Type"), "steady state");
  EXPECT_EQ(warnings(found), 3) << found.printed;
}

TEST(FormerNames, the_echo_has_the_present_ones_and_no_warning_follows) {
  const Read found = read(read(old_file).set->echo());
  EXPECT_EQ(warnings(found), 0) << found.printed;
  EXPECT_EQ(found.set->root().instance("Analysis", "a").subsection("Steady state").text("Tied to"),
            "b");
}

TEST(FormerNames, of_both_names_of_a_key_only_one_may_stand) {
  const std::string text = "subsection Analysis a\n  subsection Steady state\n    set Tied to = b\n"
                           "    set Follows = c\n  end\nend\n";
  EXPECT_EQ(error_of([&] { ParameterSet::parse(declarations(), text, "old.prm", false, {}); }),
            "old.prm:4: Analysis a / Steady state / Tied to = c\n  this key is set twice; first at "
            "old.prm:3.");
}

TEST(FormerNames, other_text_with_a_slash_is_left_alone) {
  const Values root =
      read("subsection Analysis a\n  set Path = data/Response/Follows\nend\n").set->root();
  EXPECT_EQ(root.instance("Analysis", "a").text("Path"), "data/Response/Follows");
}

} // namespace former_names_tests
} // namespace vibroimpact::parameters
