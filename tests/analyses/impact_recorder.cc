// Impact figures of a mass that flies to and fro between two stops, in closed form.
#include "analyses/recorders/energy.h"
#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/impacts.h"
#include "analyses/recorders/statistics.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace impact_recorder_tests {

using namespace contact;
using testing::recorded;
using testing::value_of;

constexpr double pi = std::numbers::pi;
constexpr double mass = 3, speed = 0.4, clearance = 0.01, stop = 3e5;

// A free mass between two equal stops, starting in the middle.
System between_stops(std::shared_ptr<const ContactLaw> law) {
  model::Model model({testing::single_mass("ball", mass, 0, 0)});
  ContactPair right = testing::contact_along_x(model, "ball.head", "", clearance, std::move(law));
  right.name = "right";
  ContactPair left = right;
  left.name = "left";
  left.gap.row *= -1;
  System system = testing::system_of(std::move(model), ContactSet({right, left}));
  system.initial.velocity[0] = speed;
  return system;
}

// Four flights of one clearance and two contacts of half a natural period.
double round_trip() { return 4 * clearance / speed + 2 * pi * std::sqrt(mass / stop); }

TEST(ImpactRecorderTest, FiguresOfElasticImpacts) {
  const System system = between_stops(std::make_shared<LinearPenalty>(stop));
  const PointResult result = recorded<Impacts>(system, periods_window(0, round_trip(), 5));
  const double peak = speed * std::sqrt(mass * stop);
  const double duration = pi * std::sqrt(mass / stop);
  for (const std::string base : {"contact/left/", "contact/right/"}) {
    EXPECT_EQ(value_of(result, base + "impacts"), 5);
    EXPECT_EQ(value_of(result, base + "impacts_per_period"), 1);
    EXPECT_NEAR(value_of(result, base + "contact_fraction"), duration / round_trip(), 1e-8);
    for (const std::string which : {"/mean", "/minimum", "/maximum"}) {
      EXPECT_NEAR(value_of(result, base + "approach_speed" + which), speed, 1e-8);
      EXPECT_NEAR(value_of(result, base + "impulse" + which), 2 * mass * speed, 1e-7);
      EXPECT_NEAR(value_of(result, base + "peak_force" + which), peak, 1e-6 * peak);
      EXPECT_NEAR(value_of(result, base + "contact_duration" + which), duration, 1e-8 * duration);
      EXPECT_NEAR(value_of(result, base + "penetration" + which), peak / stop, 1e-6 * clearance);
    }
  }
}

TEST(ImpactRecorderTest, WithoutImpactsThereAreNoFigures) {
  const System system = between_stops(std::make_shared<LinearPenalty>(stop));
  const PointResult result =
      recorded<Impacts>(system, Window{.start = 0, .end = 0.9 * clearance / speed});
  EXPECT_EQ(value_of(result, "contact/right/impacts"), 0);
  EXPECT_EQ(value_of(result, "contact/right/contact_fraction"), 0);
  EXPECT_TRUE(std::isnan(value_of(result, "contact/right/impulse/mean")));
  EXPECT_FALSE(testing::has_field(result, "contact/right/impacts_per_period"));
}

// The law keeps the approach speed of its latest impact, and some other number before the first.
TEST(ImpactRecorderTest, ALawHasNoApproachSpeedWithoutAnImpact) {
  const System system = between_stops(
      HuntCrossley::with_dimensionless_damping({.stiffness = stop, .exponent = 1.5}, 0.3, 1e-3));
  const std::string right = "contact/right/internal/approach_speed/";
  const auto until = [&](double flights) {
    return recorded<ExtremeValues>(system, Window{.start = 0, .end = flights * clearance / speed},
                                   ObservedSelection{});
  };
  const PointResult before = until(0.9), after = until(1.2);
  for (const std::string which : {"minimum", "maximum", "largest", "peak_to_peak", "amplitude"})
    EXPECT_TRUE(std::isnan(value_of(before, right + which))) << which;
  EXPECT_NEAR(value_of(after, right + "minimum"), speed, 1e-9);
  EXPECT_NEAR(value_of(after, right + "maximum"), speed, 1e-9);
  EXPECT_TRUE(std::isnan(value_of(after, "contact/left/internal/approach_speed/maximum")));
}

