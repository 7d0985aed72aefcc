// Basins of maps whose attractors and boundaries are known in closed form.
#include "periodic/attractors.h"
#include "common/decompositions.h"
#include "periodic/interpolated_map.h"

#include "common/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::periodic {
namespace attractors_tests {

// x' = x (3 - x^2) / 2, y' = 0.3 y: the sign of x decides between (1, 0) and (-1, 0) as long as
// x^2 < 3. The derivative at both is diag(0, 0.3), at (0, 0) diag(1.5, 0.3).
Vector double_well(const Vector &z) {
  return Eigen::Vector2d(z[0] * (3 - z[0] * z[0]) / 2, 0.3 * z[1]);
}
Matrix slope_of_double_well(const Vector &z) {
  return Eigen::Vector2d(1.5 * (1 - z[0] * z[0]), 0.3).asDiagonal();
}

// Henon's map with b = 0.3, whose motion of period 2 is stable for 0.3675 < a < 0.9125.
struct Henon {
  double a = 0.8, b = 0.3;

  Vector operator()(const Vector &z) const {
    return Eigen::Vector2d(1 - a * z[0] * z[0] + z[1], b * z[0]);
  }
  Matrix slope(const Vector &z) const {
    Matrix slope(2, 2);
    slope << -2 * a * z[0], 1, b, 0;
    return slope;
  }
};

// Newton's method for fixed points of the power of a map.
Attractors::Newton newton_of(const StateMap &map,
                             const std::function<Matrix(const Vector &)> &slope,
                             long *calls = nullptr) {
  return [=](const Vector &start, long multiple) -> std::optional<FoundMotion> {
    if (calls)
      ++*calls;
    Vector state = start;
    Matrix product;
    for (int iteration = 0; iteration < 20; ++iteration) {
      Vector image = state;
      product = Matrix::Identity(2, 2);
      for (long k = 0; k < multiple; ++k) {
        product = (slope(image) * product).eval();
        image = map(image);
      }
      state += LuFactors<Matrix>(Matrix::Identity(2, 2) - product).solve(Vector(image - state));
    }
    return FoundMotion{.state = state, .multiple = multiple, .by_state = product};
  };
}

TEST(AttractorsTest, SolutionOfTheDiscreteLyapunovEquation) {
  Matrix a(3, 3); // a defective double eigenvalue of 0.95
  a << 0.95, 1, 0, 0, 0.95, 0, 0.2, 0, -0.4;
  const Matrix s = discrete_lyapunov(a);
  EXPECT_LT((s - Matrix::Identity(3, 3) - a.transpose() * s * a).norm(), 1e-13 * s.norm());
  EXPECT_LT((s - s.transpose()).norm(), 1e-14 * s.norm());
}

// A defective linear map contracts everywhere, though not in the length of the states.
TEST(AttractorsTest, TheBallOfALinearMapIsAsLargeAsAskedFor) {
  Matrix a(2, 2);
  a << 0.9, 5, 0, 0.9;
  EXPECT_GT((a * Vector::Unit(2, 1)).norm(), 1);
  const TrappingBall ball([&](const Vector &z) -> Vector { return a * z; }, Vector::Zero(2), a,
                          100);
  for (const Vector &state : {Vector(70 * Vector::Unit(2, 0)), Vector(-70 * Vector::Unit(2, 1))})
    EXPECT_TRUE(ball.contains(state));
}

// The map goes away from where it contracts: |x'| < |x| only for |x| < 1.
TEST(AttractorsTest, TheBallEndsWhereTheMapDoesNotContract) {
  const auto cube = [](const Vector &z) -> Vector {
    return Eigen::Vector2d(std::pow(z[0], 3), 0.5 * z[1]);
  };
  const Matrix slope = Eigen::Vector2d(0, 0.5).asDiagonal();
  const TrappingBall ball(cube, Vector::Zero(2), slope, 100);
  // S = diag(1, 1 / (1 - (0.5 / 0.75)^2)): x^3 <= 0.85 x on the axis.
  EXPECT_LT(ball.radius(), 0.8 * std::sqrt(0.85) + 1e-12);
  EXPECT_GT(ball.radius(), 0.8 * std::sqrt(0.85) / 1.15);
  EXPECT_TRUE(ball.contains(Eigen::Vector2d(0.6, 0)));
  EXPECT_FALSE(ball.contains(Eigen::Vector2d(0.6, 1)));
}

TEST(AttractorsTest, StatesWithoutAMotionLieOutsideOfTheBall) {
  const auto half = [](const Vector &z) -> Vector {
    if (z[0] > 0.25)
      throw NumericalError("no motion starts here");
    return 0.5 * z;
  };
  const TrappingBall ball(half, Vector::Zero(2), 0.5 * Matrix::Identity(2, 2), 100);
  const double size = std::sqrt(1 / (1 - std::pow(0.5 / 0.75, 2))); // |x| of x = (1, 0)
  EXPECT_LT(ball.radius(), 0.8 * 0.25 * size);
  EXPECT_GT(ball.radius(), 0.8 * 0.25 * size / 1.16);
}

TEST(AttractorsTest, AnUnstablePointHasNone) {
  EXPECT_THROW(TrappingBall(double_well, Vector::Zero(2), slope_of_double_well(Vector::Zero(2)), 1),
               std::logic_error);
}

TEST(AttractorsTest, EveryCellOfTheDoubleWell) {
  long calls = 0;
  Attractors attractors(double_well, newton_of(double_well, slope_of_double_well, &calls),
                        {.most_periods = 200, .largest = 4});
  long wrong = 0, cells = 0, periods = 0;
  for (int i = 0; i < 80; ++i)
    for (int j = 0; j < 80; ++j) {
      const Vector start = Eigen::Vector2d(-1.7 + 3.4 * (i + 0.5) / 80, -2 + 4 * (j + 0.5) / 80);
      const Decision decision = attractors.follow(start);
      ASSERT_EQ(decision.outcome, Outcome::decided);
      const Vector end = attractors.list()[decision.attractor].motion.state;
      wrong += (end[0] > 0) == (start[0] > 0) ? 0 : 1;
      ++cells;
      periods += decision.periods;
    }
  EXPECT_EQ(wrong, 0);
  ASSERT_EQ(attractors.list().size(), 2u);
  for (const Attractor &attractor : attractors.list()) {
    EXPECT_NEAR(std::abs(attractor.motion.state[0]), 1, 1e-12);
    EXPECT_EQ(attractor.motion.multiple, 1);
  }
  EXPECT_LE(calls, 2);
  EXPECT_LT(periods, 4 * cells); // without balls every cell would take ten
}

// The two states of period 2 solve a^2 x^2 - a (1 - b) x + (1 - b)^2 - a = 0.
TEST(AttractorsTest, AMotionOfTwoPeriods) {
  const Henon henon;
  Attractors attractors(henon, newton_of(henon, [&](const Vector &z) { return henon.slope(z); }),
                        {.most_periods = 300, .largest = 2});
  const Decision decision = attractors.follow(Eigen::Vector2d(0.1, 0.05));
  ASSERT_EQ(decision.outcome, Outcome::decided);
  const Attractor &found = attractors.list().at(decision.attractor);
  ASSERT_EQ(found.states.size(), 2u);
  for (const Vector &state : found.states)
    EXPECT_NEAR(0.64 * state[0] * state[0] - 0.8 * 0.7 * state[0] + 0.49 - 0.8, 0, 1e-12);
  // Their product of derivatives: determinant b^2, trace 4 a^2 x1 x2 + 2 b.
  const double trace = 4 * 0.64 * (0.49 - 0.8) / 0.64 + 0.6;
  EXPECT_NEAR(found.multipliers.sum().real(), trace, 1e-10);
  EXPECT_NEAR(std::abs(found.multipliers.prod()), 0.09, 1e-10);
  // The same from elsewhere, in either phase.
  for (const double x : {-0.5, 0.0, 0.7})
    EXPECT_EQ(attractors.follow(Eigen::Vector2d(x, 0)).outcome, Outcome::decided);
  EXPECT_EQ(attractors.list().size(), 1u);
}

// Beyond the basin Henon's map goes to infinity; a chaotic motion never repeats.
TEST(AttractorsTest, MotionsThatSettleToNothing) {
  const Henon henon;
  Attractors escaping(henon, newton_of(henon, [&](const Vector &z) { return henon.slope(z); }),
                      {.largest = 2});
  EXPECT_EQ(escaping.follow(Eigen::Vector2d(3, 3)).outcome, Outcome::failed);
  const Henon strange{.a = 1.4};
  Attractors chaotic(strange, newton_of(strange, [&](const Vector &z) { return strange.slope(z); }),
                     {.most_periods = 2000, .largest = 2});
  const Decision decision = chaotic.follow(Eigen::Vector2d(0.1, 0.1));
  EXPECT_EQ(decision.outcome, Outcome::undecided);
  EXPECT_EQ(decision.periods, 2000);
  EXPECT_TRUE(chaotic.list().empty());
}

// Fourth order, at the rim too.
TEST(AttractorsTest, OrderOfTheInterpolatedMap) {
  const auto smooth = [](const Vector &z) -> Vector {
    return Eigen::Vector2d(std::sin(z[0]) * std::cos(2 * z[1]), std::exp(0.3 * z[0] - z[1]));
  };
  const auto error = [&](Index nodes) {
    const NodeAxis axis{.first = -1, .last = 1, .count = nodes};
    const InterpolatedMap map(smooth, {axis, axis});
    double largest = 0;
    for (int i = 0; i <= 50; ++i)
      for (int j = 0; j <= 50; ++j) {
        const Vector z = Eigen::Vector2d(-1 + 0.04 * i, -1 + 0.04 * j);
        largest = std::max(largest, (map(z).value() - smooth(z)).cwiseAbs().maxCoeff());
      }
    return largest;
  };
  EXPECT_NEAR(std::log2(error(33) / error(65)), 4, 0.3);
}

TEST(AttractorsTest, WhereTheInterpolatedMapHasNoImage) {
  const auto half = [](const Vector &z) -> Vector {
    if (z[0] > 0.5)
      throw NumericalError("no motion starts here");
    return 0.5 * z;
  };
  const NodeAxis axis{.first = -1, .last = 1, .count = 21};
  const InterpolatedMap map(half, {axis, axis});
  EXPECT_FALSE(map(Eigen::Vector2d(1.01, 0)));
  EXPECT_FALSE(map(Eigen::Vector2d(0, -1.01)));
  EXPECT_FALSE(map(Eigen::Vector2d(0.48, 0)));
  EXPECT_TRUE(map(Eigen::Vector2d(0.3, 1)));
  EXPECT_NEAR((*map(Eigen::Vector2d(-0.33, 0.77)))[1], 0.385, 1e-15);
}

} // namespace attractors_tests
} // namespace vibroimpact::periodic
