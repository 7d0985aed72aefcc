// Rigid contacts that chatter, rest, and part again, against closed forms.
#include "common/error.h"
#include "model/sine_sweep.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace resting_contacts_tests {

using namespace model;
using contact::ContactPair;
using contact::ContactSet;
using testing::add_weight;
using testing::contact_along_x;
using testing::Events;
using testing::newton;
using testing::settings_of;
using testing::single_mass;
using testing::stop_on_base;
using testing::vector_of;

constexpr double gravity = 9.81;

class RestingContactsTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, RestingContactsTest, ::testing::Values("exact", "rk"));

// A body that was never moved has no energy to measure the work of its loads against, and its speed
// is rounding alone: steps follow the load, not that. A sweep has no closed form.
TEST_P(RestingContactsTest, LoadsOnABodyThatNeverMoved) {
  const double mass = 0.8;
  Model model({single_mass("block", mass, 174, 0.013)});
  add_weight(model, gravity, {0});
  const SweepDefinition sweep{
      .given = Given::displacement, .amplitude = 5, .from = 2, .to = 7, .duration = 10};
  model.add_force("push", std::make_shared<SineSweep>(sweep), {.body = 0, .point = 0},
                  Vector3::UnitX());
  const ContactSet contacts({contact_along_x(model, "block.head", "", 0, newton(0))});
  Settings settings = settings_of(GetParam());
  settings.maximum_steps = 10000;
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(10, events);
  EXPECT_NEAR(trajectory.state()[0], 0, 1e-12);
  EXPECT_TRUE(events.list.empty());
}

// A ball falls on the ground (weight along x): impacts at t_n, and rest at v (1 + e) / (g (1 - e)).
TEST_P(RestingContactsTest, BouncingBallComesToRest) {
  for (const double e : {0.0, 0.2, 0.5, 0.9}) {
    const double mass = 2, height = 0.3, end = 8;
    Model model({single_mass("ball", mass, 0, 0)});
    add_weight(model, gravity, {0});
    const ContactSet contacts({contact_along_x(model, "ball.head", "", height, newton(e))});
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    ImpactLog log(contacts, 0);
    Events events;
    Observers observers({&log, &events});
    trajectory.start(0, vector_of({0}), vector_of({0}));
    trajectory.advance(end, observers);

    const double fall = std::sqrt(2 * height / gravity);
    const double speed = gravity * fall;
    double instant = fall;
    for (std::size_t i = 0; i < log.impacts(0).size(); ++i) {
      const Impact &impact = log.impacts(0)[i];
      EXPECT_NEAR(impact.start_time, instant, 1e-10) << e << ' ' << i;
      EXPECT_NEAR(impact.approach_speed, speed * std::pow(e, static_cast<double>(i)), 1e-10);
      EXPECT_EQ(impact.duration, 0);
      instant += 2 * speed / gravity * std::pow(e, static_cast<double>(i + 1));
    }
    ASSERT_FALSE(events.list.empty());
    const Events::Event &last = events.list.back();
    EXPECT_EQ(last.to, 1);
    EXPECT_NEAR(last.time + last.chatter_duration, speed * (1 + e) / (gravity * (1 - e)), 1e-10)
        << e;
    EXPECT_EQ(trajectory.accuracy().chatters, e > 0 ? 1 : 0);
    // Flights down to 8e-11 times |clearance| + |q| + |v t| at the first impact were followed.
    if (e > 0) {
      EXPECT_NEAR(std::pow(e, 2.0 * static_cast<double>(log.begun(0))) * height, 4 * 8e-11 * height,
                  4 * 8e-11 * height)
          << e;
    }
    EXPECT_NEAR(trajectory.state()[0], height, 1e-13) << e;
    EXPECT_NEAR(trajectory.state()[1], 0, 1e-13) << e;
    const StateLayout &layout = trajectory.layout();
    EXPECT_NEAR(trajectory.state()[layout.impulse(0)], mass * gravity * end, 1e-9) << e;
    EXPECT_NEAR(trajectory.state()[layout.contact_work(0)], mass * gravity * height, 1e-9) << e;
    EXPECT_LT(trajectory.accuracy().energy_residual, 1e-12) << e;
  }
}

