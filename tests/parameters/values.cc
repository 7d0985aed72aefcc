#include "parameters/values.h"
#include "parameters/text.h"
#include "parameters/tree.h"

#include "sample.h"

#include <deal.II/base/parameter_handler.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace vibroimpact::parameters {
namespace values_tests {

using Names = std::vector<std::string>;

TEST(Values, the_sample_is_read_in_si) {
  const Values root = parse_prm(sample_text)->root();
  EXPECT_EQ(root.text("Title"), "Two beams");
  EXPECT_EQ(root.names("Bodies"), (Names{"left", "right"}));
  EXPECT_EQ(root.instances("Body"), (Names{"left", "right"}));
  EXPECT_DOUBLE_EQ(root.subsection("Excitation").quantity("Frequency"), 5.9 * std::numbers::pi);
  const Values left = root.instance("Body", "left");
  EXPECT_EQ(left.subsection("Geometry").integer("Elements"), 20);
  EXPECT_EQ(left.subsection("Geometry").quantities("Start"), (std::vector<double>{0, 0.01, 0.6}));
  EXPECT_EQ(left.instances("Point"), (Names{"head", "tail"}));
  EXPECT_DOUBLE_EQ(left.instance("Point", "head").quantity("Mass"), 0.0577114);
  const Values heads = root.instance("Contact", "heads");
  EXPECT_EQ(heads.names("Between"), (Names{"left.head", "right.head"}));
  EXPECT_EQ(heads.quantity("Clearance"), 0.005);
  EXPECT_EQ(heads.quantity("Stiffness"), 2000);
  EXPECT_TRUE(heads.boolean("Prestressed"));
  EXPECT_EQ(root.instance("Body", "right").choice("Type"), "lumped");
}

// The language is that of deal.II's ParameterHandler: whatever stands in a file, both read the
// same.
TEST(Values, texts_are_those_that_deal_ii_reads) {
  const std::string text = sample_text + "  SUBSECTION   Contact\ttails # two = 2\n"
                                         "SET Between\t=  left.tail ,\t\tright.tail \\ \n, x # y\n"
                                         "   set Clearance= a = 1,  set b\r\n END\n";
  const auto declarations = sample_declarations();
  const Node root = build_tree(*declarations, scan_prm(text, "beams.prm"));
  dealii::ParameterHandler handler;
  for_each_node(root, [&](const Node &node) {
    for (const std::string &name : node.path)
      handler.enter_subsection(name);
    for (const Value &value : node.values)
      handler.declare_entry(value.key->name, value.key->default_value);
    for (std::size_t i = 0; i < node.path.size(); ++i)
      handler.leave_subsection();
  });
  handler.parse_input_from_string(text);
  for_each_node(root, [&](const Node &node) {
    for (const Value &value : node.values)
      EXPECT_EQ(value.text, normalised(handler.get(node.path, value.key->name))) << value.key->name;
  });
}

TEST(Values, what_is_not_given_has_its_default) {
  const Values root = parse_prm(sample_text)->root();
  const Values left = root.instance("Body", "left");
  EXPECT_EQ(left.choice("Type"), "beam");
  EXPECT_FALSE(left.given("Type"));
  EXPECT_EQ(left.subsection("Modes").quantity("Damping ratio"), 0.01);
  EXPECT_FALSE(left.subsection_given("Modes"));
  EXPECT_TRUE(left.subsection_given("Geometry"));
  EXPECT_TRUE(root.instance("Body", "right").given("Type"));
  EXPECT_EQ(root.instance("Body", "right").subsection("Geometry").integer("Elements"), 40);
}

TEST(Values, an_empty_file_has_all_defaults) {
  const Values root = parse_prm("")->root();
  EXPECT_EQ(root.text("Title"), "");
  EXPECT_TRUE(root.instances("Body").empty());
  EXPECT_DOUBLE_EQ(root.subsection("Excitation").quantity("Frequency"), 6 * std::numbers::pi);
}

TEST(Values, json_reads_the_same) {
  const auto set = parse_json(R"({"Title": "Two beams", "Variables": "lambda = 2",
    "Body left": {"Geometry": {"Elements": 20, "Start": "0 m, 1 cm -> 0.6"},
                  "Point head": {"Mass": "57.7114 g"}, "Point tail": {}},
    "Contact heads": {"Clearance": 5e-3, "Stiffness": "lambda * 1 kN/m", "Prestressed": true}})");
  const Values root = set->root();
  EXPECT_EQ(root.text("Title"), "Two beams");
  const Values left = root.instance("Body", "left");
  EXPECT_EQ(left.subsection("Geometry").integer("Elements"), 20);
  EXPECT_EQ(left.subsection("Geometry").quantities("Start"), (std::vector<double>{0, 0.01, 0.6}));
  EXPECT_EQ(left.instances("Point"), (Names{"head", "tail"}));
  EXPECT_EQ(root.instance("Contact", "heads").quantity("Clearance"), 0.005);
  EXPECT_EQ(root.instance("Contact", "heads").quantity("Stiffness"), 2000);
  EXPECT_TRUE(root.instance("Contact", "heads").boolean("Prestressed"));
}

TEST(Values, optional_keys_are_asked_for_by_has) {
  const Values heads =
      parse_prm("subsection Contact heads\nend\n")->root().instance("Contact", "heads");
  EXPECT_FALSE(heads.has("Stiffness"));
  EXPECT_EQ(error_of([&] { heads.require("Stiffness"); }),
            "params/beams.prm:1: Contact heads / Stiffness\n  a value must be given when "
            "Law = penalty; a stiffness [N/m] is expected (greater than 0), for example 10 kN/m.");
  EXPECT_EQ(error_of([&] { heads.quantity("Stiffness"); }),
            error_of([&] { heads.require("Stiffness"); }));
}

