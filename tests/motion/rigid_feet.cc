// Feet of one rigid block that come to rest, begin to slide and part together, with friction on
// rigid ground: closed forms, both ways to integrate.
#include "contact/laws/newton_restitution.h"
#include "support/friction_by_method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace rigid_feet_tests {

using namespace model;
using contact::ContactSet;
using testing::Changes;
using testing::oblique_contact;
using testing::particle;

std::shared_ptr<const contact::ContactLaw> rough(double coefficient, double at_rest) {
  return std::make_shared<contact::FrictionalLaw>(
      std::make_shared<contact::NewtonRestitution>(0.3),
      std::make_shared<contact::Coulomb>(coefficient, at_rest));
}

/// A block with the coordinates x, y (down) and its angle from x to y; its feet lie by `height`
/// below the centre of mass at some places along x. A force acts on the centre along x.
struct Block {
  double mass = 2, inertia = 0.1, height = 0.2;
  std::vector<double> feet{};
  double coefficient = 0.4, at_rest = 0.4;
  std::shared_ptr<const TimeFunction> push{};
  static constexpr double gravity = 9.81;

  Model model() const {
    auto body = std::make_shared<reduction::ReducedBody>(*particle("block", mass));
    body->mass = Vector{{mass, mass, inertia}};
    body->stiffness = Vector::Zero(3);
    body->damping = Matrix::Zero(3, 3);
    body->base_participation = Matrix::Identity(3, 3) * mass;
    body->base_participation(2, 2) = 0;
    body->points.clear();
    const auto add = [&](const std::string &name, double place, double below) {
      Matrix rows = Matrix::Zero(6, 3);
      rows(0, 0) = rows(1, 1) = 1;
      rows(0, 2) = -below;
      rows(1, 2) = place;
      body->points.push_back({.name = name, .position = Vector3::Zero(), .rows = rows});
    };
    for (std::size_t i = 0; i < feet.size(); ++i)
      add("foot" + std::to_string(i), feet[i], height);
    add("centre", 0, 0);
    Model made({body});
    made.add_gravity("weight", make_constant(Given::displacement, gravity), {0}, Vector3::UnitY());
    if (push)
      made.add_force("push", push, {.body = 0, .point = feet.size()}, Vector3::UnitX());
    return made;
  }

  ContactSet contacts(const Model &model) const {
    std::vector<contact::ContactPair> pairs;
    for (std::size_t i = 0; i < feet.size(); ++i)
      pairs.push_back(
          oblique_contact(model, "block.foot" + std::to_string(i), 0, rough(coefficient, at_rest)));
    return ContactSet(std::move(pairs));
  }
};

/// For how long each contact has been in stick from `start` to `end`, from its first change on.
std::vector<double> times_in_stick(const Changes &changes, std::size_t count, double end) {
  std::vector<double> times(count, 0), since(count, -1);
  for (const Changes::Change &change : changes.list) {
    double &from = since[change.contact];
    if (from >= 0)
      times[change.contact] += change.time - from;
    from = change.to == "stick" ? change.time : -1;
  }
  for (std::size_t c = 0; c < count; ++c)
    times[c] += since[c] >= 0 ? end - since[c] : 0;
  return times;
}

class RigidFeetTest : public testing::FrictionByMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, RigidFeetTest, ::testing::Values("exact", "rk"));

// v = v0 - mu g t, then all of them stick.
TEST_P(RigidFeetTest, AllComeToRestTogether) {
  for (const std::vector<double> &feet :
       {std::vector{-0.3, 0.3}, {-0.3, 0.1, 0.25}, {-0.3, -0.1, 0.1, 0.3}}) {
    SCOPED_TRACE(feet.size());
    const Block block{.feet = feet};
    const Model model = block.model();
    const ContactSet contacts = block.contacts(model);
    Trajectory trajectory(model, contacts, settings());
    Changes changes(contacts);
    const double v0 = 1.5, stop = v0 / (block.coefficient * Block::gravity);
    trajectory.start(0, Vector::Zero(3), Vector{{v0, 0, 0}});
    trajectory.advance(2 * stop, changes);
    ASSERT_EQ(changes.list.size(), feet.size());
    for (const Changes::Change &change : changes.list) {
      EXPECT_EQ(change.to, "stick");
      EXPECT_NEAR(change.time, stop, error(1e-13));
    }
    for (const double time : times_in_stick(changes, feet.size(), 2 * stop))
      EXPECT_NEAR(time, stop, error(1e-13));
    EXPECT_NEAR(trajectory.state()[0], v0 * stop / 2, error(1e-13));
    EXPECT_EQ(trajectory.equations().holding().size(), static_cast<Index>(2 * feet.size()));
    EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
    EXPECT_EQ(trajectory.accuracy().undecided_events, 0);
  }
}

