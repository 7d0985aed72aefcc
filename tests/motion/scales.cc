// Impacts of every size with the same tolerance: from penetrations of an atom's size to that of a
// hand, from dust to a building.
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/restitution_relation.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace vibroimpact::motion {
namespace scales_tests {

using namespace contact;

/// A free mass that meets a stop.
struct Scale {
  double penetration; ///< that a Hertz stop without losses would let it reach [m]
  double mass;        ///< [kg]
  double speed;       ///< [m/s]

  /// 5/4 m v^2 = k u^(5/2)
  double stiffness() const { return 1.25 * mass * speed * speed / std::pow(penetration, 2.5); }
  double time() const { return penetration / speed; }
};

using Law = std::function<std::shared_ptr<const ContactLaw>(const Scale &)>;

std::shared_ptr<const ContactLaw> hertz(const Scale &scale) {
  return std::make_shared<Hertz>(HertzConstants{.stiffness = scale.stiffness()});
}

/// e = 0.7 at any speed
std::shared_ptr<const ContactLaw> hunt_crossley(const Scale &scale) {
  return HuntCrossley::with_dissipation({.stiffness = scale.stiffness(), .exponent = 1.5},
                                        dimensionless_damping("exact", 0.7) / scale.speed);
}

std::shared_ptr<const ContactLaw> kuwabara_kono(const Scale &scale) {
  return std::make_shared<KuwabaraKono>(scale.stiffness(), 0.2 * scale.time());
}

struct Outcome {
  Impact impact;
  Accuracy accuracy;
};

Outcome collide(const Scale &scale, const Law &law, const Settings &settings) {
  const model::Model model({testing::single_mass("mass", scale.mass, 0, 0)});
  const ContactSet contacts(
      {testing::contact_along_x(model, "mass.head", "", 3 * scale.penetration, law(scale))});
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, scale.speed));
  trajectory.advance(15 * scale.time(), log);
  EXPECT_EQ(log.impacts(0).size(), 1u);
  if (log.impacts(0).empty())
    return {};
  return {log.impacts(0)[0], trajectory.accuracy()};
}

std::vector<Scale> scales() {
  std::vector<Scale> list;
  for (const double penetration : {1e-10, 1e-8, 1e-6, 1e-3, 1e-1})
    for (const double mass : {1e-12, 1e-3, 1.0, 1e6})
      for (const double speed : {1e-4, 1e-1, 30.0})
        list.push_back({penetration, mass, speed});
  return list;
}

struct Worst {
  double separation = 0, duration = 0, depth = 0, force = 0, balance = 0;
  long steps = 0;
  void take(const Worst &other) {
    separation = std::max(separation, other.separation);
    duration = std::max(duration, other.duration);
    depth = std::max(depth, other.depth);
    force = std::max(force, other.force);
    balance = std::max(balance, other.balance);
    steps = std::max(steps, other.steps);
  }
};

/// Relative errors against the closed forms: u_max, 2.94 u_max / v, k u_max^1.5.
Worst errors(const Scale &scale, const Settings &settings) {
  const auto [impact, accuracy] = collide(scale, hertz, settings);
  const double duration = 0.8 * boost::math::beta(0.4, 0.5) * scale.time();
  const double force = scale.stiffness() * std::pow(scale.penetration, 1.5);
  return {.separation = std::abs(impact.separation_speed / scale.speed - 1),
          .duration = std::abs(impact.duration / duration - 1),
          .depth = std::abs(impact.maximum_penetration / scale.penetration - 1),
          .force = std::abs(impact.peak_force / force - 1),
          .balance = accuracy.energy_residual,
          .steps = accuracy.steps};
}

constexpr double modest = 2e-9; // the default relative tolerance is 1e-9

TEST(ScalesTest, HertzImpactsOfEverySize) {
  Worst worst;
  for (const Scale &scale : scales())
    worst.take(errors(scale, {}));
  EXPECT_LT(worst.separation, modest);
  EXPECT_LT(worst.duration, modest);
  EXPECT_LT(worst.depth, modest);
  EXPECT_LT(worst.force, modest);
  EXPECT_LT(worst.balance, modest);
  EXPECT_LT(worst.steps, 60);
}

/// Largest relative error of the restitution coefficient, and the largest energy residual.
Worst restitution_errors(const Law &law, double exact) {
  Worst worst;
  for (const Scale &scale : scales()) {
    const auto [impact, accuracy] = collide(scale, law, {});
    worst.take({.separation = std::abs(impact.restitution_coefficient() / exact - 1),
                .balance = accuracy.energy_residual});
  }
  return worst;
}

TEST(ScalesTest, HuntCrossleyOfEverySize) {
  const Worst worst = restitution_errors(hunt_crossley, 0.7);
  EXPECT_LT(worst.separation, modest);
  EXPECT_LT(worst.balance, modest);
}

