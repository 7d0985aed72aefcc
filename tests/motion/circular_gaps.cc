// Contacts in circular gaps against closed forms, plane contacts, quadrature and differences.
#include "common/error.h"
#include "contact/friction/spring_slider.h"
#include "contact/friction/viscous.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "model/time_function.h"
#include "motion/variation/linearised_motion.h"
#include "support/circular_contacts.h"
#include "support/motion_derivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace vibroimpact::motion {
namespace circular_gaps_tests {

using namespace model;
using contact::ContactSet;
using contact::Coulomb;
using contact::LinearPenalty;
using contact::SpringSlider;
using contact::Viscous;
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

Complex place(const Trajectory &trajectory) {
  return {trajectory.state()[0], trajectory.state()[1]};
}

/// A rotor with an unbalance, m = k = 1, in a ring of stiffness .5.
struct Rub {
  double speed = 0, damping = 0.1, radius = 0;
  /// The force of friction against the whirl, at a normal force and a slip rate.
  std::function<double(double, double)> friction;
  static constexpr double clearance = 0.1, eccentricity = 0.05, ring = 0.5;

  double normal_force() const { return ring * (radius - clearance); }
  // q = r exp(i (W t + phase)): what the unbalance m e W^2 balances, over the whirl.
  Complex load() const {
    return {(1 - speed * speed) * radius + normal_force(),
            damping * speed * radius + friction(normal_force(), speed * radius)};
  }
  void solve() {
    double low = clearance, high = 1;
    for (int i = 0; i < 200; ++i) {
      radius = (low + high) / 2;
      (std::abs(load()) > eccentricity * speed * speed ? high : low) = radius;
    }
  }
  Model model() const { return testing::unbalanced_rotor(damping, eccentricity, speed); }
  Complex at(double time) const { return std::polar(radius, speed * time - std::arg(load())); }
};

// Digits of the radius from the literature's closed form; a spring-slider that slips and a dashpot
// make the same equation with another friction.
TEST(CircularGaps, SynchronousRub) {
  struct Case {
    double speed, mu, radius;
  };
  for (const Case &of : {Case{0.9, 0.02, .128586879700}, Case{1.0, 0.02, .191586342698},
                         Case{1.1, 0.02, .332272610326}, Case{1.3, 0.1, .162789290904},
                         Case{1.0, 0.1, .188504135468}}) {
    Rub rub{.speed = of.speed, .friction = [&](double n, double) { return of.mu * n; }};
    rub.solve();
    EXPECT_NEAR(rub.radius, of.radius, 1e-12);
    const Model model = rub.model();
    const ContactSet contacts({ring_about_z(model, "rotor.head", "", Rub::clearance,
                                            std::make_shared<LinearPenalty>(Rub::ring),
                                            std::make_shared<Coulomb>(of.mu, of.mu))});
    Trajectory trajectory(model, contacts, accurate());
    const Complex start = rub.at(0), velocity = Complex(0, of.speed) * start;
    trajectory.start(0, vector_of({start.real(), start.imag()}),
                     vector_of({velocity.real(), velocity.imag()}));
    const double end = 10 * 2 * pi / of.speed;
    testing::Changes changes(contacts);
    trajectory.advance(end, changes);
    EXPECT_TRUE(changes.list.empty());
    EXPECT_LT(std::abs(place(trajectory) - rub.at(end)), 1e-11 * rub.radius) << of.speed;
    const StateLayout &layout = trajectory.layout();
    const double power = of.mu * rub.normal_force() * of.speed * rub.radius;
    EXPECT_NEAR(trajectory.state()[layout.friction_work(0)] / end, power, 1e-11 * power);
    EXPECT_NEAR(trajectory.state()[layout.wear_work(0)] / end, power / of.mu,
                1e-11 * power / of.mu);
    EXPECT_NEAR(trajectory.state()[layout.impulse(0)] / end, rub.normal_force(),
                1e-11 * rub.normal_force());
    EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
  }
}

TEST(CircularGaps, SynchronousRubWithOtherFriction) {
  const double mu = 0.1, dashpot = 0.07;
  const std::vector<std::pair<std::shared_ptr<const contact::TangentialLaw>,
                              std::function<double(double, double)>>>
      laws = {
          {std::make_shared<Viscous>(dashpot), [&](double, double v) { return dashpot * v; }},
          {std::make_shared<SpringSlider>(4.0, mu, 0), [&](double n, double) { return mu * n; }},
          {std::make_shared<Coulomb>(mu, mu, dashpot),
           [&](double n, double v) { return mu * n + dashpot * v; }}};
  for (const auto &[law, friction] : laws) {
    Rub rub{.speed = 1.1, .friction = friction};
    rub.solve();
    const Model model = rub.model();
    const ContactSet contacts({ring_about_z(model, "rotor.head", "", Rub::clearance,
                                            std::make_shared<LinearPenalty>(Rub::ring), law)});
    Trajectory trajectory(model, contacts, accurate());
    const Complex start = rub.at(0), velocity = Complex(0, rub.speed) * start;
    trajectory.start(0, vector_of({start.real(), start.imag()}),
                     vector_of({velocity.real(), velocity.imag()}));
    const double end = 150 * 2 * pi / rub.speed; // the slider sticks at first
    testing::Changes changes(contacts);
    trajectory.advance(end, changes);
    EXPECT_LT(std::abs(place(trajectory) - rub.at(end)), 2e-11 * rub.radius) << law->name();
    EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10) << law->name();
  }
}

