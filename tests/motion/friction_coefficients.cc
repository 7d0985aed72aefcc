// Friction whose coefficient depends on the slip speed, against closed forms, published figures and
// an independent program (tests/support/friction_reference.py).
#include "contact/friction/lugre.h"
#include "contact/friction/piecewise_linear.h"
#include "contact/friction/stribeck.h"
#include "contact/laws/linear_penalty.h"
#include "model/piecewise_function.h"
#include "support/friction_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace friction_coefficients_tests {

using namespace model;
using contact::ContactPair;
using contact::ContactSet;
using contact::Coulomb;
using contact::FrictionalLaw;
using contact::LinearPenalty;
using contact::LuGre;
using contact::PiecewiseLinear;
using contact::Stribeck;
using testing::Changes;
using testing::constant_with;
using testing::oblique_contact;
using testing::particle;
using testing::settings_of;
using testing::single_mass;
using testing::sliding_along_x;
using testing::vector_of;

class FrictionCoefficientsTest : public ::testing::TestWithParam<const char *> {
protected:
  bool exact() const { return std::string(GetParam()) == "exact"; }
  Settings settings() const {
    Settings settings = settings_of(GetParam());
    settings.relative_tolerance = 1e-12;
    settings.absolute_tolerance = 0;
    return settings;
  }
};
INSTANTIATE_TEST_SUITE_P(Methods, FrictionCoefficientsTest, ::testing::Values("exact", "rk"));

// Each half swing goes about the point to which friction draws the spring, with the decay of a
// damped vibration.
TEST_P(FrictionCoefficientsTest, CoulombWithDamping) {
  const double m = 2, k = 50, c = 1.5, mu = 0.2, normal = 10;
  const double drawn = mu * normal / k, w = std::sqrt(k / m - c * c / (4 * m * m));
  const double decay = std::exp(-c / (2 * m) * std::numbers::pi / w);
  const Model model({single_mass("block", m, k, 0)});
  const ContactSet contacts({sliding_along_x(
      model, "block.head", "", constant_with(normal, std::make_shared<Coulomb>(mu, mu, c)))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0.5}), vector_of({0}));
  trajectory.advance(10, changes);
  double x = 0.5;
  std::size_t i = 0;
  const double error = exact() ? 1e-13 : 1e-10;
  for (; std::abs(x) > drawn; ++i) {
    x = std::copysign(1, x) * (drawn - (std::abs(x) - drawn) * decay);
    ASSERT_LT(i, changes.list.size());
    EXPECT_NEAR(changes.list[i].state[0], x, error) << i;
    EXPECT_NEAR(changes.list[i].time, static_cast<double>(i + 1) * std::numbers::pi / w, error)
        << i;
  }
  EXPECT_EQ(changes.list.size(), i);
  EXPECT_EQ(changes.list.back().to, "stick");
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

// A mass 2 under 10 N comes to rest through three pieces: v' = -3/2, -(v + 1/2), 2 (v - 1).
void expect_rest_through_pieces(const Changes &changes, double error) {
  const double times[] = {1.0 / 3, std::log(1.5), std::log(2.0) / 2};
  const double ways[] = {5.0 / 12, 0.5 - 0.5 * std::log(1.5), std::log(2.0) / 2 - 0.25};
  const char *names[] = {"slip backward 2", "slip backward 1", "stick"};
  ASSERT_EQ(changes.list.size(), 3u);
  double time = 0, way = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    time += times[i];
    way += ways[i];
    EXPECT_NEAR(changes.list[i].time, time, error) << i;
    EXPECT_NEAR(changes.list[i].state[0], way, error) << i;
    EXPECT_EQ(changes.list[i].to, names[i]);
  }
}

std::shared_ptr<const PiecewiseLinear> three_pieces() {
  return std::make_shared<PiecewiseLinear>(std::vector{0.0, 0.5, 1.0}, std::vector{0.4, 0.2, 0.3},
                                           0.4);
}

TEST_P(FrictionCoefficientsTest, PiecesUnderAConstantForce) {
  const Model model({single_mass("block", 2, 0, 0)});
  const ContactSet contacts(
      {sliding_along_x(model, "block.head", "", constant_with(10, three_pieces()))});
  for (const contact::Mode &mode : contacts.pairs()[0].law->modes())
    EXPECT_TRUE(mode.affine) << mode.name;
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0}), vector_of({1.5}));
  trajectory.advance(2, changes);
  expect_rest_through_pieces(changes, exact() ? 1e-13 : 1e-10);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