// Restitution depends on A v / u alone. The force begins like a root.
TEST(ScalesTest, KuwabaraKonoOfEverySize) {
  const double exact = collide({1, 1, 1}, kuwabara_kono, {.relative_tolerance = 1e-13})
                           .impact.restitution_coefficient();
  const Worst worst = restitution_errors(kuwabara_kono, exact);
  EXPECT_LT(worst.separation, 1e-8);
  EXPECT_LT(worst.balance, 1e-8);
}

// The same motion in other units of length and mass, by powers of two: relative results are the
// same but for rounding, and so are the steps.
TEST(ScalesTest, UnitsOfLengthAndMassDoNotMatter) {
  for (const Law &law : {Law(hertz), Law(kuwabara_kono)}) {
    const Scale one{.penetration = 1e-3, .mass = 1, .speed = 0.5};
    const auto [reference, accuracy] = collide(one, law, {});
    for (const int length : {-20, -10, 7})
      for (const int mass : {-30, 20}) {
        const double unit = std::ldexp(1, length);
        const auto [impact, other] = collide({.penetration = unit * one.penetration,
                                              .mass = std::ldexp(one.mass, mass),
                                              .speed = unit * one.speed},
                                             law, {});
        EXPECT_NEAR(impact.maximum_penetration / unit / reference.maximum_penetration, 1, 1e-12);
        EXPECT_NEAR(impact.separation_speed / unit / reference.separation_speed, 1, 1e-12);
        EXPECT_NEAR(impact.duration / reference.duration, 1, 1e-12);
        EXPECT_EQ(other.steps, accuracy.steps) << length << ' ' << mass;
      }
  }
}

// A gap is the difference of displacements; how far these are from zero does not matter either,
// down to their rounding: 0.1 um of penetration ten metres away.
TEST(ScalesTest, ThePlaceOfAContactDoesNotMatter) {
  const Scale scale{.penetration = 1e-7, .mass = 1e-3, .speed = 0.5};
  const model::Model model({testing::single_mass("mass", scale.mass, 0, 0)});
  for (const double place : {0.0, 0.01, 10.0}) {
    const ContactSet contacts({testing::contact_along_x(
        model, "mass.head", "", place + 3 * scale.penetration, hertz(scale))});
    Trajectory trajectory(model, contacts, {});
    ImpactLog log(contacts, 0);
    trajectory.start(0, Vector::Constant(1, place), Vector::Constant(1, scale.speed));
    trajectory.advance(15 * scale.time(), log);
    ASSERT_EQ(log.impacts(0).size(), 1u) << place;
    const double rounding = 1e-15 * place / scale.penetration;
    EXPECT_NEAR(log.impacts(0)[0].separation_speed / scale.speed, 1, 2e-9 + 10 * rounding) << place;
    EXPECT_LT(trajectory.accuracy().energy_residual, 2e-9 + 10 * rounding) << place;
    EXPECT_LT(trajectory.accuracy().steps, 80) << place;
  }
}

// A mass that a rigid stop holds on a shaken base, whose coordinate therefore never moves, and a
// Hertz stop that the base drives into it: the work of the base is the energy of that stop.
TEST(ScalesTest, AHeldMassOnAMovingBase) {
  const double stiffness = 2.5e5;
  model::Model model({testing::single_mass("mass", 2.8, 1.7, 1.5)});
  model.add_base_motion("shaker",
                        std::make_shared<model::Harmonic>(model::Given::acceleration, 0.53, 18.9,
                                                          std::numbers::pi / 2),
                        {0}, Vector3::UnitX());
  testing::add_weight(model, -9.81, {0});
  ContactPair held = testing::stop_on_base(model, "mass.head", 0, testing::newton(0));
  held.gap.row *= -1;
  const ContactPair stop =
      testing::contact_along_x(model, "mass.head", "", 9e-4,
                               std::make_shared<Hertz>(HertzConstants{.stiffness = stiffness}));
  const ContactSet contacts({held, stop});
  for (const double tolerance : {1e-6, 1e-9, 1e-11}) {
    Trajectory trajectory(model, contacts, {.relative_tolerance = tolerance});
    ImpactLog log(contacts, 0);
    trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
    trajectory.advance(1, log);
    ASSERT_GT(log.impacts(1).size(), 1u);
    EXPECT_LT(trajectory.accuracy().energy_residual, 10 * tolerance) << tolerance;
    // The deepest overlap is the base's amplitude less the clearance.
    const double deepest = 0.53 / (18.9 * 18.9) - 9e-4;
    EXPECT_NEAR(log.impacts(1)[1].maximum_penetration, deepest, 20 * tolerance * deepest)
        << tolerance;
  }
}

} // namespace scales_tests
} // namespace vibroimpact::motion