// A disc that turns fast drives itself backwards along the ring: a saddle. The surface of the ring
// moves backwards along the disc's.
TEST(CircularGaps, DryBackwardWhirl) {
  const double c = 0.1, mu = 0.2, ring = 30, clearance = 0.1, surface = 50;
  const double whirl = (c / mu + std::sqrt(c * c / (mu * mu) + 4)) / 2;
  const double radius = ring * clearance / (ring - c * whirl / mu);
  EXPECT_NEAR(whirl, 1.280776406404, 1e-12);
  EXPECT_NEAR(radius, .102181187570, 1e-12);
  const Model model({isotropic("disc", 1, 1, c)});
  const ContactSet contacts(
      {ring_about_z(model, "disc.head", "", clearance, std::make_shared<LinearPenalty>(ring),
                    std::make_shared<Coulomb>(mu, mu), -surface)});
  Trajectory trajectory(model, contacts, accurate());
  trajectory.start(0, vector_of({radius, 0}), vector_of({0, -whirl * radius}));
  const double end = 2 * 2 * pi / whirl;
  testing::Changes changes(contacts);
  trajectory.advance(end, changes);
  EXPECT_LT(std::abs(place(trajectory) - std::polar(radius, -whirl * end)), 1e-10 * radius);
  const double force = ring * (radius - clearance);
  EXPECT_NEAR(trajectory.state()[trajectory.layout().friction_work(0)] / end,
              mu * force * (surface - whirl * radius), 1e-9);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

std::vector<std::shared_ptr<const contact::ContactLaw>> normal_laws() {
  using namespace contact;
  return {std::make_shared<LinearPenalty>(3e4), std::make_shared<KelvinVoigt>(3e4, 90),
          std::make_shared<Hertz>(HertzConstants{.stiffness = 1e5}),
          HuntCrossley::with_dissipation({.stiffness = 1e5}, 0.2)};
}

// Along a diameter a ring is a pair of plane stops, in whatever direction the diameter lies.
TEST(CircularGaps, AlongADiameter) {
  const double clearance = 0.013, end = 0.4;
  for (const auto &law : normal_laws())
    for (const double angle : {0.0, 0.7, pi / 2, 2.5}) {
      const Model on_line({testing::single_mass("ball", 1.5, 400, 0.3)});
      contact::ContactPair right =
          testing::contact_along_x(on_line, "ball.head", "", clearance, law);
      contact::ContactPair left = right;
      left.gap.row *= -1;
      const ContactSet stops({right, left});
      Trajectory line(on_line, stops, accurate());
      line.start(0, vector_of({0.002}), vector_of({0.8}));
      line.advance(end);
      const Model model({isotropic("ball", 1.5, 400, 0.3)});
      const ContactSet contacts({ring_about_z(model, "ball.head", "", clearance, law)});
      Trajectory trajectory(model, contacts, accurate());
      const Vector direction = vector_of({std::cos(angle), std::sin(angle)});
      trajectory.start(0, 0.002 * direction, 0.8 * direction);
      trajectory.advance(end);
      EXPECT_EQ(trajectory.accuracy().events, line.accuracy().events) << law->name();
      EXPECT_LT((trajectory.state().head(2) - line.state()[0] * direction).norm(),
                1e-11 * clearance)
          << law->name() << angle;
      EXPECT_LT((trajectory.state().segment(2, 2) - line.state()[1] * direction).norm(),
                1e-10 * 0.8)
          << law->name() << angle;
    }
}

// Straight flights of a free ball from (.5, 0): first touch of a ring with the radius 1.
TEST(CircularGaps, FirstTouch) {
  const Model model({isotropic("ball", 1, 0, 0)});
  const ContactSet contacts(
      {ring_about_z(model, "ball.head", "", 1, std::make_shared<LinearPenalty>(1e4))});
  for (const std::string method : {"exact", "rk"}) {
    Trajectory trajectory(model, contacts, accurate(method));
    testing::Events events;
    trajectory.start(0, vector_of({0.5, 0}), vector_of({0.6, 0.8}));
    trajectory.advance(1, events);
    ASSERT_EQ(events.list.size(), 2u);
    EXPECT_NEAR(events.list[0].time, 0.616515138991168, 1e-12);
    EXPECT_NEAR(events.list[0].gap_rate, -0.916515138991168, 1e-12);
  }
}

// Bounces of a free ball without friction: by the integrals of energy and angular momentum,
// (dr/dt)^2 = v^2 - h^2 / r^2 - k (r - c)^2, and the substitution r = c + d - w^2.
TEST(CircularGaps, BounceByQuadrature) {
  const double k = 900, c = 0.1, h = 0.04, speed = 0.7;
  const auto radial = [&](double r) {
    return speed * speed - h * h / (r * r) - (r > c ? k * (r - c) * (r - c) : 0);
  };
  double low = c, high = 2 * c;
  for (int i = 0; i < 200; ++i)
    (radial((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const double depth = low - c;
  double duration = 0, turn = 0;
  const int count = 400;
  for (int i = 0; i < count; ++i)
    for (const auto &[node, weight] :
         {std::pair(-std::sqrt(0.6), 5.0), std::pair(0.0, 8.0), std::pair(std::sqrt(0.6), 5.0)}) {
      const double w = std::sqrt(depth) * (i + (1 + node) / 2) / count, r = low - w * w;
      const double part = 2 * w / std::sqrt(radial(r)) * weight / 18 * std::sqrt(depth) / count;
      duration += 2 * part;
      turn += 2 * part * h / (r * r);
    }
  const Model model({isotropic("ball", 1, 0, 0)});
  const ContactSet contacts(
      {ring_about_z(model, "ball.head", "", c, std::make_shared<LinearPenalty>(k))});
  Trajectory trajectory(model, contacts, accurate());
  testing::Changes changes(contacts);
  trajectory.start(0, vector_of({0.05, h / speed}), vector_of({speed, 0}));
  trajectory.advance(0.6, changes);
  ASSERT_GE(changes.list.size(), 4u);
  const auto angle = [](const Vector &x) { return std::atan2(x[1], x[0]); };
  EXPECT_NEAR(changes.list[1].time - changes.list[0].time, duration, 1e-9 * duration);
  EXPECT_NEAR(
      std::remainder(angle(changes.list[0].state) - angle(changes.list[1].state) - turn, 2 * pi), 0,
      1e-9);
  const Vector &x = trajectory.state();
  EXPECT_NEAR(x[0] * x[3] - x[1] * x[2], -h, 1e-11 * h);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
}

// Two bodies see their relative motion alone: a free ring and a ball in it, against a ball of the
// mass that meets; and the centre of mass goes on.
TEST(CircularGaps, BallInAFreeRing) {
  const double clearance = 0.02, ball = 1.5, ring = 4, meets = ball * ring / (ball + ring);
  const auto law = std::make_shared<contact::KelvinVoigt>(3e4, 20);
  const auto friction = std::make_shared<Viscous>(30);
  const Model model({isotropic("ball", ball, 0, 0), isotropic("ring", ring, 0, 0)});
  const ContactSet contacts(
      {ring_about_z(model, "ball.head", "ring.head", clearance, law, friction)});
  Trajectory both(model, contacts, accurate());
  testing::Changes changes(contacts);
  both.start(0, vector_of({0.004, -0.003, 0, 0}), vector_of({0.3, 0.5, 0, 0}));
  both.advance(0.4, changes);
  const Model alone({isotropic("ball", meets, 0, 0)});
  const ContactSet fixed({ring_about_z(alone, "ball.head", "", clearance, law, friction)});
  Trajectory one(alone, fixed, accurate());
  testing::Changes same(fixed);
  one.start(0, vector_of({0.004, -0.003}), vector_of({0.3, 0.5}));
  one.advance(0.4, same);
  EXPECT_GE(changes.list.size(), 6u);
  EXPECT_EQ(changes.list.size(), same.list.size());
  const Vector &x = both.state();
  EXPECT_LT((x.head(2) - x.segment(2, 2) - one.state().head(2)).norm(), 1e-10 * clearance);
  EXPECT_NEAR(ball * x[4] + ring * x[6], ball * 0.3, 1e-11);
  EXPECT_NEAR(ball * x[5] + ring * x[7], ball * 0.5, 1e-11);
  EXPECT_LT(both.accuracy().energy_residual, 1e-10);
}

// Discs beside each other: a head-on impact is that of a plane contact, and the other disc is
// passed at the distance of the radii where the ball flies by just outside.
TEST(CircularGaps, BesideEachOther) {
  const double radii = 0.3, gap = 0.1;
  const auto beside = [&](const Model &model,
                          const std::shared_ptr<const contact::ContactLaw> &law) {
    return ContactSet({ring_about_z(model, "ball.head", "", radii, law, nullptr, 0,
                                    contact::CircularGap::Kind::beside, {radii + gap, 0})});
  };
  const Model model({isotropic("ball", 1.5, 0, 0)});
  for (const auto &law : normal_laws()) {
    const Model on_line({testing::single_mass("ball", 1.5, 0, 0)});
    const ContactSet stop({testing::contact_along_x(on_line, "ball.head", "", gap, law)});
    Trajectory line(on_line, stop, accurate());
    line.start(0, vector_of({0.0}), vector_of({0.8}));
    line.advance(0.3);
    const ContactSet contacts = beside(model, law);
    Trajectory trajectory(model, contacts, accurate());
    trajectory.start(0, vector_of({0, 0}), vector_of({0.8, 0}));
    trajectory.advance(0.3);
    EXPECT_NEAR(trajectory.state()[0], line.state()[0], 1e-11) << law->name();
    EXPECT_NEAR(trajectory.state()[2], line.state()[1], 1e-10) << law->name();
  }
  const ContactSet contacts = beside(model, std::make_shared<LinearPenalty>(1e4));
  Trajectory trajectory(model, contacts, accurate());
  for (const double side : {1 + 1e-9, 1 - 1e-6}) {
    testing::Changes changes(contacts);
    trajectory.start(0, vector_of({0, radii * side}), vector_of({0.8, 0}));
    trajectory.advance(1, changes);
    EXPECT_EQ(changes.list.size(), side > 1 ? 0u : 2u);
  }
}

// A ring whose centre lies beside the point, at rest on its spring: where both forces balance.
TEST(CircularGaps, PressedByEccentricity) {
  const double c = 0.01, e = 0.015, ring = 3000, spring = 1000;
  const Model model({isotropic("ball", 1, spring, 80)});
  const ContactSet contacts(
      {ring_about_z(model, "ball.head", "", c, std::make_shared<LinearPenalty>(ring), nullptr, 0,
                    contact::CircularGap::Kind::inside, {0.6 * e, 0.8 * e})});
  Trajectory trajectory(model, contacts, accurate());
  trajectory.start(0, vector_of({0, 0}), vector_of({0, 0}));
  trajectory.advance(2);
  const double moved = ring * (e - c) / (ring + spring);
  EXPECT_NEAR(trajectory.state()[0], 0.6 * moved, 1e-11);
  EXPECT_NEAR(trajectory.state()[1], 0.8 * moved, 1e-11);
}

// The sides cannot stick by Coulomb's law in a circular gap, and a motion that comes to it says so.
TEST(CircularGaps, StickIsRefused) {
  const Model model({isotropic("ball", 1, 0, 0)});
  const ContactSet contacts(
      {ring_about_z(model, "ball.head", "", 0.1, std::make_shared<LinearPenalty>(900),
                    std::make_shared<Coulomb>(0.5, 0.5))});
  Trajectory trajectory(model, contacts, accurate());
  trajectory.start(0, vector_of({0, 0.01}), vector_of({1, 0}));
  try {
    trajectory.advance(10);
    FAIL();
  } catch (const NumericalError &error) {
    EXPECT_NE(std::string(error.what()).find("contact ring comes to stick"), std::string::npos);
  }
}

// By a start, of motions through several contacts, against differences.
TEST(CircularGaps, VariationAgainstDifferences) {
  const Model model({isotropic("ball", 2, 400, 0.5)});
  const std::vector<std::shared_ptr<const contact::TangentialLaw>> friction = {
      nullptr, std::make_shared<Coulomb>(0.2, 0.2, 3), std::make_shared<Viscous>(20)};
  const Vector start = vector_of({0.003, -0.004, 0.3, 0.45});
  const Vector scale = vector_of({1e-3, 1e-3, 0.1, 0.1});
  for (const auto &normal : normal_laws())
    for (const auto &tangential : friction) {
      const ContactSet contacts(
          {ring_about_z(model, "ball.head", "", 0.013, normal, tangential, 5)});
      Trajectory trajectory(model, contacts, accurate());
      for (const double end : {0.0265, 0.15}) {
        const auto image = [&](const Vector &from) {
          trajectory.start({.time = 0, .physical = from});
          trajectory.advance(end);
          return Vector(trajectory.motion_state().physical.cwiseQuotient(scale));
        };
        trajectory.start({.time = 0, .physical = start});
        Variation variation(trajectory, scale.cwiseInverse(), 1e-12);
        variation.set_columns(Matrix::Identity(4, 4));
        trajectory.advance(end, variation);
        const Matrix columns =
            scale.cwiseInverse().asDiagonal() * variation.columns() * scale.asDiagonal();
        for (Index j = 0; j < 4; ++j) {
          const auto difference = testing::numerical_derivative(
              [&](double h) {
                return std::optional(image(start + h * scale[j] * Vector::Unit(4, j)));
              },
              1e-3, 4);
          EXPECT_LT((difference.value - columns.col(j)).cwiseAbs().maxCoeff(),
                    1e-7 * difference.value.cwiseAbs().maxCoeff())
              << normal->name() << ", " << (tangential ? tangential->name() : "none")
              << ", t = " << end << ", column " << j << ": " << difference.error << "\n"
              << difference.value.transpose() << "\n"
              << columns.col(j).transpose();
        }
      }
    }
}

} // namespace circular_gaps_tests
} // namespace vibroimpact::motion
