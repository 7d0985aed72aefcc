// Rigid contacts in circular gaps against closed forms: flights and impacts, and contact that
// lasts.
#include "common/error.h"
#include "model/time_function.h"
#include "support/circular_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace rigid_rings_tests {

using namespace model;
using contact::ContactSet;
using contact::Coulomb;
using testing::isotropic;
using testing::ring_about_z;
using testing::settings_of;
using testing::vector_of;
constexpr double pi = std::numbers::pi;

Settings accurate(const std::string &method = "exact") {
  Settings settings = settings_of(method);
  settings.relative_tolerance = 1e-12;
  settings.absolute_tolerance = 0;
  return settings;
}

std::shared_ptr<const contact::ContactLaw> newton(double restitution) {
  return std::make_shared<contact::NewtonRestitution>(restitution);
}

std::shared_ptr<const Coulomb> coulomb(double coefficient) {
  return std::make_shared<Coulomb>(coefficient, coefficient);
}

Complex place(const Vector &x) { return {x[0], x[1]}; }
Complex speed(const Vector &x) { return {x[2], x[3]}; }
/// Along the normal, outwards, and along the wall in place of the velocity.
Complex along_wall(const Vector &x) { return speed(x) * std::conj(place(x)) / std::abs(place(x)); }

/// A free ball of 1.5 kg in a ring of the radius 1 m, from (.5, 0) with the velocity (.6, .8): it
/// meets the wall at .4 m/s along it.
struct Billiard {
  static constexpr double along = 0.4;
  static constexpr double into = 0.916515138991168; // sqrt(.84)
  static constexpr double first = 0.616515138991168;
  Model model{{isotropic("ball", 1.5, 0, 0)}};
  ContactSet contacts;
  Trajectory trajectory;

  explicit Billiard(double restitution,
                    const std::shared_ptr<const contact::TangentialLaw> &friction = nullptr,
                    const std::string &method = "exact")
      : contacts({ring_about_z(model, "ball.head", "", 1, newton(restitution), friction)}),
        trajectory(model, contacts, accurate(method)) {
    trajectory.start(0, vector_of({0.5, 0}), vector_of({0.6, 0.8}));
  }
  static double first_angle() { return std::atan2(0.8 * first, 0.5 + 0.6 * first); }
};

// Chords of equal length, 2 into / speed^2 apart, that turn by 2 atan(into / along).
TEST(RigidRings, BilliardWithoutLosses) {
  for (const std::string method : {"exact", "rk"}) {
    Billiard ball(1, nullptr, method);
    testing::Changes changes(ball.contacts);
    const int count = method == "exact" ? 500 : 20;
    const double chord = 2 * Billiard::into, turn = 2 * std::atan2(Billiard::into, Billiard::along);
    ball.trajectory.advance(Billiard::first + (count - 0.5) * chord, changes);
    ASSERT_EQ(changes.list.size(), static_cast<std::size_t>(count)) << method;
    double furthest = 0;
    for (int k = 0; k < count; ++k) {
      const auto &bounce = changes.list[static_cast<std::size_t>(k)];
      EXPECT_NEAR(bounce.time, Billiard::first + k * chord, 1e-12 * (1 + k));
      const Complex there = std::polar(1.0, Billiard::first_angle() + k * turn);
      furthest = std::max(furthest, std::abs(place(bounce.state) - there) / (1 + k));
      EXPECT_LT(std::abs(along_wall(bounce.state) - Complex(-Billiard::into, Billiard::along)),
                1e-12);
    }
    EXPECT_LT(furthest, 1e-12);
    const Vector &x = ball.trajectory.state();
    EXPECT_NEAR(std::abs(speed(x)), 1, 1e-13);
    EXPECT_NEAR(x[0] * x[3] - x[1] * x[2], 0.4, 1e-12);
    EXPECT_NEAR(x[ball.trajectory.layout().impulse(0)], count * 1.5 * 2 * Billiard::into,
                1e-12 * count);
  }
}

