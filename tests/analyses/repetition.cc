// Regimes of sequences made by hand.
#include "analyses/signals/repetition.h"

#include "analyses/signals/growth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace vibroimpact::analyses {
namespace repetition_tests {

std::vector<Vector> sequence(int count, const std::function<double(int)> &first,
                             const std::function<double(int)> &second) {
  std::vector<Vector> states;
  for (int n = 0; n < count; ++n) {
    states.emplace_back(2);
    states.back() << first(n), second(n);
  }
  return states;
}

const Vector ones = Vector::Ones(2);

TEST(RepetitionTest, PeriodThree) {
  const auto states = sequence(
      31, [](int n) { return n % 3 == 0 ? 0.5 : 0.1 * (n % 3); }, [](int) { return 2.0; });
  const Repetition found = find_repetition({states, ones, {}}, 16, 1e-7);
  EXPECT_EQ(found.multiple, 3);
  EXPECT_EQ(found.searched, 15);
  EXPECT_EQ(find_repetition({states, ones, {}}, 2, 1e-7).multiple, 0);
}

// One component repeats after 2, the other after 3 periods.
TEST(RepetitionTest, TheSlowestComponentDecides) {
  const auto states = sequence(
      40, [](int n) { return n % 2 * 1.0; }, [](int n) { return n % 3 * 1.0; });
  EXPECT_EQ(find_repetition({states, ones, {}}, 16, 1e-7).multiple, 6);
}

// Scales weigh the differences; a repetition that does not fit twice into the points is not seen.
TEST(RepetitionTest, ScalesAndShortWindows) {
  const auto states = sequence(
      10, [](int n) { return 1e-3 * (n % 5); }, [](int n) { return n % 5 * 1.0; });
  EXPECT_EQ(find_repetition({states, ones, {}}, 16, 1e-7).multiple, 0);
  Vector large = Vector::Constant(2, 1e9);
  EXPECT_EQ(find_repetition({states, large, {}}, 16, 1e-7).multiple, 1);
  const auto longer = sequence(
      11, [](int n) { return 1e-3 * (n % 5); }, [](int n) { return n % 5 * 1.0; });
  EXPECT_EQ(find_repetition({longer, ones, {}}, 16, 1e-7).multiple, 5);
}

// r^n cos(n theta) with theta near a third of a turn: differences over three periods are small long
// before those over one are.
std::vector<Vector> spiral(int count, double rate, double amplitude, double constant = 0) {
  const double theta = 2 * std::numbers::pi * 0.334;
  const auto part = [=](int n, double phase) {
    return amplitude * std::pow(rate, n) * std::cos(n * theta + phase) +
           (n % 3 == 0 ? constant : 0);
  };
  return sequence(
      count, [=](int n) { return part(n, 0); }, [=](int n) { return part(n, 1.5); });
}

TEST(RepetitionTest, ASpiralIsNoRepetition) {
  for (const double rate : {0.9, 0.99}) {
    const auto states = spiral(17, rate, 2e-7);
    const StroboscopicPoints points(states, ones, {});
    ASSERT_EQ(find_repetition(points, 8, 1e-7).multiple, 3);
    const Approach approach = find_spiral(points, 3);
    EXPECT_EQ(approach.multiple, 1);
    EXPECT_NEAR(approach.rate, rate, 0.02);
  }
}

TEST(RepetitionTest, ARepetitionIsNoSpiral) {
  for (const double amplitude : {0.0, 1e-8}) {
    const auto states = spiral(17, 0.9, amplitude, 1e-5);
    const StroboscopicPoints points(states, ones, {});
    ASSERT_EQ(find_repetition(points, 8, 1e-7).multiple, 3);
    EXPECT_EQ(find_spiral(points, 3).multiple, 0);
  }
}

TEST(RepetitionTest, AnglesRepeatAfterATurn) {
  const auto states = sequence(
      20, [](int n) { return 2 * std::numbers::pi * 3 * n; }, [](int) { return 1.0; });
  EXPECT_EQ(find_repetition({states, ones, {}}, 4, 1e-7).multiple, 0);
  EXPECT_EQ(find_repetition({states, ones, {0}}, 4, 1e-7).multiple, 1);
}

// The trap of slow convergence: a spiral into a period-2 motion is no aperiodic one.
TEST(RepetitionTest, SlowConvergenceIsRecognised) {
  const auto states = sequence(
      300, [](int n) { return (n % 2 ? 1.0 : -1.0) + std::pow(0.97, n); },
      [](int n) { return 0.5 * std::pow(0.97, n); });
  const StroboscopicPoints points(states, ones, {});
  EXPECT_EQ(find_repetition(points, 8, 1e-7).multiple, 0);
  const Approach approach = find_approach(points, 8);
  EXPECT_EQ(approach.multiple, 2);
  EXPECT_NEAR(approach.rate, 0.97, 1e-3);
  EXPECT_NEAR(approach.remaining, std::pow(0.97, 299), 0.05 * std::pow(0.97, 299));
}

TEST(RepetitionTest, ATorusAndChaosApproachNothing) {
  const auto torus = sequence(
      300, [](int n) { return std::cos(0.61803 * 2 * std::numbers::pi * n); },
      [](int n) { return std::sin(0.61803 * 2 * std::numbers::pi * n); });
  EXPECT_EQ(find_repetition({torus, ones, {}}, 16, 1e-7).multiple, 0);
  EXPECT_EQ(find_approach({torus, ones, {}}, 16).multiple, 0);
  double x = 0.3;
  const auto logistic = sequence(
      300, [&x](int) { return x = 4 * x * (1 - x); }, [](int) { return 0.0; });
  EXPECT_EQ(find_repetition({logistic, ones, {}}, 16, 1e-7).multiple, 0);
  EXPECT_EQ(find_approach({logistic, ones, {}}, 16).multiple, 0);
}

// The logistic map at 4 has exponent ln 2; deviations grow by |4 - 8x|.
TEST(RepetitionTest, GrowthOfTheLogisticMap) {
  Growth growth(0.1);
  double x = 0.3123;
  for (int n = 0; n < 20000; ++n) {
    growth.add(0.5, std::log(std::abs(4 - 8 * x)));
    x = 4 * x * (1 - x);
  }
  const double error = growth.standard_error(20);
  EXPECT_NEAR(growth.exponent(), 2 * std::numbers::ln2, 4 * error);
  EXPECT_LT(error, 0.02);
  EXPECT_GT(error, 1e-5);
  EXPECT_DOUBLE_EQ(growth.running_exponent().back(), growth.exponent());
  EXPECT_EQ(growth.running_exponent().size(), 18000u);
  EXPECT_TRUE(std::isnan(Growth(0).exponent()));
}

} // namespace repetition_tests
} // namespace vibroimpact::analyses
