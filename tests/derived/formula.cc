#include "derived/small_analysis.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::derived {
namespace formula_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

SmallAnalysis analysis() {
  SmallAnalysis small({1, 2}, {1, 3});
  small.add("length", "m", [](double gap, double frequency, bool) { return gap * frequency; });
  small.add("mass", "kg", [](double gap, double, bool forward) { return forward ? gap : NAN; });
  return small;
}

TEST(Formula, UnitsFollowFromTheFields) {
  const DerivedArray result = analysis().derive_one(
      "set Operation = expression\nset Fields = a = length, b = mass\nset Expression = a * b / "
      "(2 s)^2");
  EXPECT_EQ(result.unit, "N");
  EXPECT_EQ(result.shape, (Shape{2, 2, 2}));
  expect_values(result.values, {0.25, NAN, 0.75, NAN, 1, NAN, 3, NAN});
}

TEST(Formula, UnitThatIsAskedFor) {
  const DerivedArray result = analysis().derive_one(
      "set Operation = expression\nset Fields = a = length\nset Expression = scale * a\n"
      "set Unit = mm");
  EXPECT_EQ(result.unit, "mm");
  expect_values(result.values, {4000, 4000, 12000, 12000, 8000, 8000, 24000, 24000}, 1e-9);
}

TEST(Formula, FrequenciesEnterAsSuch) {
  const DerivedArray ratio = analysis().derive_one(
      "set Operation = expression\nset Fields = f = frequency\nset Expression = f / (1 rad/s)");
  EXPECT_EQ(ratio.unit, "1");
  EXPECT_EQ(ratio.dimensions, (std::vector<std::string>{"frequency"}));
  expect_values(ratio.values, {2 * std::numbers::pi, 6 * std::numbers::pi});
  const DerivedArray twice = analysis().derive_one(
      "set Operation = expression\nset Fields = f = frequency\nset Expression = 2 * f\n"
      "set Unit = Hz");
  expect_values(twice.values, {2, 6});
}

TEST(Formula, DimensionsAreJoinedByName) {
  const auto result = analysis().derive(
      {{"top", "set Operation = maximum\nset Field = length\nset Along = frequency, direction"},
       {"share", "set Operation = expression\nset Fields = T = top, a = length, d = gap\n"
                 "set Expression = d * a / T"}});
  ASSERT_TRUE(result.problems.empty()) << result.problems[0];
  const DerivedArray &share = result.arrays.at(1);
  EXPECT_EQ(share.unit, "1");
  EXPECT_EQ(share.dimensions,
            (std::vector<std::string>{"Variables.gap", "frequency", "direction"}));
  expect_values(share.values, {1. / 3, 1. / 3, 1, 1, 2. / 3, 2. / 3, 2, 2});
}

TEST(Formula, StandInWhereItIsNoNumber) {
  const std::string keys = "set Operation = expression\nset Fields = a = mass, b = length\n"
                           "set Expression = a * b / (1 kg)\nset Otherwise = ";
  expect_values(analysis().derive_one(keys + "length").values, {1, 1, 3, 3, 4, 2, 12, 6});
  expect_parts(analysis().problem(keys + "mass"), {"Otherwise", "a field in m", "direction"});
}

TEST(Formula, OfSingleNumbers) {
  const auto result = analysis().derive(
      {{"top", "set Operation = maximum\nset Field = length\n"
               "set Along = gap, frequency, direction"},
       {"square", "set Operation = expression\nset Fields = T = top\nset Expression = T^2"}});
  ASSERT_TRUE(result.problems.empty()) << result.problems[0];
  EXPECT_EQ(result.arrays.at(1).unit, "m^2");
  expect_values(result.arrays.at(1).values, {36});
}

TEST(Formula, WhatIsRefused) {
  const SmallAnalysis small = analysis();
  const std::string expression = "set Operation = expression\nset Fields = a = length, b = mass\n"
                                 "set Expression = ";
  expect_parts(small.problem(expression + "a + b"), {"Expression", "dimensions"});
  expect_parts(small.problem(expression + "a * c"), {"Expression", "'c'"});
  expect_parts(small.problem(expression + "a *"), {"Expression", "operators"});
  expect_parts(small.problem(expression + "a * gap"), {"Expression", "'gap'", "Fields"});
  expect_parts(small.problem(expression + "a\nset Unit = kg"), {"Unit", "length"});
  expect_parts(small.problem(expression + "a\nset Unit = parsec"), {"Unit", "parsec"});
  const std::string fields = "set Operation = expression\nset Expression = 1\nset Fields = ";
  expect_parts(small.problem(fields + "length"), {"Fields", "'='"});
  expect_parts(small.problem(fields + "m = length"), {"Fields", "'m' is a unit"});
  expect_parts(small.problem(fields + "a = width"), {"Fields", "width", "length, mass"});
}

} // namespace formula_tests
} // namespace vibroimpact::derived
