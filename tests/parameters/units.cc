// Every unit against its definition, worked out by hand.
#include "parameters/units.h"
#include "parameters/expression.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace vibroimpact::parameters {
namespace units_tests {

constexpr double pi = std::numbers::pi;

struct Case {
  const char *text;
  double value;
  const char *unit;
};

class UnitsTable : public ::testing::TestWithParam<Case> {};

TEST_P(UnitsTable, has_its_si_value_and_dimension) {
  const Number number = evaluate(GetParam().text, {});
  EXPECT_DOUBLE_EQ(number.value, GetParam().value);
  EXPECT_EQ(si_unit(number.dimension), GetParam().unit);
  EXPECT_FALSE(number.bare);
}

const std::vector<Case> cases{
    {"2 m", 2, "m"},
    {"30 mm", 0.03, "m"},
    {"7cm", 0.07, "m"},
    {"5 um", 5e-6, "m"},
    {"5 \u00b5m", 5e-6, "m"},
    {"5 \u03bcm", 5e-6, "m"},
    {"3 nm", 3e-9, "m"},
    {"1.5 km", 1500, "m"},
    {"2 kg", 2, "kg"},
    {"57.7114 g", 0.0577114, "kg"},
    {"0.2 t", 200, "kg"},
    {"4 s", 4, "s"},
    {"20 ms", 0.02, "s"},
    {"3 us", 3e-6, "s"},
    {"3 \u00b5s", 3e-6, "s"},
    {"3 \u03bcs", 3e-6, "s"},
    {"5 min", 300, "s"},
    {"2 h", 7200, "s"},
    {"1.2 rad", 1.2, "rad"},
    {"180 deg", pi, "rad"},
    {"2.95 Hz", 2 * pi * 2.95, "rad/s"},
    {"2 kHz", 4000 * pi, "rad/s"},
    {"1 MHz", 2e6 * pi, "rad/s"},
    {"60 rpm", 2 * pi, "rad/s"},
    {"3 rad/s", 3, "rad/s"},
    {"10 N", 10, "N"},
    {"3 mN", 3e-3, "N"},
    {"3 kN", 3000, "N"},
    {"3 MN", 3e6, "N"},
    {"2 N m", 2, "N m"},
    {"2 Nm", 2, "N m"},
    {"2 kNm", 2000, "N m"},
    {"2 Nmm", 2e-3, "N m"},
    {"2 N*m", 2, "N m"},
    {"2 Ns", 2, "N s"},
    {"4 Pa", 4, "Pa"},
    {"4 kPa", 4e3, "Pa"},
    {"4 MPa", 4e6, "Pa"},
    {"206 GPa", 206e9, "Pa"},
    {"2 J", 2, "N m"},
    {"2 W", 2, "W"},
    {"2 g0", 19.6133, "m/s^2"},
    {"50 %", 0.5, "1"},
    {"50%", 0.5, "1"},
    {"7850 kg/m^3", 7850, "kg/m^3"},
    {"7.85 g/cm^3", 7850, "kg/m^3"},
    {"3 N/mm", 3000, "N/m"},
    {"3 kN/m", 3000, "N/m"},
    {"4 N s/m", 4, "N s/m"},
    {"4 N s/mm", 4000, "N s/m"},
    {"1e9 N/m^1.5", 1e9, "N/m^1.5"},
    {"1 N/mm^1.5", 31622.776601683793, "N/m^1.5"},
    {"1e9 N/m^(3/2)", 1e9, "N/m^1.5"},
    {"2 N s/m^2.5", 2, "N s/m^2.5"},
    {"9.81 m/s^2", 9.81, "m/s^2"},
    {"9.81 m s^-2", 9.81, "m/s^2"},
    {"3 N/(m s)", 3, "kg/s^3"},
    {"-5 mm", -0.005, "m"},
    {"+5 mm", 0.005, "m"},
    {"0.1/s", 0.1, "1/s"},
    {".5 m", 0.5, "m"},
};
INSTANTIATE_TEST_SUITE_P(All, UnitsTable, ::testing::ValuesIn(cases));

TEST(Units, every_unit_of_the_table_is_tried) {
  std::string all;
  for (const Case &tried : cases)
    all += std::string(tried.text) + "\n";
  for (const std::string &unit : unit_names())
    EXPECT_NE(all.find(unit), std::string::npos) << unit;
}

TEST(Units, decimal_prefixes_give_the_nearest_double) {
  for (int i = 1; i < 2000; ++i)
    EXPECT_EQ(evaluate(std::to_string(i) + " mm", {}).value, std::stod(std::to_string(i) + "e-3"));
}

TEST(Units, a_bare_number_is_si) {
  const Number number = evaluate("5e-3", {});
  EXPECT_EQ(number.value, 5e-3);
  EXPECT_TRUE(number.bare);
}

TEST(Units, dimensions_print_as_coherent_units) {
  EXPECT_EQ(si_unit(dimension::none), "1");
  EXPECT_EQ(si_unit(dimension::hertz_stiffness), "N/m^1.5");
  EXPECT_EQ(si_unit(dimension::rotary_inertia), "kg m^2");
  EXPECT_EQ(si_unit(dimension::inverse_velocity), "s/m");
  EXPECT_EQ(si_unit(dimension::rotational_damping), "N m s");
  EXPECT_EQ(si_unit({.length = 0.5, .mass = 1, .time = -3}), "kg m^0.5/s^3");
}

TEST(Units, examples_have_the_dimension_they_stand_for) {
  const std::vector<Dimension> dimensions{dimension::none,
                                          dimension::length,
                                          dimension::area,
                                          dimension::mass,
                                          dimension::second_moment,
                                          dimension::rotary_inertia,
                                          dimension::density,
                                          dimension::time,
                                          dimension::inverse_time,
                                          dimension::frequency,
                                          dimension::angle,
                                          dimension::velocity,
                                          dimension::acceleration,
                                          dimension::force,
                                          dimension::torque,
                                          dimension::stress,
                                          dimension::stiffness,
                                          dimension::hertz_stiffness,
                                          dimension::damping,
                                          dimension::inverse_velocity,
                                          {.length = -0.7, .mass = 1, .time = -2},
                                          {.length = -0.5}};
  for (const Dimension &dimension : dimensions)
    EXPECT_EQ(evaluate(example_value(dimension), {}).dimension, dimension)
        << example_value(dimension);
}

TEST(Units, composed_units_that_read_two_ways_are_refused) {
  EXPECT_THROW(evaluate("3 N/m s", {}), Refused);
  EXPECT_THROW(evaluate("3 m^", {}), Refused);
  EXPECT_THROW(evaluate("3 N/(m s", {}), Refused);
}

} // namespace units_tests
} // namespace vibroimpact::parameters
