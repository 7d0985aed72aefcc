// Contacts that change at one instant, and impacts too small to be resolved, against closed
// forms: which of their modes holds is a matter of rounding there, and the motion must not depend
// on it.
#include "common/error.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace vibroimpact::motion {
namespace indeterminate_modes_tests {

using namespace model;
using contact::ContactPair;
using contact::ContactSet;
using std::numbers::pi;
using testing::add_weight;
using testing::contact_along_x;
using testing::Events;
using testing::newton;
using testing::settings_of;
using testing::single_mass;
using testing::stop_on_base;
using testing::vector_of;

constexpr double gravity = 9.81;

// Where nothing moves, the steps of a stock method grow until they overlook the force.
Settings short_steps_of(const std::string &method, double longest) {
  Settings settings = settings_of(method);
  if (method == "rk")
    settings.maximum_step = longest;
  return settings;
}

class IndeterminateModesTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, IndeterminateModesTest, ::testing::Values("exact", "rk"));

ContactPair turned(ContactPair pair) {
  pair.gap.row *= -1;
  for (double &base_coefficients : pair.gap.base_coefficients)
    base_coefficients *= -1;
  return pair;
}

void push(Model &model, double amplitude, double omega, double phase) {
  model.add_force("push", std::make_shared<Harmonic>(Given::displacement, amplitude, omega, phase),
                  {.body = 0, .point = 0}, Vector3::UnitX());
}

// A mass before a rigid wall of a shaken base, s = a sin(w t), and a spring stop in space behind
// it. It stays at the wall: where its inertia would part it from there, at s = 0, the stop begins
// to push it on. The wall's force is k max(0, -s) - m s''; its impulse in a period 2 k a / w.
TEST_P(IndeterminateModesTest, AnotherContactTakesOverWhereAForceEnds) {
  const double mass = 0.12, stiffness = 11000, amplitude = 0.0225, omega = 2.9, phase = 0.3;
  for (const double restitution : {0.0, 0.5, 1.0}) {
    Model model({single_mass("block", mass, 0, 0)});
    model.add_base_motion("shake",
                          std::make_shared<Harmonic>(Given::displacement, amplitude, omega, phase),
                          {0}, Vector3::UnitX());
    const ContactSet contacts(
        {turned(contact_along_x(model, "block.head", "", 0,
                                std::make_shared<contact::LinearPenalty>(stiffness))),
         stop_on_base(model, "block.head", 0, newton(restitution))});
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    Events events;
    trajectory.start(0, vector_of({0}), vector_of({0}));
    trajectory.advance(3 * 2 * pi / omega, events);
    EXPECT_NEAR(trajectory.state()[0], 0, 1e-9) << restitution;
    const double impulse = 3 * 2 * stiffness * amplitude / omega;
    EXPECT_NEAR(trajectory.state()[trajectory.layout().impulse(1)], impulse, 1e-7 * impulse)
        << restitution;
    EXPECT_LT(events.list.size(), 100U) << restitution;
    EXPECT_TRUE(trajectory.accuracy().balanced()) << restitution;
  }
}

// Without play between two rigid stops: the one takes the force when the other one is left.
TEST_P(IndeterminateModesTest, NoPlayBetweenRigidStops) {
  const double load = 3, omega = 7;
  for (const double restitution : {0.0, 0.7, 1.0}) {
    Model model({single_mass("block", 1.3, 0, 0)});
    push(model, load, omega, 0.4);
    const ContactPair ahead = contact_along_x(model, "block.head", "", 0, newton(restitution));
    const ContactSet contacts({ahead, turned(ahead)});
    const Settings settings = short_steps_of(GetParam(), 1e-2 / omega);
    Trajectory trajectory(model, contacts, settings);
    Events events;
    trajectory.start(0, vector_of({0}), vector_of({0}));
    trajectory.advance(5 * 2 * pi / omega, events);
    EXPECT_NEAR(trajectory.state()[0], 0, 1e-11) << restitution;
    for (const Index side : {0, 1})
      EXPECT_NEAR(trajectory.state()[trajectory.layout().impulse(side)], 5 * 2 * load / omega, 1e-8)
          << restitution << ' ' << side;
  }
}

