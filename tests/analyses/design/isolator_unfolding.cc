// The plane of the unfolding parameters against published values, and against the roots of its
// bifurcation equation.
#include "analyses/isolators/isolator_unfolding.h"

#include <gtest/gtest.h>
#include <random>
#include <unsupported/Eigen/Polynomials>

namespace vibroimpact::analyses {
namespace isolator_unfolding_tests {

constexpr IsolatorDamping damping{.isolator = 0.01, .stop = 0.2};

TEST(IsolatorUnfoldingTest, HasThePublishedHysteresisSet) {
  EXPECT_NEAR(damping.rho(), 2.4252182, 5e-8);
  const double published[][3] = {{0.25, 0.05922766, -0.88056799},
                                 {0.5, 0.21588542, -0.57036812},
                                 {0.75, 0.45822776, -0.14075808},
                                 {0.9, 0.65886056, 0.18726431}};
  for (const auto &[z, first, second] : published) {
    const HysteresisPoint point = hysteresis_set(z, damping.rho());
    EXPECT_NEAR(point.at.first, first, 5e-9) << z;
    EXPECT_NEAR(point.at.second, second, 5e-9) << z;
  }
}

TEST(IsolatorUnfoldingTest, HasThePublishedBifurcationSets) {
  EXPECT_NEAR(set_b2(0.5, damping.rho()), 0.367605, 5e-7);
  EXPECT_NEAR(set_b3_plus(0.5, damping.rho()), 0.348191, 5e-7);
  EXPECT_NEAR(set_b3_minus(0.5, damping.rho()), 0.008114, 5e-7);
}

TEST(IsolatorUnfoldingTest, HasThePublishedStops) {
  const double published[][4] = {{0.7, 0, 0.471239, 0.509296},
                                 {0.4, -0.8, 0.824668, 1.068355},
                                 {0.3, -0.2, 1.099557, 0.807083},
                                 {0.1, -0.1, 3.298672, 1.422456}};
  for (const auto &[first, second, stiffness, force] : published) {
    const StopChoice stop = stop_of({first, second}, damping, 1);
    EXPECT_NEAR(stop.stiffness, stiffness, 5e-7);
    EXPECT_NEAR(stop.force, force, 5e-7);
    const UnfoldingParameters back = unfolding_of(stop, damping, 1);
    EXPECT_NEAR(back.first, first, 1e-14);
    EXPECT_NEAR(back.second, second, 1e-14);
  }
  EXPECT_EQ(region_of({0.7, 0}, damping.rho()), Region::four);
  EXPECT_EQ(region_of({0.4, -0.8}, damping.rho()), Region::four);
  EXPECT_EQ(region_of({0.3, -0.2}, damping.rho()), Region::three);
  EXPECT_EQ(region_of({0.1, -0.1}, damping.rho()), Region::two);
}

// H begins at (0, -1).
TEST(IsolatorUnfoldingTest, HardStopsJumpAboveMinusOne) {
  EXPECT_EQ(region_of({1e-7, -0.999}, damping.rho()), Region::three);
  EXPECT_EQ(region_of({1e-7, -1.001}, damping.rho()), Region::four);
}

TEST(IsolatorUnfoldingTest, AStopAboveB2HasNoForce) {
  EXPECT_TRUE(std::isnan(stop_of({0.5, 0.4}, damping, 1).force));
  EXPECT_EQ(region_of({0.5, 0.4}, damping.rho()), Region::none);
}

/// The bifurcation equation and its derivatives by z.
struct Equation {
  UnfoldingParameters at;
  double rho, eta;
  double side(double z) const { return z - z * z * z / 6 + eta; }
  double value(double z) const {
    const double a = at.first * at.first;
    return side(z) * side(z) + a * (1 - rho * z) + at.second * z * z;
  }
  double slope(double z) const {
    return 2 * side(z) * (1 - z * z / 2) - rho * at.first * at.first + 2 * at.second * z;
  }
  double curvature(double z) const {
    return 2 * (1 - z * z / 2) * (1 - z * z / 2) - 2 * z * side(z) + 2 * at.second;
  }
};

// Also at z = 1/rho, where the formula of the paper is 0/0.
TEST(IsolatorUnfoldingTest, OnTheHysteresisSetThreeRootsMeet) {
  for (const double sigma : {0.0, 0.05, 0.27}) {
    const double rho = IsolatorDamping{.isolator = sigma, .stop = 1}.rho();
    for (const double z : {1e-3, 0.1, 1 / rho, 0.6, 0.99, 1.0}) {
      const HysteresisPoint point = hysteresis_set(z, rho);
      const Equation g{point.at, rho, point.eta};
      EXPECT_NEAR(g.value(z), 0, 1e-15) << z;
      EXPECT_NEAR(g.slope(z), 0, 1e-14) << z;
      EXPECT_NEAR(g.curvature(z), 0, 1e-14) << z;
      EXPECT_GT(point.at.first, 0);
    }
  }
}

// alpha_1 -> z^2 as z -> 0: three digits of it at z = 1e-3, where 16 would cancel otherwise.
TEST(IsolatorUnfoldingTest, TheHysteresisSetBeginsAtMinusOne) {
  const HysteresisPoint point = hysteresis_set(1e-3, damping.rho());
  EXPECT_NEAR(point.at.first / 1e-6, 1, 2e-3);
  EXPECT_NEAR(point.at.second, -1, 1e-5);
}

TEST(IsolatorUnfoldingTest, TheHysteresisSetEndsOnB3) {
  for (const double sigma : {0.0, 0.05, 0.27}) {
    const double rho = IsolatorDamping{.isolator = sigma, .stop = 1}.rho();
    const HysteresisPoint end = hysteresis_set(1, rho);
    EXPECT_NEAR(end.at.second, set_b3_minus(end.at.first, rho), 1e-14);
    EXPECT_EQ(hysteresis_above(end.at.first, rho).z, 1);
    const HysteresisPoint inside = hysteresis_set(0.4, rho);
    EXPECT_NEAR(hysteresis_above(inside.at.first, rho).z, 0.4, 1e-13);
  }
  EXPECT_THROW(hysteresis_above(0.9, damping.rho()), std::domain_error);
}

// B3 is a fold at z = 1, on either side of the curve.
TEST(IsolatorUnfoldingTest, OnB3TheCurveTurnsWhereTheStopIsFirstReached) {
  const double rho = damping.rho(), first = 0.5;
  for (const double second : {set_b3_plus(first, rho), set_b3_minus(first, rho)}) {
    const double side = rho * first * first - 2 * second; // from G_z(1) = 0
    const Equation g{{first, second}, rho, side - 5.0 / 6};
    EXPECT_NEAR(g.value(1), 0, 1e-15);
    EXPECT_NEAR(g.slope(1), 0, 1e-15);
  }
}

// eta = -u +- sqrt(D) with D = -A (1 - rho z) - alpha_2 z^2: folds where D'^2 = 4 u'^2 D, a
// polynomial of degree six.
int folds_by_roots(const UnfoldingParameters &at, double rho) {
  const double a = at.first * at.first, d[3] = {-a, rho * a, -at.second};
  const double slope_squared[5] = {1, 0, -1, 0, 0.25};
  Eigen::VectorXd p = Eigen::VectorXd::Zero(7);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j)
      p[i + j] += 4 * slope_squared[i] * d[j];
  p[0] -= d[1] * d[1];
  p[1] -= 4 * d[1] * d[2];
  p[2] -= 4 * d[2] * d[2];
  const Eigen::PolynomialSolver<double, 6> roots(p);
  int folds = 0;
  for (const std::complex<double> &root : roots.roots())
    folds += std::abs(root.imag()) < 1e-9 && root.real() > 0 && root.real() < 1 ? 1 : 0;
  return folds;
}

TEST(IsolatorUnfoldingTest, EveryRegionHasItsNumberOfFolds) {
  std::mt19937 generator(7);
  for (const double sigma : {0.0, 0.05, 0.2}) {
    const double rho = IsolatorDamping{.isolator = sigma, .stop = 1}.rho();
    int seen[5] = {};
    for (int i = 0; i < 2000; ++i) {
      const auto uniform = [&] { return static_cast<double>(generator()) / 4294967296.0; };
      const UnfoldingParameters at{0.01 + 0.99 * uniform(), -1.1 + 2.1 * uniform()};
      const Region region = region_of(at, rho);
      ++seen[static_cast<int>(region)];
      EXPECT_EQ(folds_in(region), folds_by_roots(at, rho)) << at.first << ", " << at.second;
    }
    for (const int count : seen)
      EXPECT_GT(count, 0) << sigma;
  }
}

TEST(IsolatorUnfoldingTest, ExamplesLieInTheirRegions) {
  for (const double sigma : {0.0, 0.05, 0.25}) {
    const double rho = IsolatorDamping{.isolator = sigma, .stop = 1}.rho();
    for (const Region region : {Region::one, Region::two, Region::three, Region::four})
      EXPECT_EQ(region_of(example_of(region, rho), rho), region) << sigma << name_of(region);
  }
}

} // namespace isolator_unfolding_tests
} // namespace vibroimpact::analyses
