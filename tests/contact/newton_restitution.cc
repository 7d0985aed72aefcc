// The rigid law by itself: what it tells the integration, and what a motion shows of it.
#include "contact/laws/newton_restitution.h"
#include "support/law_checks.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

namespace vibroimpact::contact {
namespace newton_restitution_tests {

using testing::LawPoint;

TEST(NewtonRestitutionTest, ModesAndGuards) {
  const NewtonRestitution law(0.3);
  ASSERT_EQ(law.modes().size(), 2U);
  const Mode &open = law.modes()[0];
  const Mode &resting = law.modes()[1];
  EXPECT_FALSE(open.in_contact);
  EXPECT_FALSE(open.holds_gap);
  ASSERT_EQ(open.guards.size(), 1U);
  EXPECT_EQ(open.guards[0].action, GuardAction::impact);
  EXPECT_EQ(open.guards[0].target, 1);
  EXPECT_EQ(open.guards[0].indicator({.gap = 0.2, .gap_rate = -3}), 0.2);
  EXPECT_TRUE(resting.in_contact);
  EXPECT_TRUE(resting.holds_gap);
  ASSERT_EQ(resting.guards.size(), 1U);
  EXPECT_EQ(resting.guards[0].action, GuardAction::change_mode);
  EXPECT_EQ(resting.guards[0].indicator({.normal_force = 7}), 7);
  EXPECT_TRUE(law.rigid());
  for (const double speed : {1e-6, 1.0, 50.0})
    EXPECT_EQ(law.restitution(speed), 0.3);
}

TEST(NewtonRestitutionTest, ForceIsWhatHoldsTheGap) {
  const NewtonRestitution law(0.3);
  testing::check_law(law, LawPoint{.mode = 0, .gap = 0.1, .gap_rate = -1});
  LawResponse response;
  const LocalState rest{.gap = 0, .gap_rate = 1e-9, .normal_force = 12};
  law.evaluate(1, rest, response);
  EXPECT_EQ(response.force, 12);
  EXPECT_EQ(response.stored_energy, 0);
  EXPECT_DOUBLE_EQ(response.dissipated_power, -12e-9);
  EXPECT_EQ(law.modes()[1].affine->force(rest), 12);
  law.evaluate(0, rest, response);
  EXPECT_EQ(response.force, 0);
}

// Impacts, chatter, rest and release on a shaken base.
TEST(NewtonRestitutionTest, GuardsArePositiveInTheirModes) {
  model::Model model({testing::single_mass("block", 1, 20, 0.3)});
  model.add_force("push", std::make_shared<model::Harmonic>(model::Given::displacement, 9, 3, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts(
      {testing::contact_along_x(model, "block.head", "", 0.02, testing::newton(0.4))});
  motion::Trajectory trajectory(model, contacts, {});
  testing::GuardWatch guards;
  testing::Events events;
  motion::Observers observers({&guards, &events});
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  trajectory.advance(20, observers);
  EXPECT_GT(trajectory.accuracy().chatters, 5);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-12);
}

} // namespace newton_restitution_tests
} // namespace vibroimpact::contact