// The same normal force by a spring that rests: the product with v is no affine form.
TEST_P(FrictionCoefficientsTest, PiecesUnderASpring) {
  Model model({particle("block", 2)});
  model.add_force("weight", make_constant(Given::displacement, 10), {.body = 0, .point = 0},
                  Vector3::UnitY());
  ContactPair pair = oblique_contact(
      model, "block.head", 0,
      std::make_shared<FrictionalLaw>(std::make_shared<LinearPenalty>(1e3), three_pieces()));
  pair.accept_initial_penetration = true;
  const ContactSet contacts({pair});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0.01}), vector_of({1.5, 0}));
  trajectory.advance(2, changes);
  expect_rest_through_pieces(changes, 1e-10);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-9);
}

struct BeltChange {
  double time, x;
  const char *mode;
};

void expect_on_belt(const Settings &settings, const contact::StribeckConstants &constants,
                    const std::vector<BeltChange> &known, double x, double v) {
  const Model model({single_mass("block", 1, 1, 0)});
  const ContactSet contacts({sliding_along_x(
      model, "block.head", "", constant_with(1, std::make_shared<Stribeck>(constants)), 0.2)});
  Trajectory trajectory(model, contacts, settings);
  Changes changes(contacts);
  trajectory.start(0, vector_of({0}), vector_of({0.2}));
  trajectory.advance(30, changes);
  ASSERT_EQ(changes.list.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_NEAR(changes.list[i].time, known[i].time, 1e-9) << i;
    EXPECT_NEAR(changes.list[i].state[0], known[i].x, 1e-9) << i;
    EXPECT_EQ(changes.list[i].to, known[i].mode) << i;
  }
  EXPECT_NEAR(trajectory.state()[0], x, 1e-9);
  EXPECT_NEAR(trajectory.state()[1], v, 1e-9);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-9);
}

TEST_P(FrictionCoefficientsTest, StribeckOnABelt) {
  const char *slip = "slip forward";
  expect_on_belt(
      settings(),
      {.coefficient = 0.5, .static_coefficient = 1, .speed = 0.3, .damping_constant = 0.02},
      {{5, 1, slip},
       {9.52973560897921, .0210861743306817, "stick"},
       {14.4243047373258, 1, slip},
       {18.954040346305, .0210861743306817, "stick"},
       {23.8486094746516, 1, slip},
       {28.3783450836308, .0210861743306814, "stick"}},
      .345417157604515, .2);
  expect_on_belt(settings(),
                 {.coefficient = 0.5, .static_coefficient = 1, .speed = 0.3, .exponent = 2},
                 {{5, 1, slip},
                  {9.72385270277671, -.140368355321969, "stick"},
                  {15.4256944793865, 1, slip},
                  {20.1495471821633, -.140368355321968, "stick"},
                  {25.8513889587731, 1, slip}},
                 -.0950818944492357, -.300995803156364);
}

// A mass pulled by a spring 2 whose end moves at 0.1 (Canudas de Wit et al. 1995), seen from that
// end. Figures of the program Exudyn and of own steps of order 8; slips begin where v rises.
TEST(FrictionCoefficients, BristlesOfAPulledMass) {
  const Model model({single_mass("block", 1, 2, 0)});
  const auto law = std::make_shared<LuGre>(contact::LuGreConstants{
      .coefficient = {.coefficient = 1, .static_coefficient = 1.5, .speed = 1e-3, .exponent = 2},
      .stiffness = 1e5,
      .damping = std::sqrt(1e5),
      .viscous = 0.4});
  const ContactSet contacts(
      {sliding_along_x(model, "block.head", "", constant_with(1, law), -0.1)});
  Settings settings = settings_of("exact");
  settings.relative_tolerance = 1e-12;
  Trajectory trajectory(model, contacts, settings);
  Changes changes(contacts);
  trajectory.start(0, vector_of({0}), vector_of({-0.1}));
  for (const auto &[time, x] :
       {std::pair(10.2628, .636283), {16.6255, 1.272555}, {22.9882, 1.908827}}) {
    trajectory.advance(time, changes);
    EXPECT_NEAR(trajectory.state()[0] + 0.1 * time, x, 5e-6);
  }
  trajectory.advance(25, changes);
  const Vector &state = trajectory.state();
  EXPECT_NEAR(state[0] + 2.5, 1.908839199, 5e-10);
  EXPECT_NEAR(state[1] + 0.1, 9.4241546e-6, 5e-12);
  EXPECT_NEAR(-state[trajectory.layout().internal()], 1.18167955e-5, 5e-13);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8);
}

} // namespace friction_coefficients_tests
} // namespace vibroimpact::motion
