// Bodies that fall on contacts with a stiffness, bounce, and stay: the place where they stand, the
// energy that is lost, and the instant at which they are thrown off again have closed forms.
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace settling_on_contacts_tests {

using namespace model;
using contact::ContactSet;
using contact::KelvinVoigt;
using testing::add_weight;
using testing::contact_along_x;
using testing::Events;
using testing::newton;
using testing::settings_of;
using testing::single_mass;
using testing::stop_on_base;
using testing::vector_of;

constexpr double gravity = 9.81;

class SettlingOnContactsTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, SettlingOnContactsTest, ::testing::Values("exact", "rk"));

/// A floor F = k u^n, with damping of some kind.
struct Floor {
  double stiffness, exponent;
  double penetration(double weight) const { return std::pow(weight / stiffness, 1 / exponent); }
  double energy(double u) const { return stiffness * std::pow(u, exponent + 1) / (exponent + 1); }
};

// From the height h to the static penetration u: m g (h + u) = energy of the floor + loss. Losses
// and impulses are integrals beside the motion, exact where the floor is linear; where it is not,
// no step controls their error, which may be what an energy balance may leave open.
void expect_at_rest(Trajectory &trajectory, const Floor &floor, double mass, double height) {
  const StateLayout &layout = trajectory.layout();
  const double u = floor.penetration(mass * gravity);
  EXPECT_NEAR(trajectory.state()[0], height + u, 1e-7 * u);
  EXPECT_NEAR(trajectory.state()[layout.velocity()], 0, 1e-7 * std::sqrt(gravity * u));
  double loss = 0;
  double impulse = 0;
  for (Index c = 0; c < layout.n_contacts; ++c) {
    loss += trajectory.state()[layout.contact_work(c)];
    impulse += trajectory.state()[layout.impulse(c)];
  }
  const double expected = mass * gravity * (height + u) - floor.energy(u);
  const double of_integrals = floor.exponent == 1 ? 1e-8 : 1e-6;
  EXPECT_NEAR(loss, expected, of_integrals * expected);
  EXPECT_NEAR(impulse, mass * gravity * trajectory.time(), of_integrals * impulse);
  EXPECT_TRUE(trajectory.accuracy().balanced()) << trajectory.accuracy().energy_residual;
}

TEST_P(SettlingOnContactsTest, KelvinVoigtFloor) {
  const double mass = 2, height = 0.05;
  const Floor floor{.stiffness = 4e4, .exponent = 1};
  for (const int count : {1, 2}) { // as one contact, and as two at the same place
    Model model({single_mass("ball", mass, 0, 0)});
    add_weight(model, gravity, {0});
    const auto law = std::make_shared<KelvinVoigt>(floor.stiffness / count, 60.0 / count);
    const ContactSet contacts(std::vector(static_cast<std::size_t>(count),
                                          contact_along_x(model, "ball.head", "", height, law)));
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    Events events;
    trajectory.start(0, vector_of({0}), vector_of({0}));
    trajectory.advance(4, events);
    expect_at_rest(trajectory, floor, mass, height);
    EXPECT_EQ(events.list.back().to, 1);
    EXPECT_GT(events.list.size(), 4U * static_cast<std::size_t>(count)); // it has bounced
  }
}

TEST_P(SettlingOnContactsTest, HuntCrossleyFloor) {
  const double mass = 2, height = 0.05;
  const Floor floor{.stiffness = 5e7, .exponent = 1.5};
  const contact::HertzConstants all{.stiffness = floor.stiffness, .exponent = floor.exponent};
  const contact::HertzConstants half{.stiffness = all.stiffness / 2, .exponent = all.exponent};
  const std::vector<std::shared_ptr<const contact::ContactLaw>> laws = {
      contact::HuntCrossley::with_dissipation(all, 0.9),
      contact::HuntCrossley::with_dimensionless_damping(all, 0.7, 1e-3),
      contact::HuntCrossley::with_dimensionless_damping(half, 0.7, 1e-3)};
  for (std::size_t i = 0; i < laws.size(); ++i) {
    Model model({single_mass("ball", mass, 0, 0)});
    add_weight(model, gravity, {0});
    const ContactSet contacts(
        std::vector(i == 2 ? 2 : 1, contact_along_x(model, "ball.head", "", height, laws[i])));
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    Events events;
    trajectory.start(0, vector_of({0}), vector_of({0}));
    trajectory.advance(12, events);
    expect_at_rest(trajectory, floor, mass, height);
    EXPECT_LT(events.list.size(), 1000U);
  }
}

