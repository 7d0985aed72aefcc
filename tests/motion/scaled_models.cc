// The same motion in other units of length, time and mass: contacts that touch, chatter, rest, part
// and give way do the same at the same instants, whatever the size of the model.
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vibroimpact::motion {
namespace scaled_models_tests {

using namespace model;
using contact::ContactPair;
using contact::ContactSet;
using testing::add_weight;
using testing::contact_along_x;
using testing::Events;
using testing::newton;
using testing::single_mass;
using testing::stop_on_base;
using testing::vector_of;

/// Of everything that has a dimension.
struct Units {
  double length = 1, time = 1, mass = 1;
  double speed() const { return length / time; }
  double acceleration() const { return length / (time * time); }
  double force() const { return mass * acceleration(); }
  double stiffness() const { return mass / (time * time); }
  double damping() const { return mass / time; }
};

struct Setup {
  std::unique_ptr<Model> model;
  ContactSet contacts;
  double start = 0; ///< displacement [m]
};

using MakeSetup = std::function<Setup(const Units &)>;

Model oscillator(const Units &units) {
  return Model(
      {single_mass("block", 1.3 * units.mass, 20 * units.stiffness(), 0.02 * units.damping())});
}

void push(Model &model, const Units &units, double amplitude) {
  model.add_force("push",
                  std::make_shared<Harmonic>(Given::displacement, amplitude * units.force(),
                                             3.1 / units.time, 0.4),
                  {.body = 0, .point = 0}, Vector3::UnitX());
}

/// Falls on rigid ground, chatters, rests, and is thrown off by the push again and again.
Setup chatter_and_rest(const Units &units) {
  auto model = std::make_unique<Model>(oscillator(units));
  add_weight(*model, 9.81 * units.acceleration(), {0});
  push(*model, units, 25);
  const ContactPair ground =
      contact_along_x(*model, "block.head", "", 0.03 * units.length, newton(0.4));
  return {.model = std::move(model), .contacts = ContactSet({ground})};
}

/// Rests from the start at a stop without clearance.
Setup resting_at_the_start(const Units &units) {
  auto model = std::make_unique<Model>(oscillator(units));
  add_weight(*model, 9.81 * units.acceleration(), {0});
  push(*model, units, 14);
  const ContactPair ground = contact_along_x(*model, "block.head", "", 0, newton(0.7));
  return {.model = std::move(model), .contacts = ContactSet({ground})};
}

/// Rigid on one side and compliant on the other, without play.
Setup no_play(const Units &units) {
  auto model = std::make_unique<Model>(oscillator(units));
  push(*model, units, 2);
  ContactPair behind = contact_along_x(
      *model, "block.head", "", 0,
      std::make_shared<contact::KelvinVoigt>(900 * units.stiffness(), 3 * units.damping()));
  behind.gap.row *= -1;
  const ContactPair ahead = contact_along_x(*model, "block.head", "", 0, newton(0.5));
  return {.model = std::move(model), .contacts = ContactSet({ahead, behind})};
}

/// A compliant stop with clearance on a shaken base, which falls on rigid ground beside it.
Setup compliant_stop(const Units &units) {
  auto model = std::make_unique<Model>(oscillator(units));
  model->add_base_motion(
      "shaker",
      std::make_shared<Harmonic>(Given::displacement, 0.04 * units.length, 3.7 / units.time, 0),
      {0}, Vector3::UnitX());
  const ContactPair stop = contact_along_x(
      *model, "block.head", "", 0.01 * units.length,
      std::make_shared<contact::KelvinVoigt>(3000 * units.stiffness(), 4 * units.damping()));
  ContactPair back = stop_on_base(*model, "block.head", 0.02 * units.length, newton(0.8));
  back.gap.row *= -1;
  return {.model = std::move(model),
          .contacts = ContactSet({stop, back}),
          .start = 0.005 * units.length};
}

struct Motion {
  std::vector<Events::Event> events; ///< in the units of the model
  double position = 0, speed = 0;
  long chatters = 0;
};

Motion motion_of(const MakeSetup &make, const Units &units) {
  const Setup setup = make(units);
  Settings settings;
  settings.event_tolerance *= units.time;
  Trajectory trajectory(*setup.model, setup.contacts, settings);
  Events events;
  trajectory.start(0, vector_of({setup.start}), vector_of({0}));
  trajectory.advance(12 * units.time, events);
  return {.events = events.list,
          .position = trajectory.state()[0] / units.length,
          .speed = trajectory.state()[1] / units.speed(),
          .chatters = trajectory.accuracy().chatters};
}

void expect_same_events(const Motion &motion, const Motion &reference, const Units &units) {
  constexpr double tolerance = 1e-12;
  ASSERT_EQ(motion.events.size(), reference.events.size());
  for (std::size_t i = 0; i < motion.events.size(); ++i) {
    const Events::Event &event = motion.events[i];
    const Events::Event &same = reference.events[i];
    ASSERT_EQ(event.contact, same.contact) << i;
    ASSERT_EQ(event.to, same.to) << i;
    EXPECT_NEAR(event.time / units.time, same.time, tolerance) << i;
    EXPECT_NEAR(event.gap_rate / units.speed(), same.gap_rate, tolerance) << i;
  }
  EXPECT_EQ(motion.chatters, reference.chatters);
}

void expect_same_end(const Motion &motion, const Motion &reference, double tolerance) {
  EXPECT_NEAR(motion.position, reference.position, tolerance);
  EXPECT_NEAR(motion.speed, reference.speed, tolerance);
}

const std::vector<std::pair<const char *, MakeSetup>> setups = {
    {"chatter and rest", chatter_and_rest},
    {"resting at the start", resting_at_the_start},
    {"no play", no_play},
    {"compliant stop", compliant_stop}};

// Powers of two change no digit.
TEST(ScaledModelsTest, ByPowersOfTwo) {
  for (const auto &[name, make] : setups) {
    const Motion reference = motion_of(make, {});
    EXPECT_GT(reference.events.size(), 10U) << name;
    for (const int length : {-30, -10, 20})
      for (const int time : {-13, 0, 10})
        for (const int mass : {-30, 20}) {
          SCOPED_TRACE(std::string(name) + " 2^" + std::to_string(length) + " m, 2^" +
                       std::to_string(time) + " s, 2^" + std::to_string(mass) + " kg");
          const Units units{.length = std::ldexp(1, length),
                            .time = std::ldexp(1, time),
                            .mass = std::ldexp(1, mass)};
          const Motion motion = motion_of(make, units);
          expect_same_events(motion, reference, units);
          expect_same_end(motion, reference, 1e-12);
        }
  }
}

// Where rounding differs, the last of many ever lower bounces may too.
TEST(ScaledModelsTest, ByPowersOfTen) {
  for (const auto &[name, make] : setups) {
    const Motion reference = motion_of(make, {});
    for (const double length : {1e-9, 1e-3, 1e6}) {
      SCOPED_TRACE(std::string(name) + ' ' + std::to_string(length) + " m");
      expect_same_end(motion_of(make, {.length = length}), reference, 1e-9);
    }
  }
}

} // namespace scaled_models_tests
} // namespace vibroimpact::motion
