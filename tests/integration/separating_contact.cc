// A Hunt–Crossley contact that other forces pull apart so fast that its force ends while the two
// sides still overlap: it changes from contact to separating, and must not change back and forth.
#include "contact/laws/hunt_crossley.h"
#include "contact/restitution_relation.h"
#include "integration/impact_log.h"
#include "integration/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace {

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

} // namespace
} // namespace vibroimpact
