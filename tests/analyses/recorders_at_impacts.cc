// What recorders tell of rigid impacts, where velocities jump: a free block between two stops.
#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/impacts.h"
#include "analyses/recorders/section.h"
#include "support/recorded_windows.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace recorders_at_impacts_tests {

using contact::ContactPair;
using testing::field_of;
using testing::recorded;
using testing::value_of;

constexpr double mass = 2, clearance = 0.1;

// At 1 m/s towards the right stop. With e = 1/2 it hits the right one at 0.1 s with 1 m/s, the left
// one at 0.5 s with 1/2 m/s, and the right one again at 1.3 s with 1/4 m/s.
System between_stops() {
  model::Model model({testing::single_mass("block", mass, 0, 0)});
  ContactPair right =
      testing::contact_along_x(model, "block.head", "", clearance, testing::newton(0.5));
  ContactPair left = right;
  right.name = "right";
  left.name = "left";
  left.gap.row *= -1;
  System system = testing::system_of(std::move(model), contact::ContactSet({right, left}));
  system.initial.velocity[0] = 1;
  return system;
}

void expect_near(const std::vector<double> &values, const std::vector<double> &expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], expected[i], 1e-9) << i;
}

PointResult sections() {
  const System system = between_stops();
  SectionRecorder section(
      system, {.onsets = {0, 1}, .gap_extrema = {0}, .extrema = true, .maximum_samples = 100});
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  section.begin({.start = 0, .end = 2}, trajectory);
  trajectory.advance(2, section);
  PointResult result;
  section.add_fields(result);
  return result;
}

const std::string velocity = "/point/block.head/velocity_x";
const std::string displacement = "/point/block.head/displacement_x";

// An onset is the end of the approach.
TEST(RecordersAtImpactsTest, OnsetsHaveTheApproachSpeed) {
  const PointResult result = sections();
  expect_near(field_of(result, "section/onset/right/time").values, {0.1, 1.3});
  expect_near(field_of(result, "section/onset/right" + velocity).values, {1, 0.25});
  expect_near(field_of(result, "section/onset/left" + velocity).values, {-0.5});
  expect_near(field_of(result, "section/onset/left" + displacement).values, {-clearance});
}

// Gap and displacement turn at the impacts, where their rates jump through zero, and nowhere else.
TEST(RecordersAtImpactsTest, ExtremaWhereTheRateJumps) {
  const PointResult result = sections();
  for (const std::string name : {"gap_extremum/right", "extremum/block.head/displacement_x"}) {
    expect_near(field_of(result, "section/" + name + "/time").values, {0.1, 0.5, 1.3});
    expect_near(field_of(result, "section/" + name + displacement).values,
                {clearance, -clearance, clearance});
  }
}

// Impulse (1 + e) m v each.
TEST(RecordersAtImpactsTest, SpeedsAndImpulses) {
  const PointResult result = recorded<Impacts>(between_stops(), Window{.end = 2});
  const std::string right = "contact/right/";
  EXPECT_EQ(value_of(result, right + "impacts"), 2);
  EXPECT_EQ(value_of(result, "contact/left/impacts"), 1);
  EXPECT_NEAR(value_of(result, right + "approach_speed/maximum"), 1, 1e-9);
  EXPECT_NEAR(value_of(result, right + "approach_speed/minimum"), 0.25, 1e-9);
  EXPECT_NEAR(value_of(result, right + "approach_speed/mean"), 0.625, 1e-9);
  EXPECT_NEAR(value_of(result, right + "impulse/maximum"), 1.5 * mass, 1e-9);
  EXPECT_NEAR(value_of(result, "contact/left/impulse/mean"), 0.75 * mass, 1e-9);
}

TEST(RecordersAtImpactsTest, ExtremeValuesOfVelocitiesThatJump) {
  const PointResult result =
      recorded<ExtremeValues>(between_stops(), Window{.end = 1}, ObservedSelection{});
  EXPECT_NEAR(value_of(result, "point/block.head/velocity_x/maximum"), 1, 1e-12);
  EXPECT_NEAR(value_of(result, "point/block.head/velocity_x/minimum"), -0.5, 1e-12);
  EXPECT_NEAR(value_of(result, "point/block.head/displacement_x/minimum"), -clearance, 1e-12);
}

} // namespace recorders_at_impacts_tests
} // namespace vibroimpact::analyses
