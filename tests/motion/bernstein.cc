// Dense output polynomials: interpolation, safe isolation of falls through zero, extrema.
#include "motion/interval/bernstein.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace vibroimpact::motion {
namespace bernstein_tests {

// Quintic with the given roots, through its values and derivatives at 0 and 1.
Bernstein from_roots(const std::vector<double> &roots, double factor) {
  const auto value = [&](long double t) {
    long double p = factor;
    for (const double root : roots)
      p *= t - root;
    return p;
  };
  const auto derivatives = [&](double t) {
    std::array<double, 3> d{static_cast<double>(value(t)), 0, 0};
    for (std::size_t i = 0; i < roots.size(); ++i) {
      long double product = factor;
      for (std::size_t k = 0; k < roots.size(); ++k)
        if (k != i)
          product *= t - roots[k];
      d[1] += static_cast<double>(product);
      for (std::size_t j = 0; j < roots.size(); ++j) {
        long double second = factor;
        for (std::size_t k = 0; k < roots.size(); ++k)
          if (k != i && k != j)
            second *= t - roots[k];
        if (j != i)
          d[2] += static_cast<double>(second);
      }
    }
    return d;
  };
  return Bernstein::quintic(1, derivatives(0), derivatives(1));
}

TEST(BernsteinTest, ReproducesAQuintic) {
  const Bernstein p = from_roots({-0.3, 0.2, 0.25, 0.7, 1.4}, 2);
  for (const double t : {0.0, 0.1, 0.2, 0.5, 0.77, 1.0})
    EXPECT_NEAR(p(t), 2 * (t + 0.3) * (t - 0.2) * (t - 0.25) * (t - 0.7) * (t - 1.4), 1e-14);
  const double h = 1e-5;
  EXPECT_NEAR(p.derivative()(0.3), (p(0.3 + h) - p(0.3 - h)) / (2 * h), 1e-8);
}

TEST(BernsteinTest, FindsTheFirstFallAmongRandomRoots) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-0.5, 1.5);
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<double> roots(5);
    for (double &root : roots)
      root = uniform(generator);
    // A close pair in every second trial.
    if (trial % 2 == 0)
      roots[1] = roots[0] + std::pow(10.0, -1 - 5 * (trial % 1000) / 1000.0);
    const double factor = trial % 3 == 0 ? -1 : 1;
    const Bernstein p = from_roots(roots, factor);
    std::sort(roots.begin(), roots.end());
    // Expected: the first root in (0, 1) at which the sign turns from + to -, or 0.
    double sign = factor;
    for (const double root : roots)
      if (root > 0)
        sign = -sign;
    // sign is now that of p(0): each root above 0 flips the sign seen from +infinity.
    std::optional<double> expected;
    if (sign < 0)
      expected = 0;
    for (const double root : roots) {
      if (root <= 0 || expected)
        continue;
      sign = -sign;
      if (sign < 0 && root <= 1)
        expected = root;
    }
    const std::optional<double> found = p.first_down_crossing();
    ASSERT_EQ(found.has_value(), expected.has_value()) << "trial " << trial;
    if (expected) {
      ASSERT_NEAR(*found, *expected, 1e-8) << "trial " << trial;
    }
  }
}

TEST(BernsteinTest, ZeroAtTheStartIsNoFallWhenItRises) {
  Bernstein rising = Bernstein::quintic(1, {-1e-18, 1, 0}, {1, 1, 0});
  rising.clear_start();
  EXPECT_FALSE(rising.first_down_crossing());
  Bernstein falling = Bernstein::quintic(1, {0, 0, -1}, {-1, -1, 0});
  EXPECT_EQ(falling.first_down_crossing(), 0);
}

TEST(BernsteinTest, TouchingZeroIsNoFall) {
  Bernstein above = from_roots({0.5, 0.5, -1, -1, -1}, 1);
  above += Bernstein(1e-13);
  EXPECT_FALSE(above.first_down_crossing());
  Bernstein below = from_roots({0.5, 0.5, -1, -1, -1}, 1);
  below += Bernstein(-1e-13);
  ASSERT_TRUE(below.first_down_crossing());
  EXPECT_NEAR(*below.first_down_crossing(), 0.5, 1e-6);
}

TEST(BernsteinTest, Extrema) {
  // sin over one step of length 2, start at 0.6: maximum 1 near t = pi/2.
  const double a = 0.6;
  const double h = 2;
  const Bernstein p = Bernstein::quintic(h, {std::sin(a), std::cos(a), -std::sin(a)},
                                         {std::sin(a + h), std::cos(a + h), -std::sin(a + h)});
  double dense = -1;
  for (int i = 0; i <= 100000; ++i)
    dense = std::max(dense, p(i / 100000.0));
  EXPECT_NEAR(p.maximum(), dense, 1e-9);
  EXPECT_NEAR(p.maximum(), 1, 2e-3);
  EXPECT_NEAR(p.minimum(), std::sin(a + h), 1e-15);
}

TEST(BernsteinTest, APartIsThePolynomialThere) {
  const Bernstein whole = from_roots({-0.3, 0.2, 0.45, 0.9, 1.4}, 7);
  for (const auto &[from, to] : {std::pair(0.0, 0.4), std::pair(0.3, 0.7), std::pair(0.6, 1.0),
                                 std::pair(0.5, 0.5), std::pair(1.0, 1.0)}) {
    const Bernstein part = whole.between(from, to);
    for (const double tau : {0.0, 0.25, 0.7, 1.0})
      EXPECT_NEAR(part(tau), whole(from + tau * (to - from)), 1e-14) << from << " " << to;
  }
}

TEST(BernsteinTest, SumRaisesTheDegree) {
  Bernstein sum = Bernstein::cubic(1, {1, 2}, {3, -1});
  sum += from_roots({0.1, 0.2, 0.3, 0.4, 0.5}, 1);
  EXPECT_EQ(sum.degree(), 5);
  const Bernstein cubic = Bernstein::cubic(1, {1, 2}, {3, -1});
  EXPECT_NEAR(sum(0.37), cubic(0.37) + 0.27 * 0.17 * 0.07 * -0.03 * -0.13, 1e-15);
}

// A bounce within one step: from an exact zero up and down again, tau (0.4 - tau).
TEST(BernsteinTest, FallsAgainAfterAnExactZeroAtTheStart) {
  Bernstein parabola = Bernstein::quintic(1, {0, 0.4, -2}, {-0.6, -1.6, -2});
  parabola.clear_start();
  ASSERT_TRUE(parabola.first_down_crossing());
  EXPECT_NEAR(*parabola.first_down_crossing(), 0.4, 1e-15);
}

// The coefficient in the middle of degree 6 is that of t^3 (1 - t)^3, times 20.
TEST(BernsteinTest, WhatIsAddedToTheMiddleVanishesThriceAtBothEnds) {
  const Bernstein p = from_roots({-0.3, 0.2, 0.25, 0.7, 1.4}, 2);
  const Bernstein q = p.with_middle(0.7);
  for (const double t : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0})
    EXPECT_NEAR(q(t) - p(t), 20 * 0.7 * std::pow(t * (1 - t), 3), 1e-14) << t;
}

} // namespace bernstein_tests
} // namespace vibroimpact::motion
