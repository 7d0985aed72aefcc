// Files that include others: what stands where, and what is said of a file that is not there.
#include "sample.h"

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vibroimpact::parameters {
namespace includes_tests {

class Includes : public ::testing::Test {
protected:
  std::string write(const std::string &name, const std::string &text) const {
    const std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }
  std::string file(const std::string &name) const { return (folder_.path() / name).string(); }

  vibroimpact::testing::TemporaryFolder folder_;
};

std::string read_error(const std::string &file) {
  return error_of([&] { ParameterSet::read(sample_declarations(), file); });
}

TEST_F(Includes, are_found_beside_the_file_that_names_them) {
  const std::string top = write("top.prm", "include parts/bodies.prm\nset Title = top\n");
  write("parts/bodies.prm", "include left.prm\nsubsection Body right\n  include type.prm\nend\n");
  write("parts/left.prm", "subsection Body left\nend\n");
  write("parts/type.prm", "set Type = lumped\n");
  const auto set = ParameterSet::read(sample_declarations(), top);
  EXPECT_EQ(set->root().instances("Body"), (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(set->root().instance("Body", "right").choice("Type"), "lumped");
  EXPECT_EQ(set->root().instance("Body", "right").place("Type"),
            file("parts/type.prm") + ":1: Body right / Type");
}

TEST_F(Includes, the_echo_holds_what_they_hold) {
  const std::string top = write("top.prm", "include bodies.prm\n");
  write("bodies.prm", "subsection Body right\n  set Type = lumped\nend\n");
  const auto set = ParameterSet::read(sample_declarations(), top);
  const auto again = parse_prm(set->echo());
  EXPECT_EQ(set->echo().find("include"), std::string::npos);
  EXPECT_EQ(again->root().instance("Body", "right").choice("Type"), "lumped");
  EXPECT_EQ(again->root().fingerprint(), set->root().fingerprint());
}

TEST_F(Includes, one_that_is_missing_is_named_with_the_way_to_it) {
  const std::string top = write("top.prm", "include middle.prm\n");
  const std::string middle = write("middle.prm", "# nothing\ninclude nowhere.prm\n");
  const std::string nowhere = file("nowhere.prm");
  EXPECT_EQ(read_error(top), middle + ":2\n  the file '" + nowhere +
                                 "' does not exist; it is included by way of " + top + " -> " +
                                 middle + " -> " + nowhere + ".");
}

TEST_F(Includes, a_circle_is_refused_with_the_way_round) {
  const std::string top = write("top.prm", "include parts/middle.prm\n");
  const std::string middle = write("parts/middle.prm", "include ../top.prm\n");
  EXPECT_EQ(read_error(top), middle + ":1\n  the file includes itself: " + top + " -> " + middle +
                                 " -> " + file("parts/../top.prm") + ".");
}

TEST_F(Includes, a_key_that_stands_in_both_files_is_set_twice) {
  const std::string top = write("top.prm", "set Title = a\ninclude more.prm\n");
  const std::string more = write("more.prm", "\nset Title = b\n");
  EXPECT_EQ(read_error(top),
            more + ":2: Title = b\n  this key is set twice; first at " + top + ":1.");
}

TEST_F(Includes, a_section_must_end_in_the_file_it_begins_in) {
  const std::string top = write("top.prm", "include more.prm\nend\n");
  const std::string more = write("more.prm", "subsection Body a\n");
  EXPECT_EQ(read_error(top),
            more + ":1: Body a\n  this subsection is not closed: its 'end' is missing.");
}

} // namespace includes_tests
} // namespace vibroimpact::parameters
