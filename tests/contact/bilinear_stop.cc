// A mass on a stop that may pull is a damped oscillator for half a damped period.
#include "contact/laws/bilinear_stop.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::contact {
namespace bilinear_stop_tests {

using namespace motion;

constexpr double mass = 2;
constexpr double stiffness = 8e4;
constexpr double speed = 0.5;

struct Outcome {
  std::vector<Impact> impacts;
  double gap = 0, gap_rate = 0;
};

Outcome run(double contact_stiffness, double damping, double duration) {
  const model::Model model({testing::single_mass("block", mass, 0, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "block.head", "", 0, std::make_shared<BilinearStop>(contact_stiffness, damping))});
  Trajectory trajectory(model, contacts, Settings{});
  ImpactLog log(contacts, 0);
  testing::GuardWatch guards;
  Observers observers({&log, &guards});
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
  trajectory.advance(duration, observers);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8);
  return {log.impacts(0), -trajectory.state()[0], -trajectory.state()[1]};
}

TEST(BilinearStopTest, AFreeMassLeavesAfterHalfADampedPeriod) {
  const double frequency = std::sqrt(stiffness / mass);
  for (const double z : {0.0, 0.05, 0.4, 0.9}) {
    const Outcome out = run(stiffness, 2 * z * std::sqrt(stiffness * mass), 0.5);
    ASSERT_EQ(out.impacts.size(), 1u) << z;
    const double damped = std::sqrt(1 - z * z);
    const double e = std::exp(-std::numbers::pi * z / damped);
    EXPECT_NEAR(out.impacts[0].restitution_coefficient(), e, 1e-8) << z;
    EXPECT_NEAR(out.impacts[0].duration, std::numbers::pi / (frequency * damped), 1e-9) << z;
    EXPECT_NEAR(out.impacts[0].dissipated_energy, 0.5 * mass * speed * speed * (1 - e * e), 1e-8);
  }
}

// Overdamped, the mass creeps back and never leaves: u = v sinh(b t) exp(-z w t) / b.
TEST(BilinearStopTest, OverdampedItNeverLetsGo) {
  const double z = 1.25;
  const double frequency = std::sqrt(stiffness / mass);
  const Outcome out = run(stiffness, 2 * z * std::sqrt(stiffness * mass), 0.02);
  EXPECT_TRUE(out.impacts.empty());
  const double b = frequency * std::sqrt(z * z - 1);
  EXPECT_NEAR(out.gap, -speed * std::sinh(b * 0.02) * std::exp(-z * frequency * 0.02) / b, 1e-11);
}

TEST(BilinearStopTest, ADashpotAloneStopsTheMassWithinItsStroke) {
  const double damping = 200;
  const Outcome out = run(0, damping, 0.3);
  EXPECT_NEAR(out.gap, -speed * mass / damping, 1e-9);
  EXPECT_NEAR(out.gap_rate, 0, 1e-9);
}

TEST(BilinearStopTest, PullsWhereTheDashpotIsStronger) {
  const BilinearStop law(8e4, 200);
  EXPECT_DOUBLE_EQ(testing::response_of(law, {.mode = 1, .gap = -1e-3, .gap_rate = 3}).force, -520);
  EXPECT_EQ(testing::response_of(law, {.mode = 0, .gap = 1e-3, .gap_rate = 3}).force, 0);
}

TEST(BilinearStopTest, DerivativesPowerAndAffineForm) {
  const BilinearStop law(8e4, 200);
  for (const int mode : {0, 1})
    for (const double rate : {-0.3, 0.4})
      testing::check_law(law, {.mode = mode, .gap = mode == 0 ? 1e-3 : -1e-3, .gap_rate = rate});
}

} // namespace bilinear_stop_tests
} // namespace vibroimpact::contact
