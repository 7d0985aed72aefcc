// Periodic motions against closed forms: linear ones, one with an impact on a rigid stop in each
// period, and those of the isolator between elastic stops.
#include "common/decompositions.h"
#include "periodic/orbit.h"

#include "common/error.h"
#include "contact/laws/linear_penalty.h"
#include "forced_models.h"
#include "support/rotor_models.h"

#include <gtest/gtest.h>

#include <complex>

namespace vibroimpact::periodic {
namespace orbits_tests {

using Complex = std::complex<double>;
using testing::ForcedMap;
using testing::isolator;
using testing::Oscillator;
using testing::oscillator;
using testing::vector_of;

// m x'' + c x' + k x = f sin(w t): x = Im(A e^(i w t)).
struct LinearVibration {
  double m, c, k, f, w;

  Complex amplitude() const { return f / Complex(k - m * w * w, c * w); }
  Vector state_at(double t) const {
    const Complex x = amplitude() * std::polar(1.0, w * t);
    return vector_of({x.imag(), (x * Complex(0, w)).imag()});
  }
  double period() const { return 2 * std::numbers::pi / w; }
  Complex multiplier() const {
    const double rate = c / (2 * m);
    return std::exp(Complex(-rate, std::sqrt(k / m - rate * rate)) * period());
  }
};

void expect_pair(const Eigen::VectorXcd &multipliers, Complex expected, double tolerance) {
  ASSERT_EQ(multipliers.size(), 2);
  expected = Complex(expected.real(), std::abs(expected.imag()));
  EXPECT_LT(std::abs(multipliers[0] - expected), tolerance);
  EXPECT_LT(std::abs(multipliers[1] - std::conj(expected)), tolerance);
}

TEST(OrbitsTest, LinearVibrationHasItsAmplitudeAndMultipliers) {
  const LinearVibration exact{.m = 2, .c = 0.6, .k = 30, .f = 5, .w = 3.1};
  Oscillator linear = oscillator(exact.m, exact.k, exact.c);
  linear.push(exact.f, exact.w);
  ForcedMap forced(linear);
  const Orbit orbit = find_orbit(forced.map, 3, vector_of({0.2, -0.4}));
  EXPECT_EQ(orbit.multiple(), 1);
  EXPECT_TRUE(orbit.symmetric());
  EXPECT_LT(orbit.point.residual, 1e-13);
  EXPECT_LT((state_at_zero_phase(forced.map, orbit) - exact.state_at(0)).norm(), 1e-12);
  expect_pair(orbit.multipliers(forced.map), exact.multiplier(), 1e-12);
  EXPECT_TRUE(is_stable(orbit.multipliers(forced.map)));
}

// A stop that is pressed in by 20 mm all the time adds its stiffness, and an offset.
TEST(OrbitsTest, ContactForTheWholePeriod) {
  const double stop = 80, prestress = 0.02;
  const LinearVibration exact{.m = 2, .c = 0.6, .k = 30 + stop, .f = 0.3, .w = 3.1};
  Oscillator pressed = oscillator(exact.m, exact.k - stop, exact.c);
  pressed.push(exact.f, exact.w);
  pressed.stop({{-prestress, std::make_shared<contact::LinearPenalty>(stop)}});
  ForcedMap forced(pressed);
  const Orbit orbit = find_orbit(forced.map, 1, vector_of({0, 0}));
  EXPECT_TRUE(orbit.point.image.pattern.touches);
  EXPECT_TRUE(orbit.point.image.pattern.events.empty());
  EXPECT_FALSE(orbit.symmetric());
  const Vector offset = vector_of({-stop * prestress / exact.k, 0});
  EXPECT_LT((state_at_zero_phase(forced.map, orbit) - offset - exact.state_at(0)).norm(), 1e-12);
  expect_pair(orbit.multipliers(forced.map), exact.multiplier(), 1e-12);
}

// x'' + 2 d x' + x = a sin(w t), x <= 1, one impact with restitution e in each period. Between
// impacts y(t) = p(t) + Phi(t) (y0 - p(0)); with y0 = (1, v) just behind one and (1, -v/e) just
// before the next,
//   (I - Phi) p(0) = (1, -v/e) - Phi (1, v),   p(0) = X (sin s, w cos s),
// so that v solves a quadratic equation.
struct ImpactMotion {
  double d = 0.05, a = 1.2, w = 0.8, e = 0.8;
  double v = 0;       ///< just behind the impact
  double instant = 0; ///< of the impact, in the first period
  Matrix flow;        ///< Phi of one period
  Vector behind;      ///< (1, v)

  double period() const { return 2 * std::numbers::pi / w; }