// The window ends in the first impact: a half sine of which a quarter and three quarters are over.
TEST(ImpactRecorderTest, AnImpactThatLastsAtTheEndCounts) {
  const System system = between_stops(std::make_shared<LinearPenalty>(stop));
  const double omega = std::sqrt(stop / mass);
  const double peak = speed * std::sqrt(mass * stop);
  for (const double part : {0.25, 0.75}) {
    const Window window{.start = 0, .end = clearance / speed + part * pi / omega};
    const PointResult result = recorded<Impacts>(system, window);
    const double so_far = part < 0.5 ? peak * std::sin(part * pi) : peak;
    EXPECT_EQ(value_of(result, "contact/right/impacts"), 1);
    EXPECT_EQ(value_of(result, "contact/right/unfinished"), 1);
    EXPECT_EQ(value_of(result, "contact/left/unfinished"), 0);
    for (const std::string which : {"/mean", "/minimum", "/maximum"}) {
      EXPECT_NEAR(value_of(result, "contact/right/peak_force" + which), so_far, 1e-7 * peak);
      EXPECT_NEAR(value_of(result, "contact/right/penetration" + which), so_far / stop,
                  1e-7 * peak / stop);
    }
    EXPECT_TRUE(std::isnan(value_of(result, "contact/right/impulse/mean")));
  }
}

TEST(ImpactRecorderTest, TheMeanForceIsTheImpulseOverTime) {
  const System system = between_stops(std::make_shared<LinearPenalty>(stop));
  const PointResult result =
      recorded<Statistics>(system, periods_window(0, round_trip(), 2), ObservedSelection{});
  const double contact = pi * std::sqrt(mass / stop);
  const double peak = speed * std::sqrt(mass * stop);
  EXPECT_NEAR(value_of(result, "contact/left/normal_force/mean"), 2 * mass * speed / round_trip(),
              1e-6);
  EXPECT_NEAR(value_of(result, "contact/left/normal_force/rms"),
              peak * std::sqrt(contact / 2 / round_trip()), 1e-5 * peak);
}

// A dashpot jumps to its force at touch: the largest deceleration is the value just after it.
TEST(ImpactRecorderTest, AccelerationsJustAfterTouchCount) {
  const double constant = 4 * std::sqrt(stop * mass); // twice critical
  const System system = between_stops(std::make_shared<KelvinVoigt>(stop, constant));
  const PointResult result = recorded<ExtremeValues>(
      system, Window{.start = 0, .end = 1.5 * clearance / speed}, ObservedSelection{});
  EXPECT_NEAR(value_of(result, "point/ball.head/acceleration_x/minimum"), -constant * speed / mass,
              1e-6 * constant * speed / mass);
  EXPECT_NEAR(value_of(result, "contact/right/normal_force/maximum"), constant * speed,
              1e-6 * constant * speed);
}

TEST(ImpactRecorderTest, TheStopTakesWhatTheMassLoses) {
  const System system =
      between_stops(std::make_shared<KelvinVoigt>(stop, 0.3 * std::sqrt(stop * mass)));
  const PointResult result =
      recorded<Energy>(system, Window{.start = 0, .end = 1.5 * clearance / speed});
  const double ratio = 0.15;
  const double back =
      std::exp(-2 * ratio * std::acos(ratio) / std::sqrt(1 - ratio * ratio)); // of the speed
  const double loss = mass * speed * speed * (1 - back * back) / 2;
  EXPECT_NEAR(value_of(result, "contact/right/dissipated_energy"), loss, 1e-7 * loss);
  EXPECT_NEAR(value_of(result, "energy/contact_work"), loss, 1e-7 * loss);
  EXPECT_NEAR(value_of(result, "energy/residual"), 0, 1e-7 * loss);
  EXPECT_EQ(value_of(result, "contact/left/dissipated_energy"), 0);
}

TEST(ImpactRecorderTest, TheStopsEndMovesWithTheMass) {
  const System system =
      between_stops(std::make_shared<KelvinVoigtBumper>(stop, 0.3 * std::sqrt(stop * mass)));
  const PointResult result = recorded<ExtremeValues>(
      system, Window{.start = 0, .end = 1.5 * clearance / speed}, ObservedSelection{});
  const double reach = value_of(result, "point/ball.head/displacement_x/maximum");
  EXPECT_GT(reach, clearance);
  EXPECT_NEAR(value_of(result, "contact/right/stop_position/maximum"), reach, 1e-9);
  EXPECT_NEAR(value_of(result, "contact/right/internal/stop_deformation/maximum"),
              reach - clearance, 1e-9);
  EXPECT_EQ(value_of(result, "contact/left/internal/stop_deformation/largest"), 0);
}

} // namespace impact_recorder_tests
} // namespace vibroimpact::analyses