// Put down on the floor without any speed: with d = d_c / v_min it creeps to its place.
TEST_P(SettlingOnContactsTest, PutDownWithoutSpeed) {
  const double mass = 2;
  const Floor floor{.stiffness = 5e9, .exponent = 1.5};
  Model model({single_mass("ball", mass, 0, 0)});
  add_weight(model, gravity, {0});
  const auto law = contact::HuntCrossley::with_dimensionless_damping(
      {.stiffness = floor.stiffness, .exponent = floor.exponent}, 0.7, 1e-4);
  const ContactSet contacts({contact_along_x(model, "ball.head", "", 0, law),
                             contact_along_x(model, "ball.head", "", 1, law)});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(2, events);
  expect_at_rest(trajectory, floor, mass, 0);
}

// The same with so small a v_min that the way to rest takes seconds, while the damped contact would
// answer a disturbance within 1 / (g d) = 0.15 us: no method may go by steps of that length.
TEST(SettlingOnContactsTest, CreepIsNoMatterOfTheFastestDecay) {
  const double mass = 2, damping = 0.7, lowest_speed = 1e-6, end = 30;
  const Floor floor{.stiffness = 5e9, .exponent = 1.5};
  Model model({single_mass("ball", mass, 0, 0)});
  add_weight(model, gravity, {0});
  const ContactSet contacts({contact_along_x(
      model, "ball.head", "", 0,
      contact::HuntCrossley::with_dimensionless_damping(
          {.stiffness = floor.stiffness, .exponent = floor.exponent}, damping, lowest_speed))});
  const double stable_steps = end * gravity * damping / lowest_speed / 6;
  Settings settings;
  settings.maximum_steps = static_cast<long>(1e-2 * stable_steps);
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(end, events);
  expect_at_rest(trajectory, floor, mass, 0);
}

/// s'' = jerk (t - start) after `start`, nothing before.
std::shared_ptr<const TimeFunction> beginning_to_fall(double start, double jerk) {
  return std::make_shared<PiecewiseFunction>(
      Given::acceleration,
      Pieces{.breaks = {start},
             .forms = {{.origin = start, .terms = {}, .polynomial = {}},
                       {.origin = start, .terms = {}, .polynomial = {0, jerk}}}},
      0.0);
}

