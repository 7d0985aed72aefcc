// Branches of motions with dry friction to where their sides come to stick, in closed form.
//
// x'' + x = cos(b t) - f sign(x') without stops (Den Hartog 1930), V = 1 / (1 - b^2),
// U = sin(pi / b) / (b (1 + cos(pi / b))):
//
//   A = sqrt(V^2 - U^2 f^2)   amplitude,   cos(phi) = A / V at a turn
//
// At a turn the force that would hold the mass is A b^2, and
//
//   f = |V| / sqrt(U^2 + S^2),   S = max over 0 < s < pi of (sin(s / b) + b U (cos s - cos(s / b)))
//   / (b sin s)
//
// is the largest friction without stops. For b > 1/2 it is that of the turns, S = 1 / b^2; below
// 1/2 the speed falls to zero between two turns first.
#include "continuation/branch.h"
#include "continuation/locus.h"

#include "family.h"
#include "support/friction_models.h"

#include <gtest/gtest.h>

#include <boost/math/tools/minima.hpp>

namespace vibroimpact::periodic {
namespace sliding_tests {

using continuation::Branch;
using continuation::Special;
using continuation::SpecialPoint;
using testing::Family;
using testing::Oscillator;

constexpr double pi = std::numbers::pi;

/// The motion without stops.
struct NonStop {
  double b;
  double v() const { return 1 / (1 - b * b); }
  double u() const { return std::sin(pi / b) / (b * (1 + std::cos(pi / b))); }
  /// The friction at which the force at a turn is `ratio` times it.
  double at_turns(double ratio) const { return std::abs(v()) / std::hypot(u(), ratio / (b * b)); }
  double between_turns() const {
    const auto less = [this](double s) {
      return -(std::sin(s / b) + b * u() * (std::cos(s) - std::cos(s / b))) / (b * std::sin(s));
    };
    const double most = -boost::math::tools::brent_find_minima(less, 0.1, 1.2, 52).second;
    return std::abs(v()) / std::hypot(u(), most);
  }
};

Oscillator rubbing(double friction, double ratio, double b) {
  Oscillator model = testing::oscillator(1, 1, 0);
  model.push(1, b, 1);
  model.contacts = contact::ContactSet({testing::sliding_along_x(
      model.model, "block.head", "", testing::coulomb(1, friction, ratio * friction))});
  return model;
}

Branch along(Family &family, double from, double lower, double upper) {
  const Orbit orbit = find_orbit(family.at(from), 1, Vector::Constant(2, 0.1));
  const long halves = orbit.symmetric() ? 1 : 2;
  OrbitProblem problem(family, halves,
                       problem_sizes(family.at(from), orbit, Vector::Constant(1, upper - lower)));
  continuation::Settings settings;
  settings.first_key = {.lower = lower, .upper = upper};
  const continuation::Point start{
      .state = orbit.point.state, .keys = Vector::Constant(1, from), .chart = orbit.section.phase};
  return follow(problem, {.point = start, .direction = {}}, settings);
}

Branch along_friction(double b, double ratio, double from, double upper) {
  Family family([b, ratio](double friction) { return rubbing(friction, ratio, b); });
  return along(family, from, 0.02, upper);
}

void expect_graze(const Branch &branch, GrazeKind kind, double key, double up_to) {
  ASSERT_EQ(branch.special.size(), 1u);
  const SpecialPoint &found = branch.special[0];
  EXPECT_EQ(found.kind, Special::graze) << name_of(found.kind);
  EXPECT_NEAR(found.at.point.keys[0], key, up_to);
  ASSERT_TRUE(found.graze.has_value());
  EXPECT_EQ(found.graze->kind, static_cast<int>(kind));
}

TEST(SlidingTest, BorderOfTheMotionsThatStop) {
  for (const double b : {0.6, 0.8, 1.2, 1.5, 2.0}) {
    const double exact = NonStop{b}.at_turns(1);
    const Branch branch = along_friction(b, 1, 0.6 * exact, 1.05 * exact);
    EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
    expect_graze(branch, GrazeKind::crossing_sliding, exact, 1e-12);
  }
}

TEST(SlidingTest, SpeedsThatFallToZeroBetweenTurns) {
  for (const double b : {0.4, 0.42}) {
    const double exact = NonStop{b}.between_turns();
    const Branch branch = along_friction(b, 1, 0.6 * exact, 1.02 * exact);
    EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
    expect_graze(branch, GrazeKind::grazing_sliding, exact, 1e-12);
  }
}

TEST(SlidingTest, BorderWithALargerStaticCoefficient) {
  const double b = 1.2, ratio = 1.25, exact = NonStop{b}.at_turns(ratio);
  const Branch branch = along_friction(b, ratio, 0.6 * exact, 1.05 * exact);
  EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
  expect_graze(branch, GrazeKind::crossing_sliding, exact, 1e-12);
}

/// x'' + x = F(t) - f sign(x'), F = cos(b t) + q cos(3 b t), for motions that slip once each way
/// and stick in between. Before the slip from x = -A at t_1 the force that holds the mass is F + A;
/// it is largest at b t = pi. There it reaches f where F(t_1) = F(pi / b) too: with c = cos(b t_1),
/// 4 q c^2 - 4 q c + 1 + q = 0. Then x + f until the stop at t_2 depends on t_1 alone, and x(t_2) =
/// A = f - F(t_1).
struct SlipBetweenSticks {
  double b, q;
  double force(double t) const { return std::cos(b * t) + q * std::cos(3 * b * t); }
  double particular(double t) const {
    return std::cos(b * t) / (1 - b * b) + q * std::cos(3 * b * t) / (1 - 9 * b * b);
  }
  double particular_rate(double t) const {
    return -b * std::sin(b * t) / (1 - b * b) - 3 * b * q * std::sin(3 * b * t) / (1 - 9 * b * b);
  }
  /// The friction at which the mass just slips in the middle of a stick.
  double border() const {
    const double c = (1 - std::sqrt(1 - (1 + q) / q)) / 2;
    const double start = (2 * pi - std::acos(c)) / b;
    const double along = force(start) - particular(start), across = -particular_rate(start);
    const auto speed = [&](double s) {
      return particular_rate(start + s) - along * std::sin(s) + across * std::cos(s);
    };
    double low = 2, high = 6;
    for (int i = 0; i < 100; ++i)
      (speed((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    const double end = particular(start + low) + along * std::cos(low) + across * std::sin(low);
    return (end + force(start)) / 2;
  }
};

TEST(SlidingTest, SlipInTheMiddleOfAStick) {
  const double b = 0.3, q = -0.35, exact = SlipBetweenSticks{b, q}.border();
  EXPECT_NEAR(exact, 0.6833, 1e-3);
  Family family([&](double friction) {
    Oscillator model = testing::oscillator(1, 1, 0);
    model.push(1, b, pi / 2);
    model.push(q, 3 * b, pi / 2);
    model.contacts = contact::ContactSet({testing::sliding_along_x(
        model.model, "block.head", "", testing::coulomb(1, friction, friction))});
    return model;
  });
  const Branch branch = along(family, 0.67, 0.5, 0.72);
  EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
  expect_graze(branch, GrazeKind::adding_sliding, exact, 1e-11);
}

// The border over the frequency.
TEST(SlidingTest, BorderInTwoKeys) {
  Family family(Family::Make([](const Vector &keys) { return rubbing(keys[0], 1, keys[1]); }),
                false);
  const double b = 1.3;
  const Vector keys = Eigen::Vector2d(0.999 * NonStop{b}.at_turns(1), b);
  const Orbit orbit = find_orbit(family.at(keys), 1, Vector::Constant(2, 0.1));
  OrbitProblem problem(family, 2, Eigen::Vector4d(1, 1, 1, 1));
  const continuation::Point start{
      .state = orbit.point.state, .keys = keys, .chart = orbit.section.phase};
  const auto grazes = problem.grazes_near(start);
  const auto turn = std::find_if(grazes.begin(), grazes.end(), [&](const auto &graze) {
    return problem.extend(start, graze).kind == static_cast<int>(GrazeKind::crossing_sliding);
  });
  ASSERT_NE(turn, grazes.end());
  continuation::Settings settings;
  settings.longest_step = 0.05;
  settings.first_key = {.lower = 0.1, .upper = 1.2};
  settings.second_key = {.lower = 1.05, .upper = 2};
  for (const bool forward : {true, false}) {
    const continuation::Locus locus = follow_locus(problem,
                                                   {.kind = continuation::LocusKind::graze,
                                                    .point = start,
                                                    .graze = *turn,
                                                    .forward = forward},
                                                   settings);
    EXPECT_EQ(locus.end, continuation::End::bounds) << locus.reason;
    for (const continuation::LocusPoint &point : locus.points)
      EXPECT_NEAR(point.point.keys[0], NonStop{point.point.keys[1]}.at_turns(1), 1e-11);
  }
}

} // namespace sliding_tests
} // namespace vibroimpact::periodic
