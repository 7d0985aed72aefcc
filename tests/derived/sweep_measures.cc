// Width of a hysteresis and locus of a jump.
#include "derived/small_analysis.h"

#include <cmath>

namespace vibroimpact::derived {
namespace sweep_measures_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

/// A response of 2 that falls to 1: at 3 + gap forward, at 3 backward.
SmallAnalysis folded() {
  SmallAnalysis analysis({0, 1, 2}, {1, 2, 2.5, 3.5, 4.5, 6});
  analysis.add("peak", "m", [](double gap, double frequency, bool forward) {
    return frequency < 3 + (forward ? gap : 0) ? 2 : 1;
  });
  analysis.add("nearly", "m", [](double, double frequency, bool forward) {
    return frequency * (forward ? 1 : 1.001);
  });
  return analysis;
}

const std::string width = "set Operation = hysteresis width\nset Along = frequency\nset Field = ";

TEST(SweepMeasures, WidthIsTheShareOfThePointsThatDiffer) {
  const DerivedArray result = folded().derive_one(width + "peak");
  EXPECT_EQ(result.unit, "Hz");
  EXPECT_EQ(result.axis, "");
  EXPECT_EQ(result.dimensions, (std::vector<std::string>{"Variables.gap"}));
  // 3.5 stands for 3 ... 4, 4.5 for 4 ... 5.25
  expect_values(result.values, {0, 1, 2.25});
}

TEST(SweepMeasures, WidthByTheTolerance) {
  expect_values(folded().derive_one(width + "nearly").values, {0, 0, 0});
  expect_values(folded().derive_one(width + "nearly\nset Tolerance = 0.0005").values, {5, 5, 5});
}

TEST(SweepMeasures, WidthOfMissingPointsIsMissing) {
  SmallAnalysis analysis({0}, {1, 2});
  analysis.add("peak", "m", [](double, double, bool forward) { return forward ? 1 : NAN; });
  expect_values(analysis.derive_one(width + "peak").values, {NAN});
}

TEST(SweepMeasures, JumpBetweenItsPoints) {
  const DerivedArray result =
      folded().derive_one("set Operation = locus of jump\nset Field = peak\nset Along = frequency\n"
                          "set Threshold = 500 mm");
  EXPECT_EQ(result.axis, "frequency");
  EXPECT_EQ(result.unit, "Hz");
  expect_values(result.values, {3, 3, 4, 3, 5.25, 3});
  expect_values(folded()
                    .derive_one("set Operation = locus of jump\nset Field = peak\n"
                                "set Along = frequency\nset Threshold = 1 m")
                    .values,
                std::vector<double>(6, NAN));
}

TEST(SweepMeasures, WhatIsRefused) {
  const auto result = folded().derive(
      {{"forward", "set Operation = select\nset Field = peak\nset Where = direction = forward"},
       {"width", width + "forward"}});
  ASSERT_EQ(result.problems.size(), 1U);
  expect_parts(result.problems[0], {"Field", "both directions"});
  expect_parts(folded().problem("set Operation = locus of jump\nset Field = peak\n"
                                "set Along = frequency\nset Threshold = 1 N"),
               {"Threshold", "1 N"});
}

} // namespace sweep_measures_tests
} // namespace vibroimpact::derived
