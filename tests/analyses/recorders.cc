// What recorders tell of a linear oscillator in its steady motion, in closed form: extreme values,
// averages, works, forces, and which of them are stored.
#include "analyses/recorders/recorders.h"

#include "analyses/recorders/energy.h"
#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/forces.h"
#include "analyses/recorders/history.h"
#include "analyses/recorders/quasi_static.h"
#include "analyses/recorders/statistics.h"
#include "contact/laws/linear_penalty.h"
#include "model/piecewise_function.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace vibroimpact::analyses {
namespace recorders_tests {

using namespace model;
using testing::field_of;
using testing::has_field;
using testing::recorded;
using testing::value_of;

constexpr double pi = std::numbers::pi;
constexpr double mass = 2, stiffness = 800, damping = 8, omega = 13;
constexpr double force = 5, offset = 12, base = 0.01;
using Complex = std::complex<double>;
const Complex impedance(stiffness - mass * omega * omega, omega *damping);
const std::string displacement = "point/block.head/displacement_x";
const std::string acceleration = "point/block.head/acceleration_x";
const std::string base_force = "body/block/base_force_x";

std::shared_ptr<const TimeFunction> harmonic(double amplitude) {
  return std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0);
}

// Starts in the steady motion Im(amplitude exp(i omega t)) + mean.
void start_steady(System &system, Complex amplitude, double mean) {
  system.initial.displacement[0] = amplitude.imag() + mean;
  system.initial.velocity[0] = omega * amplitude.real();
}

// Pushed by force sin(omega t) + offset.
System pushed() {
  Model model({testing::single_mass("block", mass, stiffness, damping)});
  model.add_force("push", harmonic(force), {}, Vector3::UnitX());
  model.add_force("lean", make_constant(Given::displacement, offset), {}, Vector3::UnitX());
  System system = testing::system_of(std::move(model));
  start_steady(system, force / impedance, offset / stiffness);
  return system;
}

// On a base that moves by base sin(omega t).
System shaken() {
  Model model({testing::single_mass("block", mass, stiffness, damping)});
  model.add_base_motion("floor", harmonic(base), {0}, Vector3::UnitX());
  System system = testing::system_of(std::move(model));
  start_steady(system, mass * omega * omega * base / impedance, 0);
  return system;
}

Window three_periods() { return periods_window(0, 2 * pi / omega, 3); }

TEST(RecordersTest, ExtremeValuesOfASine) {
  const PointResult result =
      recorded<ExtremeValues>(pushed(), three_periods(), ObservedSelection{});
  const double amplitude = force / std::abs(impedance);
  const double mean = offset / stiffness;
  EXPECT_NEAR(value_of(result, displacement + "/peak_to_peak"), 2 * amplitude, 1e-10);
  EXPECT_NEAR(value_of(result, displacement + "/amplitude"), amplitude, 1e-10);
  EXPECT_NEAR(value_of(result, displacement + "/largest"), mean + amplitude, 1e-10);
  EXPECT_NEAR(value_of(result, displacement + "/minimum"), mean - amplitude, 1e-10);
  EXPECT_NEAR(value_of(result, displacement + "/maximum"), mean + amplitude, 1e-10);
  EXPECT_NEAR(value_of(result, "point/block.head/velocity_x/largest"), omega * amplitude, 1e-8);
  EXPECT_NEAR(value_of(result, acceleration + "/minimum"), -omega * omega * amplitude, 1e-6);
  EXPECT_FALSE(has_field(result, "point/block.head/absolute_displacement_x/maximum"));
}

TEST(RecordersTest, ExtremeValuesInSpaceWhereTheBaseMoves) {
  const PointResult result =
      recorded<ExtremeValues>(shaken(), three_periods(), ObservedSelection{});
  const double amplitude = std::abs(Complex(stiffness, omega * damping) / impedance) * base;
  EXPECT_NEAR(value_of(result, "point/block.head/absolute_displacement_x/maximum"), amplitude,
              1e-10);
  EXPECT_NEAR(value_of(result, acceleration + "/maximum"), omega * omega * amplitude, 1e-7);
}