// Between two springs without play each change is one of both contacts. One after the other in
// time they are all determined: as many as one likes are no sign of a standstill.
TEST_P(IndeterminateModesTest, NoPlayBetweenTwoSprings) {
  const double mass = 0.2, ahead = 1.95e5, behind = 1.3e5, speed = 0.4;
  const int periods = 150;
  const Model model({single_mass("block", mass, 0, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0, std::make_shared<contact::LinearPenalty>(ahead)),
       turned(contact_along_x(model, "block.head", "", 0,
                              std::make_shared<contact::LinearPenalty>(behind)))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({speed}));
  const double half = pi * std::sqrt(mass / ahead);
  const double period = half + pi * std::sqrt(mass / behind);
  trajectory.advance(periods * period + half / 2, events);
  EXPECT_NEAR(trajectory.state()[0], speed * std::sqrt(mass / ahead), 1e-8);
  EXPECT_EQ(events.list.size(), 4U * periods + 1);
  EXPECT_EQ(trajectory.accuracy().undecided_events, 0);
}

// One side is rigid, the other gives way: leaving the rigid one begins a contact without any speed.
TEST_P(IndeterminateModesTest, NoPlayBetweenARigidAndACompliantStop) {
  const double mass = 1.3, load = 3, omega = 7;
  Model model({single_mass("block", mass, 0, 0)});
  push(model, load, omega, 0.4);
  const auto compliant = contact::HuntCrossley::with_dimensionless_damping(
      {.stiffness = 1e7, .exponent = 1.5}, 0.6, 1e-2);
  const ContactSet contacts({contact_along_x(model, "block.head", "", 0, newton(0.3)),
                             turned(contact_along_x(model, "block.head", "", 0, compliant))});
  const Settings settings = short_steps_of(GetParam(), 1e-2 / omega);
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  const double end = 2 * pi / omega;
  trajectory.advance(end, events);
  const StateLayout &layout = trajectory.layout();
  // The load has no impulse in a period.
  EXPECT_NEAR(trajectory.state()[layout.impulse(1)] - trajectory.state()[layout.impulse(0)],
              mass * trajectory.state()[layout.velocity()], 1e-9);
  EXPECT_NEAR(trajectory.state()[layout.impulse(1)], 2 * load / omega, 1e-3);
  EXPECT_GT(trajectory.state()[0], -std::pow(2 * load / 1e7, 2.0 / 3));
  EXPECT_TRUE(trajectory.accuracy().balanced());
}

// Far from its origin the gap of a ball is known to no better than its rounding, which feeds the
// flights that are lower. It rests when it would have come to rest, v (1 + e) / (g (1 - e)).
TEST_P(IndeterminateModesTest, FlightsLowerThanRounding) {
  const double e = 0.9, far = 1e4, height = 0.1, mass = 2;
  Model model({single_mass("ball", mass, 0, 0)});
  add_weight(model, gravity, {0});
  const ContactSet contacts({contact_along_x(model, "ball.head", "", far, newton(e))});
  Settings settings = settings_of(GetParam());
  settings.absolute_tolerance = 1e-16;
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({far - height}), vector_of({0}));
  const double end = 4;
  trajectory.advance(end, events);
  ASSERT_EQ(trajectory.accuracy().chatters, 1);
  const Events::Event &last = events.list.back();
  const double speed = std::sqrt(2 * gravity * height);
  EXPECT_EQ(last.to, 1);
  // The position at which the flights begin is known to 1e-12 m, their speeds to that by sqrt(g h).
  EXPECT_NEAR(last.time + last.chatter_duration, speed * (1 + e) / (gravity * (1 - e)), 1e-5);
  EXPECT_NEAR(trajectory.state()[0], far, 1e-9);
  EXPECT_NEAR(trajectory.state()[trajectory.layout().impulse(0)], mass * gravity * end, 1e-6);
}

// A ball that loses nothing bounces for ever. When that is nothing beside the energy of a pendulum
// which has no part in it, it rests; else it does not.
TEST_P(IndeterminateModesTest, ElasticFlightsWithoutEnergyEnd) {
  for (const double height : {1e-8, 1e-3}) {
    const double mass = 2, stiffness = 800, swing = 0.5, end = 1;
    Model model({single_mass("ball", mass, 0, 0), single_mass("pendulum", 2, stiffness, 0)});
    add_weight(model, gravity, {0});
    const ContactSet contacts({contact_along_x(model, "ball.head", "", height, newton(1))});
    Settings settings = settings_of(GetParam());
    settings.relative_tolerance = 1e-9;
    Trajectory trajectory(model, contacts, settings);
    Events events;
    trajectory.start(0, vector_of({0, swing}), vector_of({0, 0}));
    trajectory.advance(end, events);
    const double fall = std::sqrt(2 * height / gravity);
    const bool rests = mass * gravity * height < 1e-6 * 0.5 * stiffness * swing * swing;
    EXPECT_EQ(events.list.size(), rests ? 1 : std::floor((end / fall + 1) / 2));
    EXPECT_EQ(trajectory.accuracy().chatters, rests ? 1 : 0);
    EXPECT_NEAR(events.list[0].time, fall, 1e-10);
    EXPECT_EQ(trajectory.accuracy().energy_residual <= 1e-6, true);
    if (rests) {
      EXPECT_NEAR(trajectory.state()[0], height, 1e-13);
      EXPECT_NEAR(trajectory.state()[trajectory.layout().impulse(0)], mass * gravity * end, 1e-9);
    }
  }
}