// Nobody watches: the same end, and a standing ball needs no steps.
TEST(RestingContactsTest, UnwatchedBallComesToRest) {
  Model model({single_mass("ball", 2, 0, 0)});
  add_weight(model, gravity, {0});
  const ContactSet contacts({contact_along_x(model, "ball.head", "", 0.3, newton(0.5))});
  Trajectory trajectory(model, contacts, {});
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(1e4);
  EXPECT_NEAR(trajectory.state()[0], 0.3, 1e-13);
  EXPECT_EQ(trajectory.accuracy().chatters, 1);
  EXPECT_LT(trajectory.accuracy().steps, 1000);
}

// Looks at the force of a resting contact along the steps.
class ForceWatch : public Observer {
public:
  ForceWatch(std::function<double(double)> force, double tolerance)
      : force_(std::move(force)), tolerance_(tolerance) {}
  void step(const StepView &view) override {
    if (!view.equations().mode(0).holds_gap)
      return;
    held_ += view.length();
    for (const double tau : {0.0, 0.13, 0.5, 0.77, 1.0})
      EXPECT_NEAR(view.force(0, tau), force_(view.start() + tau * view.length()), tolerance_);
  }
  double held() const { return held_; }

private:
  std::function<double(double)> force_;
  double tolerance_;
  double held_ = 0;
};

// On a shaken base until the base falls away faster than the mass can: s'' = g.
TEST_P(RestingContactsTest, LiftsOffWhereTheBaseFallsAway) {
  const double mass = 2, omega = 9, amplitude = 0.2;
  Model model({single_mass("ball", mass, 0, 0)});
  model.add_base_motion("shake",
                        std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0), {0},
                        Vector3::UnitX());
  add_weight(model, gravity, {0});
  const ContactSet contacts({stop_on_base(model, "ball.head", 0, newton(0.5))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  ForceWatch forces(
      [&](double t) { return mass * (gravity + amplitude * omega * omega * std::sin(omega * t)); },
      // Inside a step the Runge-Kutta method has a polynomial of degree five.
      std::string(GetParam()) == "rk" ? 1e-6 : 1e-8);
  Observers observers({&events, &forces});
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(0.5, observers);
  // Along x, which points down, the base has the acceleration g where sin(omega t) = -g / A w^2.
  const double instant =
      (std::numbers::pi + std::asin(gravity / (amplitude * omega * omega))) / omega;
  ASSERT_FALSE(events.list.empty());
  EXPECT_EQ(events.list[0].from, 1);
  EXPECT_EQ(events.list[0].to, 0);
  EXPECT_NEAR(events.list[0].time, instant, 1e-11);
  EXPECT_NEAR(forces.held(), instant, 1e-11);
}

// Pressed on a stop in space by a spring and a dashpot to a shaken base: F = f - k (g0 - s) + c s'.
TEST_P(RestingContactsTest, ForceFromAMovingBaseOnAStopInSpace) {
  const double mass = 2, stiffness = 300, damping = 4, load = 30, clearance = 0.01;
  const double omega = 7, amplitude = 0.13;
  Model model({single_mass("block", mass, stiffness, damping)});
  const auto shake = std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0.4);
  model.add_base_motion("shake", shake, {0}, Vector3::UnitX());
  model.add_force("load", make_constant(Given::displacement, load), {.body = 0, .point = 0},
                  Vector3::UnitX());
  const ContactSet contacts({contact_along_x(model, "block.head", "", clearance, newton(0.5))});
  const auto force = [&](double t) {
    return load - stiffness * (clearance - shake->value(t)) + damping * shake->rate(t);
  };
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  ForceWatch forces(force, 1e-7);
  Observers observers({&events, &forces});
  trajectory.start(0, vector_of({clearance - shake->value(0)}), vector_of({-shake->rate(0)}));
  trajectory.advance(3, observers);
  ASSERT_GE(events.list.size(), 3U);
  EXPECT_EQ(events.list[0].from, 1);
  EXPECT_EQ(events.list[0].to, 0);
  EXPECT_NEAR(force(events.list[0].time), 0, 1e-8);
  EXPECT_GT(forces.held(), 0.5);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

// Two blocks on each other on the ground: each contact carries what stands above it.
TEST_P(RestingContactsTest, StackCarriesItsWeight) {
  Model model({single_mass("upper", 2, 0, 0), single_mass("lower", 3, 0, 0)});
  add_weight(model, gravity, {0, 1});
  const ContactSet contacts({contact_along_x(model, "upper.head", "lower.head", 0.1, newton(0.4)),
                             contact_along_x(model, "lower.head", "", 0.2, newton(0.6))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0, 0}), vector_of({0, 0}));
  trajectory.advance(5, events);
  EXPECT_NEAR(trajectory.state()[0], 0.3, 1e-11);
  EXPECT_NEAR(trajectory.state()[1], 0.2, 1e-11);
  const Vector before = trajectory.state();
  trajectory.advance(6, events);
  const StateLayout &layout = trajectory.layout();
  EXPECT_NEAR(trajectory.state()[layout.impulse(0)] - before[layout.impulse(0)], 2 * gravity, 1e-9);
  EXPECT_NEAR(trajectory.state()[layout.impulse(1)] - before[layout.impulse(1)], 5 * gravity, 1e-9);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
}

