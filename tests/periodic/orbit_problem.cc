// Periodic motions as a continuation problem: derivatives of the residual and of the change of the
// section phase, by differences; lower multiples.
#include "periodic/orbit_problem.h"

#include "family.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace orbit_problem_tests {

using continuation::Point;
using testing::Family;
using testing::isolator;
using testing::Oscillator;
using testing::vector_of;

Oscillator isolator_of(double lambda) { return isolator(lambda); }

constexpr double lambda = 1.3002392653669812;
const Point some_point{
    .state = vector_of({-0.3, -1.5}), .keys = Vector::Constant(1, lambda), .chart = 0.13};

Point moved(const Point &point, Index entry, double by) {
  Point other = point;
  (entry < point.state.size() ? other.state[entry] : other.keys[0]) += by;
  return other;
}

// Columns of d(state)/d(state and key) by differences of order 4.
template <class Function> Matrix differences(const Point &point, Function function) {
  const double h = 1e-3;
  Matrix matrix(point.state.size(), point.state.size() + 1);
  for (Index j = 0; j < matrix.cols(); ++j) {
    const auto at = [&](double by) -> Vector { return function(moved(point, j, by)); };
    matrix.col(j) = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
  }
  return matrix;
}

void expect_columns(const Matrix &by_state, const Matrix &by_keys, const Matrix &expected) {
  Matrix exact(by_state.rows(), by_state.cols() + 1);
  exact << by_state, by_keys;
  EXPECT_LT((exact - expected).norm(), 1e-7 * expected.norm()) << exact << "\n" << expected;
}

TEST(OrbitProblemTest, DerivativesOfTheResidual) {
  Family family(isolator_of);
  for (const long halves : {1, 2, 3}) {
    OrbitProblem problem(family, halves, Vector::Ones(3));
    const continuation::Evaluation exact = problem.evaluate(some_point);
    expect_columns(exact.by_state, exact.by_keys, differences(some_point, [&](const Point &at) {
                     return problem.evaluate(at).residual;
                   }));
  }
}

TEST(OrbitProblemTest, DerivativesOfTheChangeOfPhase) {
  Family family(isolator_of);
  OrbitProblem problem(family, 2, Vector::Ones(3));
  for (const double chart : {0.4, 0.05}) {
    const continuation::Transfer exact = problem.transfer(some_point, chart);
    EXPECT_EQ(exact.point.chart, chart);
    expect_columns(exact.by_state, exact.by_keys, differences(some_point, [&](const Point &at) {
                     return problem.transfer(at, chart).point.state;
                   }));
  }
}

// Round the period once, in two parts.
TEST(OrbitProblemTest, PhasesComeRound) {
  Family family(isolator_of);
  OrbitProblem problem(family, 2, Vector::Ones(3));
  const Point there = problem.transfer(some_point, 0.7).point;
  const Point back = problem.transfer(there, some_point.chart).point;
  const Vector image = problem.evaluate(some_point).residual + some_point.state;
  EXPECT_LT((back.state - image).norm(), 1e-11);
}

TEST(OrbitProblemTest, LowerMultiples) {
  Family family(isolator_of);
  const Orbit orbit = find_orbit(family.at(lambda), 1, vector_of({-0.41, -1.68}));
  const Point point{.state = orbit.point.state,
                    .keys = Vector::Constant(1, lambda),
                    .chart = orbit.section.phase};
  OrbitProblem problem(family, 6, Vector::Ones(3));
  const std::vector<continuation::ShorterReturn> returns = problem.shorter_returns(point);
  ASSERT_EQ(returns.size(), 3u);
  for (const continuation::ShorterReturn &shorter : returns)
    EXPECT_LT(shorter.displacement.norm(), 1e-9) << shorter.multiple;
  EXPECT_EQ(returns[0].multiple, 1);
  EXPECT_EQ(returns[1].multiple, 2);
  EXPECT_EQ(returns[2].multiple, 3);
}

TEST(OrbitProblemTest, BestPhaseIsAwayFromContactChanges) {
  Family family(isolator_of);
  const Orbit orbit = find_orbit(family.at(lambda), 1, vector_of({-0.41, -1.68}));
  OrbitProblem problem(family, 2, Vector::Ones(3));
  Point point{.state = orbit.point.state,
              .keys = Vector::Constant(1, lambda),
              .chart = orbit.section.phase};
  const double event = orbit.point.image.pattern.events[0].time / family.at(lambda).period();
  point = problem.transfer(point, std::fmod(point.chart + event + 0.01, 1.0)).point;
  EXPECT_LT(problem.evaluate(point).chart_margin, 0.011);
  const Point best = problem.transfer(point, problem.best_chart(point)).point;
  EXPECT_GT(problem.evaluate(best).chart_margin, 0.08);
}

} // namespace orbit_problem_tests
} // namespace vibroimpact::periodic
