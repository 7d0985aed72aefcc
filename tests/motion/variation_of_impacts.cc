// Rigid impacts on shaken bases: periodic motions in closed form with their stability limit, and
// the variational equation through impacts, rest and release.
#include "common/decompositions.h"
#include "motion/variation/variation.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace variation_of_impacts_tests {

using namespace model;
using contact::ContactSet;
using testing::add_weight;
using testing::contact_along_x;
using testing::Events;
using testing::newton;
using testing::single_mass;
using testing::stop_on_base;
using testing::vector_of;

constexpr double gravity = 9.81;

// A ball on a table A sin(w t), one impact per period T. Upwards counted, it leaves with g T / 2
// and comes with -g T / 2 where the table has the speed V = (1 - e) / (1 + e) g T / 2 and the
// acceleration -a, V^2 w^2 + a^2 = (A w^2)^2. Small deviations of the instant and of the speed
// after the impact obey a linear map with the determinant e^2 and the trace 1 + e^2 - (1 + e)^2
// a/g, so that it is stable for 0 < a < 2 g (1 + e^2) / (1 + e)^2.
struct Table {
  double e = 0.5, omega = 30, part_of_limit = 0.5;

  double period() const { return 2 * std::numbers::pi / omega; }
  double speed() const { return (1 - e) / (1 + e) * gravity * period() / 2; }
  double acceleration() const {
    return part_of_limit * 2 * gravity * (1 + e * e) / ((1 + e) * (1 + e));
  }
  double amplitude() const { return std::hypot(speed() * omega, acceleration()) / (omega * omega); }
  // The ball moves along x, downwards.
  double impact_time() const {
    return (std::numbers::pi + std::acos(speed() / (amplitude() * omega))) / omega;
  }
  double trace() const { return 1 + e * e - (1 + e) * (1 + e) * acceleration() / gravity; }

  Model model() const {
    Model model({single_mass("ball", 2, 0, 0)});
    model.add_base_motion("table",
                          std::make_shared<Harmonic>(Given::displacement, amplitude(), omega, 0),
                          {0}, Vector3::UnitX());
    add_weight(model, gravity, {0});
    return model;
  }
  // Half a period after an impact, relative to the table.
  MotionState start() const {
    const double t = impact_time() + period() / 2;
    const double top = gravity * period() * period() / 8;
    const double table = amplitude() * std::sin(omega * t);
    const double at_impact = amplitude() * std::sin(omega * impact_time());
    return {.time = t,
            .physical =
                vector_of({at_impact - top - table, -amplitude() * omega * std::cos(omega * t)})};
  }
};

TEST(VariationOfImpactsTest, PeriodicBallOnATable) {
  for (const double e : {0.0, 0.5, 0.9}) {
    const Table table{.e = e};
    const Model model = table.model();
    const ContactSet contacts({stop_on_base(model, "ball.head", 0, newton(e))});
    Trajectory trajectory(model, contacts, {});
    trajectory.start(table.start());
    Variation variation(trajectory, Vector::Ones(2), 1e-11);
    variation.set_columns(Matrix::Identity(2, 2));
    Events events;
    Observers observers({&events, &variation});
    trajectory.advance(table.start().time + table.period(), observers);
    ASSERT_EQ(events.list.size(), 1U);
    EXPECT_NEAR(events.list[0].time, table.impact_time() + table.period(), 1e-11);
    EXPECT_NEAR(events.list[0].gap_rate, -gravity * table.period() / 2 - table.speed(), 1e-10);
    EXPECT_LT((trajectory.motion_state().physical - table.start().physical).norm(), 1e-11);
    EXPECT_NEAR(variation.columns().trace(), table.trace(), 1e-8) << e;
    EXPECT_NEAR(determinant(variation.columns()), e * e, 1e-8) << e;
    EXPECT_EQ(variation.tangential_events(), 0);
  }
}

// A small deviation dies out below the limit and grows above it.
TEST(VariationOfImpactsTest, StabilityLimitOfTheBall) {
  for (const double part : {0.9, 1.1}) {
    const Table table{.e = 0.6, .part_of_limit = part};
    const Model model = table.model();
    const ContactSet contacts({stop_on_base(model, "ball.head", 0, newton(table.e))});
    Trajectory trajectory(model, contacts, {});
    MotionState start = table.start();
    start.physical[1] += 1e-6;
    trajectory.start(start);
    trajectory.advance(start.time + 100 * table.period());
    const double deviation = (trajectory.motion_state().physical - table.start().physical).norm();
    EXPECT_TRUE(part < 1 ? deviation < 1e-8 : deviation > 1e-4) << deviation;
  }
}

