// Bilinear approximations of a free mass that is pressed on a stop, in closed form, and of two
// oscillators whose values an independent solver gave.
#include "analyses/bilinear/bilinear_approximation.h"

#include "analyses/bilinear/bilinear_motion.h"
#include "analyses/sweeps/frequency_response.h"
#include "support/lumped_models.h"
#include "support/points.h"
#include "support/rigid_contacts.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace bilinear_approximation_tests {

constexpr double pi = std::numbers::pi;

System with_contact(model::Model model, const std::string &b, double clearance) {
  const contact::ContactPair pair = testing::contact_along_x(
      model, model.bodies()[0]->name + ".head", b, clearance, testing::newton(0));
  const Index n = model.size();
  return {.model = std::move(model),
          .contacts = contact::ContactSet({pair}),
          .integration = {},
          .initial = {.displacement = Vector::Zero(n), .velocity = Vector::Zero(n)}};
}

/// A free mass that is pressed on a stop by `press` and shaken by `force` sin(omega t).
System pressed(double press, double force) {
  model::Model model({testing::single_mass("block", 2, 0, 0)});
  model.add_force("press", model::make_constant(model::Given::displacement, press), {},
                  Vector3::UnitX());
  model.add_force("shaker",
                  std::make_shared<model::Harmonic>(model::Given::displacement, force, 1.0, 0.0),
                  {}, Vector3::UnitX());
  return with_contact(std::move(model), "", 0);
}

testing::Points approximation(System system, double frequency) {
  testing::Points points;
  BilinearApproximation({.frequencies = {frequency}}).run_line(0, system, points);
  return points;
}

constexpr double omega = 2 * pi * 3;

/// x / (force / (m omega^2)) since opening at phase `start`, at rest: x'' = ratio + sin.
double flight(double ratio, double start, double since) {
  return ratio * since * since / 2 - std::sin(start + since) + std::sin(start) +
         since * std::cos(start);
}

// It leaves the stop where the force changes its sign, sin theta = -press / force, and the flight
// ends where x is zero again.
TEST(BilinearApproximationTest, AFreeMassFollowsTheClosedForm) {
  for (const double ratio : {0.4, 0.6, 0.9}) {
    const testing::Points points = approximation(pressed(5 * ratio, 5), 3);
    const double opening = pi + std::asin(ratio);
    std::uintmax_t most = 100;
    const auto [low, high] = boost::math::tools::toms748_solve(
        [&](double since) { return flight(ratio, opening, since); },
        0.5 * (2 * pi - 2 * std::asin(ratio)) * 0.9, 2 * pi,
        boost::math::tools::eps_tolerance<double>(50), most);
    const double air = (low + high) / 2;
    EXPECT_NEAR(points.value({0}, "contact/heads/contact_fraction"), 1 - air / (2 * pi), 1e-11);
    EXPECT_NEAR(points.value({0}, "contact/heads/closing_phase"), std::fmod(opening + air, 2 * pi),
                1e-10);
    const double speed = ratio * air - std::cos(opening + air) + std::cos(opening);
    EXPECT_NEAR(points.value({0}, "contact/heads/approach_speed/maximum"), 5 / (2 * omega) * speed,
                1e-10);
    const double closing = std::fmod(opening + air, 2 * pi);
    const double largest = closing < pi / 2 || closing > opening ? 1 : std::sin(closing);
    EXPECT_NEAR(points.value({0}, "contact/heads/normal_force/maximum"), 5 * (largest + ratio),
                1e-9);
    // The stop forgets what was before.
    EXPECT_NEAR(points.value({0}, "largest_multiplier"), 0, 1e-7);
    EXPECT_EQ(points.value({0}, "contact/heads/impacts_per_period"), 1);
    // The farthest point is where the velocity is zero.
    double farthest = 0;
    for (int i = 0; i < 200000; ++i)
      farthest = std::min(farthest, flight(ratio, opening, air * i / 200000));
    EXPECT_NEAR(points.value({0}, "point/block.head/displacement_x/minimum"),
                5 / (2 * omega * omega) * farthest, 1e-12);
    EXPECT_NEAR(points.value({0}, "point/block.head/displacement_x/maximum"), 0, 1e-15);
  }
}

TEST(BilinearApproximationTest, PressedHardItStaysAtTheStop) {
  const testing::Points points = approximation(pressed(6, 5), 3);
  EXPECT_EQ(points.value({0}, "contact/heads/contact_fraction"), 1);
  EXPECT_EQ(points.value({0}, "contact/heads/impacts_per_period"), 0);
  EXPECT_NEAR(points.value({0}, "contact/heads/normal_force/maximum"), 11, 1e-12);
}

