#include "algebraic.h"

#include "continuation/branch.h"

#include <gtest/gtest.h>

namespace vibroimpact::continuation {
namespace special_points_tests {

Settings within(double lower, double upper) {
  Settings settings;
  settings.first_key = {lower, upper};
  return settings;
}

// Fixed points a x^2 + (1 - b) x - 1 = 0 have a fold at a = -(1 - b)^2 / 4, and a flip at 3 (1 -
// b)^2 / 4.
TEST(SpecialPointsTest, OfTheHenonMap) {
  PowerOfMap map(henon_map, vector({1, 1, 1}));
  const double b = 0.3, a = 0.6;
  const double x = (-(1 - b) + std::sqrt((1 - b) * (1 - b) + 4 * a)) / (2 * a);
  const Branch branch =
      follow(map, {{vector({x, b * x}), vector({a})}, {}, false}, within(-1, 0.7));
  // Behind the fold x goes to infinity as a to zero.
  EXPECT_EQ(branch.end, End::far) << branch.reason;
  ASSERT_EQ(branch.special.size(), 2u);
  const SpecialPoint &flip = branch.special[0], &fold = branch.special[1];
  ASSERT_EQ(flip.kind, Special::flip);
  EXPECT_NEAR(flip.at.point.keys(0), 0.3675, 1e-14);
  EXPECT_EQ(flip.unstable_before, 1);
  EXPECT_EQ(flip.unstable_after, 0);
  // mu^2 + z mu - b = 0 with z = 2 a x = -(1 - b) + sqrt((1 - b)^2 + 4 a); at mu = -1: dmu = dz /
  // (z - 2)
  const double root = std::sqrt((1 - b) * (1 - b) + 4 * 0.3675), z = -(1 - b) + root;
  EXPECT_NEAR(flip.slope, 2 / root / (z - 2), 1e-8);
  // The eigenvector of -1 of [[-z, 1], [b, 0]] is (1, -b).
  EXPECT_NEAR(flip.vector(1, 0) / flip.vector(0, 0), -b, 1e-12);
  ASSERT_EQ(fold.kind, Special::fold);
  EXPECT_NEAR(fold.at.point.keys(0), -0.1225, 1e-14);
  EXPECT_NEAR(fold.at.point.state(0), 2 / (1 - b), 1e-9);
  // That of 1 is (1, b).
  EXPECT_NEAR(fold.vector(1, 0) / fold.vector(0, 0), b, 1e-9);
}

// mu^2 - mu + a - 1 = 0: |mu|^2 = a - 1, at a = 2 with mu = exp(i pi / 3).
TEST(SpecialPointsTest, OfTheDelayedLogisticMap) {
  PowerOfMap map(delayed_logistic_map, vector({1, 1, 1}));
  const double x = 1 - 1 / 1.5;
  const Branch branch = follow(map, {{vector({x, x}), vector({1.5})}, {}, true}, within(1.1, 2.4));
  ASSERT_EQ(branch.special.size(), 1u);
  const SpecialPoint &point = branch.special[0];
  ASSERT_EQ(point.kind, Special::neimark_sacker);
  EXPECT_NEAR(point.at.point.keys(0), 2, 1e-13);
  EXPECT_NEAR(point.at.point.state(0), 0.5, 1e-13);
  EXPECT_NEAR(point.angle, M_PI / 3, 1e-13);
  EXPECT_NEAR(point.slope, 0.5, 1e-8);
  EXPECT_EQ(point.unstable_after - point.unstable_before, 2);
  const double a = 2;
  Eigen::Matrix2cd jacobian;
  jacobian << 1, 1 - a, 1, 0;
  const Eigen::Vector2cd v(std::complex(point.vector(0, 0), point.vector(0, 1)),
                           std::complex(point.vector(1, 0), point.vector(1, 1)));
  EXPECT_LT((jacobian * v - std::polar(1.0, point.angle) * v).norm(), 1e-12);
}

// At the crossing of two branches the eigenvalue 1 has no turn of the key.
TEST(SpecialPointsTest, WhereBranchesCross) {
  PowerOfMap map(logistic_map, vector({1, 1}));
  for (const bool trivial : {true, false}) {
    const double x = trivial ? 0 : 1 - 1 / 0.8;
    const Branch branch = follow(map, {{vector({x}), vector({0.8})}, {}, true}, within(0.5, 2));
    EXPECT_EQ(branch.end, End::upper_bound);
    ASSERT_EQ(branch.special.size(), 1u);
    EXPECT_EQ(branch.special[0].kind, Special::branch_point);
    EXPECT_NEAR(branch.special[0].at.point.keys(0), 1, 1e-13);
    EXPECT_NEAR(branch.special[0].at.point.state(0), 0, 1e-13);
    EXPECT_NEAR(branch.points.back().point.state(0), trivial ? 0 : 0.5, 1e-13);
  }
}

// Branches x = 0 and p = x + 2 x^2 with y = sin x + p, in turned axes; the second one turns at x =
// -1/4.
TEST(SpecialPointsTest, AreFoldsBesideCrossings) {
  Algebraic problem(
      [](const Point &at) {
        const double c = std::cos(0.3), s = std::sin(0.3);
        const double x = c * at.state(0) - s * at.state(1), y = s * at.state(0) + c * at.state(1);
        const double p = at.keys(0);
        Matrix turn(2, 2), slope(2, 2);
        turn << c, -s, s, c;
        slope << p - 2 * x - 6 * x * x, 0, std::cos(x), -1;
        return Evaluation{vector({x * (p - x - 2 * x * x), std::sin(x) + p - y}),
                          slope * turn,
                          vector({x, 1}),
                          {}};
      },
      vector({1, 1, 1}));
  const auto at = [](double x, double p) {
    const double y = std::sin(x) + p, c = std::cos(0.3), s = std::sin(0.3);
    return Point{vector({c * x + s * y, -s * x + c * y}), vector({p})};
  };
  Settings settings = within(-1, 1.5);
  const Branch branch = follow(problem, {at(0.5, 1), {}, false}, settings);
  EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
  ASSERT_EQ(branch.special.size(), 2u);
  EXPECT_EQ(branch.special[0].kind, Special::branch_point);
  EXPECT_LT((branch.special[0].at.point.state - at(0, 0).state).norm(), 1e-12);
  EXPECT_NEAR(branch.special[0].at.point.keys(0), 0, 1e-12);
  EXPECT_EQ(branch.special[1].kind, Special::fold);
  EXPECT_NEAR(branch.special[1].at.point.keys(0), -0.125, 1e-14);
}

// On x^2 = p the key turns where x = 0 crosses: a crossing, no fold.
TEST(SpecialPointsTest, AreCrossingsWhereASideBranchTurns) {
  Algebraic problem(
      [](const Point &at) {
        const double x = at.state(0), p = at.keys(0);
        return scalar(x * (p - x * x), p - 3 * x * x, x);
      },
      vector({1, 1}));
  const Branch branch =
      follow(problem, {{vector({0.5}), vector({0.25})}, {}, false}, within(-1, 1));
  EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
  ASSERT_EQ(branch.special.size(), 1u);
  EXPECT_EQ(branch.special[0].kind, Special::branch_point);
  EXPECT_NEAR(branch.special[0].at.point.keys(0), 0, 1e-14);
  EXPECT_NEAR(branch.points.back().point.state(0), -1, 1e-14);
}

// Multipliers 2 and p: their product passes 1 at p = 1/2, where they are real.
TEST(SpecialPointsTest, AreNoNeutralSaddles) {
  PowerOfMap map(
      [](const Vector &x, const Vector &p) {
        Image image{vector({2 * x(0), p(0) * x(1)}), Matrix(2, 2), vector({0, x(1)})};
        image.by_state << 2, 0, 0, p(0);
        return image;
      },
      vector({1, 1, 1}));
  const Branch branch = follow(map, {{vector({0, 0}), vector({0.3})}, {}, true}, within(0.2, 0.9));
  EXPECT_EQ(branch.end, End::upper_bound);
  EXPECT_TRUE(branch.special.empty()) << name_of(branch.special[0].kind);
}

// The multiplier -1 - d + (p - 0.013)^2 is below -1 for 2 sqrt d = 0.04, less than half a step.
TEST(SpecialPointsTest, ComeInPairsWithinAStep) {
  constexpr double d = 4e-4, middle = 0.013;
  PowerOfMap map(
      [](const Vector &x, const Vector &p) {
        const double mu = -1 - d + (p(0) - middle) * (p(0) - middle);
        return Image{vector({mu * x(0)}), vector({mu}), vector({2 * (p(0) - middle) * x(0)})};
      },
      vector({1, 1}));
  for (const double start : {-0.9, -0.93, -0.96}) {
    const Branch branch = follow(map, {{vector({0}), vector({start})}, {}, true}, within(-1, 1));
    ASSERT_EQ(branch.special.size(), 2u) << start;
    EXPECT_NEAR(branch.special[0].at.point.keys(0), middle - 0.02, 1e-13);
    EXPECT_NEAR(branch.special[1].at.point.keys(0), middle + 0.02, 1e-13);
  }
}

// Errors of 1e-10 that differ from evaluation to evaluation, as an integration makes them, end
// Newton's method.
TEST(SpecialPointsTest, AreFoundWithNoise) {
  unsigned random = 1;
  Algebraic problem(
      [&](const Point &at) {
        random = 1664525 * random + 1013904223;
        const double x = at.state(0), p = at.keys(0), error = 1e-10 * (random / 4294967296.0 - 0.5);
        return scalar(x * x + p * p - 1 + error, 2 * x, 2 * p);
      },
      vector({1, 1}));
  const Branch branch = follow(problem, {{vector({-1}), vector({0})}, {}, true}, Settings());
  EXPECT_EQ(branch.end, End::closed) << branch.reason;
  ASSERT_EQ(branch.special.size(), 2u);
  EXPECT_NEAR(branch.special[0].at.point.keys(0), 1, 1e-10);
  EXPECT_NEAR(branch.special[1].at.point.keys(0), -1, 1e-10);
}

// A pair of modulus sqrt 2 that becomes complex is no Neimark-Sacker point: mu^2 - 2 c mu + 2 = 0,
// complex where c < sqrt 2.
TEST(SpecialPointsTest, AreNoPairsThatBecomeComplex) {
  PowerOfMap map(
      [](const Vector &x, const Vector &c) {
        Image image{vector({2 * c(0) * x(0) - 2 * x(1), x(0)}), Matrix(2, 2),
                    vector({2 * x(0), 0})};
        image.by_state << 2 * c(0), -2, 1, 0;
        return image;
      },
      vector({1, 1, 1}));
  const Branch branch = follow(map, {{vector({0, 0}), vector({1.3})}, {}, true}, within(1.3, 1.48));
  EXPECT_EQ(branch.end, End::upper_bound);
  EXPECT_TRUE(branch.special.empty());
  EXPECT_NE(branch.points.front().multipliers[0].imag(), 0);
  EXPECT_EQ(branch.points.back().multipliers[0].imag(), 0);
}

// A pair that passes the unit circle and becomes real within one step: det J = p, tr J = 2 sqrt
// 0.99.
TEST(SpecialPointsTest, AreFoundBesidePairsThatBecomeReal) {
  PowerOfMap map(
      [](const Vector &x, const Vector &p) {
        Image image{vector({2 * std::sqrt(0.99) * x(0) - p(0) * x(1), x(0)}), Matrix(2, 2),
                    vector({-x(1), 0})};
        image.by_state << 2 * std::sqrt(0.99), -p(0), 1, 0;
        return image;
      },
      vector({1, 1, 1}));
  Settings settings = within(0.9, 1.2);
  settings.first_step = 0.1;
  const Branch branch = follow(map, {{vector({0, 0}), vector({1.05})}, {}, false}, settings);
  ASSERT_FALSE(branch.special.empty());
  EXPECT_EQ(branch.special[0].kind, Special::neimark_sacker);
  EXPECT_NEAR(branch.special[0].at.point.keys(0), 1, 1e-13);
}

// 24 coordinates: rotations by fixed angles, shrunk by 0.99, and one multiplier p - 1.
TEST(SpecialPointsTest, OfManyCoordinates) {
  constexpr Index n = 25;
  Matrix linear = Matrix::Zero(n, n);
  for (Index i = 0; i + 1 < n; i += 2) {
    const double angle = 0.1 * static_cast<double>(i + 1);
    linear.block(i, i, 2, 2) << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  }
  linear *= 0.99;
  PowerOfMap map(
      [&](const Vector &x, const Vector &p) {
        Image image{linear * x, linear, Matrix::Zero(n, 1)};
        image.value(n - 1) = (p(0) - 1) * x(n - 1) + 1;
        image.by_state(n - 1, n - 1) = p(0) - 1;
        image.by_keys(n - 1, 0) = x(n - 1);
        return image;
      },
      Vector::Ones(n + 1));
  Vector start = Vector::Zero(n);
  start(n - 1) = 1 / (2 - 0.5);
  const Branch branch = follow(map, {{start, vector({0.5})}, {}, false}, within(-0.5, 1));
  ASSERT_EQ(branch.special.size(), 1u);
  EXPECT_EQ(branch.special[0].kind, Special::flip);
  EXPECT_NEAR(branch.special[0].at.point.keys(0), 0, 1e-13);
  EXPECT_NEAR(branch.special[0].slope, 1, 1e-9);
}

// Flips of the logistic map: r = 3, 1 + sqrt 6 and 3.5440903595519228536 (OEIS A086181), each found
// on the branch that begins at the one before.
TEST(SpecialPointsTest, BeginBranchesOfTwiceTheMultiple) {
  auto problem =
      std::unique_ptr<Problem>(std::make_unique<PowerOfMap>(logistic_map, vector({1, 1})));
  Start start{{vector({0.6}), vector({2.5})}, {}, true};
  for (const double expected : {3.0, 1 + std::sqrt(6.0), 3.5440903595519228536}) {
    const Branch branch = follow(*problem, start, within(2, 3.6));
    EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
    ASSERT_EQ(branch.special.size(), 1u);
    ASSERT_EQ(branch.special[0].kind, Special::flip);
    EXPECT_NEAR(branch.special[0].at.point.keys(0), expected, 2e-14);
    problem = problem->doubled();
    start = branch_from(*problem, branch.special[0], within(2, 3.6));
    EXPECT_NEAR(start.point.state(0), branch.special[0].at.point.state(0), 2e-3);
  }
}

// The other way the branch ends where it began, and does not run on along solutions of half the
// multiple.
TEST(SpecialPointsTest, EndBranchesAtTheFlipOfTheLowerMultiple) {
  PowerOfMap twice(logistic_map, vector({1, 1}), 2);
  const double r = 3.3;
  const double x = (r + 1 + std::sqrt((r - 3) * (r + 1))) / (2 * r);
  const Branch branch = follow(twice, {{vector({x}), vector({r})}, {}, false}, within(2, 3.4));
  EXPECT_EQ(branch.end, End::shorter_return) << branch.reason;
  EXPECT_NE(branch.reason.find("multiple 1"), std::string::npos);
  EXPECT_NEAR(branch.points.back().point.keys(0), 3, 1e-13);
  EXPECT_NEAR(branch.points.back().point.state(0), 2.0 / 3, 1e-13);
  EXPECT_TRUE(branch.special.empty());
}

} // namespace special_points_tests
} // namespace vibroimpact::continuation