// The speed into the wall falls by e each time, that along it stays; infinitely many bounces end in
// even sliding.
TEST(RigidRings, BouncesThatEndInSliding) {
  const double e = 0.6;
  Billiard ball(e);
  testing::Changes changes(ball.contacts);
  ball.trajectory.advance(12, changes);
  double time = Billiard::first, angle = Billiard::first_angle(), into = Billiard::into;
  std::size_t k = 0;
  for (; into > 1e-3; ++k) {
    ASSERT_LT(k, changes.list.size());
    EXPECT_NEAR(changes.list[k].time, time, 1e-11);
    EXPECT_LT(std::abs(place(changes.list[k].state) - std::polar(1.0, angle)), 1e-11);
    into *= e;
    EXPECT_LT(std::abs(along_wall(changes.list[k].state) - Complex(-into, Billiard::along)), 1e-12);
    time += 2 * into / (into * into + 0.16);
    angle += 2 * std::atan2(into, Billiard::along);
  }
  for (; into > 0; into = into > 1e-18 ? e * into : 0) {
    time += 2 * e * into / (e * e * into * into + 0.16);
    angle += 2 * std::atan2(e * into, Billiard::along);
  }
  EXPECT_EQ(ball.trajectory.accuracy().chatters, 1);
  EXPECT_EQ(changes.list.back().to, "resting");
  const Vector &x = ball.trajectory.state();
  EXPECT_LT(std::abs(place(x) - std::polar(1.0, angle + Billiard::along * (12 - time))), 1e-10);
  EXPECT_LT(std::abs(along_wall(x) - Complex(0, Billiard::along)), 1e-11);
  const double lost = 0.75 * Billiard::into * Billiard::into;
  EXPECT_NEAR(x[ball.trajectory.layout().contact_work(0)], lost, 1e-11 * lost);
  EXPECT_LT(ball.trajectory.accuracy().energy_residual, 1e-11);
}

// Each bounce takes mu (1 + e) of the speed into the wall from that along it.
TEST(RigidRings, BouncesWithFriction) {
  const double e = 0.8, mu = 0.02;
  Billiard ball(e, coulomb(mu));
  testing::Changes changes(ball.contacts);
  ball.trajectory.advance(24, changes);
  double time = Billiard::first, angle = Billiard::first_angle();
  double into = Billiard::into, along = Billiard::along;
  std::size_t k = 0;
  for (; along > mu * (1 + e) * into && time < 23; ++k) {
    ASSERT_LT(k, changes.list.size());
    EXPECT_NEAR(changes.list[k].time, time, 1e-10);
    EXPECT_LT(std::abs(place(changes.list[k].state) - std::polar(1.0, angle)), 1e-10);
    along -= mu * (1 + e) * into;
    into *= e;
    EXPECT_LT(std::abs(along_wall(changes.list[k].state) - Complex(-into, along)), 1e-12);
    time += 2 * into / (into * into + along * along);
    angle += 2 * std::atan2(into, along);
  }
  EXPECT_GE(k, 6u);
  EXPECT_LT(ball.trajectory.accuracy().energy_residual, 1e-12);
}

// Along a diameter a ring is a pair of plane stops, in whatever direction the diameter lies.
TEST(RigidRings, AlongADiameter) {
  const double clearance = 0.013, end = 0.4;
  const Model on_line({testing::single_mass("ball", 1.5, 400, 0.3)});
  contact::ContactPair right =
      testing::contact_along_x(on_line, "ball.head", "", clearance, newton(0.7));
  contact::ContactPair left = right;
  left.gap.row *= -1;
  const ContactSet stops({right, left});
  Trajectory line(on_line, stops, accurate());
  line.start(0, vector_of({0.002}), vector_of({0.8}));
  line.advance(end);
  for (const double angle : {0.0, 0.7, pi / 2, 2.5}) {
    const Model model({isotropic("ball", 1.5, 400, 0.3)});
    const ContactSet contacts({ring_about_z(model, "ball.head", "", clearance, newton(0.7))});
    Trajectory trajectory(model, contacts, accurate());
    const Vector direction = vector_of({std::cos(angle), std::sin(angle)});
    trajectory.start(0, 0.002 * direction, 0.8 * direction);
    trajectory.advance(end);
    EXPECT_EQ(trajectory.accuracy().events, line.accuracy().events);
    EXPECT_LT((trajectory.state().head(2) - line.state()[0] * direction).norm(), 1e-13);
    EXPECT_LT((trajectory.state().segment(2, 2) - line.state()[1] * direction).norm(), 1e-11);
  }
}

