#include "algebraic.h"

#include "common/signals.h"
#include "continuation/branch.h"
#include "continuation/scaled_problem.h"

#include <gtest/gtest.h>

namespace vibroimpact::continuation {
namespace branch_tests {

Algebraic circle(double state_radius, double key_middle, double key_radius) {
  return {[=](const Point &at) {
            const double x = at.state(0) / state_radius, p = (at.keys(0) - key_middle) / key_radius;
            return scalar(state_radius * (x * x + p * p - 1), 2 * x,
                          2 * p * state_radius / key_radius);
          },
          vector({state_radius, key_radius})};
}

std::vector<SpecialPoint> of_kind(const Branch &branch, Special kind) {
  std::vector<SpecialPoint> found;
  for (const SpecialPoint &point : branch.special)
    if (point.kind == kind)
      found.push_back(point);
  return found;
}

TEST(BranchTest, OfACircleClosesAndTurnsTwice) {
  Algebraic problem = circle(1, 0, 1);
  Settings settings;
  const Branch branch = follow(problem, {{vector({-1}), vector({0})}, {}, true}, settings);
  EXPECT_EQ(branch.end, End::closed) << branch.reason;
  ASSERT_EQ(branch.special.size(), 2u);
  EXPECT_EQ(branch.special[0].kind, Special::fold);
  EXPECT_NEAR(branch.special[0].at.point.keys(0), 1, 1e-14);
  EXPECT_NEAR(branch.special[1].at.point.keys(0), -1, 1e-14);
  EXPECT_NEAR(branch.special[0].at.point.state(0), 0, 1e-12);
  EXPECT_NEAR(branch.special[1].at.point.state(0), 0, 1e-12);
  for (const BranchPoint &point : branch.points)
    EXPECT_NEAR(point.point.state.norm() * point.point.state.norm() +
                    point.point.keys(0) * point.point.keys(0),
                1, 1e-14);
  // Three evaluations a point, a dozen for each fold, and steps that are refused.
  EXPECT_LT(problem.evaluations, 7 * static_cast<int>(branch.points.size()));
  // The end repeats the start; chords of angle 0.1 are shorter than their arcs by a factor 1 -
  // 0.1^2 / 24.
  EXPECT_NEAR(branch.points.back().point.state(0), -1, 1e-15);
  EXPECT_NEAR(branch.points.back().arclength, 2 * M_PI, 2 * M_PI * 1e-2 / 24);
}

// An isolated loop a thousandth of a metre high over seven rad/s around fifty.
TEST(BranchTest, DoesNotDependOnUnits) {
  Algebraic plain = circle(1, 0, 1), scaled = circle(1e-3, 50, 7);
  Settings settings;
  const Branch a = follow(plain, {{vector({-1}), vector({0})}, {}, false}, settings);
  const Branch b = follow(scaled, {{vector({-1e-3}), vector({50})}, {}, false}, settings);
  EXPECT_EQ(b.end, End::closed) << b.reason;
  ASSERT_EQ(b.special.size(), 2u);
  EXPECT_NEAR(b.special[0].at.point.keys(0), 43, 1e-12);
  EXPECT_NEAR(b.special[1].at.point.keys(0), 57, 1e-12);
  EXPECT_NEAR(static_cast<double>(a.points.size()), static_cast<double>(b.points.size()), 2);
}

// The tangent turns by most of pi within 0.04 at the ends of an ellipse.
TEST(BranchTest, TurnsLittleWithinAStep) {
  Algebraic ellipse(
      [](const Point &at) {
        const double x = 50 * at.state(0), p = at.keys(0);
        return scalar(x * x + p * p - 1, 100 * x, 2 * p);
      },
      vector({1, 1}));
  const Branch branch = follow(ellipse, {{vector({0.02}), vector({0})}, {}, true}, Settings());
  EXPECT_EQ(branch.end, End::closed) << branch.reason;
  EXPECT_EQ(of_kind(branch, Special::fold).size(), 2u);
  for (std::size_t i = 1; i < branch.points.size(); ++i)
    EXPECT_GE(branch.points[i].tangent.dot(branch.points[i - 1].tangent), std::cos(0.25));
}

TEST(BranchTest, EndsAtBoundsExactly) {
  Algebraic parabola(
      [](const Point &at) {
        return scalar(at.state(0) - at.keys(0) * at.keys(0), 1, -2 * at.keys(0));
      },
      vector({1, 1}));
  Settings settings;
  settings.first_key = {-0.7, 1.3};
  const Start up{{vector({0.01}), vector({0.1})}, {}, true};
  const Start down{{vector({0.01}), vector({0.1})}, {}, false};
  const Branch right = follow(parabola, up, settings), left = follow(parabola, down, settings);
  EXPECT_EQ(right.end, End::upper_bound);
  EXPECT_DOUBLE_EQ(right.points.back().point.keys(0), 1.3);
  EXPECT_NEAR(right.points.back().point.state(0), 1.69, 1e-14);
  EXPECT_EQ(left.end, End::lower_bound);
  EXPECT_DOUBLE_EQ(left.points.back().point.keys(0), -0.7);
  EXPECT_NE(left.reason.find("lower bound"), std::string::npos);
  settings.first_key = {0.2, 1.3};
  EXPECT_EQ(follow(parabola, up, settings).points.size(), 1u) << "the start is outside";
}

// Beyond the bounds there are no values, and rounding there is none of the bounds either.
TEST(BranchTest, EndsAtBoundsBehindWhichThereIsNothing) {
  Settings settings;
  settings.first_key = {0.3, 1};
  Algebraic root(
      [](const Point &at) {
        if (at.keys(0) < 0.3 || at.keys(0) > 1)
          throw NumericalError("nothing beyond");
        return scalar(at.state(0) * at.state(0) - at.keys(0), 2 * at.state(0), -1);
      },
      vector({1, 1}));
  for (const bool forward : {true, false}) {
    const Branch branch = follow(root, {{vector({0.8}), vector({0.64})}, {}, forward}, settings);
    EXPECT_EQ(branch.end, forward ? End::upper_bound : End::lower_bound) << branch.reason;
    const Point &last = branch.points.back().point;
    EXPECT_EQ(last.keys(0), forward ? 1 : 0.3);
    EXPECT_NEAR(last.state(0), std::sqrt(last.keys(0)), 1e-14);
    EXPECT_LT(branch.points.size(), 20u);
  }
}

// p = x^3 - 3 a^2 x turns at -a and a; steps of 0.1 would see two tangents next to parallel.
TEST(BranchTest, FindsTwoTurnsWithinOneStep) {
  constexpr double a = 0.02;
  Algebraic cubic(
      [](const Point &at) {
        const double x = at.state(0);
        return scalar(x * x * x - 3 * a * a * x - at.keys(0), 3 * x * x - 3 * a * a, -1);
      },
      vector({1, 1}));
  Settings settings;
  settings.first_key = {-1, 1};
  for (const double start : {-0.9, -0.93, -0.96}) {
    const double p = start * start * start - 3 * a * a * start;
    const Branch branch = follow(cubic, {{vector({start}), vector({p})}, {}, true}, settings);
    EXPECT_EQ(branch.end, End::upper_bound);
    const auto folds = of_kind(branch, Special::fold);
    ASSERT_EQ(folds.size(), 2u) << "from " << start;
    EXPECT_NEAR(folds[0].at.point.state(0), -a, 1e-11);
    EXPECT_NEAR(folds[0].at.point.keys(0), 2 * a * a * a, 1e-16);
    EXPECT_NEAR(folds[1].at.point.keys(0), -2 * a * a * a, 1e-16);
  }
}

TEST(BranchTest, EndsWhereItHasNoValuesAnyMore) {
  Algebraic cut(
      [](const Point &at) {
        if (at.keys(0) > 0.5)
          throw NumericalError("nothing beyond a half");
        return scalar(at.state(0) - at.keys(0), 1, -1);
      },
      vector({1, 1}));
  const Branch branch = follow(cut, {{vector({0}), vector({0})}, {}, true}, Settings());
  EXPECT_EQ(branch.end, End::least_step);
  EXPECT_EQ(branch.reason, "steps fall below 1e-09: nothing beyond a half");
  EXPECT_NEAR(branch.points.back().point.keys(0), 0.5, 4e-9);
}

TEST(BranchTest, EndsAfterTheMostPoints) {
  Algebraic line([](const Point &at) { return scalar(at.state(0) - at.keys(0), 1, -1); },
                 vector({1, 1}));
  Settings settings;
  settings.most_points = 17;
  const Branch branch = follow(line, {{vector({0}), vector({0})}, {}, true}, settings);
  EXPECT_EQ(branch.end, End::most_points);
  EXPECT_EQ(branch.points.size(), 17u);
}

TEST(BranchTest, ReportsEveryPointAndCanBeInterrupted) {
  Algebraic problem = circle(1, 0, 1);
  std::size_t points = 0, special = 0;
  CurveListener<Branch> listener{[&](const BranchPoint &) { ++points; },
                                 [&](const SpecialPoint &) { ++special; }};
  const Start start{{vector({-1}), vector({0})}, {}, true};
  const Branch branch = follow(problem, start, Settings(), listener);
  EXPECT_EQ(points, branch.points.size());
  EXPECT_EQ(special, branch.special.size());
  listener.point = [&](const BranchPoint &) { throw Interrupted(); };
  EXPECT_THROW(follow(problem, start, Settings(), listener), Interrupted);
}

// The circle x^2 + p^2 = 1 with y = 0, in axes that are turned by the chart; a chart has no
// values where the key is close to it, whole numbers apart.
class TurnedAxes : public Problem {
public:
  Vector scales() const override { return vector({1, 1, 1}); }
  bool is_map() const override { return false; }
  Evaluation evaluate(const Point &at) override {
    const double p = at.keys(0), margin = std::abs(std::remainder(p - at.chart, 1));
    if (margin < 0.01)
      throw NumericalError("the chart ends here");
    const Matrix turn = axes(at.chart);
    const Vector x = turn * at.state;
    Matrix slope(2, 2);
    slope << 2 * x(0), 0, 0, 1;
    return {turn.transpose() * vector({x(0) * x(0) + p * p - 1, x(1)}),
            turn.transpose() * slope * turn,
            turn.transpose() * vector({2 * p, 0}),
            {},
            margin};
  }
  double best_chart(const Point &at) override {
    ++moves;
    return at.keys(0) + 0.5;
  }
  Transfer transfer(const Point &at, double chart) override {
    const Matrix turn = axes(chart).transpose() * axes(at.chart);
    return {{turn * at.state, at.keys, chart}, turn, Matrix::Zero(2, 1)};
  }
  // Neighbouring charts, 0.5 apart, have axes that point against each other.
  static Matrix axes(double chart) {
    const double angle = 6 * chart;
    Matrix turn(2, 2);
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return turn;
  }
  int moves = 0;
};

TEST(BranchTest, ChangesChartsAndClosesInTheFirst) {
  TurnedAxes problem;
  const double chart = 0.3;
  const Vector start = TurnedAxes::axes(chart).transpose() * vector({-1, 0});
  const Branch branch = follow(problem, {{start, vector({0}), chart}, {}, true}, Settings());
  EXPECT_EQ(branch.end, End::closed) << branch.reason;
  EXPECT_GE(problem.moves, 3);
  ASSERT_EQ(branch.special.size(), 2u);
  EXPECT_NEAR(branch.special[0].at.point.keys(0), 1, 1e-14);
  EXPECT_NEAR(branch.special[1].at.point.keys(0), -1, 1e-14);
  for (const BranchPoint &point : branch.points)
    EXPECT_NEAR(point.point.state.squaredNorm() + std::pow(point.point.keys(0), 2), 1, 1e-13);
}

// x' = 3 x + 7 p: scales 5 and 2, so that u' = (5 * 3 x, 7 * 2 p) / 5 in units of u.
TEST(BranchTest, TakesTangentsToOtherCharts) {
  class Sheared : public Algebraic {
  public:
    Sheared()
        : Algebraic([](const Point &at) { return scalar(at.state(0), 1, 0); }, vector({5, 2})) {}
    Transfer transfer(const Point &at, double chart) override {
      return {
          {vector({3 * at.state(0) + 7 * at.keys(0)}), at.keys, chart}, vector({3}), vector({7})};
    }
  } problem;
  const ScaledProblem scaled(problem, {vector({0}), vector({0})});
  Matrix tangents(2, 2);
  tangents << 1, 0.5, 0, -0.25;
  const Vector u = scaled.transfer(vector({0.1, 0.3}), 0, 1, tangents);
  EXPECT_NEAR(u(0), 0.3 + 14 * 0.3 / 5, 1e-15);
  EXPECT_NEAR(u(1), 0.3, 1e-15);
  EXPECT_NEAR(tangents(0, 0), 3, 1e-15);
  EXPECT_NEAR(tangents(1, 0), 0, 1e-15);
  EXPECT_NEAR(tangents(0, 1), 1.5 - 14 * 0.25 / 5, 1e-15);
  EXPECT_NEAR(tangents(1, 1), -0.25, 1e-15);
}

TEST(BranchTest, IsSolvedFromAGuessAtAFixedKey) {
  Algebraic problem = circle(1, 0, 1);
  const BranchPoint point = solve(problem, {vector({8}), vector({0.6})}, Settings());
  EXPECT_NEAR(point.point.state(0), 0.8, 1e-14);
  EXPECT_DOUBLE_EQ(point.point.keys(0), 0.6);
  EXPECT_THROW(solve(problem, {vector({8}), vector({1.6})}, Settings()), NumericalError);
  // Whole corrections from beyond 1.39 go further and further away.
  Algebraic flat(
      [](const Point &at) {
        const double x = at.state(0);
        return scalar(std::atan(x) - at.keys(0), 1 / (1 + x * x), -1);
      },
      vector({1, 1}));
  EXPECT_NEAR(solve(flat, {vector({5}), vector({0})}, Settings()).point.state(0), 0, 1e-14);
}

} // namespace branch_tests
} // namespace vibroimpact::continuation