TEST(RecordersTest, OnlyWhatIsSelectedIsStored) {
  Model model({testing::single_mass("block", mass, stiffness, damping),
               testing::single_mass("other", mass, stiffness, damping)});
  const System system = testing::system_of(std::move(model));
  const ObservedSelection selection{.points = {"other.head"}, .kinds = {"velocity"}};
  for (const PointResult &result : {recorded<ExtremeValues>(system, three_periods(), selection),
                                    recorded<Statistics>(system, three_periods(), selection)}) {
    ASSERT_FALSE(result.fields.empty());
    for (const Field &field : result.fields)
      EXPECT_TRUE(field.name().starts_with("point/other.head/velocity_x/")) << field.name();
  }
}

TEST(RecordersTest, AveragesOfASineWithAnOffset) {
  const PointResult result = recorded<Statistics>(pushed(), three_periods(), ObservedSelection{});
  const double amplitude = force / std::abs(impedance);
  const double mean = offset / stiffness;
  EXPECT_NEAR(value_of(result, displacement + "/mean"), mean, 1e-11);
  EXPECT_NEAR(value_of(result, displacement + "/rms_about_mean"), amplitude / std::sqrt(2.0),
              1e-10);
  EXPECT_NEAR(value_of(result, displacement + "/rms"),
              std::sqrt(mean * mean + amplitude * amplitude / 2), 1e-10);
  EXPECT_NEAR(value_of(result, acceleration + "/rms"), omega * omega * amplitude / std::sqrt(2.0),
              1e-6);
}

TEST(RecordersTest, TheDamperTakesWhatTheForcePutsIn) {
  const PointResult result = recorded<Energy>(pushed(), three_periods());
  const double amplitude = force / std::abs(impedance);
  const double loss = pi * damping * omega * amplitude * amplitude;
  EXPECT_NEAR(value_of(result, "body/block/dissipated_energy_per_period"), loss, 1e-8 * loss);
  EXPECT_NEAR(value_of(result, "energy/input_work"), 3 * loss, 1e-7 * loss);
  EXPECT_NEAR(value_of(result, "energy/stored_change"), 0, 1e-7 * loss);
  EXPECT_NEAR(value_of(result, "energy/residual"), 0, 1e-7 * loss);
}

// A dashpot to the fixed ground loses by the velocity in space, a spring to it holds energy too.
TEST(RecordersTest, EnergyOfAConnectionPastAMovingBase) {
  Model model({testing::single_mass("block", mass, stiffness, 0)});
  model.add_base_motion("floor", harmonic(base), {0}, Vector3::UnitX());
  const Projection elongation = model.displacement({}, -Vector3::UnitX(), true);
  model.add_connection({.name = "anchor",
                        .side_a = "block.head",
                        .side_b = "ground",
                        .elongation = elongation,
                        .stiffness = 100,
                        .damping = damping});
  System system = testing::system_of(std::move(model));
  const Complex whole =
      stiffness * base / Complex(stiffness + 100 - mass * omega * omega, omega * damping);
  start_steady(system, whole - base, 0);
  const PointResult result = recorded<Energy>(system, three_periods());
  const double loss = pi * damping * omega * std::norm(whole);
  EXPECT_NEAR(value_of(result, "connection/anchor/dissipated_energy_per_period"), loss,
              1e-8 * loss);
  EXPECT_NEAR(value_of(result, "energy/input_work_per_period"), loss, 1e-7 * loss);
  EXPECT_NEAR(value_of(result, "energy/residual"), 0, 1e-7 * loss);
  // Over part of a period what is stored changes, in the block's motion relative to the floor and
  // in both springs.
  constexpr double end = 0.13;
  const PointResult part = recorded<Energy>(system, {.start = 0, .end = end});
  const auto stored = [&](double t) {
    const Complex turn = std::polar(1.0, omega * t);
    const double velocity = omega * ((whole - base) * turn).real();
    return mass / 2 * std::pow(velocity, 2) +
           stiffness / 2 * std::pow(((whole - base) * turn).imag(), 2) +
           100 / 2.0 * std::pow((whole * turn).imag(), 2);
  };
  const double change = stored(end) - stored(0);
  const double lost =
      damping * omega * omega / 2 *
      (std::norm(whole) * end +
       (whole * whole * (std::polar(1.0, 2 * omega * end) - 1.0)).imag() / (2 * omega));
  EXPECT_GT(std::abs(change), 0.1 * loss);
  EXPECT_NEAR(value_of(part, "energy/stored_change"), change, 1e-7 * loss);
  EXPECT_NEAR(value_of(part, "energy/damping_work"), lost, 1e-7 * loss);
  EXPECT_NEAR(value_of(part, "energy/input_work"), change + lost, 1e-7 * loss);
  EXPECT_NEAR(value_of(part, "energy/residual"), 0, 1e-7 * loss);
}

