// After how many periods a sequence of states repeats that has come near to a periodic one.
#include "analyses/sweeps/steadiness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace vibroimpact::analyses {
namespace period_multiple_tests {

constexpr double tolerance = 1e-6;
const Vector at_rest = Eigen::Vector2d(1, 0.5);

struct Found {
  long multiple = 0;
  int periods = 0; ///< after which it was found
};

Found first_steady(const std::function<Vector(int)> &state) {
  Steadiness steadiness(Vector::Ones(2), 4, tolerance);
  for (int n = 0; n < 3000; ++n) {
    steadiness.add(state(n));
    if (steadiness.steady())
      return {.multiple = steadiness.multiple(), .periods = n};
  }
  return {};
}

// A lightly damped oscillator between two instants of equal phase: r^n times a turn by n theta.
Vector spiral(int n, double rate, double theta) {
  return at_rest +
         0.3 * std::pow(rate, n) * Eigen::Vector2d(std::cos(n * theta), std::sin(n * theta));
}

TEST(PeriodMultipleTest, AMotionThatSpiralsInRepeatsAfterOnePeriod) {
  for (const double rate : {0.5, 0.9, 0.97, 0.995})
    for (double theta = 0.05; theta < 2 * std::numbers::pi; theta += 0.1) {
      const Found found = first_steady([&](int n) { return spiral(n, rate, theta); });
      EXPECT_EQ(found.multiple, 1) << rate << " " << theta;
      // The largest entry of a vector that turns is down to 1/sqrt(2) of its length.
      const double distance = 0.3 * std::pow(rate, found.periods);
      EXPECT_LT(distance, 2 * tolerance) << rate << " " << theta;
    }
}

TEST(PeriodMultipleTest, ARepetitionAfterSeveralPeriodsIsTold) {
  for (const int multiple : {2, 3, 4})
    for (const double size : {1e-4, 0.3})
      for (const double rate : {0.5, 0.97}) {
        const Found found = first_steady([&](int n) {
          Vector state = spiral(n, rate, 1.3);
          state[0] += n % multiple * size; // no two alike: equal states have the same future
          return state;
        });
        EXPECT_EQ(found.multiple, multiple) << size << " " << rate;
      }
}

TEST(PeriodMultipleTest, AMotionThatDoesNotRepeatIsNotSteady) {
  EXPECT_EQ(first_steady([](int n) { return spiral(n, 1, 1); }).multiple, 0);
}

} // namespace period_multiple_tests
} // namespace vibroimpact::analyses