// In one step: a body turns at its stop to the last digit, and another one meets its own soon
// afterwards. A third one leaves its stop at the start, so that the motion begins with a step.
TEST(IndeterminateModesTest, TouchesBeforeAContactChangeAreCounted) {
  const Model model({single_mass("turning", 1, 1, 0), single_mass("meeting", 1, 0, 0),
                     single_mass("leaving", 1, 0, 0)});
  const auto law = std::make_shared<contact::LinearPenalty>(10);
  const ContactSet contacts({contact_along_x(model, "turning.head", "", 1, law),
                             contact_along_x(model, "meeting.head", "", 0.07, law),
                             contact_along_x(model, "leaving.head", "", 0, law)});
  Trajectory trajectory(model, contacts, {});
  trajectory.start(0, Vector{{std::cos(0.05), 0, 0}}, Vector{{std::sin(0.05), 1, -1}});
  trajectory.advance(0.1);
  EXPECT_EQ(trajectory.accuracy().events, 1);
  EXPECT_EQ(trajectory.accuracy().undecided_events, 1);
}

// Two bodies that touch are pushed from rest with the same acceleration a sin(w t). Their gap grows
// with the fifth power of time, k/m (difference) a w t^5 / 120, which no polynomial of a first step
// knows the sign of: it is judged by the sizes that the step reaches.
TEST(IndeterminateModesTest, BodiesThatPartInTheFifthOrder) {
  const double amplitude = 15, omega = 13, slow = 8, fast = 11;
  const auto displacement = [&](double own, double t) {
    return amplitude / (own * own - omega * omega) *
           (std::sin(omega * t) - omega / own * std::sin(own * t));
  };
  for (const char *method : {"exact", "rk", "arkimex"}) {
    Model model(
        {single_mass("behind", 1, fast * fast, 0), single_mass("ahead", 1, slow * slow, 0)});
    for (const std::size_t body : {0, 1})
      model.add_force("push " + std::to_string(body),
                      std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0),
                      {.body = body, .point = 0}, Vector3::UnitX());
    const ContactSet contacts({contact_along_x(
        model, "behind.head", "ahead.head", 0,
        contact::HuntCrossley::with_dimensionless_damping({4e8, 1.5}, 0.2, 1e-6))});
    Settings settings;
    settings.method = method;
    settings.relative_tolerance = 1e-12;
    settings.maximum_step = 9e-4;
    Trajectory trajectory(model, contacts, settings);
    trajectory.start(0, Vector::Zero(2), Vector::Zero(2));
    const double end = 0.1;
    trajectory.advance(end);
    EXPECT_NEAR(trajectory.state()[0], displacement(fast, end), 1e-11) << method;
    EXPECT_NEAR(trajectory.state()[1], displacement(slow, end), 1e-11) << method;
  }
}

// Two modes without any force, each left when its clock has run down.
class Flickering : public contact::ContactLaw {
public:
  explicit Flickering(double stay)
      : ContactLaw({mode("one", 1, stay), mode("other", 0, stay)}, {1.0}), stay_(stay) {}
  std::string name() const override { return "flickering"; }
  int initial_mode(const contact::LocalState & /*state*/) const override { return 0; }
  void evaluate(int /*mode*/, const contact::LocalState & /*state*/,
                contact::LawResponse &response) const override {
    response = {.force_by_internal = {0},
                .internal_rate = {-1 / stay_},
                .internal_rate_by_gap = {0},
                .internal_rate_by_gap_rate = {0},
                .internal_rate_by_internal = {0}};
  }

private:
  static contact::Mode mode(const std::string &name, int target, double stay) {
    return {.name = name,
            .in_contact = target == 0,
            .guards = {{.indicator = {.internal = {1}}, .target = target, .reset = {{1.0}}}},
            .affine = contact::AffineLaw{.force = {}, .internal_rate = {{-1 / stay}}}};
  }
  double stay_;
};

// Of a mass at 1 krad/s: stays of 1 ns would take a thousand million changes for a second, and end
// the motion; those of 2 us are legitimate.
TEST(IndeterminateModesEndTest, StaysFarBelowTheShortestTimeConstantEndTheMotion) {
  const auto run = [](double stay, double end) {
    Model model({single_mass("block", 1, 1e6, 0)});
    const auto law = std::make_shared<Flickering>(stay);
    const ContactSet contacts({contact_along_x(model, "block.head", "", 1, law)});
    Settings settings;
    settings.maximum_events = 100'000;
    Trajectory trajectory(model, contacts, settings);
    trajectory.start(0, Vector::Constant(1, 0.1), Vector::Zero(1));
    trajectory.advance(end);
    return trajectory.accuracy().events;
  };
  try {
    run(1e-9, 1);
    ADD_FAILURE() << "the motion has an end";
  } catch (const NumericalError &error) {
    EXPECT_NE(std::string(error.what()).find("hardly advances"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("flickering"), std::string::npos) << error.what();
  }
  EXPECT_NEAR(static_cast<double>(run(2e-6, 0.05)), 25'000, 1);
}

} // namespace indeterminate_modes_tests
} // namespace vibroimpact::motion
