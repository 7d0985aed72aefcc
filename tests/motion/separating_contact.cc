// A Hunt–Crossley contact that other forces pull apart so fast that its force ends while the two
// sides still overlap: it changes from contact to separating, and must not change back and forth.
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "contact/restitution_relation.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::motion {
namespace separating_contact_tests {

using namespace contact;
using namespace model;

TEST(SeparatingContact, EndsOnceForEverySpeed) {
  // A spring pulls the mass off the stop at 20 m/s^2 when it touches.
  constexpr double mass = 0.03;
  constexpr double clearance = 2.5e-3;
  const Model model({testing::single_mass("ball", mass, mass * 20 / clearance, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "ball.head", "", clearance,
      HuntCrossley::with_dimensionless_damping({.stiffness = 1.3e10, .exponent = 1.5},
                                               dimensionless_damping("exact", 0.33377), 1e-6))});
  Trajectory trajectory(model, contacts, {});
  for (int i = 0; i < 200; ++i) {
    const double speed = 5e-3 + 1e-4 * i;
    ImpactLog log(contacts, 0);
    trajectory.start(0, Vector::Constant(1, clearance * (1 - 1e-9)), Vector::Constant(1, speed));
    ASSERT_NO_THROW(trajectory.advance(1e-3, log)) << speed << " m/s";
    ASSERT_EQ(log.impacts(0).size(), 1U) << speed << " m/s";
    EXPECT_LE(trajectory.accuracy().events, 4) << speed << " m/s";
  }
}

// The force of a stiff stop falls by some 10^-4 N within the event tolerance, more than the overlap
// in metres at that instant: the two must not be compared.
TEST(SeparatingContact, StiffStopEndsOnceForEverySpeed) {
  const double mass = 13.5;
  const Model model({testing::single_mass("block", mass, 8e4, 0)});
  const ContactSet contacts({testing::contact_along_x(model, "block.head", "", 5e-3,
                                                      std::make_shared<KelvinVoigt>(5e8, 1e5))});
  Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-8, .event_tolerance = 1e-10});
  for (int i = 0; i < 200; ++i) {
    const double speed = 0.05 + 2e-3 * i;
    ImpactLog log(contacts, 0);
    trajectory.start(0, Vector::Constant(1, 4.99e-3), Vector::Constant(1, speed));
    ASSERT_NO_THROW(trajectory.advance(5e-3, log)) << speed << " m/s";
    ASSERT_EQ(log.impacts(0).size(), 1U) << speed << " m/s";
    EXPECT_EQ(trajectory.accuracy().events, 3) << speed << " m/s";
  }
}

// A base pushes a mass onto a stop fixed in space: the bounces die out, each lower than the last.
TEST(SeparatingContact, DyingBouncesGoOn) {
  Model model({testing::single_mass("block", 2, 1800, 3)});
  model.add_base_motion("ground", std::make_shared<Harmonic>(Given::displacement, 10, 0.2, 0), {0},
                        Vector3::UnitX());
  const ContactSet contacts({testing::contact_along_x(model, "block.head", "", 0.3,
                                                      std::make_shared<LinearPenalty>(1e6))});
  Trajectory trajectory(model, contacts, {});
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  ASSERT_NO_THROW(trajectory.advance(1.5, log));
  ASSERT_GT(log.impacts(0).size(), 10U);
  EXPECT_LT(log.impacts(0).back().approach_speed, log.impacts(0).front().approach_speed);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8);
}

} // namespace separating_contact_tests
} // namespace vibroimpact::motion