TEST(Values, only_keys_that_are_marked_are_required) {
  const Values heads = parse_prm("subsection Contact heads\n  set Hertz stiffness = 1\nend\n")
                           ->root()
                           .instance("Contact", "heads");
  EXPECT_THROW(heads.require("Hertz stiffness"), std::logic_error);
  Section file("Sample", "");
  EXPECT_THROW(file.quantity("Gap", "1 mm", dimension::length, range::any, "", "").required(),
               std::logic_error);
}

TEST(Values, rejections_name_the_place) {
  const Values root = parse_prm(sample_text)->root();
  const Values heads = root.instance("Contact", "heads");
  EXPECT_EQ(error_of([&] { heads.reject("Clearance", "must be less than 1 mm"); }),
            "params/beams.prm:26: Contact heads / Clearance = 5 mm\n  Clearance must be less than "
            "1 mm.");
  EXPECT_EQ(error_of([&] { root.instance("Body", "left").reject("Type", "no"); }),
            "params/beams.prm:8: Body left / Type = beam (default)\n  no.");
  EXPECT_EQ(error_of([&] { heads.reject_section("it touches itself"); }),
            "params/beams.prm:23: Contact heads\n  it touches itself.");
  EXPECT_EQ(error_of([&] {
              heads.require_known("Between", "left.hea", {"left.head", "x"});
            }),
            "params/beams.prm:24: Contact heads / Between = left.head, right.head\n  there is no "
            "'left.hea'; did you mean 'left.head'?");
  EXPECT_EQ(error_of([&] { heads.require_known("Between", "left.head", {"left.head"}); }), "");
}

TEST(Values, parts_of_texts_are_evaluated_with_variables) {
  const Values geometry =
      parse_prm(sample_text)->root().instance("Body", "left").subsection("Geometry");
  EXPECT_EQ(geometry.part("Section", "30 mm", dimension::length, range::positive), 0.03);
  EXPECT_DOUBLE_EQ(geometry.part("Section", "L / 400", dimension::length), 0.3 / 400);
  EXPECT_EQ(error_of([&] { geometry.part("Section", "3 kg", dimension::length); }),
            "params/beams.prm:11: Body left / Geometry / Section = rectangle, 30 mm, L / 400\n"
            "  '3 kg' is a mass [kg]; a length [m] is expected, for example 5 mm.");
}

TEST(Values, a_unit_that_depends_on_another_key_is_checked_by_the_reader) {
  const Values stop = parse_prm("subsection Contact stop\n  set Hertz stiffness = 2 N/m^1.5\nend\n")
                          ->root()
                          .instance("Contact", "stop");
  EXPECT_EQ(stop.dimension("Hertz stiffness"), dimension::hertz_stiffness);
  EXPECT_NO_THROW(stop.require_dimension("Hertz stiffness", dimension::hertz_stiffness));
  EXPECT_EQ(error_of([&] { stop.require_dimension("Hertz stiffness", dimension::stiffness); }),
            "params/beams.prm:2: Contact stop / Hertz stiffness = 2 N/m^1.5\n  '2 N/m^1.5' is a "
            "Hertz stiffness [N/m^1.5]; a stiffness [N/m] is expected (greater than 0), for "
            "example 10 kN/m.");
}

TEST(Values, asking_for_what_is_not_declared_is_a_programming_error) {
  const Values root = parse_prm(sample_text)->root();
  EXPECT_THROW(root.quantity("Nothing"), std::logic_error);
  EXPECT_THROW(root.quantity("Title"), std::logic_error);
  EXPECT_THROW(root.subsection("Nothing"), std::logic_error);
  EXPECT_THROW(root.instances("Nothing"), std::logic_error);
  EXPECT_THROW(root.instance("Body", "middle"), std::logic_error);
}

TEST(Values, a_wrong_declaration_is_a_programming_error) {
  auto wrong = std::make_shared<Section>("", "");
  wrong->quantity("Length", "5 kg", dimension::length, range::any, "", "");
  EXPECT_THROW(ParameterSet::parse(wrong, "", "x.prm", false), std::logic_error);
  EXPECT_THROW(wrong->text("Length", "", ""), std::logic_error);
  EXPECT_THROW(wrong->text("a/b", "", ""), std::logic_error);
}

TEST(Values, included_files_lie_beside_the_file) {
  const std::string folder = ::testing::TempDir() + "/vibroimpact_include";
  std::filesystem::create_directories(folder + "/parts");
  std::ofstream(folder + "/main.prm") << "include parts/more.prm\nset Title = here\n";
  std::ofstream(folder + "/parts/more.prm") << "subsection Body a\n  set Type = bean\nend\n";
  EXPECT_EQ(error_of([&] { ParameterSet::read(sample_declarations(), folder + "/main.prm"); }),
            folder + "/parts/more.prm:2: Body a / Type = bean\n  'bean' is not possible; did you "
                     "mean 'beam'? one of these is expected: beam, shell, lumped.");
  std::ofstream(folder + "/parts/more.prm") << "subsection Body a\nend\n";
  const auto set = ParameterSet::read(sample_declarations(), folder + "/main.prm");
  EXPECT_EQ(set->root().instances("Body"), Names{"a"});
  EXPECT_EQ(set->folder(), folder);
}

} // namespace values_tests
} // namespace vibroimpact::parameters
