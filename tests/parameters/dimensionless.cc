// Files with Units = dimensionless: plain numbers alone, no unit in any message.
#include "sample.h"

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

namespace vibroimpact::parameters {
namespace dimensionless_tests {

constexpr const char *plain = R"(set Units = dimensionless
set Variables = lambda = 2, w = 3 * lambda
subsection Excitation
  set Frequency = w
end
subsection Contact stop
  set Clearance       = 0.5 / lambda
  set Stiffness       = lambda
  set Hertz stiffness = 7
end
subsection Body left
  subsection Geometry
    set Start   = 1, 2, lambda
    set Section = rectangle, 3, 4
  end
end
)";

std::string message(const std::string &text) {
  return error_of([&] { parse_prm("set Units = dimensionless\n" + text); });
}

TEST(Dimensionless, all_numbers_are_plain) {
  const auto set = parse_prm(plain);
  EXPECT_TRUE(set->dimensionless());
  const Values root = set->root();
  EXPECT_EQ(root.subsection("Excitation").quantity("Frequency"), 6);
  const Values stop = root.instance("Contact", "stop");
  EXPECT_EQ(stop.quantity("Clearance"), 0.25);
  EXPECT_EQ(stop.quantity_of("Hertz stiffness", dimension::hertz_stiffness), 7);
  const Values geometry = root.instance("Body", "left").subsection("Geometry");
  EXPECT_EQ(geometry.quantities("Start"), (std::vector<double>{1, 2, 2}));
  EXPECT_EQ(geometry.part("Section", "3 * lambda", dimension::length), 6);
  EXPECT_EQ(set->number_at("Contact/stop/Stiffness")->unit, "1");
  EXPECT_FALSE(parse_prm("set Units = SI\n")->dimensionless());
}

TEST(Dimensionless, defaults_are_their_numbers_in_SI_and_repeated_by_the_echo) {
  const auto set = parse_prm(plain);
  const Values excitation = set->root().subsection("Excitation");
  EXPECT_EQ(excitation.quantity("Phase"), 0);
  EXPECT_EQ(excitation.quantity("Amplitude"), 1);
  EXPECT_DOUBLE_EQ(parse_prm("set Units = dimensionless\n")
                       ->root()
                       .subsection("Excitation")
                       .quantity("Frequency"),
                   6 * std::numbers::pi);
  EXPECT_EQ(set->echo().find(" N "), std::string::npos) << set->echo();
  const auto again = parse_prm(set->echo());
  EXPECT_EQ(again->echo(), set->echo());
  EXPECT_EQ(again->root().fingerprint(), set->root().fingerprint());
  EXPECT_FALSE(again->root().subsection("Excitation").given("Amplitude"));
}

TEST(Dimensionless, a_unit_is_refused_with_place_and_value) {
  EXPECT_EQ(message("subsection Contact stop\n  set Clearance = 5 mm\nend\n"),
            "params/beams.prm:3: Contact stop / Clearance = 5 mm\n"
            "  '5 mm' must not have a unit when Units = dimensionless; a pure number [1] is "
            "expected (greater than or equal to 0), for example 0.");
  for (const char *value : {"2 * 1 N/m", "5 mm / 1 mm", "N/m", "1/s", "sqrt(4 m^2)"})
    EXPECT_NE(
        message("subsection Contact stop\n  set Stiffness = " + std::string(value) + "\nend\n")
            .find("must not have a unit when Units = dimensionless"),
        std::string::npos)
        << value;
  EXPECT_NE(message("set Variables = L = 0.3 m\n").find("'0.3 m' must not have a unit"),
            std::string::npos);
  EXPECT_NE(message("subsection Body left\n  subsection Geometry\n    set Start = 0, 1 cm, 2\n"
                    "  end\nend\n")
                .find("'1 cm' must not have a unit"),
            std::string::npos);
}

TEST(Dimensionless, texts_that_hold_numbers_and_overrides_obey) {
  const auto set = parse_prm(plain);
  const Values geometry = set->root().instance("Body", "left").subsection("Geometry");
  EXPECT_NE(
      error_of([&] { geometry.part("Section", "3 mm", dimension::length); }).find("must not have"),
      std::string::npos);
  EXPECT_NE(error_of([&] {
              set->with({{.path = "Contact/stop/Clearance", .value = "1 m", .origin = "--set"}});
            }).find("--set Contact/stop/Clearance=1 m\n  '1 m' must not have a unit"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              set->with({{.path = "Variables/lambda", .value = "1 m", .origin = "--set"}});
            }).find("must not have a unit"),
            std::string::npos);
  const auto changed =
      set->with({{.path = "Variables/lambda", .value = "4", .origin = "parameter grid"}});
  EXPECT_EQ(changed->root().instance("Contact", "stop").quantity("Stiffness"), 4);
  EXPECT_TRUE(changed->dimensionless());
}

TEST(Dimensionless, a_percentage_is_a_plain_number) {
  const auto set = parse_prm("set Units = dimensionless\nsubsection Body left\n  subsection Modes\n"
                             "    set Damping ratio = 5 %\n  end\nend\n");
  EXPECT_EQ(set->root().instance("Body", "left").subsection("Modes").quantity("Damping ratio"),
            0.05);
}

TEST(Dimensionless, no_override_changes_it) {
  EXPECT_EQ(error_of([] {
              parse_prm("", {{.path = "Units", .value = "dimensionless", .origin = "--set"}});
            }),
            "--set Units=dimensionless\n  Units must be set in the file itself.");
}

TEST(Dimensionless, included_files_must_agree) {
  const vibroimpact::testing::TemporaryFolder folder;
  const auto write = [&](const std::string &name, const std::string &text) {
    std::ofstream(folder.path() / name) << text;
    return (folder.path() / name).string();
  };
  const std::string model = write("model.prm", "set Units = dimensionless\n");
  const auto read = [](const std::string &file) {
    return ParameterSet::read(sample_declarations(), file);
  };
  const auto same = read(write("same.prm", "set Units = dimensionless\ninclude model.prm\n"));
  EXPECT_TRUE(same->dimensionless());
  EXPECT_TRUE(read(write("silent.prm", "include model.prm\n"))->dimensionless());
  const std::string other = write("other.prm", "set Units = SI\ninclude model.prm\n");
  EXPECT_EQ(error_of([&] { read(other); }),
            model +
                ":1: Units = dimensionless\n  all files must have the same Units, but Units = "
                "SI at " +
                other + ":1.");
}

TEST(Dimensionless, other_words_for_it_are_refused) {
  EXPECT_EQ(error_of([] { parse_prm("set Units = dimensionles\n"); }),
            "params/beams.prm:1: Units = dimensionles\n  'dimensionles' is not possible; did you "
            "mean 'dimensionless'? one of these is expected: SI, dimensionless.");
}

} // namespace dimensionless_tests
} // namespace vibroimpact::parameters
