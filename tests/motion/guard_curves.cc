// First falls of known functions: pairs of zeros however close, touches, triple zeros, starts at
// zero.
#include "motion/interval/guard_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace vibroimpact::motion {
namespace guard_curves_tests {

constexpr double epsilon = 2.3e-16;

// One function by its derivatives.
class Known : public GuardCurves {
public:
  using Function = std::function<Jet(double)>;
  Known(Function function, double sixth, double rounding)
      : function_(std::move(function)), sixth_(sixth), rounding_(rounding) {}
  Index size() const override { return 1; }
  Jet at(Index /*guard*/, double time) const override {
    ++evaluations;
    return function_(time);
  }
  double sixth_derivative(Index /*guard*/, double /*from*/, double /*to*/) const override {
    return sixth_;
  }
  double rounding(Index /*guard*/) const override { return rounding_; }
  mutable int evaluations = 0;

private:
  Function function_;
  double sixth_, rounding_;
};

// depth - cos(t - 1): touches zero at t = 1 when the depth is 1.
Known cosine(double depth) {
  return {[depth](double t) -> Jet {
            const double s = std::sin((t - 1) / 2);
            return {(depth - 1) + 2 * s * s, std::sin(t - 1), std::cos(t - 1)};
          },
          1, 64 * epsilon};
}

Known polynomial(std::vector<double> coefficients) {
  return {[=](double t) {
            Jet jet;
            for (std::size_t i = coefficients.size(); i-- > 0;) {
              jet.acceleration = jet.acceleration * t + 2 * jet.rate;
              jet.rate = jet.rate * t + jet.value;
              jet.value = jet.value * t + coefficients[i];
            }
            return jet;
          },
          0, 64 * epsilon};
}

TEST(GuardCurvesTest, PairOfZerosHoweverClose) {
  for (double dip = 1e-1; dip > 3e-14; dip /= 2) {
    const FirstDownCrossing fall = first_down_crossing(cosine(1 - dip), 0, 2.9);
    ASSERT_TRUE(fall.time) << dip;
    const double half = std::sqrt(2 * dip) * (1 + dip / 12); // arccos(1 - dip)
    EXPECT_NEAR(*fall.time, 1 - half, 64 * epsilon / half + dip * dip) << dip;
    EXPECT_FALSE(fall.touch);
  }
}

TEST(GuardCurvesTest, NearMissIsNoFall) {
  for (double above = 1e-1; above > 3e-14; above /= 2) {
    const Known curve = cosine(1 + above);
    const FirstDownCrossing fall = first_down_crossing(curve, 0, 2.9);
    EXPECT_FALSE(fall.time) << above;
    EXPECT_FALSE(fall.touch) << above;
    EXPECT_LT(curve.evaluations, 400) << above;
  }
}

TEST(GuardCurvesTest, TouchWithinRoundingIsUndecided) {
  for (const double depth : {-1e-15, -1e-16, 0.0, 1e-16, 1e-15}) {
    const FirstDownCrossing fall = first_down_crossing(cosine(1 + depth), 0, 2.9);
    EXPECT_FALSE(fall.time) << depth;
    ASSERT_TRUE(fall.touch) << depth;
    EXPECT_NEAR(*fall.touch, 1, 1e-6) << depth;
  }
}

TEST(GuardCurvesTest, TouchAndThenAFall) {
  const Known curve = {[](double t) -> Jet {
                         const double s = std::sin(t);
                         // touches at pi / 2, falls where the slow cosine takes over
                         return {(1 - s) * std::cos(t / 4),
                                 -std::cos(t) * std::cos(t / 4) - (1 - s) * std::sin(t / 4) / 4,
                                 s * std::cos(t / 4) + std::cos(t) * std::sin(t / 4) / 2 -
                                     (1 - s) * std::cos(t / 4) / 16};
                       },
                       10, 64 * epsilon};
  const FirstDownCrossing fall = first_down_crossing(curve, 0, 7);
  ASSERT_TRUE(fall.touch);
  EXPECT_NEAR(*fall.touch, std::numbers::pi / 2, 1e-6);
  ASSERT_TRUE(fall.time);
  EXPECT_NEAR(*fall.time, 2 * std::numbers::pi, 1e-14);
}

TEST(GuardCurvesTest, SingleZeroToTheLastDigits) {
  const FirstDownCrossing fall = first_down_crossing(polynomial({2, 0, -1}), 0, 3);
  ASSERT_TRUE(fall.time);
  EXPECT_NEAR(*fall.time, std::sqrt(2), 4 * epsilon);
}

// (1 - t)^3: flat where it passes.
TEST(GuardCurvesTest, TripleZero) {
  const FirstDownCrossing fall = first_down_crossing(polynomial({1, -3, 3, -1}), 0, 2);
  ASSERT_TRUE(fall.time);
  EXPECT_NEAR(*fall.time, 1, 3e-5); // the cubic root of the rounding
  EXPECT_FALSE(fall.touch);
}

// The first of three zeros, 0.3, 0.300001 and 1.4.
TEST(GuardCurvesTest, TheFirstOfSeveral) {
  const double a = 0.3;
  const double b = 0.300001;
  const double c = 1.4;
  const FirstDownCrossing fall =
      first_down_crossing(polynomial({a * b * c, -(a * b + b * c + a * c), a + b + c, -1}), 0, 2);
  ASSERT_TRUE(fall.time);
  EXPECT_NEAR(*fall.time, a, 1e-9);
}

// above - 20 t^3 (1 - t)^3: value, slope and curvature are the same at 0 and 1, so that the quintic
// through them is constant. All that shows the dip of 0.3125 is the bound 14400 of the sixth
// derivative. The fall is where t (1 - t) = (above / 20)^(1/3).
TEST(GuardCurvesTest, ADipThatTheEndsDoNotShow) {
  for (const double above : {0.005, 0.05, 0.2, 0.31}) {
    const Known curve = {[above](double t) -> Jet {
                           const double w = t * (1 - t);
                           const double slope = 1 - 2 * t;
                           return {above - 20 * w * w * w, -60 * w * w * slope,
                                   -120 * w * slope * slope + 120 * w * w};
                         },
                         14400, 64 * epsilon};
    const FirstDownCrossing fall = first_down_crossing(curve, 0, 1);
    ASSERT_TRUE(fall.time) << above;
    const double exact = (1 - std::sqrt(1 - 4 * std::cbrt(above / 20))) / 2;
    EXPECT_NEAR(*fall.time, exact, 1e-13) << above;
  }
}

TEST(GuardCurvesTest, StartAtZero) {
  const auto sine = [](double shift) {
    return Known(
        [shift](double t) -> Jet {
          return {std::sin(t) + shift, std::cos(t), -std::sin(t)};
        },
        1, 64 * epsilon);
  };
  const FirstDownCrossing leaving = first_down_crossing(sine(0), 0, 4, {.zero = true, .shift = 0});
  ASSERT_TRUE(leaving.time);
  EXPECT_NEAR(*leaving.time, std::numbers::pi, 1e-14);
  EXPECT_FALSE(leaving.touch);
  // What the location of that zero has left.
  const FirstDownCrossing shifted =
      first_down_crossing(sine(-1e-13), 0, 3, {.zero = true, .shift = 1e-13});
  EXPECT_FALSE(shifted.time);
  EXPECT_FALSE(shifted.touch);
  EXPECT_EQ(first_down_crossing(sine(-1e-3), 0, 3).time.value_or(-1), 0);
  const FirstDownCrossing falling =
      first_down_crossing(polynomial({0, -1}), 0, 1, {.zero = true, .shift = 0});
  EXPECT_EQ(falling.time.value_or(-1), 0);
}

// A touch at the end of one interval and the start of the next counts once.
TEST(GuardCurvesTest, TouchBetweenTwoIntervals) {
  const Known before = polynomial({1, -2, 1}); // (1 - t)^2
  EXPECT_FALSE(first_down_crossing(before, 0, 1).touch);
  const FirstDownCrossing after = first_down_crossing(polynomial({0, 0, 1}), 0, 1);
  EXPECT_TRUE(after.touch);
  EXPECT_FALSE(after.time);
}

} // namespace guard_curves_tests
} // namespace vibroimpact::motion
