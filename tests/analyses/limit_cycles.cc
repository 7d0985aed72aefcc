// Motions that no excitation times: a mass on a belt in closed form, and one with friction that
// falls and rises with the speed, whose multiplier follows from its divergence alone.
#include "analyses/curves/orbit_branch.h"
#include "analyses/curves/periodic_orbit.h"
#include "analyses/keys/keyed_map.h"
#include "common/error.h"
#include "common/zero.h"
#include "contact/friction/piecewise_linear.h"
#include "support/friction_models.h"
#include "support/recorded_windows.h"
#include "support/steps_in_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace vibroimpact::analyses {
namespace limit_cycles_tests {

using testing::field_of;
using testing::value_of;

constexpr double pi = std::numbers::pi;
constexpr double drop = 0.5; // (mu_s - mu) N / k

using Friction = std::shared_ptr<const contact::TangentialLaw>;

Friction falling_at_once() { return std::make_shared<contact::Coulomb>(0.5, 1); }

/// Falls, and rises again: vibrations grow about the equilibrium and decay when they are large.
Friction falling_and_rising() {
  return std::make_shared<contact::PiecewiseLinear>(std::vector<double>{0, 1, 2, 3},
                                                    std::vector<double>{0.9, 0.8, 0.6, 1.2}, 0.9);
}

/// A unit mass on a unit spring and a dashpot, pressed on a belt by a unit force.
System on_belt(const Friction &friction, double speed, double damping, double displacement) {
  System system{.model = model::Model({testing::single_mass("block", 1, 1, damping)}),
                .contacts = {},
                .integration = {.relative_tolerance = 1e-12, .event_tolerance = 1e-14},
                .initial = {.displacement = Vector::Constant(1, displacement),
                            .velocity = Vector::Constant(1, 0.0)}};
  system.contacts = contact::ContactSet({testing::sliding_along_x(
      system.model, "block.head", "", testing::constant_with(1, friction), speed)});
  return system;
}

/// A point of such systems, whose key is the speed of the belt.
class OnBelt : public LineContext {
public:
  OnBelt(Friction friction, double damping) : friction_(std::move(friction)), damping_(damping) {}
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(PointResult stored) override { result = std::move(stored); }
  void skip() override {}
  System build(const std::vector<parameters::Override> &overrides) const override {
    return at(std::stod(overrides.front().value));
  }
  System at(double speed) const { return on_belt(friction_, speed, damping_, 0.1); }
  std::unique_ptr<StepRecord> steps(const std::vector<std::size_t> & /*index*/) override {
    return std::make_unique<testing::HandedSteps>(known, fresh);
  }

