#include "derived/small_analysis.h"

#include <cmath>

namespace vibroimpact::derived {
namespace band_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

/// A zigzag over 1 ... 6 between 0 and 2 gap, low at odd frequencies.
SmallAnalysis zigzag() {
  SmallAnalysis analysis({1, 2}, {1, 2, 3, 4, 5, 6});
  analysis.add("zigzag", "m", [](double gap, double frequency, bool) {
    return std::fmod(frequency, 2) == 0 ? 2 * gap : 0;
  });
  analysis.add("one", "m", [](double, double, bool forward) { return forward ? 1 : 5; });
  return analysis;
}

const std::string band = "set Operation = band\nset Field = zigzag\nset Along = frequency\n";

TEST(Band, AboveALevel) {
  const auto result = zigzag().derive(
      {{"high", band + "set Level = 1 m"},
       {"forward", "set Operation = select\nset Field = zigzag\nset Where = direction = forward"}});
  ASSERT_TRUE(result.problems.empty()) << result.problems[0];
  const DerivedArray &high = result.arrays.at(0);
  EXPECT_EQ(high.axis, "frequency");
  EXPECT_EQ(high.unit, "Hz");
  EXPECT_EQ(high.dimensions,
            (std::vector<std::string>{"Variables.gap", "direction", "interval_high", "bound"}));
  EXPECT_EQ(high.shape, (Shape{2, 2, 3, 2}));
  expect_values(high.values, {1.5,  2.5,  3.5,  4.5,  5.5,  6, 1.5,  2.5,  3.5,  4.5,  5.5,  6,
                              1.25, 2.75, 3.25, 4.75, 5.25, 6, 1.25, 2.75, 3.25, 4.75, 5.25, 6});
}

TEST(Band, BelowAnotherFieldAndShorterLists) {
  const DerivedArray result = zigzag().derive_one(band + "set Other = one\nset Side = below");
  const double n = NAN;
  EXPECT_EQ(result.shape, (Shape{2, 2, 3, 2}));
  expect_values(result.values, {1, 1.5,  2.5,  3.5,  4.5,  5.5,  1, 6, n, n, n, n,
                                1, 1.25, 2.75, 3.25, 4.75, 5.25, 1, 6, n, n, n, n});
}

TEST(Band, EndsAtMissingPoints) {
  SmallAnalysis analysis({1}, {1, 2, 3, 4});
  analysis.add("flat", "1", [](double, double frequency, bool forward) {
    return frequency == 3 || !forward ? NAN : 1;
  });
  const DerivedArray result = analysis.derive_one(
      "set Operation = band\nset Field = flat\nset Along = frequency\nset Level = 0");
  expect_values(result.values, {1, 2, 4, 4, NAN, NAN, NAN, NAN});
}

// A point exactly on the level belongs to the interval that begins, or ends, there.
TEST(Band, BeginsAndEndsAtPointsOnTheLevel) {
  SmallAnalysis analysis({1}, {1, 2, 3, 4, 5, 6});
  analysis.add("roof", "m", [](double, double frequency, bool forward) {
    const double height = std::min(frequency - 2, 5 - frequency); // 0 at 2 and at 5
    return forward ? height : -height;
  });
  const std::string roof =
      "set Operation = band\nset Field = roof\nset Along = frequency\nset Level = 0 m";
  expect_values(analysis.derive_one(roof).values, {2, 5, NAN, NAN, 1, 2, 5, 6});
}

TEST(Band, WhatIsRefused) {
  expect_parts(zigzag().problem(band), {"Other", "Other must be set when Level is not set"});
  expect_parts(zigzag().problem(band + "set Level = 1 s"), {"Level", "1 s"});
}

} // namespace band_tests
} // namespace vibroimpact::derived
