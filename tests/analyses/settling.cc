// When settling ends, on motions that never repeat and motions that do.
#include "analyses/sweeps/settling.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vibroimpact::analyses {
namespace settling_tests {

constexpr double forcing = 8; // [rad/s]
constexpr double period = 2 * std::numbers::pi / forcing;

// From rest on a base shaken at 8 rad/s. Without damping the vibration at sqrt(200) rad/s that the
// start sets off stays for ever.
SettledMotion settled(double damping, const SettlingRule &rule) {
  model::Model model({testing::single_mass("block", 1, 200, damping)});
  model.add_base_motion(
      "floor", std::make_shared<model::Harmonic>(model::Given::displacement, 0.01, forcing, 0), {0},
      Vector3::UnitX());
  const System system = testing::system_of(std::move(model));
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  return Settler(trajectory)(period, Vector::Ones(2), rule);
}

SettlingRule rule(long without_approach) {
  return {.minimum = 5,
          .maximum = 300,
          .tolerance = 1e-6,
          .longest_multiple = 4,
          .without_approach = without_approach};
}

TEST(SettlingTest, AllPeriodsWhereNothingElseIsAsked) {
  const SettledMotion motion = settled(0, rule(0));
  EXPECT_EQ(motion.cycles, 300);
  EXPECT_FALSE(motion.steady());
}

TEST(SettlingTest, EndsEarlyWhereNothingComesNearer) {
  const SettledMotion motion = settled(0, rule(20));
  EXPECT_GE(motion.cycles, 20);
  EXPECT_LT(motion.cycles, 200);
  EXPECT_FALSE(motion.steady());
}

TEST(SettlingTest, TheLeastPeriodsAreTakenAllTheSame) {
  SettlingRule patient = rule(3);
  patient.minimum = 250;
  EXPECT_EQ(settled(0, patient).cycles, 250);
}

// A motion that settles does so in the same number of periods.
TEST(SettlingTest, AnApproachIsLeftInPeace) {
  for (const double damping : {0.5, 5.0}) {
    const SettledMotion motion = settled(damping, rule(20));
    EXPECT_TRUE(motion.steady());
    EXPECT_EQ(motion.cycles, settled(damping, rule(0)).cycles);
  }
}

} // namespace settling_tests
} // namespace vibroimpact::analyses