  PointResult result;
  std::vector<std::string> known, fresh;

private:
  Friction friction_;
  double damping_;
};

OrbitStart after(long cycles) {
  return {.settling = {.minimum = cycles, .maximum = cycles, .tolerance = 1e-8}};
}

PointResult cycle(System system, const OrbitStart &start) {
  OnBelt context(nullptr, 0);
  PeriodicOrbit({.start = start, .excitation = {}, .recorders = {}}).run_line(0, system, context);
  return context.result;
}

SweptParameter speeds(double first, double last) {
  return {.path = "speed", .unit = "m/s", .values = {first, last}};
}

OrbitBranch::Settings along_speed(double first, double start, double last) {
  OrbitBranch::Settings settings{.parameter = speeds(first, last),
                                 .start_value = start,
                                 .start = after(3),
                                 .excitation = {},
                                 .recorders = {}};
  settings.continuation.first_key = {.lower = first, .upper = last};
  return settings;
}

/// Of stick and slip without a dashpot.
double belt_period(double speed) { return 2 * drop / speed + 2 * (pi - std::atan(drop / speed)); }

TEST(LimitCycles, StickSlipInClosedForm) {
  for (const double speed : {0.05, 0.2, 1.5}) {
    const PointResult found = cycle(on_belt(falling_at_once(), speed, 0, -2), after(3));
    ASSERT_EQ(found.status, Status::finished) << found.reason;
    EXPECT_NEAR(value_of(found, "period"), belt_period(speed), 1e-12 * belt_period(speed)) << speed;
    EXPECT_EQ(value_of(found, "stable"), 1);
    for (const double multiplier : field_of(found, "multiplier_real").values)
      EXPECT_NEAR(multiplier, 0, 1e-10); // sticking forgets all, and the plane the rest
  }
}

// Where all of the motion slides, nothing jumps, and the product of the multipliers is
// exp(int div f dt) = exp(-sum of damping times time / mass) (Liouville).
TEST(LimitCycles, MultiplierOfASlidingMotionByItsDivergence) {
  const double speed = 1.6;
  const System system = on_belt(falling_and_rising(), speed, 0, 1.2);
  const OrbitStart start = after(40);
  OrbitSearch search(system, std::nullopt, start);
  const periodic::Orbit orbit = search.run();
  const Eigen::VectorXcd multipliers = orbit.multipliers(search.map());
  const periodic::EventPattern &pattern = orbit.point.image.pattern;
  ASSERT_EQ(pattern.events.size(), 4U);
  ASSERT_NEAR(pattern.length, search.map().period(), 1e-12);
  // Slopes of the coefficient in 1 < |v| < 2 and 2 < |v| < 3.
  double exponent = 0;
  const auto &modes = system.contacts.pairs()[0].law->modes();
  for (std::size_t i = 0; i < pattern.events.size(); ++i) {
    const periodic::PatternEvent &event = pattern.events[i];
    const bool last = i + 1 == pattern.events.size();
    const double until =
        last ? pattern.events[0].time + pattern.length : pattern.events[i + 1].time;
    const double slope =
        -modes[static_cast<std::size_t>(event.to)].affine->tangential_force[0].tangential[0].rate;
    exponent -= slope * (until - event.time);
  }
  EXPECT_LT(exponent, 0);
  EXPECT_NEAR(multipliers[0].real(), std::exp(exponent), 1e-9);
  EXPECT_NEAR(std::abs(multipliers[1]), 0, 1e-12);
}

// The return depends on the state and on the speed of the belt.
TEST(LimitCycles, DerivativesOfTheReturnAgainstDifferences) {
  OnBelt context(falling_and_rising(), 0.01);
  const double speed = 1.6;
  System system = context.at(speed);
  const OrbitStart start = after(40);
  OrbitSearch search(system, std::nullopt, start);
  const periodic::Orbit orbit = search.run();
  KeyedMap maps({speeds(1, 2)}, "", system, context, orbit_accuracy(system, search.forced()), 1,
                search.free_period());
  const auto image = [&](double key, const Vector &state) {
    const periodic::StroboscopicMap &map = maps.at(Vector::Constant(1, key));
    return map.image(orbit.section, state);
  };
  const Vector state = orbit.point.state + Eigen::Vector2d(0.02, -0.03);
  const periodic::Flow flow = image(speed, state);
  const double step = 1e-5;
  for (Index j = 0; j < 2; ++j) {
    const Vector change = step * Vector::Unit(2, j);
    const Vector difference =
        (image(speed, state + change).state - image(speed, state - change).state) / (2 * step);
    EXPECT_LT((flow.by_state.col(j) - difference).norm(), 1e-7) << j;
  }
  const Vector by_key =
      (image(speed + step, state).state - image(speed - step, state).state) / (2 * step);
  EXPECT_LT((flow.by_keys.col(0) - by_key).norm(), 1e-7);
  EXPECT_GT(by_key.norm(), 0.1);
}

// The amplitude about mu N / k is hypot(drop, speed).
TEST(LimitCycles, DerivativesByTheSpeedOfTheBelt) {
  const double speed = 0.2;
  OnBelt context(falling_at_once(), 0);
  System system = context.at(speed);
  const OrbitKey key{.name = "speed",
                     .parameter = {.path = "speed", .unit = "m/s", .values = {speed}}};
  PeriodicOrbit({.start = after(3), .excitation = {}, .keys = {key}}).run_line(0, system, context);
  ASSERT_EQ(context.result.status, Status::finished) << context.result.reason;
  const double amplitude = std::hypot(drop, speed);
  const double longer = 2 * drop / (amplitude * amplitude) - 2 * drop / (speed * speed);
  EXPECT_NEAR(value_of(context.result, "derivative/speed/period"), longer, 1e-9);
  EXPECT_EQ(value_of(context.result, "derivative/speed/smooth"), 1);
  EXPECT_NEAR(value_of(context.result, "derivative/speed/point/block.head/displacement_x/maximum"),
              speed / amplitude, 1e-9);
}

TEST(LimitCycles, AlongTheSpeedOfTheBelt) {
  OnBelt context(falling_at_once(), 0);
  System system = context.at(0.2);
  OrbitBranch(along_speed(0.1, 0.2, 2)).run_line(0, system, context);
  ASSERT_EQ(context.result.status, Status::finished) << context.result.reason;
  const std::vector<double> &speed = field_of(context.result, "speed").values;
  const std::vector<double> &period = field_of(context.result, "period").values;
  EXPECT_EQ(speed.front(), 0.1);
  EXPECT_DOUBLE_EQ(speed.back(), 2);
  for (std::size_t i = 0; i < speed.size(); ++i)
    EXPECT_NEAR(period[i], belt_period(speed[i]), 1e-12 * period[i]) << speed[i];
  EXPECT_FALSE(testing::has_field(context.result, "special/kind"));
}

/// Largest speed that the mass reaches again when it has slid back, less that of the belt.
double regained(double speed, double ratio) {
  const double omega = std::sqrt(1 - ratio * ratio);
  const double y = drop - 2 * ratio * speed;
  const double b = (speed + ratio * y) / omega;
  const auto acceleration = [&](double t) {
    const double c = std::cos(omega * t), s = std::sin(omega * t);
    return (ratio * ratio - omega * omega) * (y * c + b * s) - 2 * ratio * omega * (b * c - y * s);
  };
  const double t = zero_between(acceleration, pi / omega, 2 * pi / omega);
  const double c = std::cos(omega * t), s = std::sin(omega * t);
  return std::exp(-ratio * t) * (omega * (b * c - y * s) - ratio * (y * c + b * s)) - speed;
}

// With a dashpot the mass no longer comes to stick where the belt is fast.
TEST(LimitCycles, StickSlipEndsWhereTheBeltIsNoLongerReached) {
  const double ratio = 0.05;
  OnBelt context(falling_at_once(), 2 * ratio);
  System system = context.at(0.2);
  OrbitBranch(along_speed(0.1, 0.2, 3)).run_line(0, system, context);
  ASSERT_EQ(context.result.status, Status::finished) << context.result.reason;
  const double end = zero_between([&](double speed) { return regained(speed, ratio); }, 0.3, 1);
  const std::vector<double> &speed = field_of(context.result, "speed").values;
  EXPECT_NEAR(speed.back(), end, 1e-12);
  EXPECT_EQ(field_of(context.result, "end/reason").values.back(), 8);    // no motion beyond
  EXPECT_EQ(field_of(context.result, "special/kind").values.back(), 10); // grazing-sliding
  EXPECT_NEAR(field_of(context.result, "special/speed").values.back(), end, 1e-12);
}

TEST(LimitCycles, ResumedBranchesAreTheSame) {
  const auto run = [](OnBelt &context) {
    System system = context.at(0.2);
    OrbitBranch(along_speed(0.1, 0.2, 0.6)).run_line(0, system, context);
  };
  OnBelt whole(falling_at_once(), 0.1);
  run(whole);
  ASSERT_GT(whole.fresh.size(), 20U);
  for (const std::size_t kept : {std::size_t{1}, std::size_t{9}, whole.fresh.size() - 4}) {
    OnBelt resumed(falling_at_once(), 0.1);
    resumed.known = testing::first_of(whole.fresh, kept);
    run(resumed);
    for (const Field &field : whole.result.fields) {
      const std::vector<double> &again = field_of(resumed.result, field.name()).values;
      ASSERT_EQ(again.size(), field.values.size());
      EXPECT_EQ(std::memcmp(again.data(), field.values.data(), 8 * again.size()), 0)
          << field.name() << " from step " << kept;
    }
  }
}

TEST(LimitCycles, WhatIsNoLimitCycleIsSaid) {
  const auto reason = [](System system) { return cycle(std::move(system), after(3)).reason; };
  // Slides at rest, where friction balances the spring.
  const std::string rest = reason(on_belt(falling_at_once(), 2, 0.5, 0.5));
  EXPECT_NE(rest.find("at rest"), std::string::npos) << rest;
  const std::string decay = reason(on_belt(falling_at_once(), 2, 0.5, 0.1));
  EXPECT_NE(decay.find("does not come back"), std::string::npos) << decay;
  const System system = on_belt(falling_at_once(), 0.2, 0, 0);
  const PeriodicOrbit derived({.start = after(3),
                               .excitation = {},
                               .recorders = {},
                               .keys = {{.name = "frequency", .parameter = {}}}});
  EXPECT_THROW(derived.check(system), InputError);
}

} // namespace limit_cycles_tests
} // namespace vibroimpact::analyses