  ImpactMotion() {
    const double damped = std::sqrt(1 - d * d), t = period();
    const double c = std::cos(damped * t), s = std::sin(damped * t) / damped;
    flow.resize(2, 2);
    flow << c + d * s, s, -s, c - d * s;
    flow *= std::exp(-d * t);
    const Matrix inverse = vibroimpact::inverse(Matrix::Identity(2, 2) - flow);
    const Vector constant = inverse * (vector_of({1, 0}) - flow * vector_of({1, 0}));
    const Vector slope = inverse * (vector_of({0, -1 / e}) - flow * vector_of({0, 1}));
    const Complex response = a / Complex(1 - w * w, 2 * d * w);
    const double x2 = std::norm(response);
    const double qa = slope[0] * slope[0] + slope[1] * slope[1] / (w * w);
    const double qb = 2 * (constant[0] * slope[0] + constant[1] * slope[1] / (w * w));
    const double qc = constant[0] * constant[0] + constant[1] * constant[1] / (w * w) - x2;
    v = (-qb - std::sqrt(qb * qb - 4 * qa * qc)) / (2 * qa);
    const Vector p = constant + slope * v;
    const double phase = std::atan2(p[0], p[1] / w) - std::arg(response);
    instant = phase / w - std::floor(phase / w / t) * t;
    behind = vector_of({1, v});
  }
  double acceleration(double speed) const { return a * std::sin(w * instant) - 2 * d * speed - 1; }
  /// Phi times the saltation matrix of the impact.
  Matrix monodromy() const {
    const double before = -v / e;
    Matrix saltation(2, 2);
    saltation << -e, 0, (acceleration(v) + e * acceleration(before)) / before, -e;
    return flow * saltation;
  }
};

TEST(OrbitsTest, OneImpactInEachPeriod) {
  const ImpactMotion exact;
  ASSERT_LT(exact.v, -0.1);
  Oscillator rigid = oscillator(1, 1, 2 * exact.d);
  rigid.push(exact.a, exact.w);
  rigid.stop({{1.0, testing::newton(exact.e)}});
  ForcedMap forced(rigid);
  const double start = exact.instant / exact.period();
  const Vector zero = forced.map.carry(start, 1, exact.behind);
  const Orbit orbit = find_orbit(forced.map, 1, zero + vector_of({-0.02, 0.02}));
  EXPECT_LT((state_at_zero_phase(forced.map, orbit) - zero).norm(), 1e-10);
  EXPECT_FALSE(orbit.symmetric());
  ASSERT_EQ(orbit.point.image.pattern.events.size(), 1u);
  const double impact =
      orbit.section.phase + orbit.point.image.pattern.events[0].time / exact.period();
  EXPECT_NEAR(impact - std::floor(impact), start, 1e-10);
  const Eigen::VectorXcd multipliers = orbit.multipliers(forced.map);
  const Eigen::VectorXcd expected = multipliers_of(exact.monodromy(), vector_of({1, 1}));
  EXPECT_LT((multipliers - expected).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR((multipliers[0] * multipliers[1]).real(),
              std::exp(-2 * exact.d * exact.period()) * exact.e * exact.e, 1e-9);
}

// From an independent shooting solver: state at phase 0 and multipliers of three motions, the
// middle one unstable.
TEST(OrbitsTest, MotionsOfTheIsolator) {
  struct Row {
    double lambda;
    Vector state;
    Complex multiplier, other;
  };
  const Row rows[] = {{1.3008545433175982,
                       vector_of({-0.028194054800724056, -0.9758280153985198}),
                       {0.11162074362033231, 0.9462870088117389},
                       {0.11162074362033231, -0.9462870088117389}},
                      {1.3002392653669812, vector_of({-0.4120753142893589, -1.6826431972517588}),
                       1.7220718731120206, 0.21250152225711297},
                      {1.299915918260678,
                       vector_of({-1.8622229781218838, 1.0779840721100555}),
                       {0.45069647046557776, 0.235308526756773},
                       {0.45069647046557776, -0.235308526756773}}};
  for (const Row &row : rows) {
    const Oscillator model = isolator(row.lambda);
    ForcedMap forced(model);
    const Orbit orbit = find_orbit(forced.map, 1, row.state + vector_of({0.01, -0.01}));
    EXPECT_TRUE(orbit.symmetric());
    EXPECT_LT((state_at_zero_phase(forced.map, orbit) - row.state).norm(), 1e-10);
    const Eigen::VectorXcd multipliers = orbit.multipliers(forced.map);
    EXPECT_LT(std::abs(multipliers[0] - row.multiplier), 1e-8);
    EXPECT_LT(std::abs(multipliers[1] - row.other), 1e-8);
  }
}

TEST(OrbitsTest, NoneIsFoundAtResonance) {
  Oscillator resonant = oscillator(1, 1, 0);
  resonant.push(1, 1);
  ForcedMap forced(resonant, false);
  EXPECT_THROW(find_orbit(forced.map, 1, vector_of({0, 0})), NumericalError);
}

TEST(OrbitsTest, OtherExcitationsMustRepeatThemselves) {
  Oscillator two = isolator(1.3);
  two.push(0.1, 3.9);
  EXPECT_NO_THROW(ForcedMap{two});
  two.push(0.1, 2.0);
  EXPECT_THROW(ForcedMap{two}, InputError);
}

TEST(OrbitsTest, RotorsHaveASecondFrequency) {
  Oscillator carrier{.model = model::Model({testing::plane_mass("block", 1, 100, 1),
                                            testing::rotation("rotor", 0.1)})};
  carrier.push(1, 3);
  testing::put_rotor(carrier.model, 1, "block.head", 0.1, 0.01);
  try {
    ForcedMap{carrier};
    FAIL();
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("rotor"), std::string::npos);
  }
}

} // namespace orbits_tests
} // namespace vibroimpact::periodic
