#include "derived/small_analysis.h"

#include <cmath>

namespace vibroimpact::derived {
namespace extreme_values_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

/// A parabola over the frequency with its vertex at 1 + gap / 10 and the value 5 + gap there; the
/// backward branch is lower by one.
SmallAnalysis parabolas() {
  SmallAnalysis analysis({0, 1, 2}, {0.5, 0.9, 1, 1.3, 1.4, 2});
  analysis.add("peak", "m", [](double gap, double frequency, bool forward) {
    return 5 + gap - 3 * std::pow(frequency - 1 - gap / 10, 2) - (forward ? 0 : 1);
  });
  analysis.add("force", "N",
               [](double gap, double frequency, bool) { return 100 * gap + frequency; });
  return analysis;
}

TEST(ExtremeValues, AlongOneAxis) {
  const DerivedArray result =
      parabolas().derive_one("set Operation = maximum\nset Field = peak\nset Along = frequency");
  EXPECT_EQ(result.unit, "m");
  EXPECT_EQ(result.operation, "maximum");
  EXPECT_EQ(result.axis, "");
  EXPECT_EQ(result.dimensions, (std::vector<std::string>{"Variables.gap", "direction"}));
  EXPECT_EQ(result.shape, (Shape{3, 2}));
  const double one = 6 - 3 * 0.01;
  const double two = 7 - 3 * 0.01;
  expect_values(result.values, {5, 4, one, one - 1, two, two - 1});
}

TEST(ExtremeValues, AlongSeveralAxesOrAll) {
  const SmallAnalysis analysis = parabolas();
  expect_values(analysis
                    .derive_one("set Operation = minimum\nset Field = peak\n"
                                "set Along = direction, frequency")
                    .values,
                {1, 2.57, 4.08});
  const DerivedArray all = analysis.derive_one(
      "set Operation = minimum\nset Field = peak\nset Along = direction, gap, frequency");
  EXPECT_TRUE(all.dimensions.empty());
  EXPECT_TRUE(all.shape.empty());
  expect_values(all.values, {1});
}

TEST(ExtremeValues, ParabolaIsExactForAParabola) {
  const SmallAnalysis analysis = parabolas();
  const std::string keys = "\nset Field = peak\nset Along = frequency\nset Refine = parabola";
  const DerivedArray position = analysis.derive_one("set Operation = position of maximum" + keys);
  EXPECT_EQ(position.unit, "Hz");
  EXPECT_EQ(position.axis, "frequency");
  expect_values(position.values, {1, 1, 1.1, 1.1, 1.2, 1.2});
  expect_values(analysis.derive_one("set Operation = maximum" + keys).values, {5, 4, 6, 5, 7, 6});
}

TEST(ExtremeValues, WithoutRefinementOnThePoints) {
  expect_values(parabolas()
                    .derive_one("set Operation = position of maximum\nset Field = peak\n"
                                "set Along = frequency")
                    .values,
                {1, 1, 1, 1, 1.3, 1.3});
}

TEST(ExtremeValues, AtTheEndsNothingIsRefined) {
  expect_values(parabolas()
                    .derive_one("set Operation = position of minimum\nset Field = peak\n"
                                "set Along = frequency\nset Refine = parabola")
                    .values,
                {2, 2, 2, 2, 2, 2});
}

TEST(ExtremeValues, OnlyInside) {
  SmallAnalysis analysis({0, 1, 2}, {1, 2, 3});
  analysis.add("hill", "m", [](double gap, double frequency, bool) {
    return -std::abs(frequency - 1 - gap); // at the first, the second and the last frequency
  });
  const std::string keys = "\nset Field = hill\nset Along = frequency\nset Inside = true";
  expect_values(analysis.derive_one("set Operation = maximum" + keys).values,
                {NAN, NAN, 0, 0, NAN, NAN});
  expect_values(analysis.derive_one("set Operation = position of maximum" + keys).values,
                {NAN, NAN, 2, 2, NAN, NAN});
  expect_values(
      analysis.derive_one("set Operation = value at maximum\nset At = frequency" + keys).values,
      {NAN, NAN, 2, 2, NAN, NAN});
}

TEST(ExtremeValues, NamesOfASweptKey) {
  for (const std::string name : {"gap", "clearance", "Variables.gap"})
    expect_values(parabolas()
                      .derive_one("set Operation = position of maximum\nset Field = force\n"
                                  "set Along = " +
                                  name)
                      .values,
                  std::vector<double>(12, 2));
}

TEST(ExtremeValues, OfAnotherFieldThere) {
  const DerivedArray result = parabolas().derive_one(
      "set Operation = value at maximum\nset Field = peak\nset Along = frequency\nset At = force");
  EXPECT_EQ(result.unit, "N");
  expect_values(result.values, {1, 1, 101, 101, 201.3, 201.3});
}

TEST(ExtremeValues, MissingPointsAreIgnored) {
  SmallAnalysis analysis({0, 1}, {1, 2, 3});
  analysis.add("peak", "m", [](double gap, double frequency, bool forward) {
    const bool missing = frequency == 2 || (gap == 1 && !forward);
    return missing ? NAN : frequency;
  });
  const std::string keys = "\nset Field = peak\nset Along = frequency\nset Refine = parabola";
  expect_values(analysis.derive_one("set Operation = maximum" + keys).values, {3, 3, 3, NAN});
  expect_values(analysis.derive_one("set Operation = position of minimum" + keys).values,
                {1, 1, 1, NAN});
  expect_values(analysis
                    .derive_one("set Operation = value at minimum\nset Field = peak\nset At = "
                                "frequency\nset Along = frequency")
                    .values,
                {1, 1, 1, NAN});
}

TEST(ExtremeValues, OfEqualOnesTheFirst) {
  SmallAnalysis analysis({0}, {1, 2, 3, 4});
  analysis.add("peak", "m", [](double, double frequency, bool) { return frequency < 3 ? 1. : 2; });
  expect_values(analysis
                    .derive_one("set Operation = position of maximum\nset Field = peak\n"
                                "set Along = frequency")
                    .values,
                {3, 3});
}

TEST(ExtremeValues, ChainsOfQuantities) {
  const auto result = parabolas().derive(
      {{"top", "set Operation = maximum\nset Field = peak\nset Along = frequency, direction"},
       {"best", "set Operation = position of minimum\nset Field = top\nset Along = gap"}});
  EXPECT_TRUE(result.problems.empty());
  ASSERT_EQ(result.arrays.size(), 2U);
  EXPECT_EQ(result.arrays[1].axis, "Variables.gap");
  expect_values(result.arrays[1].values, {0});
}

TEST(ExtremeValues, WhatIsRefused) {
  const SmallAnalysis analysis = parabolas();
  const std::string position = "set Operation = position of maximum\nset Field = ";
  expect_parts(analysis.problem(position + "peek\nset Along = frequency"),
               {"Derived quantity", "Field", "peek", "'peak'", "force"});
  expect_parts(analysis.problem(position + "peak\nset Along = direction"), {"Along", "numbers"});
  expect_parts(analysis.problem(position + "peak\nset Along = time"),
               {"Along", "time", "frequency"});
  expect_parts(analysis.problem("set Operation = maximum\nset Field = peak\nset Along = gap, "
                                "frequency\nset Refine = parabola"),
               {"Refine", "more than one"});
}

} // namespace extreme_values_tests
} // namespace vibroimpact::derived
