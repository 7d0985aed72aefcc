// The mass on a spring and two coupled masses, in closed form.
#include "analyses/sweeps/frequency_response.h"

#include "common/error.h"
#include "model/side.h"
#include "support/lumped_models.h"
#include "support/points.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace frequency_response_tests {

using namespace model;

constexpr double mass = 2, stiffness = 800, ratio = 0.1, omega_0 = 20; // sqrt(800 / 2)
constexpr double pi = std::numbers::pi;

std::shared_ptr<const TimeFunction> harmonic(Given given, double amplitude, double phase = 0) {
  return std::make_shared<Harmonic>(given, amplitude, 1.0, phase);
}

System oscillator() {
  Model model({testing::single_mass("block", mass, stiffness, 2 * ratio * omega_0 * mass)});
  return {.model = std::move(model),
          .contacts = {},
          .integration = {},
          .initial = {.displacement = Vector::Zero(1), .velocity = Vector::Zero(1)}};
}

System pushed(double force, double phase) {
  System system = oscillator();
  system.model.add_force("push", harmonic(Given::displacement, force, phase), {}, Vector3::UnitX());
  return system;
}

std::vector<double> frequencies(double first, double last, int points) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i)
    values.push_back(first + (last - first) * i / (points - 1));
  return values;
}

testing::Points response(System system, const std::vector<double> &at) {
  testing::Points points;
  FrequencyResponse({.frequencies = at, .excitation = ""}).run_line(0, system, points);
  return points;
}

TEST(FrequencyResponseTest, AForceMovesTheMassByTheClosedForm) {
  const std::vector<double> at = frequencies(0.5, 8, 16);
  const testing::Points points = response(pushed(5, 0.3), at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double beta = 2 * pi * at[k] / omega_0;
    const std::complex<double> gain = 1.0 / std::complex<double>(1 - beta * beta, 2 * ratio * beta);
    const double amplitude = 5 / stiffness * std::abs(gain);
    EXPECT_NEAR(points.values({}, "point/block.head/displacement_x/amplitude")[k], amplitude,
                1e-13 * amplitude);
    EXPECT_NEAR(points.values({}, "point/block.head/displacement_x/phase")[k], std::arg(gain) + 0.3,
                1e-12);
    EXPECT_NEAR(points.values({}, "point/block.head/acceleration_x/amplitude")[k],
                amplitude * std::pow(2 * pi * at[k], 2), 1e-10);
  }
}

TEST(FrequencyResponseTest, ThePeakIsRefinedFromACoarseGrid) {
  const testing::Points points = response(pushed(5, 0), frequencies(1, 7, 9));
  const double amplitude = 5 / stiffness / (2 * ratio * std::sqrt(1 - ratio * ratio));
  EXPECT_NEAR(points.value({}, "peak/point/block.head/displacement_x/amplitude"), amplitude, 1e-13);
  EXPECT_NEAR(points.value({}, "peak/point/block.head/displacement_x/frequency"),
              omega_0 * std::sqrt(1 - 2 * ratio * ratio) / (2 * pi), 1e-6);
}

// Velocity resonance is at the natural frequency whatever the damping.
TEST(FrequencyResponseTest, TheVelocityPeaksAtTheNaturalFrequency) {
  const testing::Points points = response(pushed(5, 0), frequencies(1, 7, 9));
  EXPECT_NEAR(points.value({}, "peak/point/block.head/velocity_x/frequency"), omega_0 / (2 * pi),
              1e-6);
}

TEST(FrequencyResponseTest, AMovingBaseIsTransmitted) {
  for (const Given given : {Given::displacement, Given::acceleration}) {
    System system = oscillator();
    system.model.add_base_motion("floor", harmonic(given, 0.01), {0}, Vector3::UnitX());
    const std::vector<double> at = frequencies(1, 8, 8);
    const testing::Points points = response(std::move(system), at);
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double omega = 2 * pi * at[k], beta = omega / omega_0;
      const double below = std::hypot(1 - beta * beta, 2 * ratio * beta);
      const double floor = given == Given::displacement ? 0.01 : 0.01 / (omega * omega);
      const double transmitted = floor * std::hypot(1, 2 * ratio * beta) / below;
      EXPECT_NEAR(points.values({}, "point/block.head/absolute_displacement_x/amplitude")[k],
                  transmitted, 1e-12 * transmitted);
      EXPECT_NEAR(points.values({}, "point/block.head/displacement_x/amplitude")[k],
                  floor * beta * beta / below, 1e-12 * floor);
    }
  }
}

TEST(FrequencyResponseTest, AnUndampedResonanceFailsWithAReason) {
  Model model({testing::single_mass("block", 1, 4 * pi * pi, 0)});
  model.add_force("push", harmonic(Given::displacement, 1), {}, Vector3::UnitX());
  const testing::Points points =
      response({.model = std::move(model), .contacts = {}, .integration = {}, .initial = {}}, {1});
  EXPECT_EQ(points.all().at({}).status, Status::failed);
}

TEST(FrequencyResponseTest, NoExcitationIsRefused) {
  const FrequencyResponse analysis({.frequencies = {1}, .excitation = ""});
  EXPECT_THROW(analysis.check(oscillator()), InputError);
}

// A block on a shaken base and one on the floor, joined along x by a contact that is tied: they
// move as one where both are pushed, and as the base and the floor have it where that shakes.
System joined(bool shaken) {
  Model model({testing::single_mass("one", 2, 800, 3), testing::single_mass("other", 5, 300, 1)});
  if (shaken)
    model.add_base_motion("shaker", harmonic(Given::displacement, 0.01), {0}, Vector3::UnitX());
  else
    model.add_force("push", harmonic(Given::displacement, 5), {}, Vector3::UnitX());
  System system = testing::system_of(std::move(model));
  return system;
}

testing::Points tied_response(const System &system, double frequency) {
  const PointReference one{.body = 0}, other{.body = 1};
  const auto tied = [&](const System &of) {
    return std::vector{relative_displacement(one, other, true, Vector3::UnitX(), of.model)};
  };
  testing::Points points;
  System copy = system;
  FrequencyResponse({.frequencies = {frequency}, .excitation = "", .tied = tied})
      .run_line(0, copy, points);
  return points;
}

// (1100 - 7 w^2 + 4 i w) u = F, or of u in space with the springs' forces from the moving base.
TEST(FrequencyResponseTest, TiedSidesMoveTogether) {
  const double frequency = 1.7, w = 2 * pi * frequency;
  const std::complex<double> dynamic(1100 - 7 * w * w, 4 * w);
  const testing::Points pushed = tied_response(joined(false), frequency);
  const double amplitude = 5 / std::abs(dynamic);
  for (const std::string point : {"one", "other"})
    EXPECT_NEAR(pushed.values({}, "point/" + point + ".head/displacement_x/amplitude")[0],
                amplitude, 1e-13 * amplitude);
  const testing::Points shaken = tied_response(joined(true), frequency);
  const double moved = std::abs(std::complex<double>(800, 3 * w) / dynamic) * 0.01;
  EXPECT_NEAR(shaken.values({}, "point/one.head/absolute_displacement_x/amplitude")[0], moved,
              1e-13 * moved);
  EXPECT_NEAR(shaken.values({}, "point/other.head/displacement_x/amplitude")[0], moved,
              1e-13 * moved);
}

} // namespace frequency_response_tests
} // namespace vibroimpact::analyses