Vector flow(const Model &model, const ContactSet &contacts, const MotionState &start, double end,
            const Settings &settings) {
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(start);
  Events events;
  trajectory.advance(end, events);
  return trajectory.motion_state().physical;
}

void compare_with_differences(const Model &model, const ContactSet &contacts,
                              const MotionState &start, double end, std::size_t least_events) {
  const Settings settings{.relative_tolerance = 1e-12, .event_tolerance = 1e-14};
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(start);
  const Index size = start.physical.size();
  Variation variation(trajectory, Vector::Ones(size), 1e-11);
  variation.set_columns(Matrix::Identity(size, size));
  Events events;
  Observers observers({&events, &variation});
  trajectory.advance(end, observers);
  EXPECT_GE(events.list.size(), least_events);
  EXPECT_EQ(variation.tangential_events(), 0);
  const double epsilon = 1e-6;
  Matrix differences(size, size);
  for (Index j = 0; j < size; ++j) {
    MotionState up = start;
    MotionState down = start;
    up.physical[j] += epsilon;
    down.physical[j] -= epsilon;
    differences.col(j) =
        (flow(model, contacts, up, end, settings) - flow(model, contacts, down, end, settings)) /
        (2 * epsilon);
  }
  EXPECT_LT((variation.columns() - differences).cwiseAbs().maxCoeff(),
            1e-5 * differences.cwiseAbs().maxCoeff());
}

TEST(VariationOfImpactsTest, TwoMassesAndAMovingBase) {
  Model model({single_mass("a", 1, 40, 0.5), single_mass("b", 2, 10, 0.1)});
  model.add_base_motion("shake", std::make_shared<Harmonic>(Given::acceleration, 2, 9, 0.3), {0},
                        Vector3::UnitX());
  const ContactSet contacts({contact_along_x(model, "a.head", "b.head", 0.02, newton(0.7)),
                             contact_along_x(model, "b.head", "", 0.04, newton(0.9))});
  compare_with_differences(model, contacts,
                           {.time = 0.2, .physical = vector_of({-0.1, 0.0, 0.8, 0.3})}, 2.5, 5);
}

// It bounces, chatters, rests, and is thrown off again.
TEST(VariationOfImpactsTest, ThroughRestAndRelease) {
  const double omega = 9;
  Model model({single_mass("ball", 1, 0, 0), single_mass("table", 3, 600, 2)});
  add_weight(model, gravity, {0});
  model.add_force("push",
                  std::make_shared<Harmonic>(Given::displacement, 150, omega, std::numbers::pi),
                  {.body = 1, .point = 0}, Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "ball.head", "table.head", 0.001, newton(0.1))});
  const MotionState start{.time = 0, .physical = vector_of({0, 0, 0, 0})};
  Trajectory trajectory(model, contacts, {});
  trajectory.start(start);
  Events events;
  trajectory.advance(0.9, events);
  long rests = 0;
  for (const Events::Event &event : events.list)
    rests += event.from == 1 && event.to == 0 ? 1 : 0;
  EXPECT_GE(rests, 1);
  compare_with_differences(model, contacts, start, 0.9, 4);
}

TEST(VariationOfImpactsTest, ImpactsAtTheSameInstantHaveNoDerivative) {
  const Model model(
      {single_mass("a", 1, 0, 0), single_mass("b", 1, 0, 0), single_mass("c", 1, 0, 0)});
  const ContactSet contacts({contact_along_x(model, "a.head", "b.head", 0.1, newton(1)),
                             contact_along_x(model, "b.head", "c.head", 0.1, newton(1))});
  Trajectory trajectory(model, contacts, {});
  trajectory.start(0, Vector::Zero(3), vector_of({1, 0, -1}));
  Variation variation(trajectory, Vector::Ones(6), 1e-9);
  variation.set_columns(Matrix::Identity(6, 6));
  trajectory.advance(0.2, variation);
  EXPECT_EQ(variation.tangential_events(), 1);
}

} // namespace variation_of_impacts_tests
} // namespace vibroimpact::motion
