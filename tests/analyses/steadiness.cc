// When a motion counts as steady, on sequences of states whose distance to their limit is known.
#include "analyses/steadiness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::analyses {
namespace {

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

} // namespace
} // namespace vibroimpact::analyses
