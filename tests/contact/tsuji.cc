// Restitution of the Tsuji law: the same at every speed, and the one its damping promises.
#include "contact/laws/tsuji.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::contact {
namespace tsuji_tests {

using namespace motion;

constexpr double stiffness = 1.3e10;
constexpr double mass_a = 0.05;
constexpr double mass_b = 0.12;
constexpr double effective_mass = mass_a * mass_b / (mass_a + mass_b);

Impact collide(double restitution, double speed) {
  const double damping = tsuji_damping(restitution) * std::sqrt(effective_mass * stiffness);
  const model::Model model(
      {testing::single_mass("a", mass_a, 0, 0), testing::single_mass("b", mass_b, 0, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "a.head", "b.head", 1e-5, std::make_shared<Tsuji>(stiffness, damping))});
  EXPECT_NEAR(contacts.effective_mass(0, model), effective_mass, 1e-15);
  Trajectory trajectory(model, contacts, Settings{});
  ImpactLog log(contacts, 0);
  testing::GuardWatch guards;
  Observers observers({&log, &guards});
  Vector velocity(2);
  velocity << 0.75 * speed, -0.25 * speed;
  trajectory.start(0, Vector::Zero(2), velocity);
  trajectory.advance(2e-3 / speed, observers);
  EXPECT_EQ(log.impacts(0).size(), 1u);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-7);
  return log.impacts(0).at(0);
}

TEST(TsujiTest, ShowsTheRestitutionAskedForAtEverySpeed) {
  for (const double e : {1.0, 0.95, 0.6, 0.2})
    for (const double speed : {0.01, 0.3, 4.0}) {
      const Impact impact = collide(e, speed);
      EXPECT_NEAR(impact.restitution_coefficient(), e, 1e-6) << speed;
      EXPECT_NEAR(impact.dissipated_energy / (0.5 * effective_mass * speed * speed), 1 - e * e,
                  1e-6);
    }
}

// Largest penetration from the linear oscillator in x = u^(5/4): K x^2 = m v^2 exp(...), K = 4 k
// / 5.
TEST(TsujiTest, PenetratesAsTheLinearOscillatorSays) {
  const double speed = 0.3;
  const double e = 0.6;
  const double z = tsuji_damping(e) / std::sqrt(5.0);
  const double x = speed * std::sqrt(effective_mass / (0.8 * stiffness)) *
                   std::exp(-z * std::acos(z) / std::sqrt(1 - z * z));
  EXPECT_NEAR(collide(e, speed).maximum_penetration / std::pow(x, 0.8), 1, 1e-7);
}

TEST(TsujiTest, SmallLosses) {
  // 1 - e = pi alpha / sqrt(5) + ...
  EXPECT_NEAR(tsuji_damping(1 - 1e-6) / (std::sqrt(5.0) * 1e-6 / 3.14159265358979), 1, 1e-5);
  EXPECT_EQ(tsuji_damping(1), 0);
  EXPECT_LT(tsuji_damping(1e-300), std::sqrt(5.0));
  EXPECT_THROW(tsuji_damping(0), std::invalid_argument);
  EXPECT_THROW(tsuji_damping(1.1), std::invalid_argument);
}

TEST(TsujiTest, DerivativesPowerAndAffineForm) {
  const Tsuji law(stiffness, 2e4);
  for (const int mode : {0, 1})
    for (const double rate : {-0.3, 0.4})
      testing::check_law(law, {.mode = mode, .gap = mode == 0 ? 1e-5 : -1e-5, .gap_rate = rate});
}

TEST(TsujiTest, EverythingIsFiniteAtTheFirstTouch) {
  const LawResponse at = testing::response_of(Tsuji(stiffness, 2e4), {.mode = 1, .gap_rate = -1});
  EXPECT_EQ(at.force, 0);
  EXPECT_EQ(at.force_by_gap, 0);
  EXPECT_EQ(at.force_by_gap_rate, 0);
}

} // namespace tsuji_tests
} // namespace vibroimpact::contact
