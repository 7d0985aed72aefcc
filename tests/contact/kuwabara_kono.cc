// Viscoelastic spheres: small losses against a quadrature, scaling with speed, no tension.
#include "contact/laws/kuwabara_kono.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>

#include <cmath>

namespace vibroimpact::contact {
namespace kuwabara_kono_tests {

using namespace motion;

constexpr double stiffness = 1.3e10;
constexpr double mass = 0.04;

struct Outcome {
  Impact impact;
  long events = 0;
};

Outcome collide(double dissipation_time, double speed, double tolerance = 1e-9) {
  const model::Model model({testing::single_mass("ball", mass, 0, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "ball.head", "", 1e-5, std::make_shared<KuwabaraKono>(stiffness, dissipation_time))});
  Trajectory trajectory(model, contacts, {.relative_tolerance = tolerance});
  ImpactLog log(contacts, 0);
  testing::GuardWatch guards;
  Observers observers({&log, &guards});
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
  trajectory.advance(2e-3 / speed, observers);
  EXPECT_EQ(log.impacts(0).size(), 1u);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-7);
  return {log.impacts(0).at(0), trajectory.accuracy().events};
}

// Work of the damping along the elastic motion: with u_m^(5/2) = 5 m v^2 / (4 k),
// m v^2 (1 - e) = 3 A k v u_m^(3/2) int_0^1 s^(1/2) sqrt(1 - s^(5/2)) ds, the integral being
// (2/5) B(3/5, 3/2).
double first_order(double dissipation_time, double speed) {
  const double depth = std::pow(1.25 * mass * speed * speed / stiffness, 0.4);
  const double integral = 0.4 * boost::math::beta(0.6, 1.5);
  return 3 * dissipation_time * stiffness * std::pow(depth, 1.5) * integral / (mass * speed);
}

TEST(KuwabaraKonoTest, SmallLossesFollowTheFirstOrder) {
  const double speed = 0.3;
  const double slope = first_order(1, speed);
  EXPECT_NEAR(slope / (1.15344 * 1.5 * std::pow(stiffness / mass, 0.4) * std::pow(speed, 0.2)), 1,
              1e-5); // the constant of the header
  double before = 0;
  for (const double time : {1e-7, 1e-8}) {
    const double loss = 1 - collide(time, speed, 1e-11).impact.restitution_coefficient();
    const double error = std::abs(loss / (slope * time) - 1);
    EXPECT_LT(error, slope * time);
    if (before > 0) {
      EXPECT_NEAR(before / error, 10, 2); // what is left is of the next order
    }
    before = error;
  }
}

// Units of length and time scale out: e depends on A (k/m)^(2/5) v^(1/5) only.
TEST(KuwabaraKonoTest, RestitutionFallsWithSpeedByItsScale) {
  const double slow = collide(2e-6, 0.1).impact.restitution_coefficient();
  EXPECT_NEAR(collide(2e-6 / std::pow(30, 0.2), 3).impact.restitution_coefficient(), slow, 1e-7);
  EXPECT_LT(collide(2e-6, 3).impact.restitution_coefficient(), slow - 0.01);
}

TEST(KuwabaraKonoTest, LetsGoBeforeTheOverlapEndsAndNeverPulls) {
  EXPECT_EQ(collide(5e-6, 0.3).events, 3); // contact, separating, open
  const KuwabaraKono law(stiffness, 5e-6);
  const Guard &guard = law.modes()[1].guards[1];
  const double limit = 1e-5 / (1.5 * 5e-6);
  EXPECT_GT(guard.indicator({.gap = -1e-5, .gap_rate = 0.999 * limit}), 0);
  EXPECT_LT(guard.indicator({.gap = -1e-5, .gap_rate = 1.001 * limit}), 0);
  EXPECT_EQ(testing::response_of(law, {.mode = 2, .gap = -1e-5, .gap_rate = 2 * limit}).force, 0);
}

TEST(KuwabaraKonoTest, WithoutDissipationItIsHertz) {
  const Impact impact = collide(0, 0.3).impact;
  EXPECT_NEAR(impact.restitution_coefficient(), 1, 1e-8);
  EXPECT_NEAR(impact.maximum_penetration, std::pow(1.25 * mass * 0.09 / stiffness, 0.4), 1e-12);
}

TEST(KuwabaraKonoTest, DerivativesPowerAndAffineForm) {
  const KuwabaraKono law(stiffness, 5e-6);
  for (const int mode : {0, 1, 2})
    for (const double rate : {-0.3, 0.4})
      testing::check_law(law, {.mode = mode, .gap = mode == 0 ? 1e-5 : -1e-5, .gap_rate = rate});
}

} // namespace kuwabara_kono_tests
} // namespace vibroimpact::contact