// A rigid and a compliant contact at one place of the base: the rigid one carries all. The base
// falls away faster and faster, and leaves the ball where s'' = g.
TEST_P(SettlingOnContactsTest, RigidAndCompliantContactUntilTheBaseFallsAway) {
  const double mass = 2, height = 0.05, start = 2, jerk = 30;
  Model model({single_mass("ball", mass, 0, 0)});
  add_weight(model, gravity, {0});
  model.add_base_motion("fall", beginning_to_fall(start, jerk), {0}, Vector3::UnitX());
  const ContactSet contacts(
      {stop_on_base(model, "ball.head", height, newton(0.5)),
       stop_on_base(model, "ball.head", height, std::make_shared<KelvinVoigt>(4e4, 30))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(start, events);
  EXPECT_NEAR(trajectory.state()[0], height, 1e-11);
  const StateLayout &layout = trajectory.layout();
  EXPECT_NEAR(trajectory.state()[layout.impulse(0)] + trajectory.state()[layout.impulse(1)],
              mass * gravity * start, 1e-8);
  const std::size_t before = events.list.size();
  const double instant = start + gravity / jerk;
  trajectory.advance(instant + 0.1, events);
  const auto left =
      std::find_if(events.list.begin() + static_cast<std::ptrdiff_t>(before), events.list.end(),
                   [](const Events::Event &event) { return event.contact == 0 && event.to == 0; });
  ASSERT_NE(left, events.list.end());
  EXPECT_NEAR(left->time, instant, 1e-9);
  // Since then it lags behind the base by jerk t^3 / 6.
  EXPECT_NEAR(trajectory.state()[0], height - jerk * 1e-3 / 6, 1e-10);
  EXPECT_TRUE(trajectory.accuracy().balanced()) << trajectory.accuracy().energy_residual;
}

// The base of a ball at rest on a Kelvin-Voigt contact begins to fall with b > g:
//   u = u_e + m b / k exp(-z w t) (cos w_d t + z w / w_d sin w_d t),   u_e = m (g - b) / k,
// until k u + c u' = 0.
TEST_P(SettlingOnContactsTest, CompliantContactLeftByItsBase) {
  const double mass = 2, stiffness = 4e4, damping = 200, start = 1, fall = 25;
  Model model({single_mass("ball", mass, 0, 0)});
  add_weight(model, gravity, {0});
  const auto base = std::make_shared<PiecewiseFunction>(
      Given::acceleration,
      Pieces{.breaks = {start},
             .forms = {{.origin = start, .terms = {}, .polynomial = {}},
                       {.origin = start, .terms = {}, .polynomial = {fall}}}},
      0.0);
  model.add_base_motion("fall", base, {0}, Vector3::UnitX());
  const ContactSet contacts(
      {stop_on_base(model, "ball.head", 0.01, std::make_shared<KelvinVoigt>(stiffness, damping))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(1.2, events);
  const double omega = std::sqrt(stiffness / mass);
  const double rate = 0.5 * damping / mass;
  const double damped = std::sqrt(omega * omega - rate * rate);
  const auto force = [&](double t) {
    const double decay = mass * fall / stiffness * std::exp(-rate * t);
    const double u = mass * (gravity - fall) / stiffness +
                     decay * (std::cos(damped * t) + rate / damped * std::sin(damped * t));
    const double u_rate = -decay * omega * omega / damped * std::sin(damped * t);
    return stiffness * u + damping * u_rate;
  };
  double early = 0;
  double late = 3.14159 / damped;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (early + late);
    (force(middle) > 0 ? early : late) = middle;
  }
  const auto left = std::find_if(events.list.begin(), events.list.end(),
                                 [](const Events::Event &event) { return event.time > 1; });
  ASSERT_NE(left, events.list.end());
  EXPECT_EQ(left->to, 2);
  EXPECT_NEAR(left->time, start + early, 1e-10);
  EXPECT_EQ(events.list.back().to, 0);
}

// A mass put down without speed on a contact with the damping of its lowest approach speed, 1e-6
// m/s, sinks for seconds, without inertia: m g = k u^1.5 (1 + d u'), so that w = u^2.5 follows w'
// = 2.5 (m g / k - w^0.6) / d. Its decay is 1e5 times faster than the motion.
TEST(SettlingOnContactsOnceTest, SinksIntoAStiffDampingInFewSteps) {
  const double mass = 0.14, stiffness = 9e5, damping = 0.3, lowest = 1e-6;
  Model model({single_mass("block", mass, 0, 0)});
  add_weight(model, gravity, {0});
  const auto force = std::make_shared<Harmonic>(Given::displacement, 0.5, 40, 0);
  model.add_force("force", force, {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0,
                       contact::HuntCrossley::with_dimensionless_damping(
                           {.stiffness = stiffness, .exponent = 1.5}, damping, lowest))});
  Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-10});
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  const double end = 5;
  trajectory.advance(end, log);
  const auto rate = [&](double time, double w) {
    const double pressing = mass * gravity + force->value(time);
    return 2.5 * (pressing / stiffness - std::pow(w, 0.6)) * lowest / damping;
  };
  double w = 0;
  constexpr int intervals = 20000;
  const double h = end / intervals;
  for (int i = 0; i < intervals; ++i) {
    const double time = i * h;
    const double k1 = rate(time, w);
    const double k2 = rate(time + h / 2, w + h / 2 * k1);
    const double k3 = rate(time + h / 2, w + h / 2 * k2);
    w += h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(time + h, w + h * k3));
  }
  EXPECT_NEAR(trajectory.state()[0] / std::pow(w, 0.4), 1, 1e-5);
  EXPECT_LT(trajectory.accuracy().steps, 2000);
}

} // namespace settling_on_contacts_tests
} // namespace vibroimpact::motion
