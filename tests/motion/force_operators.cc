// Integrals of powers at both ends times polynomials, against Beta functions.
#include "motion/episode/force_operators.h"

#include <boost/math/special_functions/beta.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {
namespace force_operators_tests {

Vector at_nodes(const ForceFamily &family, int degree) {
  Vector values(family.size());
  for (int j = 0; j < family.size(); ++j) {
    const EpisodeTime::Point at =
        family.stretch().at(family.rule().nodes[j], family.rule().rest[j]);
    values[j] = static_cast<double>(std::pow(at.x, family.shape().begin + degree) *
                                    std::pow(at.rest, family.shape().end));
  }
  return values;
}

// Integral of (X - y)^k / k! y^a (1 - y)^b over [0, X], by the binomial theorem.
double integral(int k, double a, double b, double x) {
  double sum = 0;
  double binomial = 1;
  for (int i = 0; i <= k; ++i) {
    sum += binomial * std::pow(x, k - i) * (i % 2 == 0 ? 1 : -1) *
           boost::math::beta(a + 1 + i, b + 1, x);
    binomial *= static_cast<double>(k - i) / (i + 1);
  }
  return sum / std::tgamma(k + 1.0);
}

// Of x, which is a polynomial in the parameter of the family itself.
int highest_degree(const ForceShape &shape) {
  return (shape.nodes - 1) / (shape.begin_root + shape.end_root - 1);
}

class ForceOperatorsOfShape : public ::testing::TestWithParam<ForceShape> {};

TEST_P(ForceOperatorsOfShape, IntegratesPowersTimesPolynomials) {
  const ForceFamily family(GetParam());
  ForceOperators operators(family, ForceOperators::nodes_and_end(family));
  operators.require(2);
  operators.require(5); // the first two stay
  for (const int degree : {0, 1, highest_degree(GetParam())}) {
    const Vector forces = at_nodes(family, degree);
    const double a = GetParam().begin + degree;
    for (int k = 0; k < 5; ++k) {
      const Vector integrals = operators.term(k) * forces;
      for (int i = 0; i <= family.size(); ++i) {
        const double x = i < family.size() ? family.nodes()[i] : 1;
        // Terms cancel in the sum over the nodes, and in that of the binomial theorem.
        const double summed =
            operators.term(k).row(i).cwiseAbs().dot(forces.cwiseAbs()) +
            std::pow(2 * x, k) / std::tgamma(k + 1.0) * integral(0, a, GetParam().end, x);
        EXPECT_NEAR(integrals[i], integral(k, a, GetParam().end, x), 1e-13 * summed)
            << "degree " << degree << ", k = " << k << ", target " << i;
      }
    }
  }
}

// At the end the integral is a complete Beta function for every k.
TEST_P(ForceOperatorsOfShape, IntegratesToTheEnd) {
  const ForceFamily family(GetParam());
  ForceOperators operators(family, {1});
  operators.require(40);
  const int degree = std::min(2, highest_degree(GetParam()));
  const Vector forces = at_nodes(family, degree);
  for (int k = 0; k < 40; ++k) {
    const double expected =
        boost::math::beta(GetParam().begin + degree + 1, GetParam().end + k + 1) /
        std::tgamma(k + 1.0);
    EXPECT_NEAR((operators.term(k) * forces)[0], expected, 1e-13 * expected) << "k = " << k;
  }
}

TEST_P(ForceOperatorsOfShape, InterpolatesAtItsNodes) {
  const ForceFamily family(GetParam());
  for (int i = 0; i < family.size(); ++i) {
    const LongArray functions = family.functions(family.rule().nodes[i], family.rule().rest[i]);
    for (int j = 0; j < family.size(); ++j)
      EXPECT_NEAR(static_cast<double>(functions[j]), i == j ? 1 : 0, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ForceOperatorsOfShape,
    ::testing::Values(
        ForceShape{.begin = 1.5, .end = 1.5, .nodes = 8},
        ForceShape{.begin = 1.5, .end = 1.5, .nodes = 20},
        ForceShape{.begin = 2.2, .end = 2.2, .nodes = 12},
        ForceShape{.begin = 1.1, .end = 0, .nodes = 10},
        ForceShape{.begin = 0, .end = 3, .nodes = 8}, ForceShape{.begin = 0, .end = 0, .nodes = 8},
        ForceShape{.begin = 0.5, .end = 0, .nodes = 12, .begin_root = 2},
        ForceShape{.begin = 0.25, .end = 0.25, .nodes = 16, .begin_root = 4, .end_root = 4}));

TEST(ForceOperatorsTime, IsAPolynomialWithRootsAtItsEnds) {
  for (const auto &[p, q] : {std::pair(1, 1), std::pair(2, 1), std::pair(4, 4), std::pair(1, 3)}) {
    const EpisodeTime stretch(p, q);
    for (const long double xi : {1e-6L, 0.2L, 0.5L, 0.9L}) {
      const EpisodeTime::Point at = stretch.at(xi, 1 - xi);
      const auto expected = static_cast<double>(boost::math::ibeta(p, q, xi));
      EXPECT_NEAR(static_cast<double>(at.x) / expected, 1, 1e-14);
      EXPECT_NEAR(static_cast<double>(at.x + at.rest), 1, 1e-15);
      EXPECT_NEAR(static_cast<double>(at.begin * std::pow(xi, p)) / expected, 1, 1e-14);
      EXPECT_NEAR(static_cast<double>(stretch.inverse(at.x, at.rest) / xi), 1, 1e-12);
      const double slope =
          static_cast<double>(at.slope_factor * std::pow(xi, p - 1) * std::pow(1 - xi, q - 1));
      EXPECT_NEAR(slope / boost::math::ibeta_derivative(p, q, static_cast<double>(xi)), 1, 1e-12);
      EXPECT_LE(slope, stretch.steepest() * (1 + 1e-12));
    }
  }
}

// Weight x^2 (1 - x): the quotient x^3 (1 - x)^3 / w = x (1 - x)^2 has zeros at the ends only; with
// a factor (x - 1/2) it has one within.
TEST(ForceOperatorsFamily, ProvesForcesPositive) {
  const ForceFamily family({.begin = 2, .end = 1, .nodes = 6});
  const auto forces = [&](auto quotient) {
    Vector values(family.size());
    for (int j = 0; j < family.size(); ++j) {
      const double x = family.nodes()[j];
      values[j] = x * x * (1 - x) * quotient(x);
    }
    return values;
  };
  EXPECT_TRUE(family.is_positive(forces([](double x) { return 1 + x * (1 - x); }).data()));
  EXPECT_FALSE(family.is_positive(forces([](double x) { return x - 0.5; }).data()));
  EXPECT_FALSE(
      family.is_positive(forces([](double x) { return (x - 0.5) * (x - 0.5) - 1e-3; }).data()));
}

// The last polynomials of the family alone are its tail; a quotient of low degree has none.
TEST(ForceOperatorsFamily, MeasuresTheTail) {
  constexpr int nodes = 9;
  const ForceFamily family({.begin = 1.5, .end = 2.5, .nodes = nodes});
  const JacobiPolynomials polynomials(1.5, 2.5, nodes);
  Vector low(nodes);
  Vector high(nodes);
  for (int j = 0; j < nodes; ++j) {
    const LongArray p = polynomials.at(family.rule().nodes[j]);
    const double w = std::pow(family.nodes()[j], 1.5) * std::pow(1 - family.nodes()[j], 2.5);
    low[j] = w * static_cast<double>(p[0] + p[nodes - 3]);
    high[j] = w * static_cast<double>(2 * p[0] + 0.3L * p[nodes - 2] - 0.1L * p[nodes - 1]);
  }
  EXPECT_NEAR(family.tail(low.data()), 0, 1e-13);
  EXPECT_NEAR(family.tail(high.data()), 0.15, 1e-13);
}

} // namespace force_operators_tests
} // namespace vibroimpact::motion
