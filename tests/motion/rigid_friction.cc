// Rigid sides that rub on each other: impacts, slip and stick while they last, and chatter, against
// closed forms; both ways to integrate.
#include "common/error.h"
#include "motion/variation/variation.h"
#include "support/friction_by_method.h"
#include "support/motion_derivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace rigid_friction_tests {

using namespace model;
using contact::ContactSet;
using contact::RestitutionHypothesis;
using testing::Changes;
using testing::oblique_contact;
using testing::particle;
using testing::settings_of;
using testing::vector_of;

std::shared_ptr<const contact::ContactLaw>
rubbing(double restitution, double coefficient, double at_rest = 0,
        RestitutionHypothesis hypothesis = RestitutionHypothesis::energetic) {
  return std::make_shared<contact::FrictionalLaw>(
      std::make_shared<contact::NewtonRestitution>(restitution, hypothesis),
      std::make_shared<contact::Coulomb>(coefficient, std::max(at_rest, coefficient)));
}

// The normal points to the ground along y, and what falls comes with positive y.
void add_fall(Model &model, double gravity) {
  model.add_gravity("weight", make_constant(Given::displacement, gravity), {0}, Vector3::UnitY());
}

class RigidFrictionTest : public testing::FrictionByMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, RigidFrictionTest, ::testing::Values("exact", "rk"));