TEST(RecordersTest, ForceOnTheBaseAndItsTransmissibility) {
  const PointResult result = recorded<Forces>(pushed(), three_periods());
  const double transmitted = std::abs(Complex(stiffness, omega * damping) / impedance);
  EXPECT_NEAR(value_of(result, base_force + "/mean"), offset, 1e-7);
  EXPECT_NEAR(value_of(result, base_force + "/peak_to_peak"), 2 * transmitted * force, 1e-7);
  EXPECT_NEAR(value_of(result, base_force + "/rms_about_mean"),
              transmitted * force / std::sqrt(2.0), 1e-7);
  EXPECT_NEAR(value_of(result, base_force + "/transmissibility"), transmitted, 1e-8);
}

TEST(RecordersTest, TransmissibilityOfAMovingBase) {
  const PointResult result = recorded<Forces>(shaken(), three_periods());
  const double transmitted = std::abs(Complex(stiffness, omega * damping) / impedance);
  EXPECT_NEAR(value_of(result, displacement + "/transmissibility"), transmitted, 1e-8);
  EXPECT_NEAR(value_of(result, acceleration + "/transmissibility"), transmitted, 1e-6);
}

// Mass that no coordinate takes up moves with the base.
TEST(RecordersTest, MassOnTheBaseIsPartOfTheForceOnIt) {
  auto body =
      std::make_shared<reduction::ReducedBody>(*testing::single_mass("block", mass, stiffness, 0));
  body->total_mass[0] += 3;
  Model model({body});
  model.add_base_motion("floor", harmonic(base), {0}, Vector3::UnitX());
  System system = testing::system_of(std::move(model));
  const double below = stiffness - mass * omega * omega;
  start_steady(system, mass * omega * omega * base / below, 0);
  const PointResult result = recorded<Forces>(system, three_periods());
  const double inertia = mass * stiffness / below + 3; // of the moving mass and of the rest
  EXPECT_NEAR(value_of(result, base_force + "/maximum"), std::abs(inertia) * omega * omega * base,
              1e-7);
}

// Spring and dashpot side by side pull with |k + i omega c| times the amplitude.
TEST(RecordersTest, TensionOfASpringAndADashpot) {
  Model model({testing::single_mass("block", mass, stiffness, 0)});
  model.add_force("push", harmonic(force), {}, Vector3::UnitX());
  model.add_connection({.name = "link",
                        .side_a = "block.head",
                        .side_b = "base",
                        .elongation = model.displacement({}, -Vector3::UnitX(), false),
                        .stiffness = 100,
                        .damping = damping});
  System system = testing::system_of(std::move(model));
  const Complex amplitude =
      force / Complex(stiffness + 100 - mass * omega * omega, omega * damping);
  start_steady(system, amplitude, 0);
  const PointResult result = recorded<Forces>(system, three_periods());
  const Complex link(100, omega * damping);
  EXPECT_NEAR(value_of(result, "connection/link/force/maximum"), std::abs(link * amplitude), 1e-7);
  EXPECT_NEAR(value_of(result, base_force + "/maximum"), std::abs((stiffness + link) * amplitude),
              1e-7);
}

