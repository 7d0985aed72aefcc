// Responses given as formulas: which of them jump, and where.
#include "analyses/sweeps/jump_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::analyses {
namespace jump_search_tests {

using motion::MotionState;

SettledMotion motion(double lowest, double highest, long multiple = 1) {
  return {.state = {.time = 0, .physical = Vector::Constant(1, highest)},
          .lowest = Vector::Constant(1, lowest),
          .highest = Vector::Constant(1, highest),
          .cycles = 1,
          .multiple = multiple};
}

double distance(const SettledMotion &a, const SettledMotion &b) {
  return relative_distance(a, b, Vector::Ones(1));
}

// Between 0 and 1 to a width of 1e-9.
Jump search(const SettleAt &settle_at, double threshold = 0.05) {
  const SettledMotion before = settle_at(0, motion(0, 0).state);
  return find_jump({.value = 0, .motion = before},
                   {.value = 1, .motion = settle_at(1, before.state)}, 1e-9, threshold, settle_at,
                   distance);
}

// The branch of x^2 = c - p ends at p = c = 0.37; from there on the response is -1.
TEST(JumpSearchTest, AFoldIsBracketed) {
  const double fold = 0.37;
  const Jump jump = search([&](double p, const MotionState &from) {
    const bool on_branch = p <= fold && from.physical[0] >= 0;
    const double x = on_branch ? 0.3 + std::sqrt(fold - p) : -1;
    return motion(x, x);
  });
  ASSERT_TRUE(jump.found());
  EXPECT_LE(jump.from, fold);
  EXPECT_GT(jump.to, fold);
  EXPECT_LE(jump.to - jump.from, 1e-9);
}

TEST(JumpSearchTest, TheBracketMayFall) {
  const auto settle_at = [](double p, const MotionState &) {
    return motion(p > 0.4 ? 1 : 2, p > 0.4 ? 1 : 2);
  };
  const MotionState rest;
  const Jump jump =
      find_jump({.value = 1, .motion = settle_at(1, rest)},
                {.value = 0, .motion = settle_at(0, rest)}, 1e-9, 0.05, settle_at, distance);
  EXPECT_GE(jump.from, 0.4);
  EXPECT_LE(jump.to, 0.4);
}

TEST(JumpSearchTest, GrazingAndPeriodDoublingAreNoJumps) {
  const Jump grazing = search([](double p, const MotionState &) {
    const double x = 1 + 20 * std::sqrt(std::max(0.0, p - 0.7));
    return motion(x, x);
  });
  EXPECT_FALSE(grazing.found());
  const Jump doubling = search([](double p, const MotionState &) {
    const double split = p > 0.3 ? std::sqrt(p - 0.3) : 0;
    return motion(1 - split, 1 + split, p > 0.3 ? 2 : 1);
  });
  EXPECT_FALSE(doubling.found());
}

// At the edge of chaos a motion that does not repeat lies by chance near or far from the others.
TEST(JumpSearchTest, TheEdgeOfAperiodicMotionIsSearchedOnce) {
  int settled = 0;
  const Jump jump = search([&](double p, const MotionState &) {
    ++settled;
    const double x = 1 + 0.3 * std::sin(1e12 * p);
    return p < 0.25 ? motion(1, 1) : motion(x - 0.5, x + 0.5, 0);
  });
  EXPECT_LE(settled, 40); // thirty halvings to 1e-9
  EXPECT_TRUE(!jump.found() || jump.to - jump.from <= 1e-9);
}

TEST(JumpSearchTest, ASteepFlankIsNoJump) {
  const Jump jump = search([](double p, const MotionState &) {
    const double x = 3 + std::atan(1e5 * (p - 0.613));
    return motion(x, x);
  });
  EXPECT_FALSE(jump.found());
}

// Too large a step falls off the branch x = 2, which is there everywhere, to x = 1.
TEST(JumpSearchTest, ABranchThatGoesOnIsFollowedToTheFarEnd) {
  const auto settle_at = [](double p, const MotionState &from) {
    const double x = from.physical[0] - p > 1.5 ? 2 : 1;
    SettledMotion settled = motion(x, x);
    settled.state.physical[0] = x + p;
    return settled;
  };
  const SettledMotion before = motion(2, 2);
  const SettledMotion after = settle_at(1, before.state);
  ASSERT_EQ(after.highest[0], 1);
  const Jump jump = find_jump({.value = 0, .motion = before}, {.value = 1, .motion = after}, 1e-9,
                              0.05, settle_at, distance);
  EXPECT_FALSE(jump.found());
  ASSERT_TRUE(jump.start_on_branch);
  EXPECT_EQ(settle_at(1, *jump.start_on_branch).highest[0], 2);
}

TEST(JumpSearchTest, AJumpBelowTheThresholdIsNone) {
  const auto step = [](double p, const MotionState &) {
    return motion(p > 0.5 ? 1.03 : 1, p > 0.5 ? 1.03 : 1);
  };
  EXPECT_FALSE(search(step, 0.05).found());
  EXPECT_TRUE(search(step, 0.02).found());
}

TEST(JumpSearchTest, TwoMotionsThatDoNotRepeatAreNotCompared) {
  EXPECT_FALSE(search([](double p, const MotionState &) { return motion(-p, 1 + p, 0); }).found());
}

} // namespace jump_search_tests
} // namespace vibroimpact::analyses
