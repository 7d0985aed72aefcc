// The averaged response against published folds, its equation, and the expansion of it.
#include "analyses/isolators/isolator_averaging.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace isolator_averaging_tests {

constexpr IsolatorDamping damping{.isolator = 0.01, .stop = 0.2};

TEST(IsolatorAveragingTest, HasThePublishedFolds) {
  struct Case {
    double stiffness, force;
    std::vector<double> folds;
  };
  const Case published[] = {{0.5, 0.52, {}},
                            {1, 0.52, {1.226135, 1.244841}},
                            {2, 0.52, {1.231127, 1.371611}},
                            {5, 0.52, {1.232408, 1.681482}},
                            {0.471239, 0.509296, {}},
                            {0.824668, 1.068355, {}},
                            {1.099557429, 0.807083, {1.324645, 1.328215}}};
  for (const Case &known : published) {
    const auto folds = AveragedResponse(damping, {known.stiffness, known.force}).folds();
    ASSERT_EQ(folds.size(), known.folds.size()) << known.stiffness;
    for (std::size_t i = 0; i < folds.size(); ++i)
      EXPECT_NEAR(folds[i].ratio, known.folds[i], 1e-6) << known.stiffness;
  }
}

/// (8) of the paper, with p and q of (7).
double printed_residual(double a, double ratio, const StopChoice &stop) {
  const double angle = std::acos(1 / a), share = 2 * angle - std::sin(2 * angle);
  const double p = stop.stiffness * a / (2 * M_PI) * share;
  const double q = a / M_PI * (damping.isolator * M_PI + damping.stop * share);
  const double first = p + a / 2 * (1 - ratio * ratio);
  return first * first + ratio * ratio * q * q - stop.force * stop.force / 4;
}

TEST(IsolatorAveragingTest, SolvesThePrintedEquation) {
  const StopChoice stop{.stiffness = 2, .force = 0.52};
  const AveragedResponse response(damping, stop);
  for (const double share : {0.0, 0.1, 0.5, 1.0}) {
    const double z = response.least_z() + share * (1 - response.least_z());
    for (const double ratio : response.ratios(z))
      EXPECT_NEAR(printed_residual(1 / z, ratio, stop), 0, 1e-13) << z;
  }
}

// Free response at |y| = 1: (1 - lambda^2)^2 + (2 zeta_0 lambda)^2 = f^2.
TEST(IsolatorAveragingTest, MeetsTheFreeResponseWhereTheStopIsFirstReached) {
  const auto ratios = AveragedResponse(damping, {.stiffness = 2, .force = 0.52}).ratios(1);
  EXPECT_NEAR(ratios[0], 0.69295362, 5e-9);
  EXPECT_NEAR(ratios[1], 1.23264564, 5e-9);
}

TEST(IsolatorAveragingTest, HasNoContactBelowTheFreePeak) {
  const double peak = 1 / (2 * 0.01 * std::sqrt(1 - 1e-4));
  EXPECT_FALSE(AveragedResponse(damping, {.stiffness = 2, .force = 0.999 / peak}).reaches_stop());
  EXPECT_TRUE(AveragedResponse(damping, {.stiffness = 2, .force = 1.001 / peak}).reaches_stop());
  const ResponsePeak free = AveragedResponse(damping, {.stiffness = 2, .force = 0.01}).peak();
  EXPECT_NEAR(free.amplitude, 0.01 * peak, 1e-15);
  EXPECT_NEAR(free.ratio, std::sqrt(1 - 2e-4), 1e-15);
}

// The peak of the curve is where lambda is the same on both sides, and a larger amplitude has none.
TEST(IsolatorAveragingTest, StiffnessForPeakIsTheInverseOfThePeak) {
  const StopChoice stop{.stiffness = 1.7, .force = 1.3};
  const AveragedResponse response(damping, stop);
  const ResponsePeak peak = response.peak();
  const auto sides = response.ratios(1 / peak.amplitude);
  EXPECT_NEAR(sides[0], sides[1], 1e-6);
  EXPECT_NEAR(stiffness_for_peak(stop.force, peak.amplitude, damping), 1.7, 1e-12);
  EXPECT_NEAR(printed_residual(peak.amplitude, peak.ratio, stop), 0, 1e-13);
}

// At f = 0.52 and a peak of 1.2 clearances.
TEST(IsolatorAveragingTest, TheLiteralReadingNeedsAStiffStop) {
  EXPECT_NEAR(stiffness_for_peak(0.52, 1.2, damping), 865, 0.5);
}

// Folds of z -> lambda: their neighbours lie on one side.
TEST(IsolatorAveragingTest, TheCurveTurnsAtItsFolds) {
  const AveragedResponse response(damping, {.stiffness = 2, .force = 0.52});
  const auto folds = response.folds();
  const double at_low = folds[0].ratio, at_high = folds[1].ratio, step = 1e-4;
  for (const double shift : {-step, step}) {
    EXPECT_GT(response.ratios(folds[0].z + shift)[1], at_low);
    EXPECT_LT(response.ratios(folds[1].z + shift)[1], at_high);
  }
}

// Bisected with the curves of tests/verification/study_averaging.py; the exact cusp is at mu =
// 0.782854, lambda = 1.220670.
TEST(IsolatorAveragingTest, TheFirstJumpIsACusp) {
  const double stiffness = stiffness_of_first_jump(0.52, damping);
  EXPECT_NEAR(stiffness, 0.758126869, 2e-8);
  EXPECT_TRUE(AveragedResponse(damping, {0.9999 * stiffness, 0.52}).folds().empty());
  const auto folds = AveragedResponse(damping, {1.0001 * stiffness, 0.52}).folds();
  ASSERT_EQ(folds.size(), 2);
  EXPECT_NEAR(folds[0].ratio, folds[1].ratio, 1e-5);
  EXPECT_NEAR(folds[0].ratio, 1.219711, 2e-5);
}

// For large amplitudes the expansion of isolator_unfolding.h has the same folds: both cusps meet as
// z -> 0 along H, alpha_1 -> 0.
TEST(IsolatorAveragingTest, TendsToItsExpansion) {
  double last = 1;
  for (const double z : {0.4, 0.2, 0.1}) {
    // alpha_1 holds the lambda of the cusp itself: lambda^2 = 1 + mu (1 + 4 eta/pi).
    const HysteresisPoint cusp = hysteresis_set(z, damping.rho());
    double ratio = 1;
    for (int i = 0; i < 200; ++i) {
      const double mu = stop_of(cusp.at, damping, ratio).stiffness;
      ratio = 0.5 * (ratio + std::sqrt(1 + mu * (1 + 4 * cusp.eta / M_PI)));
    }
    const StopChoice stop = stop_of(cusp.at, damping, ratio);
    const double error =
        std::abs(stiffness_of_first_jump(stop.force, damping) / stop.stiffness - 1);
    EXPECT_LT(error, 0.1 * last) << z; // as z^4
    last = error;
  }
  EXPECT_LT(last, 1e-4);
}

} // namespace isolator_averaging_tests
} // namespace vibroimpact::analyses