// Where it would be pulled off at once, it leaves at the instant at which it arrives: from rest at
// theta back to the stop takes a whole period where cos theta = -pi press / force.
TEST(BilinearApproximationTest, PressedLightlyItPartsAtOnce) {
  for (const double ratio : {0.1, 0.2, 0.25}) {
    const testing::Points points = approximation(pressed(5 * ratio, 5), 3);
    EXPECT_EQ(points.value({0}, "contact/heads/contact_fraction"), 0);
    EXPECT_EQ(points.value({0}, "contact/heads/impacts_per_period"), 1);
    EXPECT_NEAR(points.value({0}, "contact/heads/closing_phase"), 2 * pi - std::acos(-pi * ratio),
                1e-12);
    EXPECT_NEAR(points.value({0}, "contact/heads/approach_speed/maximum"),
                5 / (2 * omega) * 2 * pi * ratio, 1e-12);
  }
}

TEST(BilinearApproximationTest, WithoutASolutionThePointSaysWhy) {
  const testing::Points points = approximation(pressed(-1, 5), 3);
  EXPECT_EQ(points.all().at({0}).status, Status::failed);
  EXPECT_NE(points.all().at({0}).reason.find("the contact pulls while it is tied"),
            std::string::npos)
      << points.all().at({0}).reason;
}

System two_oscillators(double gap) {
  model::Model model({testing::single_mass("first", 1.80, 430.00, 31.14),
                      testing::single_mass("second", 2.46, 417.78, 19.13)});
  model.add_base_motion(
      "table", std::make_shared<model::Harmonic>(model::Given::displacement, 0.01, 1.0, 0.0),
      {0, 1}, Vector3::UnitX());
  return with_contact(std::move(model), "second.head", gap);
}

double amplitude(const testing::Points &points, const std::string &body) {
  return 1e3 / 2 *
         points.value({0}, "point/" + body + ".head/absolute_displacement_x/peak_to_peak");
}

TEST(BilinearApproximationTest, TwoOscillatorsAsAnIndependentSolverHasThem) {
  const testing::Points touching = approximation(two_oscillators(0), 2.4);
  EXPECT_NEAR(amplitude(touching, "first"), 13.3965, 5e-5);
  EXPECT_NEAR(amplitude(touching, "second"), 16.0744, 1e-4);
  EXPECT_NEAR(touching.value({0}, "contact/heads/contact_fraction"), 0.2528, 5e-5);
  const testing::Points apart = approximation(two_oscillators(0.002), 2.4);
  EXPECT_NEAR(amplitude(apart, "second"), 16.4207, 5e-5);
  EXPECT_NEAR(apart.value({0}, "contact/heads/contact_fraction"), 0.1853, 5e-5);
}

// Far apart they do not meet, and the motion is the linear response with its single order.
TEST(BilinearApproximationTest, WithoutContactItIsTheLinearResponse) {
  const testing::Points open = approximation(two_oscillators(0.1), 2.4);
  EXPECT_EQ(open.value({0}, "contact/heads/impacts_per_period"), 0);
  System system = two_oscillators(0.1);
  testing::Points linear;
  FrequencyResponse({.frequencies = {2.4}, .excitation = ""}).run_line(0, system, linear);
  const double expected =
      linear.values({}, "point/first.head/absolute_displacement_x/amplitude")[0];
  EXPECT_NEAR(1e-3 * amplitude(open, "first"), expected, 1e-14);
  const auto &orders = open.values({0}, "spectrum/point/first.head/absolute_displacement_x");
  EXPECT_NEAR(orders[1], expected, 1e-14);
  EXPECT_NEAR(orders[2], 0, 1e-14);
}

// The conditions of the formulation, each from the states of the solution themselves.
TEST(BilinearApproximationTest, TheStatesMeetAllConditions) {
  const System system = two_oscillators(0.002);
  const TiedSystem tied(system, 0, 2 * pi * 2.4);
  const std::vector<BilinearMotion> motions = bilinear_motions(tied, 360, 720);
  int found = 0;
  for (const BilinearMotion &motion : motions) {
    if (!motion.closes || !motion.admissible())
      continue;
    ++found;
    const double closing = motion.closing_phase;
    const Matrix y =
        states_of(tied, motion, (Vector(2) << closing - 1e-9, closing + 1e-9).finished());
    const double first = 1.80, second = 2.46;
    EXPECT_NEAR(0.002 + y(1, 1) - y(0, 1), 0, 1e-12); // gap, closed
    EXPECT_NEAR(y(0, 0), y(0, 1), 1e-10);             // position
    EXPECT_NEAR(first * y(2, 0) + second * y(3, 0), first * y(2, 1) + second * y(3, 1),
                1e-9);                    // momentum
    EXPECT_NEAR(y(2, 1), y(3, 1), 1e-12); // one velocity
    EXPECT_GT(y(2, 0) - y(3, 0), 1e-3);
    EXPECT_NEAR(tied.force().dot(motion.open_start), 0, 1e-12); // at opening
    EXPECT_GT(tied.force().dot(motion.closed_start), 0.1);
  }
  EXPECT_EQ(found, 1);
}

TEST(BilinearApproximationTest, WhatIsStoredIsNotComputedAgain) {
  System system = two_oscillators(0.002);
  testing::Points points;
  points.know({.index = {0}});
  BilinearApproximation({.frequencies = {2.4}}).run_line(0, system, points);
  EXPECT_TRUE(points.all().empty());
}

} // namespace bilinear_approximation_tests
} // namespace vibroimpact::analyses
