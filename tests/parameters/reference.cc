// The three printed forms of the declarations.
#include "sample.h"

// Without this Boost 1.74 prints a message about its own use of the placeholders.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <gtest/gtest.h>

#include <sstream>

namespace vibroimpact::parameters {
namespace reference_tests {

TEST(Reference, markdown_has_a_heading_and_a_table_for_each_section) {
  Section file("Reference", "All keys.");
  file.named_subsection("Stop", "Where it ends: a | b.")
      .quantity("Gap", "1 mm", dimension::length, range::positive, "g", "Either | or.")
      .choice("Law", "linear", {"linear", "hertz"}, "The law.");
  file.named_subsection("Stop", "")
      .subsection("Side", "Inner.")
      .quantities("Point", "0, 0", dimension::length, range::any, "", "Where.", 2, 3);
  const std::string text = print_declarations(file, "markdown");
  const std::string sections = R"(
## Stop NAME

Where it ends: a | b.

| Key | Default | Unit | Range / options | Symbol | Meaning |
|---|---|---|---|---|---|
| `Gap` | `1 mm` | m | greater than 0 | g | Either \| or. |
| `Law` | `linear` | choice | `linear`, `hertz` |  | The law. |

### Stop NAME / Side

Inner.

| Key | Default | Unit | Range / options | Symbol | Meaning |
|---|---|---|---|---|---|
| `Point` | `0, 0` | m | 2 to 3 values |  | Where. |
)";
  EXPECT_EQ(text.substr(0, 25), "# Reference\n\nAll keys.\n\nA");
  ASSERT_NE(text.find(sections), std::string::npos) << text;
  EXPECT_EQ(text.substr(text.find(sections)), sections);
  EXPECT_NE(text.find("\n| `Variables` |"), std::string::npos);
}

TEST(Reference, markdown_has_contents_and_marks_what_must_be_given) {
  Section file("Reference", "");
  Section &stop = file.named_subsection("Stop", "");
  stop.quantity("Gap", "", dimension::length, range::positive, "g", "Of the sides.")
      .required()
      .quantity("Width", "", dimension::length, range::positive, "b", "Of the stop.")
      .required("Gap | Limit is given")
      .quantity("Limit", "", dimension::length, range::positive, "", "Empty means none.");
  stop.subsection("Kelvin-Voigt", "");
  stop.named_subsection("Side", "");
  file.subsection("Integration", "");
  const std::string text = print_declarations(file, "markdown");
  EXPECT_NE(
      text.find("\n- [Integration](#integration)\n- [Stop NAME](#stop-name): "
                "[Kelvin-Voigt](#stop-name--kelvin-voigt), [Side NAME](#stop-name--side-name)\n"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("| `Gap` | **required** | m |"), std::string::npos) << text;
  EXPECT_NE(text.find("| `Width` | **required** when Gap \\| Limit is given | m |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| `Limit` |  | m |"), std::string::npos) << text;
  const std::string json = print_declarations(file, "json");
  EXPECT_NE(json.find("\"required\": true, \"required when\": \"Gap | Limit is given\""),
            std::string::npos)
      << json;
  EXPECT_NE(print_declarations(file, "prm").find("Required when Gap | Limit is given."),
            std::string::npos);
}

TEST(Reference, prm_holds_all_defaults_and_can_be_read) {
  const std::string text = print_declarations(*sample_declarations(), "prm");
  const auto set = parse_prm(text);
  const Values root = set->root();
  EXPECT_EQ(root.instances("Body"), std::vector<std::string>{"NAME"});
  EXPECT_EQ(root.instance("Body", "NAME").instances("Point"), std::vector<std::string>{"NAME"});
  EXPECT_EQ(root.instance("Body", "NAME").subsection("Geometry").integer("Elements"), 40);
  EXPECT_NE(text.find("  # Of the force. [rad/s] greater than 0.\n  set Frequency = 3 Hz\n"),
            std::string::npos)
      << text;
}

TEST(Reference, json_holds_what_was_declared) {
  std::istringstream text(print_declarations(*sample_declarations(), "json"));
  boost::property_tree::ptree tree;
  boost::property_tree::read_json(text, tree);
  EXPECT_EQ(tree.get<std::string>("name"), "Sample");
  const auto &excitation = tree.get_child("subsections").front().second;
  EXPECT_EQ(excitation.get<std::string>("name"), "Excitation");
  const auto &frequency = excitation.get_child("keys").front().second;
  EXPECT_EQ(frequency.get<std::string>("name"), "Frequency");
  EXPECT_EQ(frequency.get<std::string>("kind"), "quantity");
  EXPECT_EQ(frequency.get<std::string>("default"), "3 Hz");
  EXPECT_EQ(frequency.get<std::string>("unit"), "rad/s");
  EXPECT_EQ(frequency.get<std::string>("range"), "greater than 0");
  EXPECT_EQ(frequency.get<std::string>("symbol"), "Omega");
  EXPECT_EQ(frequency.get<std::string>("sentence"), "Of the force.");
  const auto &body = tree.get_child("named subsections").front().second;
  const auto &type = body.get_child("keys").front().second;
  EXPECT_EQ(type.get_child("options").size(), 3U);
}

TEST(Reference, an_unknown_format_is_a_programming_error) {
  EXPECT_THROW(print_declarations(*sample_declarations(), "html"), std::logic_error);
}

} // namespace reference_tests
} // namespace vibroimpact::parameters