// A ball hits a block that rests on a rigid ground: the impulse passes through the block.
TEST_P(RestingContactsTest, ImpulsePassesThroughARestingBlock) {
  const double e = 0.7, speed = 3;
  Model model({single_mass("ball", 1, 0, 0), single_mass("block", 4, 0, 0)});
  add_weight(model, gravity, {1});
  const ContactSet contacts({contact_along_x(model, "ball.head", "block.head", 0.3, newton(e)),
                             contact_along_x(model, "block.head", "", 0, newton(0.2))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, vector_of({0, 0}), vector_of({speed, 0}));
  trajectory.advance(0.2, log);
  EXPECT_NEAR(trajectory.state()[2], -e * speed, 1e-13);
  EXPECT_NEAR(trajectory.state()[1], 0, 1e-13);
  const StateLayout &layout = trajectory.layout();
  EXPECT_NEAR(trajectory.state()[layout.impulse(1)], (1 + e) * speed + 4 * gravity * 0.2, 1e-11);
  EXPECT_EQ(log.begun(0), 1U);
  EXPECT_EQ(log.begun(1), 0U); // it has rested all the time
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-13);
}

// The force of a rigid stop turns slowly: contact, release and contact again without speed.
TEST_P(RestingContactsTest, StaysWhereTheForceOnlyGrazesZero) {
  for (const double margin : {1e-6, -1e-6}) {
    Model model({single_mass("block", 1, 0, 0)});
    const double omega = 3;
    model.add_force("wave", std::make_shared<Harmonic>(Given::displacement, 1, omega, 0),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    model.add_force("load", make_constant(Given::displacement, 1 + margin), {.body = 0, .point = 0},
                    Vector3::UnitX());
    const ContactSet contacts({contact_along_x(model, "block.head", "", 0, newton(0.5))});
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    Events events;
    trajectory.start(0, vector_of({0}), vector_of({0}));
    trajectory.advance(2 * std::numbers::pi / omega, events);
    EXPECT_EQ(events.list.empty(), margin > 0);
    EXPECT_NEAR(trajectory.state()[0], 0, 1e-9);
  }
}

// Bouncing on a table that shakes gently: comes to rest, and stays.
TEST_P(RestingContactsTest, ChatterOnAShakenTable) {
  const double omega = 20, amplitude = 0.5 * gravity / (omega * omega);
  Model model({single_mass("ball", 1, 0, 0)});
  model.add_base_motion("shake",
                        std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0), {0},
                        Vector3::UnitX());
  add_weight(model, gravity, {0});
  const ContactSet contacts({stop_on_base(model, "ball.head", 0.05, newton(0.6))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(5, events);
  EXPECT_EQ(trajectory.accuracy().chatters, 1);
  EXPECT_EQ(events.list.back().to, 1);
  EXPECT_LT(events.list.back().time, 1);
  EXPECT_NEAR(trajectory.state()[0], 0.05, 1e-12);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

// The accumulation is completed to the same motion whatever height of flight is followed.
TEST(RestingContactsTest, CompletionConvergesWithItsTolerance) {
  const auto state_with = [](double tolerance) {
    Model model({single_mass("ball", 1, 0, 0), single_mass("table", 2, 400, 3)});
    add_weight(model, gravity, {0});
    const ContactSet contacts(
        {contact_along_x(model, "ball.head", "table.head", 0.05, newton(0.5))});
    Settings settings;
    settings.absolute_tolerance = tolerance;
    Trajectory trajectory(model, contacts, settings);
    Events events;
    trajectory.start(0, vector_of({0, 0}), vector_of({0, 0}));
    trajectory.advance(1.5, events);
    EXPECT_EQ(trajectory.accuracy().chatters, 1);
    return Vector(trajectory.state().head(4));
  };
  const Vector fine = state_with(1e-13);
  for (const double tolerance : {1e-7, 1e-9, 1e-11})
    EXPECT_LT((state_with(tolerance) - fine).norm(), 100 * tolerance) << tolerance;
}

TEST(RestingContactsTest, OverlapAtTheStartIsRefused) {
  const Model model({single_mass("block", 1, 10, 0)});
  ContactPair pair = contact_along_x(model, "block.head", "", 0.1, newton(0.5));
  pair.accept_initial_penetration = true;
  const ContactSet contacts({pair});
  Trajectory trajectory(model, contacts, {});
  EXPECT_THROW(trajectory.start(0, vector_of({0.2}), vector_of({0})), InputError);
}

// A press that closes on a block between two rigid sides.
TEST(RestingContactsTest, JammedContactsFailWithAMessage) {
  Model model({single_mass("block", 1, 0, 0)});
  model.add_base_motion("press", std::make_shared<Harmonic>(Given::displacement, 0.1, 2, 0), {},
                        Vector3::UnitX());
  ContactPair right = contact_along_x(model, "block.head", "", 0.01, newton(0));
  ContactPair left = right;
  left.gap.row *= -1;
  left.gap.base_coefficients = {-1}; // this side moves along x
  const ContactSet contacts({right, left});
  Trajectory trajectory(model, contacts, {});
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  EXPECT_THROW(trajectory.advance(1, events), NumericalError);
}

// Nothing acts at the start, and what follows at once decides: on bodies of every frequency, long
// after whose periods the force has another sign.
TEST(RestingContactsTest, AForceThatOnlyBeginsDecidesAtEveryTimeScale) {
  for (const double frequency : {1e2, 1e4, 1e6})
    for (const double omega : {3.0, 3.2, 3.4, 3.6})
      for (const double sign : {1.0, -1.0}) {
        Model model({single_mass("block", 1, frequency * frequency, 0)});
        model.add_force("push", std::make_shared<Harmonic>(Given::displacement, sign, omega, 0),
                        {.body = 0, .point = 0}, Vector3::UnitX());
        const ContactSet contacts({contact_along_x(model, "block.head", "", 0, newton(0.5))});
        Trajectory trajectory(model, contacts, {});
        trajectory.start(0, vector_of({0}), vector_of({0}));
        EXPECT_EQ(trajectory.equations().modes()[0], sign > 0 ? 1 : 0)
            << frequency << ' ' << omega << ' ' << sign;
      }
}

} // namespace resting_contacts_tests
} // namespace vibroimpact::motion
