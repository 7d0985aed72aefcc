// Sums of decaying, growing and oscillating exponentials are never said to be positive where they
// are not, and are followed far where they are.
#include "integration/exponential_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vibroimpact {
namespace {

using Complex = ExponentialSums::Complex;

struct Sum {
  double constant = 0;
  std::vector<Complex> coefficients, exponents;

  double operator()(double t) const {
    double value = constant;
    for (std::size_t j = 0; j < exponents.size(); ++j)
      value += (coefficients[j] * std::exp(exponents[j] * t)).real();
    return value;
  }
};

double positive_until(const Sum &sum, double limit) {
  ExponentialSums sums;
  Eigen::MatrixXcd coefficients(1, static_cast<Index>(sum.coefficients.size()));
  for (std::size_t j = 0; j < sum.coefficients.size(); ++j)
    coefficients(0, static_cast<Index>(j)) = sum.coefficients[j];
  sums.set(coefficients, coefficients.cwiseAbs(), Vector::Constant(1, sum.constant), sum.exponents);
  const std::vector<Complex> ones(sum.exponents.size(), 1.0);
  sums.start(ones);
  return sums.positive_until(limit);
}

TEST(ExponentialSumsTest, NothingToWatchReachesTheLimit) {
  ExponentialSums sums;
  sums.set(Eigen::MatrixXcd(0, 0), Matrix(0, 0), Vector(0), {});
  EXPECT_EQ(sums.positive_until(3.5), 3.5);
}

TEST(ExponentialSumsTest, FarFromZeroReachesTheLimit) {
  // 10 + cos 2 t over a quarter of its period
  EXPECT_EQ(positive_until({.constant = 10, .coefficients = {1}, .exponents = {{0, 2}}}, 0.8), 0.8);
}

TEST(ExponentialSumsTest, AtZeroOrBelowNothingIsKnown) {
  EXPECT_EQ(positive_until({.constant = -1, .coefficients = {1}, .exponents = {-2}}, 1), 0);
  EXPECT_EQ(positive_until({.constant = -1, .coefficients = {0.5}, .exponents = {-2}}, 1), 0);
}

// exp(-t) - 0.1 is zero at t = ln 10: repeated advances come close to it and never beyond.
TEST(ExponentialSumsTest, ApproachesAZeroFromBelow) {
  const double zero = std::log(10.0);
  double t = 0;
  for (int i = 0; i < 200; ++i)
    t += positive_until(
        {.constant = -0.1, .coefficients = {std::exp(-t)}, .exponents = {Complex(-1)}}, 10);
  EXPECT_LT(t, zero);
  EXPECT_GT(t, 0.99 * zero);
}

// Twenty thousand sums against samples.
TEST(ExponentialSumsTest, RandomSumsNeverCross) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int proved = 0;
  for (int i = 0; i < 20000; ++i) {
    Sum sum{.constant = unit(random), .coefficients = {}, .exponents = {}};
    for (int j = 0; j < 4; ++j) {
      sum.coefficients.emplace_back(unit(random), unit(random));
      sum.exponents.emplace_back(0.5 * unit(random) - 0.2, j == 0 ? 0 : 6 * unit(random));
    }
    const double until = positive_until(sum, 4);
    ASSERT_GE(until, 0);
    ASSERT_LE(until, 4);
    proved += until > 0;
    for (int k = 0; until > 0 && k <= 64; ++k)
      ASSERT_GT(sum(until * k / 64), 0) << i;
  }
  EXPECT_GT(proved, 5000);
}

} // namespace
} // namespace vibroimpact
