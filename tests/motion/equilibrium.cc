// Static equilibria with closed forms.
#include "motion/system/equilibrium.h"
#include "common/error.h"
#include "contact/laws/hertz.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "support/rotor_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace equilibrium_tests {

using namespace contact;
using model::Model;
using testing::contact_along_x;
using testing::single_mass;

// k1 u + k3 u^3 = F has the one real root of Cardano's formula.
TEST(EquilibriumTest, CubicSpring) {
  const double k1 = 1.5e5, k3 = 6e10, force = -155 * 9.81;
  Model model({single_mass("frame", 155, k1, 0)});
  model.add_connection(
      {.name = "spring",
       .side_a = "frame.head",
       .side_b = "base",
       .elongation = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false),
       .cubic_stiffness = k3});
  const Equilibrium found = static_equilibrium(model, {}, Vector::Constant(1, force));
  const double p = k1 / (3 * k3), q = -force / (2 * k3);
  const double root = std::sqrt(q * q + p * p * p);
  EXPECT_NEAR(found.displacement[0], std::cbrt(-q + root) + std::cbrt(-q - root), 1e-14);
}

// A ball on a Hertz stop at some distance, under its weight: k u^(3/2) = m g.
TEST(EquilibriumTest, BallRestsOnAStop) {
  const double stiffness = 1e9, weight = 20, clearance = 0.01;
  const Model model({single_mass("ball", 2, 0, 0)});
  const ContactSet contacts({contact_along_x(
      model, "ball.head", "", clearance,
      std::make_shared<Hertz>(HertzConstants{.stiffness = stiffness, .exponent = 1.5}))});
  // A spring that hardly holds it brings it to the stop.
  const Model held({single_mass("ball", 2, 1, 0)});
  const Equilibrium found = static_equilibrium(held, contacts, Vector::Constant(1, weight));
  const double at_stop = weight - clearance; // what the spring leaves
  EXPECT_NEAR(found.displacement[0], clearance + std::pow(at_stop / stiffness, 2.0 / 3),
              1e-9 * clearance);
  EXPECT_TRUE(found.closed[0]);
  EXPECT_THROW(static_equilibrium(model, {}, Vector::Constant(1, weight)), NumericalError);
}

TEST(EquilibriumTest, OpenContactStaysOpen) {
  const Model model({single_mass("block", 2, 1000, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0.03, std::make_shared<LinearPenalty>(1e6))});
  const Equilibrium found = static_equilibrium(model, contacts, Vector::Constant(1, 20.0));
  EXPECT_NEAR(found.displacement[0], 0.02, 1e-15);
  EXPECT_FALSE(found.closed[0]);
}

// Two blocks between rigid sides: the first on a prestressed stop, the second free to lie on the
// ground under its weight, a third contact out of reach.
TEST(EquilibriumTest, RigidContacts) {
  const auto rigid = std::make_shared<NewtonRestitution>(0.5);
  const Model model({single_mass("spring", 2, 1000, 0), single_mass("free", 3, 0, 0)});
  const ContactSet contacts({contact_along_x(model, "spring.head", "", -0.02, rigid),
                             contact_along_x(model, "free.head", "", 0.1, rigid),
                             contact_along_x(model, "spring.head", "free.head", 0.01, rigid)});
  Vector load(2);
  load << 5, 30;
  const Equilibrium found = static_equilibrium(model, contacts, load);
  EXPECT_NEAR(found.displacement[0], -0.02, 1e-14);
  EXPECT_NEAR(found.displacement[1], 0.1, 1e-14);
  EXPECT_EQ(found.closed, (std::vector<bool>{true, true, false}));
  load << -50, 30; // lifts the first off its stop
  EXPECT_NEAR(static_equilibrium(model, contacts, load).displacement[0], -0.05, 1e-14);
}

// Two coordinates on springs of 1 N/m with one of 10 N/m between them, 21 N on the second: alone
// they stand at (10, 11). The first stop, seen twice as far, is overlapped more and is pressed
// first; with the second one, at 3, it would have to pull: (3 + 10 q) / 11 = 30/11 < 3.
TEST(EquilibriumTest, ARigidStopThatWouldPullIsLetGoAndTheOtherOneHolds) {
  const auto rigid = std::make_shared<NewtonRestitution>(0.5);
  Model model({single_mass("first", 1, 1, 0), single_mass("second", 1, 1, 0)});
  model::Projection elongation =
      model.displacement({.body = 1, .point = 0}, Vector3::UnitX(), false);
  elongation.row[0] = -1;
  model.add_connection({.name = "link",
                        .side_a = "first.head",
                        .side_b = "second.head",
                        .elongation = elongation,
                        .stiffness = 10});
  ContactPair doubled = contact_along_x(model, "first.head", "", 6, rigid);
  doubled.gap.row *= 2;
  const ContactSet contacts({doubled, contact_along_x(model, "second.head", "", 3, rigid)});
  const Equilibrium found = static_equilibrium(model, contacts, Eigen::Vector2d(0, 21));
  EXPECT_NEAR(found.displacement[0], 30.0 / 11, 1e-12);
  EXPECT_NEAR(found.displacement[1], 3, 1e-12);
  EXPECT_EQ(found.closed, (std::vector<bool>{false, true}));
}

} // namespace equilibrium_tests
} // namespace vibroimpact::motion