/// Under P sin w t a block that is pressed on the ground by m g begins to slide where P sin w t =
/// mu_s m g and slides with v = P (cos w t0 - cos w t) / (m w) - mu g (t - t0) until that is zero.
struct Shaken {
  double mass, push, frequency, coefficient, at_rest;

  double begin() const { return std::asin(at_rest * mass * Block::gravity / push) / frequency; }
  double speed(double time) const {
    return push / (mass * frequency) *
               (std::cos(frequency * begin()) - std::cos(frequency * time)) -
           coefficient * Block::gravity * (time - begin());
  }
  double stop() const {
    double low = std::numbers::pi / 2 / frequency, high = std::numbers::pi / frequency * 1.5;
    for (int i = 0; i < 100; ++i)
      (speed((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    return low;
  }
};

// The centre of mass lies on the ground, so that all feet carry the same, and break together.
TEST_P(RigidFeetTest, AllSlideAndStopTogetherUnderAForce) {
  for (const double at_rest : {0.4, 0.5})
    for (const std::vector<double> &feet : {std::vector{-0.3, 0.3}, {-0.3, 0, 0.3}}) {
      SCOPED_TRACE(std::to_string(feet.size()) + " " + std::to_string(at_rest));
      const Shaken shaken{
          .mass = 2, .push = 11, .frequency = 7, .coefficient = 0.4, .at_rest = at_rest};
      const Block block{.mass = shaken.mass,
                        .height = 0,
                        .feet = feet,
                        .coefficient = shaken.coefficient,
                        .at_rest = at_rest,
                        .push = std::make_shared<Harmonic>(Given::displacement, shaken.push,
                                                           shaken.frequency, 0)};
      const Model model = block.model();
      const ContactSet contacts = block.contacts(model);
      Trajectory trajectory(model, contacts, settings());
      Changes changes(contacts);
      trajectory.start(0, Vector::Zero(3), Vector::Zero(3));
      for (std::size_t c = 0; c < feet.size(); ++c)
        EXPECT_EQ(trajectory.equations().mode(c).name, "resting, stick");
      const double half = std::numbers::pi / shaken.frequency;
      trajectory.advance(4 * half, changes);
      ASSERT_LT(shaken.stop(), half + shaken.begin());
      double stick = 0; // from the first change on, which is a slip
      for (int k = 0; k < 4; ++k)
        stick += std::max(0.0, std::min(4 * half, shaken.begin() + (k + 1) * half) -
                                   (shaken.stop() + k * half));
      for (const double time : times_in_stick(changes, feet.size(), 4 * half))
        EXPECT_NEAR(time, stick, error(1e-12));
      for (const Changes::Change &change : changes.list) {
        const double phase = std::fmod(change.time, half);
        EXPECT_LT(std::min(std::abs(phase - std::fmod(shaken.stop(), half)),
                           std::abs(phase - shaken.begin())),
                  error(1e-12))
            << change.time << " " << change.to;
      }
      EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-11));
    }
}

// Where P h sin w t passes m g l the hind foot parts, while the other one sticks on: the block
// turns about it with (J + m (h^2 + l^2)) theta'' = P h sin w t - m g l.
TEST_P(RigidFeetTest, TipsWithoutSliding) {
  const double l = 0.1, push = 8, w = 5;
  const Block block{.height = 0.4,
                    .feet = {-l, l},
                    .coefficient = 0.5,
                    .at_rest = 0.5,
                    .push = std::make_shared<Harmonic>(Given::displacement, push, w, 0)};
  const Model model = block.model();
  const ContactSet contacts = block.contacts(model);
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, Vector::Zero(3), Vector::Zero(3));
  const double weight = block.mass * Block::gravity;
  const double lift = std::asin(weight * l / (push * block.height)) / w;
  const double end = lift + 0.1;
  trajectory.advance(end, changes);
  ASSERT_FALSE(changes.list.empty());
  EXPECT_EQ(changes.list.back().contact, 0u);
  EXPECT_EQ(changes.list.back().to, "open");
  EXPECT_NEAR(changes.list.back().time, lift, error(1e-13));
  EXPECT_EQ(trajectory.equations().mode(1).name, "resting, stick");
  for (const Changes::Change &change : changes.list)
    EXPECT_EQ(change.contact, 0u) << change.time << " " << change.from << " " << change.to;
  const double inertia = block.inertia + block.mass * (l * l + block.height * block.height);
  const double since = end - lift;
  const double angle =
      (push * block.height / (w * w) *
           (std::sin(w * lift) + w * since * std::cos(w * lift) - std::sin(w * end)) -
       weight * l * since * since / 2) /
      inertia;
  // By 0.15 rad/s, for instants are known to the tolerance of events, 1e-12 s.
  const Vector &x = trajectory.state();
  EXPECT_NEAR(x[2], angle, error(2e-13));
  EXPECT_NEAR(x[0], block.height * angle, error(2e-13));
  EXPECT_NEAR(x[1], -l * angle, error(1e-13));
}

} // namespace rigid_feet_tests
} // namespace vibroimpact::motion
