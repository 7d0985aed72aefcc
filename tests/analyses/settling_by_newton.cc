// Settling by Newton's method: where it leads, and where it must not.
#include "analyses/sweeps/settling.h"

#include "analyses/sweeps/steadiness.h"
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "model/ramped_harmonic.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace vibroimpact::analyses {
namespace settling_by_newton_tests {

using contact::ContactSet;

constexpr double pi = std::numbers::pi;

SettlingRule rule(std::optional<long> newton_after, double tolerance = 1e-11) {
  return {.minimum = 5,
          .maximum = 6000,
          .tolerance = tolerance,
          .longest_multiple = 4,
          .newton_after = newton_after};
}

constexpr long at_once = 2;
constexpr std::nullopt_t waiting = std::nullopt;

/// x'' + damping x' + stiffness x = force sin(omega t), with stops.
struct Oscillator {
  double omega = 1;
  System system;

  Oscillator(double stiffness, double damping, double force, double angular_frequency)
      : omega(angular_frequency), system(testing::system_of(model::Model(
                                      {testing::single_mass("block", 1, stiffness, damping)}))) {
    system.model.add_force(
        "push", std::make_shared<model::Harmonic>(model::Given::displacement, force, omega, 0), {},
        Vector3::UnitX());
  }
  void stop(double clearance, std::shared_ptr<const contact::ContactLaw> law, bool both = false) {
    std::vector<contact::ContactPair> pairs = {
        testing::contact_along_x(system.model, "block.head", "", clearance, law)};
    pairs[0].accept_initial_penetration = true;
    if (both) {
      pairs.push_back(pairs[0]);
      pairs[1].gap.row *= -1;
    }
    system.contacts = ContactSet(std::move(pairs));
  }
  SettledMotion settled(const SettlingRule &rule) const {
    motion::Trajectory trajectory(system.model, system.contacts, system.integration);
    trajectory.start(0, system.initial.displacement, system.initial.velocity);
    return Settler(trajectory)(2 * pi / omega, state_scale(trajectory.equations(), omega), rule);
  }
};

Oscillator isolator(double lambda, double mu = 2) {
  Oscillator isolator(1, 0.02, 0.52, lambda);
  isolator.stop(1, std::make_shared<contact::BilinearStop>(mu, 0.4), true);
  return isolator;
}

// The same motion, up to which of its periods comes first.
void expect_same(const SettledMotion &newton, const SettledMotion &waited, double tolerance) {
  EXPECT_TRUE(newton.steady());
  EXPECT_TRUE(waited.steady());
  EXPECT_EQ(newton.multiple, waited.multiple);
  const double size = waited.highest.cwiseAbs().cwiseMax(waited.lowest.cwiseAbs()).maxCoeff();
  EXPECT_LT((newton.lowest - waited.lowest).cwiseAbs().maxCoeff(), tolerance * size);
  EXPECT_LT((newton.highest - waited.highest).cwiseAbs().maxCoeff(), tolerance * size);
}

// A motion that settles sooner is the same to the last bit; a slow one is found where it is.
TEST(SettlingByNewtonTest, MayWaitForTheTransientFirst) {
  constexpr long after = 20;
  const SettledMotion quick = Oscillator(1, 1, 1, 0.7).settled(rule(after, 1e-3));
  const SettledMotion waited = Oscillator(1, 1, 1, 0.7).settled(rule(waiting, 1e-3));
  EXPECT_LT(waited.cycles, after);
  EXPECT_EQ(quick.cycles, waited.cycles);
  EXPECT_EQ(quick.state.physical, waited.state.physical);
  const SettledMotion slow = isolator(1.1).settled(rule(after));
  EXPECT_GT(slow.cycles, after);
  EXPECT_LT(slow.cycles, after + 20);
  expect_same(slow, isolator(1.1).settled(rule(waiting)), 1e-9);
}

// A stop out of reach that would remember the speed of an impact has no say in it.
TEST(SettlingByNewtonTest, AContactThatRemembersDoesNotHoldALinearMotionUp) {
  Oscillator linear(400, 0.06, 2, 15);
  linear.stop(1, contact::HuntCrossley::with_dimensionless_damping(
                     {.stiffness = 1e6, .exponent = 1.5}, 0.4, 1e-6));
  const SettledMotion motion = linear.settled(rule(at_once));
  EXPECT_TRUE(motion.steady());
  EXPECT_LT(4 * motion.cycles, linear.settled(rule(waiting)).cycles);
}

// x = Im(X exp(i omega t)) in closed form.
TEST(SettlingByNewtonTest, ALinearMotionIsThereBeforeItsTransientHasDecayed) {
  const Oscillator linear(400, 0.06, 2, 15);
  const SettledMotion motion = linear.settled(rule(at_once));
  const std::complex<double> amplitude = 2.0 / std::complex<double>(400 - 15 * 15, 15 * 0.06);
  EXPECT_EQ(motion.multiple, 1);
  EXPECT_LT(4 * motion.cycles, linear.settled(rule(waiting)).cycles);
  EXPECT_NEAR(motion.state.physical[0], amplitude.imag(), 1e-10 * std::abs(amplitude));
  EXPECT_NEAR(motion.state.physical[1], 15 * amplitude.real(), 15e-10 * std::abs(amplitude));
}

TEST(SettlingByNewtonTest, ThroughContactsItLeadsWhereWaitingDoes) {
  long periods = 0, waited_periods = 0;
  for (const double lambda : {0.8, 1.1, 1.2, 1.25, 1.35}) {
    const SettledMotion newton = isolator(lambda).settled(rule(at_once));
    const SettledMotion waited = isolator(lambda).settled(rule(waiting));
    expect_same(newton, waited, 1e-9);
    periods += newton.cycles;
    waited_periods += waited.cycles;
  }
  EXPECT_LT(2 * periods, waited_periods);
}

// Rigid impacts, where the velocity jumps.
TEST(SettlingByNewtonTest, ThroughRigidImpacts) {
  Oscillator impacting(1, 0.1, 0.6, 0.8);
  impacting.stop(1, std::make_shared<contact::NewtonRestitution>(0.8));
  expect_same(impacting.settled(rule(at_once)), impacting.settled(rule(waiting)), 1e-9);
}

// The subharmonic resonance of an oscillator that is sixteen times stiffer on one side, at twice
// its own frequency 2 w1 w2 / (w1 + w2), w1 = 1, w2 = 4.
TEST(SettlingByNewtonTest, AMotionOfTwoPeriods) {
  Oscillator bilinear(1, 0.1, 1, 3.2);
  bilinear.stop(0, std::make_shared<contact::LinearPenalty>(15));
  const SettledMotion newton = bilinear.settled(rule(at_once));
  EXPECT_EQ(newton.multiple, 2);
  const SettledMotion waited = bilinear.settled(rule(waiting));
  expect_same(newton, waited, 1e-9);
  EXPECT_LT(2 * newton.cycles, waited.cycles);
}

// Between its folds the isolator has an unstable motion too, next to which it begins here:
// |y| = 1.39053298 at lambda = 1.3.
TEST(SettlingByNewtonTest, AnUnstableMotionIsLeft) {
  for (const double beside : {-1e-3, 1e-3}) {
    Oscillator oscillator = isolator(1.3);
    oscillator.system.initial.displacement[0] = -0.41023 + beside;
    oscillator.system.initial.velocity[0] = -1.68129;
    expect_same(oscillator.settled(rule(at_once)), oscillator.settled(rule(waiting)), 1e-9);
  }
}

// Of two stable motions the one to which the start leads, not the one that Newton's method finds
// from it.
TEST(SettlingByNewtonTest, FromEveryStartItLeadsWhereWaitingDoes) {
  Oscillator oscillator = isolator(1.3);
  int small = 0;
  constexpr int starts = 30;
  for (int i = 0; i < starts; ++i)
    for (int j = 0; j < starts; ++j) {
      oscillator.system.initial.displacement[0] = -2.9 + 5.8 * i / (starts - 1);
      oscillator.system.initial.velocity[0] = -2.9 + 5.8 * j / (starts - 1);
      const SettledMotion newton = oscillator.settled(rule(at_once));
      const SettledMotion waited = oscillator.settled(rule(waiting, 1e-6));
      ASSERT_NEAR(newton.state.physical[0], waited.state.physical[0], 1e-4) << i << " " << j;
      small += std::abs(newton.state.physical[0]) < 1 ? 1 : 0;
    }
  EXPECT_NEAR(small, 0.0879 * starts * starts, 12); // the share of the plane
}

// Close to the cusp of the folds, at mu = 0.782854, two stable motions lie close together, and the
// unstable one between them. Along the line through the three P(x) - x is nearly a cubic: about
// half-way from the unstable to a stable one Newton's method jumps beyond both, to the other stable
// motion, where it converges at once. The motion itself only leaves the unstable one.
TEST(SettlingByNewtonTest, TheMotionBeyondAnUnstableOneIsNotTaken) {
  const Eigen::Vector2d between(-0.32576206, -1.58347417), stable(-0.23441463, -1.507031);
  Oscillator oscillator = isolator(1.220919236, 0.787);
  for (double way = 0.5045; way < 0.511; way += 0.0002) {
    const Eigen::Vector2d start = between + way * (stable - between);
    oscillator.system.initial.displacement[0] = start[0];
    oscillator.system.initial.velocity[0] = start[1];
    EXPECT_NEAR(oscillator.settled(rule(true)).state.physical[0], stable[0], 1e-3) << way;
  }
}

// At resonance the free motion only grows, towards an amplitude that the stop does not allow.
TEST(SettlingByNewtonTest, AMotionThatIsBarredIsNotGoneTo) {
  const double force = 2, damping = 0.6, omega = 20;
  Oscillator growing(omega * omega, damping, force, omega);
  growing.stop(0.9 * force / (damping * omega), std::make_shared<contact::LinearPenalty>(2e4));
  expect_same(growing.settled(rule(at_once)), growing.settled(rule(waiting)), 1e-9);
}

TEST(SettlingByNewtonTest, WhatDoesNotRepeatItselfGoesOnByItself) {
  Oscillator ramped(400, 6, 0, 15);
  ramped.system.model.add_force(
      "ramp", std::make_shared<model::RampedHarmonic>(model::Given::displacement, 2, 15, 0, 5), {},
      Vector3::UnitX());
  const SettledMotion newton = ramped.settled(rule(at_once)),
                      waited = ramped.settled(rule(waiting));
  EXPECT_EQ(newton.cycles, waited.cycles);
  EXPECT_EQ(newton.state.physical, waited.state.physical);
}

TEST(SettlingByNewtonTest, ToleranceZeroTakesAllPeriods) {
  SettlingRule all = rule(at_once, 0);
  all.maximum = 12;
  EXPECT_EQ(isolator(1.1).settled(all).cycles, 12);
}

// A settler that has served other frequencies leaves no trace.
TEST(SettlingByNewtonTest, WhatWentBeforeDoesNotCount) {
  Oscillator oscillator = isolator(0.9);
  const auto at = [&](Settler &settler, motion::Trajectory &trajectory, double omega) {
    oscillator.system.model.set_frequency(0, omega);
    trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
    return settler(2 * pi / omega, state_scale(trajectory.equations(), omega), rule(at_once));
  };
  motion::Trajectory one(oscillator.system.model, oscillator.system.contacts, {});
  motion::Trajectory other(oscillator.system.model, oscillator.system.contacts, {});
  Settler first(one), second(other);
  at(first, one, 0.8);
  at(first, one, 1.2);
  EXPECT_EQ(at(first, one, 0.9).state.physical, at(second, other, 0.9).state.physical);
}

} // namespace settling_by_newton_tests
} // namespace vibroimpact::analyses
