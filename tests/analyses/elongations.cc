// Elongations of connections: the motion of two points relative to each other, in closed form, and
// where a base moves one of them.
#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/history.h"
#include "analyses/recorders/section.h"
#include "analyses/sweeps/frequency_response.h"
#include "model/side.h"
#include "support/points.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace vibroimpact::analyses {
namespace elongations_tests {

using namespace model;
using testing::field_of;
using testing::recorded;
using testing::value_of;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double mass = 2, damping = 8, omega = 13, force = 5, base = 0.01;
constexpr double first = 800, second = 500; // stiffness of the two blocks
const std::string gauge = "connection/gauge/elongation";

Complex impedance(double stiffness) { return {stiffness - mass * omega * omega, omega * damping}; }

std::shared_ptr<const TimeFunction> harmonic(double amplitude) {
  return std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0);
}

// Measures and does nothing.
void add_gauge(const Sides &sides, Model &model) {
  model.add_connection({.name = "gauge",
                        .side_a = sides.a,
                        .side_b = sides.b,
                        .elongation = relative_displacement(sides, Vector3::UnitX(), model)});
}

void start_steady(System &system, const std::vector<Complex> &amplitudes) {
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    system.initial.displacement[static_cast<Index>(i)] = amplitudes[i].imag();
    system.initial.velocity[static_cast<Index>(i)] = omega * amplitudes[i].real();
  }
}

// Two blocks with a spring each, both pushed by force sin(omega t).
System two_blocks() {
  Model model({testing::single_mass("one", mass, first, damping),
               testing::single_mass("other", mass, second, damping)});
  for (std::size_t body : {0, 1})
    model.add_force("push" + std::to_string(body), harmonic(force), {.body = body},
                    Vector3::UnitX());
  add_gauge({.a = "one.head", .b = "other.head"}, model);
  System system = testing::system_of(std::move(model));
  start_steady(system, {force / impedance(first), force / impedance(second)});
  return system;
}

// One block on a base that moves by base sin(omega t).
System shaken_block(const std::string &end) {
  Model model({testing::single_mass("one", mass, first, damping)});
  model.add_base_motion("floor", harmonic(base), {0}, Vector3::UnitX());
  add_gauge({.a = "one.head", .b = end}, model);
  System system = testing::system_of(std::move(model));
  start_steady(system, {mass * omega * omega * base / impedance(first)});
  return system;
}

Window three_periods() { return periods_window(0, 2 * pi / omega, 3); }

double largest_elongation(const System &system, const std::string &quantity) {
  return value_of(recorded<ExtremeValues>(system, three_periods(), ObservedSelection{}),
                  "connection/gauge/" + quantity + "/maximum");
}

TEST(ElongationsTest, OfTwoBlocks) {
  const double amplitude = std::abs(force / impedance(second) - force / impedance(first));
  EXPECT_NEAR(largest_elongation(two_blocks(), "elongation"), amplitude, 1e-13 * amplitude);
  EXPECT_NEAR(largest_elongation(two_blocks(), "elongation_rate"), omega * amplitude,
              1e-13 * omega * amplitude);
  EXPECT_NEAR(largest_elongation(two_blocks(), "elongation_acceleration"),
              omega * omega * amplitude, 1e-12 * omega * omega * amplitude);
}

TEST(ElongationsTest, FromTheBaseAndFromTheGround) {
  const double relative = std::abs(mass * omega * omega * base / impedance(first));
  const double absolute = std::abs(Complex(first, omega * damping) / impedance(first)) * base;
  EXPECT_NEAR(largest_elongation(shaken_block(side_base), "elongation"), relative,
              1e-13 * relative);
  EXPECT_NEAR(largest_elongation(shaken_block(side_ground), "elongation"), absolute,
              1e-13 * absolute);
}

// Samples at the ends of the periods see the base's own motion too.
TEST(ElongationsTest, InSections) {
  const System system = shaken_block(side_ground);
  std::vector<Observable> observed =
      point_observables(system.model, {.points = {}, .kinds = {"elongation_rate"}});
  ASSERT_EQ(observed.size(), 1u);
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  SectionRecorder section(system, {.observed = observed, .maximum_samples = 9});
  const Window window = three_periods();
  section.begin(window, trajectory);
  trajectory.advance(2 * pi / omega, section);
  section.period_end(1, trajectory);
  PointResult result;
  section.add_fields(result);
  const Complex absolute = Complex(first, omega * damping) / impedance(first) * base;
  EXPECT_NEAR(field_of(result, "section/period/connection/gauge/elongation_rate").values.at(0),
              -omega * absolute.real(), 1e-13 * omega * std::abs(absolute));
}

TEST(ElongationsTest, InFrequencyResponses) {
  Model model({testing::single_mass("one", mass, first, damping),
               testing::single_mass("other", mass, second, damping)});
  model.add_force("push", harmonic(force), {}, Vector3::UnitX());
  add_gauge({.a = "one.head", .b = "other.head"}, model);
  System system = testing::system_of(std::move(model));
  testing::Points points;
  FrequencyResponse({.frequencies = {omega / (2 * pi), 3}, .excitation = ""})
      .run_line(0, system, points);
  EXPECT_NEAR(points.values({}, gauge + "/amplitude")[0], force / std::abs(impedance(first)),
              1e-15);
}

TEST(ElongationsTest, OfChosenConnectionsOnly) {
  const System system = two_blocks();
  const PointResult result = recorded<ExtremeValues>(
      system, three_periods(),
      ObservedSelection{.points = {"one.head"}, .kinds = {"elongation"}, .connections = {"gauge"}});
  ASSERT_FALSE(result.fields.empty());
  for (const Field &field : result.fields)
    EXPECT_TRUE(field.name().starts_with(gauge + "/")) << field.name();
}

} // namespace elongations_tests
} // namespace vibroimpact::analyses
