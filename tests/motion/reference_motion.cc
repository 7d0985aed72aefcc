// The integration that motions with nonlinear contacts are compared with, itself against closed
// forms.
#include "support/reference_motion.h"

#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::testing {
namespace reference_motion_tests {

ReferenceSystem two_spheres(const ReferenceLaw &law) {
  return {.mass = {1, 2.5},
          .stiffness = {0, 0},
          .damping = {0, 0},
          .contacts = {{.row = {-1, 1}, .clearance = 1e-3, .law = law}}};
}

ReferenceImpact impact_of(const ReferenceLaw &law) {
  const ReferenceResult motion = reference_motion(two_spheres(law), {{0, 0}, {0.3, -0.2}}, 0.5);
  EXPECT_EQ(motion.impacts[0].size(), 1u);
  return motion.impacts[0].at(0);
}

constexpr Real effective_mass = 2.5L / 3.5L;
const Real speed = Real(0.3) + Real(0.2); // as the start is rounded

double relative(Real value, Real truth) { return static_cast<double>(std::abs(value / truth - 1)); }

// u_max^(n+1) = (n+1) m v^2 / (2 k); the contact lasts
// 2 sqrt(pi) / (n+1) Gamma(1/(n+1)) / Gamma(1/2 + 1/(n+1)) u_max / v.
TEST(ReferenceMotionTest, TwoFreeSpheres) {
  for (const double exponent : {1.1, 1.5, 2.2, 3.0}) {
    const Real k = 1e7, n = exponent, p = 1 / (n + 1);
    const ReferenceImpact impact = impact_of({.stiffness = 1e7, .exponent = exponent});
    const Real deepest = std::pow((n + 1) * effective_mass * speed * speed / (2 * k), p);
    const Real duration = 2 * std::sqrt(std::numbers::pi_v<Real>) * p * boost::math::tgamma(p) /
                          boost::math::tgamma(0.5L + p) * deepest / speed;
    EXPECT_LT(relative(impact.duration, duration), 1e-15) << n;
    EXPECT_LT(relative(impact.deepest, deepest), 1e-15) << n;
    EXPECT_LT(relative(impact.separation_speed, speed), 1e-15) << n;
    EXPECT_LT(relative(impact.impulse, 2 * effective_mass * speed), 1e-15) << n;
    EXPECT_EQ(impact.humps, 1);
  }
}

// (1 + e) c = ln[(1 + c) / (1 - e c)], c = d v, of Hunt-Crossley's force for every exponent.
Real dissipation(Real restitution) {
  const auto excess = [&](Real c) {
    return (1 + restitution) * c - std::log((1 + c) / (1 - restitution * c));
  };
  std::uintmax_t iterations = 200;
  const auto close = [](Real a, Real b) { return b - a < 1e-19L * b; };
  return boost::math::tools::toms748_solve(excess, 1e-6L * (1 - restitution),
                                           (1 - 1e-18L) / restitution, close, iterations)
      .first;
}

TEST(ReferenceMotionTest, RestitutionOfHuntCrossley) {
  for (const double exponent : {1.5, 2.2})
    for (const double restitution : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const auto damping = static_cast<double>(dissipation(restitution) / speed);
      const ReferenceImpact impact =
          impact_of({.stiffness = 1e7, .exponent = exponent, .damping = damping});
      // The damping is rounded to double precision.
      const double rounding = 2e-15;
      EXPECT_LT(relative(impact.separation_speed, restitution * speed), rounding) << restitution;
      const Real lost = effective_mass * speed * speed * (1 - Real(restitution) * restitution) / 2;
      // 1 - e^2 is the small difference that errors of e count in.
      const double counted =
          std::max(1.0, 2 * restitution * restitution / (1 - restitution * restitution));
      EXPECT_LT(relative(impact.dissipated, lost), rounding * counted) << restitution;
    }
}

// e = exp(-pi z / sqrt(1 - z^2)), z = c / sqrt(5 m k), at every speed.
TEST(ReferenceMotionTest, RestitutionOfTsuji) {
  const Real k = 1e7, c = 500;
  const ReferenceImpact impact =
      impact_of({.kind = ReferenceLaw::Kind::tsuji, .stiffness = 1e7, .damping = 500});
  const Real z = c / std::sqrt(5 * effective_mass * k);
  const Real restitution = std::exp(-std::numbers::pi_v<Real> * z / std::sqrt(1 - z * z));
  EXPECT_LT(relative(impact.separation_speed, restitution * speed), 2e-13);
}

// A spring on a moving base and a force: q = A sin(w t) solves m q'' + k q = (k - m w^2) A sin(w
// t).
TEST(ReferenceMotionTest, SourcesOfLinearMotion) {
  const double w = 3, amplitude = 0.2, base = 0.1, mass = 2, k = 50;
  const ReferenceSystem system{
      .mass = {mass},
      .stiffness = {k},
      .damping = {0},
      .forces = {ReferenceHarmonic{(k - mass * w * w) * amplitude - mass * w * w * base, w, 0}},
      .base = ReferenceHarmonic{base, w, 0}};
  const ReferenceResult motion = reference_motion(system, {{0}, {w * amplitude}}, 5);
  const Real truth = Real(amplitude) * std::sin(Real(w) * 5);
  EXPECT_LT(std::abs(motion.displacement[0] - truth), 1e-16L);
}

} // namespace reference_motion_tests
} // namespace vibroimpact::testing