// v = v0 - mu g t until it stops; then it rests.
TEST_P(RigidFrictionTest, BlockSlidesToRest) {
  const double g = 9.81, mu = 0.3, v0 = 2, mass = 1.7;
  Model model({particle("block", mass)});
  add_fall(model, g);
  const ContactSet contacts({oblique_contact(model, "block.head", 0, rubbing(0.5, mu))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({v0, 0}));
  trajectory.advance(0.2, changes);
  EXPECT_NEAR(trajectory.state()[0], v0 * 0.2 - mu * g * 0.02, error(1e-14));
  EXPECT_NEAR(trajectory.state()[2], v0 - mu * g * 0.2, error(1e-14));
  trajectory.advance(2, changes);
  ASSERT_EQ(changes.list.size(), 1u);
  EXPECT_NEAR(changes.list[0].time, v0 / (mu * g), error(1e-13));
  EXPECT_EQ(changes.list[0].to, "stick");
  const Vector &x = trajectory.state();
  EXPECT_NEAR(std::abs(x[0]), v0 * v0 / (2 * mu * g), error(1e-13));
  EXPECT_EQ(x[2], 0);
  EXPECT_NEAR(x[1], 0, error(1e-13));
  const StateLayout &layout = trajectory.layout();
  EXPECT_NEAR(x[layout.friction_work(0)], mass * v0 * v0 / 2, error(1e-12));
  EXPECT_NEAR(x[layout.contact_work(0)], mass * v0 * v0 / 2, error(1e-12));
  EXPECT_NEAR(x[layout.wear_work(0)], mass * v0 * v0 / 2 / mu, error(1e-11));
  EXPECT_NEAR(x[layout.impulse(0)], mass * g * 2, error(1e-11));
  EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
}

// Each impact takes mu (1 + e) of the approach speed from the slip, and the chatter takes the
// rest: mu (1 + e) (v + e v + e^2 v + ...) = mu v (1 + e) / (1 - e). Then the block slides on by
// its weight and stops.
TEST_P(RigidFrictionTest, BouncingBlockThatSlides) {
  const double g = 9.81, mu = 0.2, e = 0.6, height = 0.5, v0 = 8;
  Model model({particle("block", 2.5)});
  add_fall(model, g);
  const ContactSet contacts({oblique_contact(model, "block.head", height, rubbing(e, mu))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({v0, 0}));
  const double v = std::sqrt(2 * g * height);
  const double touch = v / g, flight = 2 * e * v / g;
  trajectory.advance(touch + flight / 2, changes);
  EXPECT_NEAR(trajectory.state()[2], v0 - mu * (1 + e) * v, error(1e-13));
  EXPECT_NEAR(trajectory.state()[0], v0 * touch + (v0 - mu * (1 + e) * v) * flight / 2,
              error(1e-13));
  const double rest = touch + 2 * e * v / (g * (1 - e));
  trajectory.advance(rest + 0.3, changes);
  // From the chatter on as if it had always slid: the impulse along the normal is that of the
  // weight.
  const double slip = v0 - mu * v * (1 + e) / (1 - e);
  EXPECT_NEAR(trajectory.state()[2], slip - mu * g * 0.3, error(1e-11));
  EXPECT_EQ(changes.list.back().to, "slip backward"); // of the ground on the block
  trajectory.advance(rest + 3, changes);
  EXPECT_EQ(trajectory.state()[2], 0);
  EXPECT_EQ(changes.list.back().to, "stick");
  EXPECT_NEAR(changes.list.back().time, rest + slip / (mu * g), error(1e-11));
  EXPECT_EQ(trajectory.accuracy().chatters, 1);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-9);
}

// A disc that spins and falls: it sticks within its first impact. m 1, R .5, J = (2/5) m R^2 as of
// a sphere, e .9, mu .1; the published 2/7 of the spin remain.
TEST_P(RigidFrictionTest, SpinningSphereSticksInItsFirstImpact) {
  auto body = std::make_shared<reduction::ReducedBody>(*particle("ball", 1));
  const double radius = 0.5, inertia = 0.1;
  body->mass = Vector(3);
  body->mass << 1, 1, inertia;
  body->stiffness = Vector::Zero(3);
  body->damping = Matrix::Zero(3, 3);
  Matrix base = Matrix::Zero(3, 3);
  base.topRows(2) = body->base_participation;
  body->base_participation = base;
  Matrix rows = Matrix::Zero(6, 3);
  rows.leftCols(2) = body->points[0].rows;
  body->points[0].rows = rows;
  Model model({body});
  add_fall(model, 9.81);
  contact::ContactPair pair = oblique_contact(model, "ball.head", 0.5, rubbing(0.9, 0.1));
  pair.tangential[0].slip.row[2] = radius; // of the ground on the ball: -(v_x) ; spin adds
  const ContactSet contacts({pair});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  Vector velocity(3);
  velocity << 0, 0, 2;
  trajectory.start(0, Vector::Zero(3), velocity);
  const double touch = std::sqrt(2 * 0.5 / 9.81), v = 9.81 * touch;
  EXPECT_NEAR(touch, .3192754284, 1e-10);
  trajectory.advance(touch + 0.01, changes);
  EXPECT_NEAR(trajectory.state()[5], 2. / 7 * 2, error(1e-14));
  EXPECT_NEAR(std::abs(trajectory.state()[3]), 2. / 7, error(1e-14));
  EXPECT_NEAR(trajectory.state()[trajectory.layout().impulse(0)], 1.9 * v, error(1e-13));
  trajectory.advance(7, changes);
  EXPECT_NEAR(trajectory.state()[5], 2. / 7 * 2, error(1e-12)); // rolls
  EXPECT_EQ(changes.list.back().to, "stick");
}

// A belt carries what is put on it until it sticks, and a spring pulls it back.
TEST_P(RigidFrictionTest, BlockOnABelt) {
  const double g = 10, mu = 0.25, at_rest = 0.4, k = 1, v = 0.5; // N = 10
  Model model({particle("block", 1, k)});
  add_fall(model, g);
  contact::ContactPair pair = oblique_contact(model, "block.head", 0, rubbing(0.3, mu, at_rest));
  pair.tangential[0].surface_speed = v; // of the ground: the slip row is -x
  const ContactSet contacts({pair});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({0, 0}));
  trajectory.advance(60, changes);
  std::vector<double> slips;
  for (const Changes::Change &change : changes.list)
    if (change.to != "stick")
      slips.push_back(change.time);
  ASSERT_GE(slips.size(), 4u);
  EXPECT_NEAR(slips[3] - slips[2], 9.78509376238, 1e-9);
  EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
}

// On a shaken base, from rest: work rate of N |v_s| from 4 to 12 periods, as published to six
// digits for another program's penalty contact.
TEST_P(RigidFrictionTest, BlockOnAShakenBase) {
  const double pi = std::numbers::pi;
  for (const auto &[amplitude, rate] :
       {std::pair(15.0, 15.26709959), {1.5, 0.4090624510}, {1.01, 2.261641213e-4}, {0.99, 0.0}}) {
    Model model({particle("block", 1)});
    add_fall(model, 10);
    model.add_base_motion("base",
                          std::make_shared<Harmonic>(Given::acceleration, amplitude, 2 * pi, 0),
                          {0}, Vector3::UnitX());
    contact::ContactPair pair = oblique_contact(model, "block.head", 0, rubbing(0.5, 0.1));
    const model::PointReference head{.body = 0, .point = 0};
    pair.tangential[0].slip = model.displacement(head, Vector3::UnitX(), false);
    pair.tangential[0].slip.row *= -1;
    const ContactSet contacts({pair});
    Trajectory trajectory(model, contacts, settings());
    Changes changes(contacts);
    trajectory.start(0, vector_of({0, 0}), vector_of({0, 0}));
    trajectory.advance(4, changes);
    const Index wear = trajectory.layout().wear_work(0);
    const double before = trajectory.state()[wear];
    trajectory.advance(12, changes);
    EXPECT_NEAR((trajectory.state()[wear] - before) / 8, rate, 1e-9 * (1 + rate)) << amplitude;
    // Steps leave 1e-12 of the way of the base, 0.03 m, against a work of down to 1e-5 J.
    EXPECT_LT(trajectory.accuracy().energy_residual, exact() ? 1e-12 : 1e-7);
  }
}