// v' = -mu v^2 / c along the wall.
TEST(RigidRings, SlidingWithFriction) {
  const double c = 0.3, v = 2, end = 1;
  for (const std::string method : {"exact", "rk"})
    for (const double mu : {0.0, 0.1, 0.6}) {
      const Model model({isotropic("ball", 1.5, 0, 0)});
      const ContactSet contacts(
          {ring_about_z(model, "ball.head", "", c, newton(0.5), mu > 0 ? coulomb(mu) : nullptr)});
      Trajectory trajectory(model, contacts, accurate(method));
      testing::Changes changes(contacts);
      trajectory.start(0, vector_of({c, 0}), vector_of({0, v}));
      trajectory.advance(end, changes);
      EXPECT_TRUE(changes.list.empty());
      const double slower = 1 + mu * v * end / c;
      const double angle = mu > 0 ? std::log(slower) / mu : v * end / c;
      const Vector &x = trajectory.state();
      EXPECT_LT(std::abs(place(x) - std::polar(c, angle)), 1e-10 * c) << mu << method;
      EXPECT_NEAR(std::abs(place(x)), c, method == "exact" ? 1e-14 : 1e-11 * c) << mu << method;
      EXPECT_LT(std::abs(along_wall(x) - Complex(0, v / slower)), 1e-11 * v) << mu << method;
      EXPECT_LT(trajectory.accuracy().energy_residual, method == "exact" ? 1e-14 : 1e-10);
      if (mu > 0) {
        const double taken = 0.75 * v * v * (1 - 1 / (slower * slower));
        EXPECT_NEAR(x[trajectory.layout().friction_work(0)], taken, 1e-10 * taken);
        EXPECT_NEAR(x[trajectory.layout().sliding_way(0)], c * angle, 1e-10 * c * angle);
      }
    }
}

void add_fall(Model &model, double gravity) {
  model.add_gravity("weight", make_constant(Given::displacement, gravity), {0}, -Vector3::UnitY());
}

// From the lowest point with v^2 between 2 g c and 5 g c: the ball leaves where
// v^2 - 2 g c (1 - cos f) = -g c cos f, and falls freely from there.
TEST(RigidRings, LeavesTheUpperHalf) {
  const double c = 0.4, g = 9.81, v = std::sqrt(3.5 * g * c),
               cosine = (2 * g * c - v * v) / (3 * g * c);
  Model model({isotropic("ball", 1.5, 0, 0)});
  add_fall(model, g);
  const ContactSet contacts({ring_about_z(model, "ball.head", "", c, newton(0.5))});
  Trajectory trajectory(model, contacts, accurate());
  testing::Changes changes(contacts);
  trajectory.start(0, vector_of({0, -c}), vector_of({v, 0}));
  trajectory.advance(0.42, changes);
  ASSERT_EQ(changes.list.size(), 1u);
  EXPECT_EQ(changes.list[0].to, "open");
  const Vector &left = changes.list[0].state;
  EXPECT_NEAR(left[1], -c * cosine, 1e-10 * c);
  EXPECT_NEAR(std::abs(place(left)), c, 1e-13);
  EXPECT_NEAR(std::abs(speed(left)), std::sqrt(-g * c * cosine), 1e-10 * v);
  const double after = 0.42 - changes.list[0].time;
  const Complex falls = place(left) + after * speed(left) - Complex(0, g * after * after / 2);
  EXPECT_LT(std::abs(place(trajectory.state()) - falls), 1e-13);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
}

