#include "derived/small_analysis.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::derived {
namespace crossing_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

/// A triangle over the frequency of height gap, zero at 1 and 5, its top at 3.
SmallAnalysis triangles() {
  SmallAnalysis analysis({1, 2}, {1, 2, 3, 4, 5});
  analysis.add("triangle", "m", [](double gap, double frequency, bool) {
    return gap * (1 - std::abs(frequency - 3) / 2);
  });
  analysis.add("slope", "m", [](double, double frequency, bool) { return frequency / 8; });
  return analysis;
}

const std::string level = "set Operation = crossing\nset Field = triangle\nset Along = frequency\n"
                          "set Level = 1200 mm";

TEST(Crossing, OfALevel) {
  const DerivedArray first = triangles().derive_one(level);
  EXPECT_EQ(first.axis, "frequency");
  EXPECT_EQ(first.unit, "Hz");
  expect_values(first.values, {NAN, NAN, 2.2, 2.2});
  expect_values(triangles().derive_one(level + "\nset Take = last").values, {NAN, NAN, 3.8, 3.8});
  expect_values(triangles().derive_one(level + "\nset Sense = falling").values,
                {NAN, NAN, 3.8, 3.8});
  expect_values(triangles().derive_one(level + "\nset Take = last\nset Sense = rising").values,
                {NAN, NAN, 2.2, 2.2});
}

/// gap (1 - |f - 3| / 2) = f / 8 on either side; at f = 1 the triangle is the lower one.
TEST(Crossing, OfAnotherField) {
  const SmallAnalysis analysis = triangles();
  const std::string other =
      "set Operation = crossing\nset Field = triangle\nset Along = frequency\nset Other = slope";
  expect_values(analysis.derive_one(other).values, {4. / 3, 4. / 3, 8. / 7, 8. / 7});
  expect_values(analysis.derive_one(other + "\nset Take = last").values, {4, 4, 40. / 9, 40. / 9});
}

TEST(Crossing, OnAPointIsMetOnce) {
  SmallAnalysis analysis({1}, {1, 2, 3, 4});
  analysis.add("line", "1", [](double, double frequency, bool) { return frequency - 2; });
  const std::string zero =
      "set Operation = crossing\nset Field = line\nset Along = frequency\nset Level = 0";
  expect_values(analysis.derive_one(zero).values, {2, 2});
  expect_values(analysis.derive_one(zero + "\nset Take = last").values, {2, 2});
  expect_values(analysis.derive_one(zero + "\nset Sense = falling").values, {NAN, NAN});
}

TEST(Crossing, NotOverMissingPoints) {
  SmallAnalysis analysis({1}, {1, 2, 3, 4});
  analysis.add("line", "1",
               [](double, double frequency, bool) { return frequency == 2 ? NAN : frequency; });
  expect_values(analysis
                    .derive_one("set Operation = crossing\nset Field = line\n"
                                "set Along = frequency\nset Level = 1.5")
                    .values,
                {NAN, NAN});
}

TEST(Crossing, WhatIsRefused) {
  const SmallAnalysis analysis = triangles();
  const std::string crossing =
      "set Operation = crossing\nset Field = slope\nset Along = frequency\n";
  expect_parts(analysis.problem(crossing), {"Other", "Other must be set when Level is not set"});
  expect_parts(analysis.problem(crossing + "set Level = 1 mm\nset Other = slope"),
               {"Other", "Other must not be set when Level is set"});
  expect_parts(analysis.problem(crossing + "set Level = 1 kg"), {"Level", "kg", "length"});
  expect_parts(analysis.problem(crossing + "set Other = direction"), {"Other", "direction"});
  expect_parts(analysis.problem(crossing + "set Other = frequency"), {"Other", "Hz"});
}

} // namespace crossing_tests
} // namespace vibroimpact::derived