// A body on two feet at +-l below its centre of mass at the height h: coordinates x, y, angle.
Model on_two_feet(double mass, double inertia, double l, double h) {
  auto body = std::make_shared<reduction::ReducedBody>(*particle("block", mass));
  body->mass = Vector(3);
  body->mass << mass, mass, inertia;
  body->stiffness = Vector::Zero(3);
  body->damping = Matrix::Zero(3, 3);
  Matrix base = Matrix::Zero(3, 3);
  base.topRows(2) = body->base_participation;
  body->base_participation = base;
  body->points.clear();
  for (const auto &[name, side] : {std::pair("left", -1.0), {"right", 1.0}}) {
    Matrix rows = Matrix::Zero(6, 3);
    rows(0, 0) = rows(1, 1) = 1; // y down, the angle from x to y
    rows(0, 2) = -h;
    rows(1, 2) = side * l;
    body->points.push_back({.name = name, .position = Vector3::Zero(), .rows = rows});
  }
  return Model({body});
}

// It slows down by mu g on both feet, the front one loaded by mu m g h / l more than the other.
TEST_P(RigidFrictionTest, BlockOnTwoFeetSlidesToRest) {
  const double mass = 2, g = 9.81, l = 0.3, h = 0.2, mu = 0.4, v0 = 1.5;
  Model model = on_two_feet(mass, 0.1, l, h);
  add_fall(model, g);
  const ContactSet contacts({oblique_contact(model, "block.left", 0, rubbing(0.3, mu)),
                             oblique_contact(model, "block.right", 0, rubbing(0.3, mu))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  Vector velocity = Vector::Zero(3);
  velocity[0] = v0;
  trajectory.start(0, Vector::Zero(3), velocity);
  const double stop = v0 / (mu * g);
  trajectory.advance(stop / 2, changes);
  EXPECT_NEAR(trajectory.state()[3], v0 / 2, error(1e-13));
  const StateLayout &layout = trajectory.layout();
  const double left = trajectory.state()[layout.impulse(0)];
  const double right = trajectory.state()[layout.impulse(1)];
  EXPECT_NEAR(left + right, mass * g * stop / 2, error(1e-12));
  EXPECT_NEAR(right - left, mu * mass * g * h / l * stop / 2, error(1e-12));
  trajectory.advance(stop + 1, changes);
  EXPECT_NEAR(trajectory.state()[0], v0 * stop / 2, error(1e-13));
  EXPECT_NEAR(trajectory.state()[3], 0, error(1e-14));
  EXPECT_NEAR(trajectory.state()[layout.friction_work(0)] +
                  trajectory.state()[layout.friction_work(1)],
              mass * v0 * v0 / 2, error(1e-12));
  EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
}

// Where mu h > l it tips over the front foot instead.
TEST_P(RigidFrictionTest, BlockOnTwoFeetTips) {
  const double g = 9.81, l = 0.1, h = 0.4, mu = 0.4;
  Model model = on_two_feet(2, 0.1, l, h);
  add_fall(model, g);
  const ContactSet contacts({oblique_contact(model, "block.left", 0, rubbing(0.3, mu)),
                             oblique_contact(model, "block.right", 0, rubbing(0.3, mu))});
  Trajectory trajectory(model, contacts, settings());
  Vector velocity = Vector::Zero(3);
  velocity[0] = 1;
  trajectory.start(0, Vector::Zero(3), velocity);
  trajectory.advance(0.01);
  EXPECT_EQ(trajectory.equations().mode(0).name, "open");
  EXPECT_EQ(trajectory.equations().mode(1).name, "resting, slip backward");
}

// Bounces, slides and sticks under forces along both directions; gap and slip act on each other.
struct ThrownBlock {
  explicit ThrownBlock(RestitutionHypothesis hypothesis) : model({particle("block", 1, 40)}) {
    const model::PointReference head{.body = 0, .point = 0};
    add_fall(model, 9.81);
    model.add_force("push", std::make_shared<Harmonic>(Given::displacement, 6, 17, 0.4), head,
                    Vector3::UnitX());
    model.add_force("lift", std::make_shared<Harmonic>(Given::displacement, 12, 11, 1), head,
                    Vector3::UnitY());
    contact::ContactPair pair =
        oblique_contact(model, "block.head", 0.02, rubbing(0.5, 0.35, 0.45, hypothesis));
    pair.tangential[0].slip.row[1] = 0.4 * pair.gap.row[1];
    contacts = ContactSet({pair});
  }
  Model model;
  ContactSet contacts;
};

TEST(RigidFriction, ExactPathAndStepsAgree) {
  for (const RestitutionHypothesis hypothesis :
       {RestitutionHypothesis::energetic, RestitutionHypothesis::newton,
        RestitutionHypothesis::poisson}) {
    const ThrownBlock thrown(hypothesis);
    std::vector<Vector> states;
    std::vector<std::vector<Changes::Change>> changes; // but for the flights of a chatter
    for (const char *method : {"exact", "rk"}) {
      Trajectory trajectory(thrown.model, thrown.contacts, settings_of(method));
      Changes all(thrown.contacts);
      trajectory.start(0, vector_of({0.03, 0}), vector_of({-0.5, 0}));
      trajectory.advance(3, all);
      EXPECT_LT(trajectory.accuracy().energy_residual, 1e-9) << method;
      states.push_back(trajectory.state());
      std::erase_if(all.list, [](const Changes::Change &c) { return c.from == c.to; });
      changes.push_back(all.list);
    }
    ASSERT_EQ(changes[0].size(), changes[1].size());
    EXPECT_GT(changes[0].size(), 10u);
    for (std::size_t i = 0; i < changes[0].size(); ++i) {
      EXPECT_EQ(changes[0][i].to, changes[1][i].to) << i;
      if (changes[0][i].from != "open") { // a chatter is completed at another of its impacts
        EXPECT_NEAR(changes[0][i].time, changes[1][i].time, 1e-10) << i;
      }
    }
    EXPECT_LT((states[0].head(4) - states[1].head(4)).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// Through impacts that slide and stick, and slip and stick on the ground.
TEST(RigidFriction, DerivativesAgainstDifferences) {
  for (const RestitutionHypothesis hypothesis :
       {RestitutionHypothesis::energetic, RestitutionHypothesis::poisson}) {
    const ThrownBlock thrown(hypothesis);
    Trajectory trajectory(thrown.model, thrown.contacts, settings_of("exact"));
    const Vector start = vector_of({0.03, 0, -0.5, 0});
    const double end = 1.2;
    std::vector<std::string> pattern;
    const auto image = [&](const Vector &from) {
      Changes changes(thrown.contacts);
      trajectory.start({.time = 0, .physical = from});
      trajectory.advance(end, changes);
      std::vector<std::string> seen;
      for (const Changes::Change &change : changes.list)
        seen.push_back(change.to);
      if (pattern.empty())
        pattern = seen;
      return seen == pattern ? std::optional(trajectory.motion_state().physical) : std::nullopt;
    };
    image(start);
    trajectory.start({.time = 0, .physical = start});
    Variation variation(trajectory, Vector::Ones(4), 1e-11);
    variation.set_columns(Matrix::Identity(4, 4));
    trajectory.advance(end, variation);
    const Matrix columns = variation.columns();
    for (Index j = 0; j < 4; ++j) {
      const testing::NumericalDerivative expected = testing::numerical_derivative(
          [&](double step) { return image(start + step * Vector::Unit(4, j)); }, 1e-3);
      EXPECT_LT(expected.error, 1e-6) << j;
      EXPECT_LT((expected.value - columns.col(j)).cwiseAbs().maxCoeff(),
                3 * expected.error * expected.value.cwiseAbs().maxCoeff() + 1e-9)
          << j;
    }
  }
}

// Friction that presses the sides together more than they can be parted.
TEST_P(RigidFrictionTest, SlipThatJamsIsRefused) {
  Model model({particle("block", 1)});
  add_fall(model, 1);
  contact::ContactPair pair = oblique_contact(model, "block.head", 0, rubbing(0.5, 3));
  pair.tangential[0].slip.row[1] = 0.5 * pair.gap.row[1]; // b = a / 2
  const ContactSet contacts({pair});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  try {
    trajectory.start(0, vector_of({0, 0}), vector_of({-1, 0}));
    trajectory.advance(1, changes);
    FAIL();
  } catch (const NumericalError &error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("contact heads"), std::string::npos) << what;
    EXPECT_NE(what.find("friction coefficient 3 is not below 2"), std::string::npos) << what;
  }
}

} // namespace rigid_friction_tests
} // namespace vibroimpact::motion