// Beside a disc, from its top: at cos f = 2 / 3 + v^2 / (3 g c).
TEST(RigidRings, SlidesOffADisc) {
  const double c = 0.4, g = 9.81, v = 0.3;
  Model model({isotropic("ball", 1.5, 0, 0)});
  add_fall(model, g);
  const ContactSet contacts({ring_about_z(model, "ball.head", "", c, newton(0.5), nullptr, 0,
                                          contact::CircularGap::Kind::beside, {0, -c})});
  Trajectory trajectory(model, contacts, accurate());
  testing::Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({v, 0}));
  trajectory.advance(0.6, changes);
  ASSERT_EQ(changes.list.size(), 1u);
  EXPECT_EQ(changes.list[0].to, "open");
  EXPECT_NEAR(changes.list[0].state[1] + c, c * (2.0 / 3 + v * v / (3 * g * c)), 1e-10 * c);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
}

// From the lowest point up the wall with friction: with y = v^2 / (g c),
// dy/df = -2 sin f - 2 mu (y + cos f), solved by a cosine, a sine and exp(-2 mu f). It stops, and
// stays where tan f < mu; where it is steeper it slides back.
TEST(RigidRings, StopsAndSticks) {
  const double c = 0.4, g = 9.81;
  const auto stop = [](double mu, double y0) {
    const double a = (2 - 4 * mu * mu) / (1 + 4 * mu * mu), b = -6 * mu / (1 + 4 * mu * mu);
    const auto y = [&](double f) {
      return (y0 - a) * std::exp(-2 * mu * f) + a * std::cos(f) + b * std::sin(f);
    };
    double low = 0, high = pi / 2;
    for (int i = 0; i < 100; ++i)
      (y((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    return low;
  };
  for (const std::string method : {"exact", "rk"})
    for (const auto &[mu, y0, sticks] : {std::tuple(0.6, 0.5, true), std::tuple(0.3, 1.2, false)}) {
      Model model({isotropic("ball", 1.5, 0, 0)});
      add_fall(model, g);
      const ContactSet contacts(
          {ring_about_z(model, "ball.head", "", c, newton(0.5), coulomb(mu))});
      Trajectory trajectory(model, contacts, accurate(method));
      testing::Changes changes(contacts);
      trajectory.start(0, vector_of({0, -c}), vector_of({std::sqrt(y0 * g * c), 0}));
      trajectory.advance(3, changes);
      const double highest = stop(mu, y0);
      EXPECT_EQ(std::tan(highest) < mu, sticks);
      ASSERT_EQ(changes.list.size(), sticks ? 1u : 2u) << method;
      EXPECT_NEAR(std::atan2(changes.list[0].state[0], -changes.list[0].state[1]), highest, 1e-10);
      EXPECT_EQ(changes.list[0].to, sticks ? "stick" : "slip forward");
      EXPECT_EQ(changes.list.back().to, "stick");
      const Vector &x = trajectory.state();
      EXPECT_LT(std::abs(speed(x)), 1e-12);
      EXPECT_NEAR(std::abs(place(x)), c, 1e-11 * c);
      EXPECT_LT(std::abs(place(x) - place(changes.list.back().state)), 1e-12);
      EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
    }
}

// A rotor with an unbalance along the wall: (1 - W^2) c + N and d W c + mu N balance e W^2.
TEST(RigidRings, SynchronousWhirl) {
  const double c = 0.1, eccentricity = 0.05, damping = 0.1;
  for (const double mu : {0.0, 0.3})
    for (const double w : {0.9, 1.1}) {
      const auto load = [&](double n) {
        return Complex((1 - w * w) * c + n, damping * w * c + mu * n);
      };
      double low = std::max(0.0, (w * w - 1) * c), high = 1;
      for (int i = 0; i < 200; ++i)
        (std::abs(load((low + high) / 2)) > eccentricity * w * w ? high : low) = (low + high) / 2;
      const Model model = testing::unbalanced_rotor(damping, eccentricity, w);
      const ContactSet contacts(
          {ring_about_z(model, "rotor.head", "", c, newton(0.5), mu > 0 ? coulomb(mu) : nullptr)});
      Trajectory trajectory(model, contacts, accurate());
      const Complex start = std::polar(c, -std::arg(load(low)));
      const double end = 3 * 2 * pi / w;
      testing::Changes changes(contacts);
      trajectory.start(0, vector_of({start.real(), start.imag()}),
                       vector_of({-w * start.imag(), w * start.real()}));
      trajectory.advance(end, changes);
      EXPECT_TRUE(changes.list.empty());
      const Vector &x = trajectory.state();
      EXPECT_LT(std::abs(place(x) - start * std::polar(1.0, w * end)), 1e-10 * c) << mu << " " << w;
      EXPECT_NEAR(std::abs(place(x)), c, 1e-13);
      EXPECT_NEAR(x[trajectory.layout().impulse(0)] / end, low, 1e-10 * low);
      EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
      if (mu > 0) {
        EXPECT_NEAR(x[trajectory.layout().friction_work(0)] / end, mu * low * w * c,
                    1e-10 * mu * low * w * c);
      }
    }
}

// A disc that turns fast and is driven backwards along the wall: its whirl w follows
// w' = mu (w^2 - 1) - d w; it stays at the upper zero, and leaves the wall at w = 1 from below it.
TEST(RigidRings, DryBackwardWhirl) {
  const double d = 0.1, mu = 0.2, c = 0.1, surface = 50;
  const double root = std::sqrt(d * d / (mu * mu) + 4);
  const double upper = (d / mu + root) / 2, lower = (d / mu - root) / 2;
  EXPECT_NEAR(upper, 1.280776406404, 1e-12);
  const Model model({isotropic("disc", 1, 1, d)});
  const ContactSet contacts(
      {ring_about_z(model, "disc.head", "", c, newton(0.5), coulomb(mu), -surface)});
  Trajectory trajectory(model, contacts, accurate());
  testing::Changes changes(contacts);
  trajectory.start(0, vector_of({c, 0}), vector_of({0, -upper * c}));
  const double end = 2 * 2 * pi / upper;
  trajectory.advance(end, changes);
  EXPECT_TRUE(changes.list.empty());
  EXPECT_LT(std::abs(place(trajectory.state()) - std::polar(c, -upper * end)), 1e-10 * c);
  const double force = (upper * upper - 1) * c;
  EXPECT_NEAR(trajectory.state()[trajectory.layout().friction_work(0)] / end,
              mu * force * (surface - upper * c), 1e-9);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
  // (w - upper) / (w - lower) grows by exp(mu (upper - lower) t).
  const double start = 1.2;
  const auto ratio = [&](double w) { return (w - upper) / (w - lower); };
  const double leaves = std::log(ratio(1) / ratio(start)) / (mu * root);
  trajectory.start(0, vector_of({c, 0}), vector_of({0, -start * c}));
  trajectory.advance(leaves + 0.01, changes);
  ASSERT_EQ(changes.list.size(), 1u);
  EXPECT_EQ(changes.list[0].to, "open");
  EXPECT_NEAR(changes.list[0].time, leaves, 1e-9);
}

// Linear rings of growing stiffness: the ball slides over the wall with friction, deeper by N / k.
TEST(RigidRings, LimitOfStiffRings) {
  const double c = 0.3, v = 2, mu = 0.3, end = 0.5;
  const Model model({isotropic("ball", 1, 0, 0)});
  const double slower = 1 + mu * v * end / c;
  const Complex rigid = std::polar(c, std::log(slower) / mu);
  double before = 0;
  for (const double k : {4e4, 16e4, 64e4}) {
    const ContactSet contacts({ring_about_z(
        model, "ball.head", "", c, std::make_shared<contact::LinearPenalty>(k), coulomb(mu))});
    Trajectory trajectory(model, contacts, accurate());
    trajectory.start(0, vector_of({c + v * v / c / k, 0}), vector_of({0, v}));
    trajectory.advance(end);
    const double distance = std::abs(place(trajectory.state()) - rigid);
    if (before > 0) {
      EXPECT_NEAR(before / distance, 4, 0.2);
    }
    before = distance;
  }
}

// A ball that slides along the wall meets a plane stop: both act at that instant. The stop turns
// its velocity along x round, which takes it off the wall.
TEST(RigidRings, MeetsAStopWhileSliding) {
  const double c = 1, v = 0.7, e = 0.6, stop = 0.5;
  const Model model({isotropic("ball", 1.5, 0, 0)});
  const ContactSet contacts({ring_about_z(model, "ball.head", "", c, newton(0)),
                             testing::contact_along_x(model, "ball.head", "", stop, newton(e))});
  Trajectory trajectory(model, contacts, accurate());
  testing::Changes changes(contacts);
  trajectory.start(0, vector_of({0, -c}), vector_of({v, 0}));
  const double angle = std::asin(stop / c);
  trajectory.advance(angle * c / v + 0.1, changes);
  ASSERT_GE(changes.list.size(), 1u);
  EXPECT_NEAR(changes.list[0].time, angle * c / v, 1e-11);
  const Vector &x = trajectory.state();
  EXPECT_NEAR(x[2], -e * v * std::cos(angle), 1e-11);
  EXPECT_NEAR(x[3], v * std::sin(angle), 1e-11);
  EXPECT_NEAR(x[1], -c * std::cos(angle) + 0.1 * x[3], 1e-11);
  EXPECT_EQ(trajectory.equations().mode(0).name, "open");
}

// Two bodies see their relative motion alone: a free ring and a ball in it, against a ball of the
// mass that meets; and the centre of mass goes on.
TEST(RigidRings, BallInAFreeRing) {
  const double clearance = 0.02, ball = 1.5, ring = 4, meets = ball * ring / (ball + ring);
  const Model model({isotropic("ball", ball, 0, 0), isotropic("ring", ring, 0, 0)});
  const ContactSet contacts(
      {ring_about_z(model, "ball.head", "ring.head", clearance, newton(0.4), coulomb(0.05))});
  Trajectory both(model, contacts, accurate());
  testing::Changes changes(contacts);
  both.start(0, vector_of({0.004, -0.003, 0, 0}), vector_of({0.3, 0.5, 0, 0}));
  both.advance(2, changes);
  const Model alone({isotropic("ball", meets, 0, 0)});
  const ContactSet fixed(
      {ring_about_z(alone, "ball.head", "", clearance, newton(0.4), coulomb(0.05))});
  Trajectory one(alone, fixed, accurate());
  testing::Changes same(fixed);
  one.start(0, vector_of({0.004, -0.003}), vector_of({0.3, 0.5}));
  one.advance(2, same);
  EXPECT_GE(changes.list.size(), 6u);
  EXPECT_EQ(changes.list.size(), same.list.size());
  EXPECT_EQ(one.equations().mode(0).name, both.equations().mode(0).name);
  EXPECT_TRUE(one.equations().mode(0).holds_gap);
  const Vector &x = both.state();
  EXPECT_LT((x.head(2) - x.segment(2, 2) - one.state().head(2)).norm(), 1e-10 * clearance);
  EXPECT_NEAR(ball * x[4] + ring * x[6], ball * 0.3, 1e-13);
  EXPECT_NEAR(ball * x[5] + ring * x[7], ball * 0.5, 1e-13);
  EXPECT_LT(both.accuracy().energy_residual, 1e-10);
}

} // namespace rigid_rings_tests
} // namespace vibroimpact::motion
