// When a motion counts as steady, on sequences of states whose distance to their limit is known.
#include "analyses/sweeps/steadiness.h"

#include "contact/laws/hunt_crossley.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {
namespace steadiness_tests {

constexpr double tolerance = 1e-4;

// The number of periods after which a sequence is first called steady, and the multiple then.
template <class State>
std::pair<int, long> first_steady(State state, long longest, int most = 100000) {
  Steadiness steadiness(Vector::Ones(state(0).size()), longest, tolerance);
  for (int n = 0; n < most; ++n) {
    steadiness.add(state(n));
    if (steadiness.steady())
      return {n, steadiness.multiple()};
  }
  return {-1, 0};
}

// 1 + r^n is r^n from its limit, however little it changes in a period: it must not count as steady
// before that is within the tolerance, and should not long after.
TEST(SteadinessTest, ASlowApproachIsSteadyWhenItIsNear) {
  for (const double r : {0.3, 0.9, 0.99, 0.999}) {
    const auto [n, multiple] =
        first_steady([r](int k) { return Vector::Constant(1, 1 + std::pow(r, k)); }, 1);
    EXPECT_EQ(multiple, 1) << r;
    EXPECT_LT(std::pow(r, n), 1.01 * tolerance) << r;
    EXPECT_GT(std::pow(r, n), 0.98 * r * r * tolerance) << r;
  }
}

// Two states in turn, each approached with r^n: steady with multiple 2.
TEST(SteadinessTest, APeriodOfTwo) {
  constexpr double r = 0.98;
  const auto [n, multiple] = first_steady(
      [](int k) { return Vector::Constant(1, (k % 2 == 0 ? 1 : -1.5) + std::pow(r, k)); }, 4);
  EXPECT_EQ(multiple, 2);
  EXPECT_LT(std::pow(r, n), 1.6 * tolerance);
}

TEST(SteadinessTest, WhatGrowsIsNotSteady) {
  const auto growing = [](int k) { return Vector::Constant(1, 1 + 1e-3 * std::pow(1.001, k)); };
  EXPECT_EQ(first_steady(growing, 1, 1000).first, -1);
}

// The longest run of periods without an approach.
template <class State> long longest_without_approach(State state, long longest, int most) {
  Steadiness steadiness(Vector::Ones(state(0).size()), longest, 0);
  long found = 0;
  for (int n = 0; n < most; ++n) {
    steadiness.add(state(n));
    found = n > 0 ? std::max(found, steadiness.without_approach()) : 0;
  }
  return found;
}

// However slowly: every period brings it nearer, also to one of several periods.
TEST(SteadinessTest, AnApproachIsSeenInEveryPeriod) {
  for (const double r : {0.3, 0.9, 0.999}) {
    const int most = static_cast<int>(-20 / std::log(r));
    EXPECT_EQ(longest_without_approach(
                  [r](int k) { return Vector::Constant(1, 1 + std::pow(r, k)); }, 1, most),
              0);
    EXPECT_LE(longest_without_approach(
                  [r](int k) { return Vector::Constant(1, k % 3 + std::pow(r, k)); }, 4, most),
              3);
  }
}

// A quarter of a turn in so many periods, inward: the largest entry of what turns grows again and
// again for part of that, by no more than the root of two.
TEST(SteadinessTest, ASpiralInwardIsSeenWithinItsTurn) {
  constexpr double r = 0.98;
  constexpr int quarter = 10;
  const auto spiral = [](int k) {
    const double angle = k * 1.5707963267948966 / quarter;
    return Vector(std::pow(r, k) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  };
  EXPECT_LE(longest_without_approach(spiral, 1, 500), 2 * quarter);
}

// x -> 4 x (1 - x) never comes to repeat.
TEST(SteadinessTest, AChaoticSequenceComesNoNearerForLong) {
  Steadiness steadiness(Vector::Ones(1), 4, tolerance);
  double x = 0.3;
  int n = 0;
  for (; n < 1000 && steadiness.without_approach() < 20; ++n, x = 4 * x * (1 - x))
    steadiness.add(Vector::Constant(1, x));
  EXPECT_LT(n, 200);
  EXPECT_FALSE(steadiness.steady());
  steadiness.clear();
  EXPECT_EQ(steadiness.without_approach(), 0);
}

// Speeds over a frequency are lengths, those that contacts remember too.
TEST(SteadinessTest, ScalesMakeSpeedsComparableWithDisplacements) {
  const model::Model model({testing::single_mass("block", 1, 9, 0)});
  const contact::ContactSet contacts(
      {testing::contact_along_x(model, "block.head", "", 1,
                                contact::HuntCrossley::with_dimensionless_damping(
                                    {.stiffness = 1e4, .exponent = 1.5}, 0.5, 1e-3))});
  const Vector scale = state_scale(motion::Equations(model, contacts), 5);
  EXPECT_DOUBLE_EQ(scale[1] / scale[0], 1.0 / 3);
  EXPECT_DOUBLE_EQ(scale[2] / scale[0], 1.0 / 5);
}

} // namespace steadiness_tests
} // namespace vibroimpact::analyses
