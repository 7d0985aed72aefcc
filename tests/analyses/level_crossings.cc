// How often levels are passed, when first and for how long: of a sine in closed form, through the
// jumps of rigid impacts, and of what rests at a level.
#include "analyses/recorders/level_crossings.h"

#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace level_crossings_tests {

using namespace model;
using testing::field_of;
using testing::single_mass;
using testing::value_of;

constexpr double pi = std::numbers::pi;
const std::string displacement = "point/block.head/displacement_x";
const std::string velocity = "point/block.head/velocity_x";

std::vector<Observable> observed(const System &system, const std::string &kind) {
  return observables({.points = {}, .kinds = {kind}, .connections = {}}, system);
}

PointResult crossings(const System &system, const Window &window, const std::string &kind,
                      const std::vector<double> &levels, long blocks = 10) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(window.start, system.initial.displacement, system.initial.velocity);
  WindowRecording recording({[&](const System &) {
                              return std::make_unique<LevelCrossings>(
                                  LevelSettings{.levels = levels, .blocks = blocks},
                                  observed(system, kind));
                            }},
                            system);
  recording.run(window, trajectory);
  PointResult result;
  recording.add_fields(result);
  return result;
}

class LevelCrossingsTest : public ::testing::Test {
protected:
  // x = a sin(t) from rest at zero with the velocity a.
  static System system() {
    System system = testing::system_of(Model({single_mass("block", 1, 1, 0)}));
    system.initial.velocity[0] = amplitude;
    return system;
  }
  static constexpr double amplitude = 0.3;
};

TEST_F(LevelCrossingsTest, FractionsAndPassagesInClosedForm) {
  const std::vector<double> levels{-0.4, -0.2, 0.1, 0.25, 0.35};
  const PointResult result =
      crossings(system(), periods_window(0, 2 * pi, 3), "displacement", levels);
  EXPECT_EQ(field_of(result, "crossing_level").values, levels);
  const auto values = [&](const std::string &name) {
    return field_of(result, displacement + "/" + name).values;
  };
  EXPECT_EQ(values("up_crossings"), (std::vector<double>{0, 3, 3, 3, 0}));
  EXPECT_NEAR(values("up_crossing_rate")[2], 1 / (2 * pi), 1e-15);
  EXPECT_NEAR(values("up_crossing_rate_error")[2], 0, 1e-15); // a block is a period
  for (const std::size_t i : {1, 2, 3}) {
    EXPECT_NEAR(values("fraction_above")[i], std::acos(levels[i] / amplitude) / pi, 1e-10);
    EXPECT_NEAR(values("fraction_above_error")[i], 0, 1e-10);
  }
  EXPECT_EQ(values("fraction_above")[0], 1);
  EXPECT_EQ(values("fraction_above")[4], 0);
  const std::vector<double> passages = values("first_passage");
  EXPECT_NEAR(passages[1], pi + std::asin(0.2 / amplitude), 1e-10); // downwards
  EXPECT_NEAR(passages[2], std::asin(0.1 / amplitude), 1e-10);
  EXPECT_TRUE(std::isnan(passages[0]) && std::isnan(passages[4]));
}

// Four blocks of a period and a half hold two passages or one, in turn.
TEST_F(LevelCrossingsTest, BlocksOfAWindowWithoutPeriods) {
  const PointResult result =
      crossings(system(), Window{.start = 0, .end = 12 * pi}, "displacement", {0.1}, 4);
  EXPECT_EQ(value_of(result, displacement + "/up_crossings"), 6);
  const double error = std::sqrt(1.0 / 3) / (6 * pi); // but that blocks end with steps
  EXPECT_GT(value_of(result, displacement + "/up_crossing_rate_error"), error / 2);
  EXPECT_LT(value_of(result, displacement + "/up_crossing_rate_error"), 2 * error);
}

TEST_F(LevelCrossingsTest, WhatRestsAtALevelDoesNotPassIt) {
  const System still = testing::system_of(Model({single_mass("block", 1, 1, 0)}));
  const PointResult result =
      crossings(still, Window{.start = 0, .end = 5}, "displacement", {-1, 0, 1});
  EXPECT_EQ(field_of(result, displacement + "/up_crossings").values,
            (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(field_of(result, displacement + "/fraction_above").values,
            (std::vector<double>{1, 0, 0}));
}

// A mass bounces elastically on a stop at its place at rest: v = -a cos t over half a period, then
// its velocity jumps from a to -a, past all levels between.
TEST_F(LevelCrossingsTest, JumpsPassLevels) {
  System bouncing = system();
  bouncing.contacts = contact::ContactSet({testing::contact_along_x(
      bouncing.model, "block.head", "", 0, std::make_shared<contact::NewtonRestitution>(1.0))});
  bouncing.initial.velocity[0] = -amplitude;
  const PointResult result =
      crossings(bouncing, Window{.start = 0, .end = 3.5 * pi}, "velocity", {-0.1, 0.1, 0.31});
  EXPECT_EQ(field_of(result, velocity + "/up_crossings").values, (std::vector<double>{4, 3, 0}));
  EXPECT_NEAR(field_of(result, velocity + "/first_passage").values[1], std::acos(-0.1 / amplitude),
              1e-9);
}

// Steps end where a contact closes or opens; at that level too each passage counts once.
TEST_F(LevelCrossingsTest, LevelAtWhichAContactCloses) {
  for (const double clearance : {0.1, 0.07, 0.123}) {
    System stopped = system();
    stopped.contacts = contact::ContactSet({testing::contact_along_x(
        stopped.model, "block.head", "", clearance, std::make_shared<contact::LinearPenalty>(30))});
    const PointResult result = crossings(stopped, Window{.start = 0, .end = 400}, "displacement",
                                         {clearance - 1e-7, clearance, clearance + 1e-7});
    const std::vector<double> &rises = field_of(result, displacement + "/up_crossings").values;
    EXPECT_GT(rises[0], 80);
    EXPECT_EQ(rises[1], rises[0]);
    EXPECT_EQ(rises[1], rises[2]);
  }
}

} // namespace level_crossings_tests
} // namespace vibroimpact::analyses