// At the turning points of a free motion the tension is that of the cubic spring.
TEST(RecordersTest, TensionOfACubicConnection) {
  Model model({testing::single_mass("block", mass, 0, 0)});
  model.add_connection({.name = "spring",
                        .side_a = "block.head",
                        .side_b = "base",
                        .elongation = model.displacement({}, -Vector3::UnitX(), false),
                        .stiffness = stiffness,
                        .cubic_stiffness = 2e5});
  System system = testing::system_of(std::move(model));
  system.initial.displacement[0] = 0.1;
  const double tension = stiffness * 0.1 + 2e5 * 0.1 * 0.1 * 0.1;
  const PointResult result = recorded<Forces>(system, {.start = 0, .end = 0.5});
  EXPECT_NEAR(value_of(result, "connection/spring/force/maximum"), tension, 1e-6 * tension);
  EXPECT_NEAR(value_of(result, "connection/spring/force/minimum"), -tension, 1e-6 * tension);
  EXPECT_NEAR(value_of(result, base_force + "/peak_to_peak"), 2 * tension, 1e-6 * tension);
}

TEST(RecordersTest, StaticDisplacementUnderTheFrozenPeak) {
  System system = pushed();
  contact::ContactPair stop = testing::contact_along_x(
      system.model, "block.head", "", 0.018, std::make_shared<contact::LinearPenalty>(5000));
  system.contacts = contact::ContactSet({stop});
  const PointResult result = recorded<QuasiStatic>(system, three_periods());
  const std::string name = "point/block.head/quasi_static_displacement_x";
  EXPECT_NEAR(value_of(result, name + "/minimum"), (offset - force) / stiffness, 1e-10);
  EXPECT_NEAR(value_of(result, name + "/maximum"),
              (offset + force + 5000 * 0.018) / (stiffness + 5000), 1e-10);
}

TEST(RecordersTest, StaticDisplacementUnderAFaintLoad) {
  constexpr double faint = 1e-6;
  Model model({testing::single_mass("block", mass, stiffness, damping)});
  model.add_force("push", harmonic(faint), {}, Vector3::UnitX());
  const PointResult result =
      recorded<QuasiStatic>(testing::system_of(std::move(model)), three_periods());
  EXPECT_NEAR(value_of(result, "point/block.head/quasi_static_displacement_x/maximum"),
              faint / stiffness, 1e-6 * faint / stiffness);
}

// A base shaken at omega pushes with m omega^2 times its amplitude.
TEST(RecordersTest, StaticDisplacementUnderAShakenBase) {
  const PointResult result = recorded<QuasiStatic>(shaken(), three_periods());
  const std::string name = "point/block.head/quasi_static_displacement_x";
  const double expected = mass * omega * omega * base / stiffness;
  EXPECT_NEAR(value_of(result, name + "/minimum"), -expected, 1e-12);
  EXPECT_NEAR(value_of(result, name + "/maximum"), expected, 1e-12);
}

TEST(RecordersTest, HistoriesAreSampledInTheWindow) {
  const History::Settings settings{.selection = {.points = {}, .kinds = {"displacement"}},
                                   .samples_per_period = 50};
  const PointResult result = recorded<History>(pushed(), three_periods(), settings);
  const std::vector<double> &time = field_of(result, "history/history_time").values;
  const std::vector<double> &values = field_of(result, "history/" + displacement).values;
  ASSERT_EQ(time.size(), 151u);
  ASSERT_EQ(values.size(), 151u);
  for (std::size_t i = 0; i < time.size(); ++i)
    EXPECT_NEAR(values[i],
                (force / impedance * std::polar(1.0, omega * time[i])).imag() + offset / stiffness,
                1e-9);
}

} // namespace recorders_tests
} // namespace vibroimpact::analyses
