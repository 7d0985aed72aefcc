// Guards that an impact takes below zero at once, and guards that fall at the instant of an impact.
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

namespace vibroimpact::motion {
namespace guards_after_impacts_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::newton;
using testing::settings_of;
using testing::single_mass;
using testing::vector_of;

class GuardsAfterImpactsTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, GuardsAfterImpactsTest, ::testing::Values("exact", "rk"));

// A mass overlaps a Hunt-Crossley stop; an equal one hits it elastically and sends it off faster
// than 1/d, at which the force ends at once. A weight slows it down to 1/d, where the force comes
// on again, and not before. A third mass in a Hertz stop of its own keeps the phase from being
// linear.
TEST_P(GuardsAfterImpactsTest, AForceThatAnImpactEndsStaysEnded) {
  const double overlap = 1e-2, weight = 5, dissipation = 2;
  Model model({single_mass("a", 1, 0, 0), single_mass("b", 1, 0, 0), single_mass("c", 1, 0, 0)});
  testing::add_weight(model, weight, {0});
  const HertzConstants constants{.stiffness = 1e4, .exponent = 1.5};
  const ContactSet contacts(
      {contact_along_x(model, "a.head", "", 0,
                       HuntCrossley::with_dissipation(constants, dissipation)),
       contact_along_x(model, "a.head", "b.head", 0, newton(1)),
       contact_along_x(model, "c.head", "", 0, std::make_shared<Hertz>(constants))});
  for (const double slowed : {1e-8, 1e-7, 1e-6, 1e-4}) { // [s]
    const double speed = 1 / dissipation + weight * slowed;
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    testing::Events events;
    Vector state = Vector::Zero(trajectory.layout().physical_size());
    state.head(6) = vector_of({overlap, overlap, overlap, 0, -speed, 0});
    trajectory.start(MotionState{.time = 0, .physical = state});
    trajectory.advance(2 * slowed, events);
    ASSERT_EQ(events.list.size(), 3U) << slowed;
    EXPECT_NEAR(events.list[2].time, slowed, 1e-4 * slowed);
    EXPECT_EQ(trajectory.accuracy().undecided_events, 0) << slowed;
  }
}

// A mass is pressed onto a rigid stop, against a stop with damping that it overlaps by u. Its
// bounces end the force of that stop again and again; at rest it is k u.
TEST_P(GuardsAfterImpactsTest, ARestingMassIsPushedByTheOtherStop) {
  const double overlap = 4.73e-5, stiffness = 19.4;
  Model model({single_mass("block", 5.75, 12.4, 0.09)});
  testing::add_weight(model, -0.72, {0});
  ContactPair below = contact_along_x(model, "block.head", "", 0, newton(0.3));
  below.gap.row *= -1;
  const ContactSet contacts(
      {below, contact_along_x(model, "block.head", "", -overlap,
                              std::make_shared<KelvinVoigt>(stiffness, 1.345))});
  for (int i = 0; i < 10; ++i) {
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    Vector state = Vector::Zero(trajectory.layout().physical_size());
    state.head(2) = vector_of({1e-6, -5e-3 - 1e-3 * i});
    trajectory.start(MotionState{.time = 0, .physical = state});
    ImpactLog log(contacts, 0);
    trajectory.advance(0.1, log);
    ASSERT_LT(std::abs(trajectory.state()[1]), 1e-9) << i;
    const double before = trajectory.state()[trajectory.layout().impulse(1)];
    trajectory.advance(0.2, log);
    const double impulse = trajectory.state()[trajectory.layout().impulse(1)] - before;
    EXPECT_NEAR(impulse, 0.1 * stiffness * overlap, 1e-6 * impulse) << i;
  }
}

// Of two equal masses one rests against a stop that remembers its approach speed, on which a force
// presses it, and the other one hits it there: the stop is entered with the speed after the impact.
TEST_P(GuardsAfterImpactsTest, AnImpactComesBeforeTheContactThatItCloses) {
  const double speed = 0.5;
  Model model({single_mass("a", 1, 0, 0), single_mass("b", 1, 0, 0)});
  testing::add_weight(model, 3, {0});
  const auto law =
      HuntCrossley::with_dimensionless_damping({.stiffness = 1e6, .exponent = 1.5}, 0.3, 1e-6);
  ContactPair hit = contact_along_x(model, "b.head", "a.head", 0, newton(0));
  const ContactSet contacts({contact_along_x(model, "a.head", "", 0, law), hit});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(2), vector_of({0, speed}));
  trajectory.advance(1e-4, log);
  EXPECT_NEAR(trajectory.state()[trajectory.layout().internal()], speed / 2, 1e-9);
}

} // namespace guards_after_impacts_tests
} // namespace vibroimpact::motion
