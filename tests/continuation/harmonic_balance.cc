#include "algebraic.h"

#include "continuation/branch.h"
#include "continuation/harmonic_balance.h"

#include <gtest/gtest.h>

namespace vibroimpact::continuation {
namespace {

// x'' + 2 d x' + x + g x^3 = F cos(omega t), key omega.
class Duffing : public HarmonicSystem {
public:
  static constexpr double d = 0.05, g = 0.7, F = 0.3;
  HarmonicEquations equations(double key) override {
    Matrix load(1, 2);
    load << 0, F;
    return {vector({1}), vector({2 * d}), vector({1}), key, load};
  }
  ForceSample force(const Vector &x, const Vector &, double, double) override {
    return {vector({g * x(0) * x(0) * x(0)}), vector({3 * g * x(0) * x(0)}), vector({0})};
  }
};

// With s = A^2 and D = 1 - w^2 + 3/4 g s: s (D^2 + (2 d w)^2) = F^2 for H = 1.
TEST(HarmonicBalanceTest, OfTheDuffingOscillatorIsItsClosedForm) {
  Duffing duffing;
  HarmonicBalance problem(duffing, 1, 8, vector({1}), 1);
  Settings settings;
  settings.first_key = {0.3, 4};
  const BranchPoint start = solve(problem, {vector({0, 0.3, 0}), vector({0.4})}, settings);
  const Branch branch = follow(problem, {start.point, {}, true}, settings);
  EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
  const double d = Duffing::d, g = Duffing::g;
  for (const BranchPoint &point : branch.points) {
    const double w = point.point.keys(0), amplitude = problem.amplitudes(point.point.state, 1)(0);
    const double s = amplitude * amplitude, detuning = 1 - w * w + 0.75 * g * s;
    EXPECT_NEAR(s * (detuning * detuning + 4 * d * d * w * w), Duffing::F * Duffing::F, 1e-11);
    EXPECT_NEAR(problem.amplitudes(point.point.state, 0)(0), 0, 1e-14);
  }
  // The response leans to the right: the key turns where the derivative by s is zero.
  ASSERT_EQ(branch.special.size(), 2u);
  for (const SpecialPoint &fold : branch.special) {
    EXPECT_EQ(fold.kind, Special::fold);
    const double w = fold.at.point.keys(0),
                 amplitude = problem.amplitudes(fold.at.point.state, 1)(0);
    const double s = amplitude * amplitude, detuning = 1 - w * w + 0.75 * g * s;
    EXPECT_NEAR(detuning * detuning + 4 * d * d * w * w + 1.5 * g * s * detuning, 0, 1e-7);
  }
}

// Two coordinates with a force of displacements and velocities, and a load that makes a given
// motion exact: 0.3 + cos phi + 0.2 sin 3 phi and 0.5 sin 2 phi.
class Manufactured : public HarmonicSystem {
public:
  static constexpr double omega = 1.3;
  static constexpr Index harmonics = 9;
  Manufactured() : load_(Matrix::Zero(2, 2 * harmonics + 1)) {
    constexpr int samples = 64;
    for (int i = 0; i < samples; ++i) {
      const double phase = 2 * M_PI * i / samples;
      const Vector value = total(phase) / samples;
      load_.col(0) += value;
      for (Index h = 1; h <= harmonics; ++h) {
        load_.col(2 * h - 1) += 2 * value * std::cos(static_cast<double>(h) * phase);
        load_.col(2 * h) += 2 * value * std::sin(static_cast<double>(h) * phase);
      }
    }
  }
  static Vector motion(double phase) {
    return vector({0.3 + std::cos(phase) + 0.2 * std::sin(3 * phase), 0.5 * std::sin(2 * phase)});
  }
  HarmonicEquations equations(double) override {
    return {mass(), damping(), stiffness(), omega, load_};
  }
  ForceSample force(const Vector &x, const Vector &v, double, double) override {
    ForceSample sample{vector({x(0) * x(0) * v(0), (x(0) - x(1)) * (x(0) - x(1))}), Matrix(2, 2),
                       Matrix(2, 2)};
    const double relative = 2 * (x(0) - x(1));
    sample.by_displacement << 2 * x(0) * v(0), 0, relative, -relative;
    sample.by_velocity << x(0) * x(0), 0, 0, 0;
    return sample;
  }

private:
  static Matrix mass() { return vector({2, 1}).asDiagonal(); }
  static Matrix damping() { return vector({0.1, 0.3}).asDiagonal(); }
  static Matrix stiffness() {
    Matrix stiffness(2, 2);
    stiffness << 3, -1, -1, 4;
    return stiffness;
  }
  Vector total(double phase) {
    const Vector velocity =
        omega * vector({-std::sin(phase) + 0.6 * std::cos(3 * phase), std::cos(2 * phase)});
    const Vector acceleration =
        omega * omega *
        vector({-std::cos(phase) - 1.8 * std::sin(3 * phase), -2 * std::sin(2 * phase)});
    const Vector x = motion(phase);
    return mass() * acceleration + damping() * velocity + stiffness() * x +
           force(x, velocity, phase, 0).force;
  }
  Matrix load_;
};

TEST(HarmonicBalanceTest, FindsAManufacturedMotion) {
  Manufactured system;
  constexpr Index coefficients = 2 * Manufactured::harmonics + 1;
  HarmonicBalance problem(system, Manufactured::harmonics, 40, vector({1, 1}), 1);
  Vector guess = Vector::Zero(2 * coefficients);
  guess(0) = 0.25; // constant and cosine of the first coordinate
  guess(2) = 0.95;
  const Vector state = solve(problem, {guess, vector({0})}, Settings()).point.state;
  EXPECT_NEAR(problem.amplitudes(state, 0)(0), 0.3, 1e-12);
  EXPECT_NEAR(problem.amplitudes(state, 3)(0), 0.2, 1e-12);
  EXPECT_NEAR(problem.amplitudes(state, 2)(1), 0.5, 1e-12);
  for (const double phase : {0.1, 1.7, 4.0})
    EXPECT_LT((problem.displacement(state, phase) - Manufactured::motion(phase)).norm(), 1e-12);
}

TEST(HarmonicBalanceTest, HasTheDerivativesOfItsResidual) {
  Manufactured system;
  HarmonicBalance problem(system, 3, 16, vector({1, 1}), 1);
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

TEST(HarmonicBalanceTest, NeedsASampleForEachCoefficient) {
  Duffing duffing;
  EXPECT_THROW(HarmonicBalance(duffing, 3, 6, vector({1}), 1), std::logic_error);
}

} // namespace
} // namespace vibroimpact::continuation
