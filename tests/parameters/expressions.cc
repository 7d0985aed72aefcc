#include "parameters/expression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::parameters {
namespace expressions_tests {

VariableTable variables() {
  VariableTable table;
  table["lambda"] = evaluate("2", table);
  table["L"] = evaluate("0.3 m", table);
  table["zero"] = evaluate("0", table);
  table["angle"] = evaluate("30 deg", table);
  return table;
}

struct Case {
  const char *text;
  double value;
  const char *unit;
};

class ExpressionsTable : public ::testing::TestWithParam<Case> {};

TEST_P(ExpressionsTable, has_value_and_dimension) {
  const Number number = evaluate(GetParam().text, variables());
  EXPECT_NEAR(number.value, GetParam().value, 1e-15 * (1 + std::abs(GetParam().value)));
  EXPECT_EQ(si_unit(number.dimension), GetParam().unit);
}

INSTANTIATE_TEST_SUITE_P(
    All, ExpressionsTable,
    ::testing::Values(
        Case{"lambda * 1 kN/m", 2000, "N/m"}, Case{"1 + 2 * 3", 7, "1"},
        Case{"sqrt(2) * 0.3 m", 0.3 * std::sqrt(2.0), "m"}, Case{"1 m + 5 mm", 1.005, "m"},
        Case{"L / 2", 0.15, "m"}, Case{"L^2", 0.09, "m^2"},
        Case{"sqrt(L)", std::sqrt(0.3), "m^0.5"}, Case{"(1 m)^1.5 * 4", 4, "m^1.5"},
        Case{"pi * (10 mm)^2 / 4", std::numbers::pi * 25e-6, "m^2"}, Case{"10 N / 2 m", 5, "N/m"},
        Case{"lambda / 2 * mm", 1e-3, "m"}, Case{"6 / N / m", 6, "s^2/(kg m^2)"},
        Case{"lambda * N s/m", 2, "N s/m"}, Case{"min(1 m, 200 mm)", 0.2, "m"},
        Case{"max(L, 1 cm)", 0.3, "m"}, Case{"-L", -0.3, "m"}, Case{"2 * -3", -6, "1"},
        Case{"-(2)^2", -4, "1"}, Case{"1 m - 0.9999999 m", 1 - 0.9999999, "m"},
        Case{"zero * 1 kN/m", 0, "N/m"}, Case{"sin(30 deg) * 2 N", 1, "N"},
        Case{"cos(pi / 3)", 0.5, "1"}, Case{"sin(angle)", 0.5, "1"},
        Case{"tan((30 deg + 15 deg))", 1, "1"},
        Case{"cos(2 * pi * 1 rad) * 1 Hz", 2 * std::numbers::pi, "rad/s"},
        Case{"(2 Hz)^2 * 3 kg", 48 * std::numbers::pi *std::numbers::pi, "kg rad^2/s^2"},
        Case{"2^3^2", 512, "1"}, Case{"-2^2", -4, "1"}, Case{"2^-2", 0.25, "1"},
        Case{"2 - 3 - 4", -5, "1"}, Case{"24 / 3 / 4", 2, "1"}, Case{"--3 m", 3, "m"},
        Case{"(L^(1/3))^3", 0.3, "m"}, Case{"max(0, L - 1 m)", 0, "m"}, Case{"0 + L", 0.3, "m"},
        Case{"min(3, 1, 2) * 1 N", 1, "N"}, Case{"1 m - 1 m", 0, "m"}, Case{"0 * 3 kg", 0, "kg"},
        Case{"ln(exp(2))", 2, "1"}, Case{"log10(1000)", 3, "1"}, Case{"abs(-3 m)", 3, "m"},
        Case{"atan(1) * 4", std::numbers::pi, "1"}, Case{"5 mm / 1 mm", 5, "1"}));

class ExpressionsRefused : public ::testing::TestWithParam<std::pair<const char *, const char *>> {
};

TEST_P(ExpressionsRefused, says_why) {
  try {
    evaluate(GetParam().first, variables());
    FAIL() << "accepted";
  } catch (const Refused &refused) {
    EXPECT_NE(std::string(refused.what()).find(GetParam().second), std::string::npos)
        << refused.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ExpressionsRefused,
    ::testing::Values(
        std::pair{"1 m + 1 s", "different dimensions"},
        std::pair{"1 + 1 m", "different dimensions"},
        std::pair{"max(1 m, 200 s)", "different dimensions"},
        std::pair{"min(1 m, 5 ms)", "different dimensions"},
        std::pair{"exp(1 m)", "different dimensions"}, std::pair{"2^(1 m)", "different dimensions"},
        std::pair{"lambda + L", "different dimensions"}, std::pair{"1 / 0", "not a finite number"},
        std::pair{"1 / zero", "not a finite number"}, std::pair{"0 / 0", "not a finite number"},
        std::pair{"sqrt(-1)", "not a finite number"}, std::pair{"1e400", "too large"},
        std::pair{"1e308 km", "not a finite number"},
        std::pair{"nan", "neither a unit nor a variable"},
        std::pair{"inf", "neither a unit nor a variable"},
        std::pair{"5 mmm", "lacks an operator such as '*' before 'mmm'"},
        std::pair{"lamda * 2", "did you mean 'lambda'?"},
        std::pair{"sqr(2)", "did you mean 'sqrt'?"}, std::pair{"2 lambda", "lacks an operator"},
        std::pair{"2 (3)", "lacks an operator"}, std::pair{"(2", "not closed"},
        std::pair{"2)", "without '('"}, std::pair{"2 *", "cannot be computed"},
        std::pair{"5,3 mm", "decimals follow a point"},
        std::pair{"(5,3) * 1 mm", "decimals follow a point"},
        std::pair{"max((1, 2), 3)", "decimals follow a point"},
        std::pair{"max()", "cannot be computed"}, std::pair{"sqrt(1, 2)", "cannot be computed"},
        std::pair{"* 2", "cannot be computed"}, std::pair{"2 + / 3", "cannot be computed"},
        std::pair{"((((", "not closed"}, std::pair{"max(1,", "not closed"},
        std::pair{"(1 m - 1 m) + 2 s", "different dimensions"},
        std::pair{"zero + lambda + L", "different dimensions"}, std::pair{"2 ; 3", "holds ';'"},
        std::pair{"", "a number is missing"}));

std::string repeated(const std::string &part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i)
    text += part;
  return text;
}

std::string refusal(const std::string &text) {
  try {
    evaluate(text, {});
  } catch (const Refused &refused) {
    return refused.what();
  }
  return "accepted";
}

TEST(Expressions, may_be_of_any_length) {
  EXPECT_EQ(evaluate(repeated("1 + ", 100000) + "1", {}).value, 100001);
  EXPECT_EQ(evaluate(repeated("-", 100000) + "1", {}).value, 1);
  EXPECT_EQ(evaluate(repeated("2 * 0.5 * ", 50000) + "3 m", {}).dimension, dimension::length);
}

// Each level of nesting takes a piece of the stack.
TEST(Expressions, nest_a_hundred_deep_and_no_deeper) {
  EXPECT_EQ(evaluate(repeated("(", 100) + "2 m" + repeated(")", 100), {}).value, 2);
  EXPECT_EQ(evaluate(repeated("abs(", 100) + "-2" + repeated(")", 100), {}).value, 2);
  EXPECT_EQ(evaluate(repeated("1^", 100) + "2", {}).value, 1);
  for (const std::string level : {"(", "sqrt(", "2^"})
    for (const int times : {101, 100000})
      EXPECT_NE(refusal(repeated(level, times)).find("more than 100 deep"), std::string::npos);
  EXPECT_NE(refusal("3 m" + repeated("/(m", 100000)).find("more than 20 deep"), std::string::npos);
}

TEST(Expressions, a_function_gives_the_values_of_its_expression) {
  Function function("scale * max(x, y)^2 - sin(30 deg) / z", {{"scale", evaluate("3 m", {})}},
                    {"x", "y", "z"});
  for (const double x : {-1.0, 0.5, 2.0})
    EXPECT_DOUBLE_EQ(function({x, 1, 4}), 3 * std::pow(std::max(x, 1.0), 2) - 0.125);
  EXPECT_TRUE(std::isinf(function({1, 1, 0})));
}

TEST(Expressions, names_of_units_functions_and_constants_are_reserved) {
  for (const char *name : {"m", "g0", "min", "sqrt", "pi", "2x", "a b", "", "a-b"})
    EXPECT_THROW(check_variable_name(name), Refused) << name;
  for (const char *name : {"lambda", "L", "x2", "my_value"})
    EXPECT_NO_THROW(check_variable_name(name)) << name;
}

TEST(Expressions, the_radian_counts_as_one_only_beside_length_or_mass) {
  EXPECT_TRUE(fits(evaluate("3 N m/rad", {}), dimension::rotational_stiffness));
  EXPECT_TRUE(fits(evaluate("2 mm * 3 Hz", {}), dimension::velocity));
  EXPECT_TRUE(fits(evaluate("3 N rad/m", {}), dimension::stiffness)); // kg/s^2 has no length
  EXPECT_FALSE(fits(evaluate("3 Hz", {}), dimension::inverse_time));
  EXPECT_FALSE(fits(evaluate("3/s", {}), dimension::frequency));
  EXPECT_FALSE(fits(evaluate("3 deg", {}), dimension::none));
  EXPECT_TRUE(fits(evaluate("0.5", {}), dimension::angle));
}

TEST(Expressions, a_bare_number_fits_all_but_frequencies) {
  EXPECT_TRUE(fits(evaluate("3", {}), dimension::stiffness));
  EXPECT_FALSE(fits(evaluate("3", {}), dimension::frequency));
  EXPECT_FALSE(fits(evaluate("0", {}), dimension::frequency));
  EXPECT_FALSE(fits(evaluate("5 mm / 1 mm", {}), dimension::length));
  EXPECT_FALSE(fits(evaluate("0 kg", {}), dimension::length));
}

} // namespace expressions_tests
} // namespace vibroimpact::parameters
