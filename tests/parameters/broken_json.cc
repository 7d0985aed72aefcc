#include "sample.h"

#include <gtest/gtest.h>

namespace vibroimpact::parameters {
namespace broken_json_tests {

std::string message(const std::string &text) {
  return error_of([&] { parse_json(text); });
}

TEST(BrokenJson, invalid_syntax_has_a_line) {
  const std::string found = message("{\n \"Title\": \"a\",\n \"Bodies\" \"b\"\n}");
  EXPECT_EQ(found.substr(0, 45), "beams.json:3\n  this is not valid JSON: expect") << found;
}

TEST(BrokenJson, only_an_object_is_a_file) {
  const std::string expected =
      "beams.json\n  the file must hold one object: { \"KEY\": \"VALUE\", ... }.";
  EXPECT_EQ(message("[1, 2]"), expected);
  EXPECT_EQ(message("\"text\""), expected);
}

TEST(BrokenJson, arrays_are_not_ignored) {
  EXPECT_EQ(message(R"({"Body a": {"Geometry": {"Start": [1, 2, 3]}}})"),
            "beams.json: \"Body a\"/\"Geometry\"/\"Start\"\n  arrays are not read; write a list as "
            "one string: \"1, 2, 3\".");
  EXPECT_EQ(
      message(R"({"Body a": [{"Type": "beam"}]})"),
      "beams.json: \"Body a\"\n  arrays are not read; write a list as one string: \"1, 2, 3\".");
}

TEST(BrokenJson, keys_and_sections_are_not_mixed_up) {
  EXPECT_EQ(message(R"({"Title": {"value": "a"}})"),
            "beams.json: \"Title\"\n  'Title' is a key, not a subsection.");
  EXPECT_EQ(
      message(R"({"Excitation": 3})"),
      "beams.json: \"Excitation\" = 3\n  'Excitation' is a subsection, not a key with a value.");
}

TEST(BrokenJson, unknown_and_duplicate_entries) {
  EXPECT_EQ(message(R"({"Titel": "a"})"),
            "beams.json: \"Titel\" = a\n  there is no key 'Titel' here; did you mean 'Title'?");
  EXPECT_EQ(
      message(R"({"Contct heads": {"Clearance": 1}})"),
      "beams.json: \"Contct heads\"\n  there is no subsection 'Contct heads' here; did you mean "
      "'Contact heads'?");
  EXPECT_EQ(message(R"({"Title": "a", "Title": "b"})"),
            "beams.json: \"Title\" = b\n  this key is set twice.");
  EXPECT_EQ(message(R"({"Body a": {"Type": "beam"}, "Body a": {"Type": "beam"}})"),
            "beams.json: \"Body a\"\n  this subsection stands here twice.");
  EXPECT_EQ(message(R"({"Body": {"Type": "beam"}})"),
            "beams.json: \"Body\"\n  a name is missing; write 'subsection Body NAME'.");
}

TEST(BrokenJson, values_are_checked_as_in_prm) {
  EXPECT_EQ(
      message(R"({"Contact heads": {"Clearance": "5 kg"}})"),
      "beams.json: \"Contact heads\"/\"Clearance\" = 5 kg\n  '5 kg' is a mass [kg]; a length [m] "
      "is expected (greater than or equal to 0), for example 0 m.");
  EXPECT_EQ(
      message(R"({"Excitation": {"Frequency": 3}})"),
      "beams.json: \"Excitation\"/\"Frequency\" = 3\n  '3' has no unit; a frequency must say Hz, "
      "kHz, MHz, rad/s or rpm; a frequency [rad/s] is expected (greater than 0), for example 3 "
      "Hz.");
  EXPECT_EQ(
      message(R"({"Contact heads": {"Prestressed": null}})"),
      "beams.json: \"Contact heads\"/\"Prestressed\" = null\n  'null' is not possible; true or "
      "false is expected (or yes, no, on, off).");
}

TEST(BrokenJson, a_value_that_prm_could_not_hold_is_refused) {
  EXPECT_EQ(
      message(R"({"Title": "number #1"})"),
      "beams.json: \"Title\" = number #1\n  a value may not hold '#' or a line break, nor end in "
      "'\\'.");
}

TEST(BrokenJson, endless_nesting_is_refused) {
  EXPECT_EQ(message("{\n\"a\": " + std::string(100000, '[')),
            "beams.json:2\n  brackets nest more than 50 deep.");
  EXPECT_EQ(
      message("{ \"Title\": \"" + std::string(100, '{') + "\\\"" + std::string(100, '[') + "\" }"),
      ""); // within a text they are letters
}

TEST(BrokenJson, control_characters_are_refused) {
  EXPECT_NE(message(R"({"Title": "a\u0000b"})").find("no text"), std::string::npos);
}

} // namespace broken_json_tests
} // namespace vibroimpact::parameters
