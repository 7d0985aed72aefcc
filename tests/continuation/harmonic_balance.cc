#include "continuation/harmonic_balance.h"

#include "algebraic.h"

#include "continuation/branch.h"
#include "continuation/harmonic_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace vibroimpact::continuation {
namespace harmonic_balance_tests {

using std::numbers::pi;

// Of a force f(y, y') by equal samples, exact for polynomials; `slopes` are df/dy and df/dy'.
ForceSeries sampled(const RowVector &series, double frequency,
                    const std::function<double(double, double)> &force,
                    const std::function<Eigen::RowVector2d(double, double)> &slopes) {
  constexpr int samples = 120;
  const Index harmonics = harmonics_of(series.size());
  const Matrix rate = frequency * harmonic_rate(harmonics);
  ForceSeries result{RowVector::Zero(series.size()), Matrix::Zero(series.size(), series.size())};
  for (int i = 0; i < samples; ++i) {
    const Vector basis = harmonic_basis(2 * pi * i / samples, harmonics);
    const Vector weight = harmonic_projection(basis) * (2 * pi / samples);
    const double y = series.dot(basis), v = (series * rate).dot(basis);
    result.force += force(y, v) * weight.transpose();
    result.by_displacement +=
        weight * (slopes(y, v)(0) * basis + slopes(y, v)(1) * (rate * basis)).transpose();
  }
  return result;
}

// x'' + 2 d x' + x + g x^3 = F cos(omega t), key omega.
class Duffing : public HarmonicSystem {
public:
  static constexpr double d = 0.05, g = 0.7, F = 0.3;
  explicit Duffing(Index harmonics = 1, double push = F) : harmonics_{harmonics}, push_{push} {}
  HarmonicEquations equations(double key) override {
    omega_ = key;
    Matrix load = Matrix::Zero(1, 2 * harmonics_ + 1);
    load(1) = push_;
    return {vector({1}),
            vector({2 * d}),
            vector({1}),
            key,
            load,
            vector({1}),
            Matrix::Zero(1, 2 * harmonics_ + 1)};
  }
  ForceSeries force(Index, const RowVector &y, bool /*slopes*/) override {
    return sampled(
        y, omega_, [](double x, double) { return g * x * x * x; },
        [](double x, double) { return Eigen::RowVector2d(3 * g * x * x, 0); });
  }

private:
  Index harmonics_;
  double push_;
  double omega_ = 0;
};

double amplitude(const Vector &state) { return harmonic_amplitudes(state.transpose())(1); }

// With s = A^2 and D = 1 - w^2 + 3/4 g s: s (D^2 + (2 d w)^2) = F^2 for H = 1.
TEST(HarmonicBalanceTest, OfTheDuffingOscillatorIsItsClosedForm) {
  Duffing duffing;
  HarmonicBalance problem(duffing, 1, vector({1}), 1);
  Settings settings;
  settings.first_key = {0.3, 4};
  const BranchPoint start = solve(problem, {vector({0, 0.3, 0}), vector({0.4})}, settings);
  const Branch branch = follow(problem, {start.point, {}, true}, settings);
  EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
  const double d = Duffing::d, g = Duffing::g;
  for (const BranchPoint &point : branch.points) {
    const double w = point.point.keys(0), a = amplitude(point.point.state);
    const double s = a * a, detuning = 1 - w * w + 0.75 * g * s;
    EXPECT_NEAR(s * (detuning * detuning + 4 * d * d * w * w), Duffing::F * Duffing::F, 1e-11);
    EXPECT_NEAR(point.point.state(0), 0, 1e-14);
  }
  // The response leans to the right: the key turns where the derivative by s is zero.
  ASSERT_EQ(branch.special.size(), 2u);
  for (const SpecialPoint &fold : branch.special) {
    EXPECT_EQ(fold.kind, Special::fold);
    const double w = fold.at.point.keys(0), a = amplitude(fold.at.point.state);
    const double s = a * a, detuning = 1 - w * w + 0.75 * g * s;
    EXPECT_NEAR(detuning * detuning + 4 * d * d * w * w + 1.5 * g * s * detuning, 0, 1e-7);
  }
}

// Two coordinates with two elements, one of them on their difference, which moves at one end; and a
// load that makes a given motion exact: 0.3 + cos phi + 0.2 sin 3 phi and 0.5 sin 2 phi.
class Manufactured : public HarmonicSystem {
public:
  static constexpr double omega = 1.3;
  explicit Manufactured(Index harmonics) : harmonics_{harmonics} {
    const Matrix q = motion(harmonics), rate = omega * harmonic_rate(harmonics);
    at_ = {mass(), damping(), stiffness(), omega, {}, rows(), Matrix::Zero(2, q.cols())};
    at_.offset.row(1) << 0.1, 0.2, RowVector::Zero(q.cols() - 2);
    at_.load = mass() * q * rate * rate + damping() * q * rate + stiffness() * q;
    for (Index e = 0; e < 2; ++e)
      at_.load += rows().row(e).transpose() * force(e, rows().row(e) * q + at_.offset.row(e)).force;
  }
  static Matrix motion(Index harmonics) {
    Matrix q = Matrix::Zero(2, 2 * harmonics + 1);
    q(0, 0) = 0.3;
    q(0, 1) = 1;
    q(0, 6) = 0.2;
    q(1, 4) = 0.5;
    return q;
  }
  HarmonicEquations equations(double) override { return at_; }
  ForceSeries force(Index element, const RowVector &y, bool /*slopes*/ = true) override {
    if (element == 0)
      return sampled(
          y, omega, [](double x, double v) { return x * x * v; },
          [](double x, double v) { return Eigen::RowVector2d(2 * x * v, x * x); });
    return sampled(
        y, omega, [](double x, double) { return x * x; },
        [](double x, double) { return Eigen::RowVector2d(2 * x, 0); });
  }

private:
  static Matrix mass() { return vector({2, 1}).asDiagonal(); }
  static Matrix damping() { return vector({0.1, 0.3}).asDiagonal(); }
  static Matrix stiffness() {
    Matrix stiffness(2, 2);
    stiffness << 3, -1, -1, 4;
    return stiffness;
  }
  static Matrix rows() {
    Matrix rows(2, 2);
    rows << 1, 0, 1, -1;
    return rows;
  }
  Index harmonics_;
  HarmonicEquations at_;
};

TEST(HarmonicBalanceTest, FindsAManufacturedMotion) {
  constexpr Index harmonics = 9;
  Manufactured system(harmonics);
  HarmonicBalance problem(system, harmonics, vector({1, 1}), 1);
  const Matrix exact = Manufactured::motion(harmonics);
  const Vector guess = problem.state_of(0.9 * exact, 0);
  const Vector state = solve(problem, {guess, vector({0})}, Settings()).point.state;
  EXPECT_LT((problem.motion(state, 0).coordinates - exact).norm(), 1e-12);
}

TEST(HarmonicBalanceTest, HasTheDerivativesOfItsResidual) {
  Manufactured system(3);
  HarmonicBalance problem(system, 3, vector({1, 1}), 1);
  Point point{Vector::LinSpaced(14, -0.7, 0.9), vector({0.2})};
  const Matrix exact = problem.evaluate(point).by_state;
  for (Index i = 0; i < 14; ++i) {
    Point ahead = point, behind = point;
    ahead.state(i) += 1e-5;
    behind.state(i) -= 1e-5;
    const Vector difference =
        (problem.evaluate(ahead).residual - problem.evaluate(behind).residual) / 2e-5;
    EXPECT_LT((exact.col(i) - difference).norm(), 1e-8) << i;
  }
}

TEST(HarmonicBalanceTest, DerivativeByTheKeyAtABound) {
  class Bounded : public Duffing {
  public:
    double lowest = 0;
    HarmonicEquations equations(double key) override {
      if (key < lowest)
        throw NumericalError("no system");
      return Duffing::equations(key);
    }
  } system;
  HarmonicBalance problem(system, 1, vector({1}), 1);
  const Point point{vector({0.1, 0.5, -0.2}), vector({0.8})};
  const Matrix central = problem.evaluate(point).by_keys;
  system.lowest = 0.8;
  EXPECT_LT((problem.evaluate(point).by_keys - central).norm(), 1e-7 * central.norm());
}

// Of a cubic force on A cos phi: 3/4 A^3 cos phi + 1/4 A^3 cos 3 phi, of which H = 1 keeps one.
TEST(HarmonicBalanceTest, ForceLeftOut) {
  Duffing duffing;
  HarmonicBalance problem(duffing, 1, vector({1}), 1);
  const double w = 0.8, a = 0.6, d = Duffing::d, g = Duffing::g;
  const LeftOut left = problem.left_out(problem.motion(vector({0, a, 0}), w), w);
  EXPECT_NEAR(left.force, 1 / std::sqrt(10.0), 1e-14);
  const double force = g * a * a * a / 4;
  EXPECT_NEAR(left.coordinates.norm(), force / std::hypot(1 - 9 * w * w, 6 * d * w), 1e-14);
  EXPECT_EQ(left.coordinates.leftCols(3).norm(), 0);
}

// Third harmonic that H = 1 leaves out, over that of H = 9, less 1.
double error_of_third(double push) {
  Duffing few(1, push), many(9, push);
  HarmonicBalance rough(few, 1, vector({1}), 1), fine(many, 9, vector({1}), 1);
  const Settings settings;
  const double w = 0.5;
  const Vector low = solve(rough, {vector({0, push, 0}), vector({w})}, settings).point.state;
  const Vector guess = with_harmonics(low.transpose(), 9).transpose();
  const Vector high = solve(fine, {guess, vector({w})}, settings).point.state;
  return rough.left_out(rough.motion(low, w), w).coordinates(5) / high(5) - 1;
}

// Up to what it changes itself, which is in proportion to the stiffness that the motion adds, its
// square.
TEST(HarmonicBalanceTest, ResponseToTheForceLeftOutIsTheError) {
  EXPECT_LT(std::abs(error_of_third(0.1)), 0.02);
  EXPECT_NEAR(error_of_third(0.1) / error_of_third(0.05), 4, 0.2);
}

} // namespace harmonic_balance_tests
} // namespace vibroimpact::continuation
