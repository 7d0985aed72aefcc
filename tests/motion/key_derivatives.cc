// Derivatives of motions by keys: closed forms, and differences of the motions.
#include "common/error.h"
#include "contact/laws/crushable_table.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/tsuji.h"
#include "model/pulse.h"
#include "motion/variation/linearised_motion.h"
#include "support/friction_models.h"
#include "support/key_families.h"
#include "support/motion_derivative.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace key_derivatives_tests {

using namespace model;
using contact::ContactSet;
using testing::add_weight;
using testing::contact_along_x;
using testing::newton;
using testing::Parts;
using testing::single_mass;
using testing::stop_on_base;
using testing::tangent_by_key;
using testing::vector_of;

// A system as a function of one key.
struct Family {
  std::function<Parts(double)> make;
  double value = 1;
  MotionState start{};
  double end = 1;

  Settings settings() const {
    return {.relative_tolerance = 1e-12, .absolute_tolerance = 1e-15, .event_tolerance = 1e-14};
  }
  LinearisedMotion linearised() const {
    const Parts parts = make(value);
    KeyTangent key = tangent_by_key(make, value, parts);
    Trajectory trajectory(parts.model, parts.contacts, settings());
    Lineariser linearise(trajectory,
                         {.scale = Vector::Ones(start.physical.size()), .tolerance = 1e-12});
    return linearise(start, end, {&key});
  }
  Vector flow(double of, Index *events = nullptr) const {
    const Parts parts = make(of);
    Trajectory trajectory(parts.model, parts.contacts, settings());
    trajectory.start(start);
    testing::Events seen;
    trajectory.advance(end, seen);
    if (events)
      *events = static_cast<Index>(seen.list.size());
    return trajectory.motion_state().physical;
  }
  void agrees_with_differences(Index least_events, double tolerance = 1e-8) const {
    const LinearisedMotion motion = linearised();
    Index events = 0;
    flow(value, &events);
    EXPECT_GE(events, least_events);
    EXPECT_EQ(motion.without_derivative, 0);
    const testing::NumericalDerivative differences = testing::numerical_derivative(
        [&](double by) { return std::optional<Vector>(flow(value + by)); }, 1e-3 * value);
    EXPECT_LT(differences.error, tolerance);
    EXPECT_LT((motion.by_key.col(0) - differences.value).cwiseAbs().maxCoeff(),
              tolerance * differences.value.cwiseAbs().maxCoeff());
  }
};

std::shared_ptr<const TimeFunction> force_of(double amplitude, double omega, double phase = 0.4) {
  return std::make_shared<Harmonic>(Given::displacement, amplitude, omega, phase);
}

Model pushed_mass(double mass, double stiffness, double damping,
                  const std::shared_ptr<const TimeFunction> &force) {
  Model model({single_mass("block", mass, stiffness, damping)});
  model.add_force("push", force, {.body = 0, .point = 0}, Vector3::UnitX());
  return model;
}

// x = Re(c exp(i w t)) for the right start, c = a e^(i phi) / (i (k - m w^2 + i c w)): its
// derivative at fixed time less the free vibration that the same deviation of the start makes.
TEST(KeyDerivativesTest, AmplitudeAndFrequencyOfASteadyVibration) {
  using Complex = std::complex<double>;
  const double m = 2, k = 50, c = 0.7, w = 3, a = 4, phi = 0.4, t0 = 5.2, t1 = 6.9;
  const auto motion = [&](double amplitude, double omega, double t, int rate) {
    const Complex response =
        Complex(0, -amplitude) * std::polar(1.0, phi) / Complex(k - m * omega * omega, c * omega);
    return (response * std::pow(Complex(0, omega), rate) * std::polar(1.0, omega * t)).real();
  };
  const auto state = [&](double amplitude, double omega, double t) {
    return vector_of({motion(amplitude, omega, t, 0), motion(amplitude, omega, t, 1)});
  };
  const auto derivative = [&](double t, bool frequency) {
    const double h = 1e-4;
    const auto at = [&](double by) {
      return frequency ? state(a, w + by, t) : state(a + by, w, t);
    };
    return Vector((8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h));
  };
  for (const bool frequency : {false, true}) {
    const Family family{.make =
                            [&](double value) {
                              return Parts{pushed_mass(
                                  m, k, c, force_of(frequency ? a : value, frequency ? value : w))};
                            },
                        .value = frequency ? w : a,
                        .start = {.time = t0, .physical = state(a, w, t0)},
                        .end = t1};
    const LinearisedMotion linear = family.linearised();
    EXPECT_LT((linear.end.physical - state(a, w, t1)).norm(), 1e-12);
    const Vector expected = derivative(t1, frequency) - linear.by_state * derivative(t0, frequency);
    EXPECT_LT((linear.by_key.col(0) - expected).norm(), 1e-10 * expected.norm()) << frequency;
  }
}

// A frequency long after t = 0, where differences at a fixed time would see another phase
// altogether.
TEST(KeyDerivativesTest, FrequencyAfterThousandsOfPeriods) {
  const double w = 3, t0 = 5000, h = 0.01;
  const Family free{
      .make = [&](double omega) { return Parts{pushed_mass(1, 0, 0, force_of(2, omega))}; },
      .value = w,
      .start = {.time = t0, .physical = vector_of({0.1, 0.2})},
      .end = t0 + h};
  // v' = a sin(w t + phi) / m: dv/dw = a int t cos(w t + phi) dt
  const auto integral = [&](double t) {
    return 2 * (t * std::sin(w * t + 0.4) / w + std::cos(w * t + 0.4) / (w * w));
  };
  const double expected = integral(t0 + h) - integral(t0);
  EXPECT_NEAR(free.linearised().by_key(1, 0) / expected, 1, 1e-9);
}

// A mass that comes with speed v onto a stop: where it begins half a period of contact later it
// stands at the clearance with -v, so that a larger clearance c delays it by dc/v, twice.
TEST(KeyDerivativesTest, ClearanceOfALinearStop) {
  const double m = 2, stiffness = 800, v = 0.7;
  const Family family{
      .make =
          [&](double clearance) {
            Parts parts{Model({single_mass("block", m, 0, 0)})};
            parts.contacts =
                ContactSet({contact_along_x(parts.model, "block.head", "", clearance,
                                            std::make_shared<contact::LinearPenalty>(stiffness))});
            return parts;
          },
      .value = 0.03,
      .start = {.time = 0, .physical = vector_of({-0.01, v})},
      .end = 0.5};
  const LinearisedMotion motion = family.linearised();
  // x = c - v (t - t2), t2 = (c + 0.01)/v + pi sqrt(m/k)
  EXPECT_NEAR(motion.by_key(0, 0), 2, 1e-11);
  EXPECT_NEAR(motion.by_key(1, 0), 0, 1e-11);
  EXPECT_EQ(motion.events, 2);
  EXPECT_NEAR(motion.determinant.value(), 1, 1e-12);
}

// A ball that falls from rest at height c: x after the impact is c - e v s + g s^2 / 2 in the time
// s since then, v = sqrt(2 g c); counted downwards.
TEST(KeyDerivativesTest, RestitutionAndClearanceOfABouncingBall) {
  const double g = 9.81, e = 0.7, c = 0.2, end = 0.35;
  const double v = std::sqrt(2 * g * c), fall = v / g, s = end - fall;
  for (const bool restitution : {false, true}) {
    const Family ball{
        .make =
            [&](double value) {
              Parts parts{Model({single_mass("ball", 1, 0, 0)})};
              add_weight(parts.model, g, {0});
              parts.contacts =
                  ContactSet({contact_along_x(parts.model, "ball.head", "", restitution ? c : value,
                                              newton(restitution ? value : e))});
              return parts;
            },
        .value = restitution ? e : c,
        .start = {.time = 0, .physical = vector_of({0, 0})},
        .end = end};
    const LinearisedMotion motion = ball.linearised();
    EXPECT_EQ(motion.events, 1);
    const double dv = g / v, ds = -dv / g;
    const Vector expected =
        restitution ? vector_of({-v * s, -v})
                    : vector_of({1 - e * dv * s - e * v * ds + g * s * ds, -e * dv + g * ds});
    EXPECT_LT((motion.by_key.col(0) - expected).norm(), 1e-10) << restitution;
    EXPECT_NEAR(motion.determinant.value(), e * e, 1e-12);
  }
}

// The end of a rectangular pulse is an instant that the key moves, and at which the force jumps.
TEST(KeyDerivativesTest, DurationOfAPulse) {
  const double m = 2, force = 3, end = 1;
  const Family family{
      .make =
          [&](double duration) {
            return Parts{pushed_mass(
                m, 0, 0,
                make_pulse(Given::displacement, PulseShape::rectangular, force, 0.1, duration))};
          },
      .value = 0.4,
      .start = {.time = 0, .physical = vector_of({0, 0})},
      .end = end};
  // v = F d / m, x = F d / m (end - 0.1 - d / 2)
  const LinearisedMotion motion = family.linearised();
  EXPECT_NEAR(motion.by_key(1, 0), force / m, 1e-10);
  EXPECT_NEAR(motion.by_key(0, 0), force / m * (end - 0.1 - 0.4), 1e-10);
}

Parts bumpers(double stiffness, double clearance) {
  Parts parts{Model({single_mass("block", 1, 40, 0.5)})};
  parts.model.add_base_motion("shake", force_of(0.05, 7), {0}, Vector3::UnitX());
  parts.contacts =
      ContactSet({stop_on_base(parts.model, "block.head", clearance,
                               std::make_shared<contact::KelvinVoigtBumper>(stiffness, 9))});
  return parts;
}

TEST(KeyDerivativesTest, StiffnessAndClearanceOfABumperWithItsOwnState) {
  const MotionState start{.time = 0.3, .physical = vector_of({-0.1, 0.5, 0})};
  Family{.make = [](double k) { return bumpers(k, 0.03); }, .value = 300, .start = start, .end = 3}
      .agrees_with_differences(6);
  Family{.make = [](double c) { return bumpers(300, c); }, .value = 0.03, .start = start, .end = 3}
      .agrees_with_differences(6);
}

TEST(KeyDerivativesTest, ForceOfATableThatCrushes) {
  const auto crushed = [](double force) {
    Parts parts{Model({single_mass("block", 1, 40, 0.5)})};
    parts.model.add_base_motion("shake", force_of(0.05, 7), {0}, Vector3::UnitX());
    const contact::CrushCurves curves({{0, 0.01, 0.1}, {0, force, 3 * force}}, {}, 2000);
    parts.contacts = ContactSet({stop_on_base(parts.model, "block.head", 0.03,
                                              std::make_shared<contact::CrushableTable>(curves))});
    return parts;
  };
  const MotionState start{.time = 0.3, .physical = vector_of({-0.1, 0.5, 0})};
  Family{.make = crushed, .value = 8, .start = start, .end = 3}.agrees_with_differences(6);
}

// The force begins with a jump, on a stop that stands still while the base moves.
TEST(KeyDerivativesTest, FrequencyOfAMovingBaseThroughImpacts) {
  for (const bool rigid : {false, true}) {
    std::shared_ptr<const contact::ContactLaw> law = newton(0.8);
    if (!rigid)
      law = std::make_shared<contact::KelvinVoigt>(800, 6);
    Family{.make =
               [&](double omega) {
                 Parts parts{Model({single_mass("block", 1, 40, 0.5)})};
                 parts.model.add_base_motion(
                     "shake", std::make_shared<Harmonic>(Given::acceleration, 3, omega, 0.3), {0},
                     Vector3::UnitX());
                 parts.contacts =
                     ContactSet({contact_along_x(parts.model, "block.head", "", 0.03, law)});
                 return parts;
               },
           .value = 7,
           .start = {.time = 0.3, .physical = vector_of({-0.1, 0.5})},
           .end = 2.5}
        .agrees_with_differences(4);
  }
}

// A nonlinear stop on a base that moves by the key: gap, gap rate and loads change with it, also
// where the gap vanishes and the slope of the force has no bound.
TEST(KeyDerivativesTest, AmplitudeOfAMovingBaseThroughNonlinearContacts) {
  const contact::HertzConstants hertz{.stiffness = 2e4, .exponent = 1.5};
  for (const std::shared_ptr<const contact::ContactLaw> &law :
       {std::shared_ptr<const contact::ContactLaw>(
            contact::HuntCrossley::with_dissipation(hertz, 0.8)),
        std::shared_ptr<const contact::ContactLaw>(std::make_shared<contact::Tsuji>(2e4, 30))}) {
    SCOPED_TRACE(law->name());
    Family{.make =
               [&](double amplitude) {
                 Parts parts{Model({single_mass("block", 1, 40, 0.5)})};
                 parts.model.add_base_motion("shake", force_of(amplitude, 7), {0},
                                             Vector3::UnitX());
                 parts.contacts =
                     ContactSet({contact_along_x(parts.model, "block.head", "", 0.03, law)});
                 return parts;
               },
           .value = 0.05,
           .start = {.time = 0.3, .physical = vector_of({-0.1, 0.5})},
           .end = 1.2}
        .agrees_with_differences(2, 1e-7);
  }
}

// The same force moves another mass otherwise, in contact too.
TEST(KeyDerivativesTest, MassUnderAForceOnANonlinearStop) {
  Family{.make =
             [](double mass) {
               Parts parts{pushed_mass(mass, 40, 0.5, force_of(60, 7))};
               parts.contacts =
                   ContactSet({contact_along_x(parts.model, "block.head", "", 0.03,
                                               contact::HuntCrossley::with_dissipation(
                                                   {.stiffness = 2e3, .exponent = 1.5}, 0.8))});
               return parts;
             },
         .value = 1,
         .start = {.time = 0.3, .physical = vector_of({-0.1, 0.5})},
         .end = 1.2}
      .agrees_with_differences(2, 1e-7);
}

// The mass of a ball that lies on a rigid table changes nothing; what rounding leaves of that is no
// derivative that could be followed through the contact of the other body.
TEST(KeyDerivativesTest, MassOfABodyAtRestBesideAMovingOne) {
  const Family family{
      .make =
          [](double mass) {
            Parts parts{
                Model({single_mass("ball", mass, 3.7, 0.3), single_mass("block", 1, 40, 0.1)})};
            add_weight(parts.model, 9.81, {0});
            parts.model.add_base_motion("shake", force_of(0.05, 7), {0, 1}, Vector3::UnitX());
            parts.contacts =
                ContactSet({stop_on_base(parts.model, "ball.head", 0.013, newton(0.5)),
                            contact_along_x(parts.model, "block.head", "", 0.03,
                                            contact::HuntCrossley::with_dissipation(
                                                {.stiffness = 2e3, .exponent = 1.5}, 0.8))});
            return parts;
          },
      .value = 0.7,
      .start = {.time = 0.3, .physical = vector_of({0.013, -0.1, 0, 0.5})},
      .end = 1.2};
  const LinearisedMotion motion = family.linearised();
  EXPECT_GE(motion.events, 2);
  EXPECT_LT(motion.by_key.cwiseAbs().maxCoeff(), 1e-12);
}

// At rest on a table that a key lifts the body follows it.
TEST(KeyDerivativesTest, ClearanceOfABodyAtRest) {
  const Family family{
      .make =
          [](double clearance) {
            Parts parts{Model({single_mass("ball", 1, 0, 0)})};
            add_weight(parts.model, 9.81, {0});
            parts.contacts =
                ContactSet({contact_along_x(parts.model, "ball.head", "", clearance, newton(0.5))});
            return parts;
          },
      .value = 0.02,
      .start = {.time = 0, .physical = vector_of({0.02, 0})},
      .end = 0.5};
  const LinearisedMotion motion = family.linearised();
  EXPECT_NEAR(motion.by_key(0, 0), 1, 1e-12);
  EXPECT_NEAR(motion.by_key(1, 0), 0, 1e-12);
  EXPECT_LT(motion.by_state.cwiseAbs().maxCoeff(), 1e-12);
}

// In contact the compression of the stop follows the gap and has no deviation of its own.
TEST(KeyDerivativesTest, InternalStateThatFollowsTheGapIsProjected) {
  const Family family{.make = [](double k) { return bumpers(k, 0.03); },
                      .value = 300,
                      .start = {.time = 0.3, .physical = vector_of({0.05, 0.5, 0.02})},
                      .end = 0.302};
  const LinearisedMotion motion = family.linearised();
  EXPECT_LT(motion.by_state.col(2).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_NEAR(motion.by_state(2, 0), motion.by_state(0, 0), 1e-12);
}

// At rest on a spring, k x + k3 x^3 = f: the derivative of the coordinate by k3 is a free
// vibration, y'' + (k + 3 k3 x^2) y = -x^3 / m. The force x^3 by which the key acts is 1e-10 of
// those that balance each other; differences of these would leave seven of its digits to rounding.
TEST(KeyDerivativesTest, KeyThatActsByLittleBesideLargeForces) {
  const double m = 2, k = 1e4, x = 1e-3, k3 = 3;
  const double force = k * x + k3 * x * x * x;
  const Family rest{
      .make =
          [&](double cubic) {
            Model model({single_mass("block", m, k, 0)});
            model.add_force("push", make_constant(Given::displacement, force),
                            {.body = 0, .point = 0}, Vector3::UnitX());
            model.add_connection(
                {.name = "spring",
                 .side_a = "block.head",
                 .side_b = "base",
                 .elongation = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false),
                 .cubic_stiffness = cubic});
            return Parts{.model = std::move(model), .contacts = {}};
          },
      .value = k3,
      .start = {.time = 0, .physical = vector_of({x, 0})},
      .end = 0.3};
  const double omega = std::sqrt((k + 3 * k3 * x * x) / m);
  const double amplitude = -x * x * x / (m * omega * omega);
  const Vector exact = vector_of({amplitude * (1 - std::cos(omega * rest.end)),
                                  amplitude * omega * std::sin(omega * rest.end)});
  EXPECT_LT((rest.linearised().by_key.col(0) - exact).norm(), 1e-9 * exact.norm());
}

// A block on a belt that breaks away twice, and a driven one that stops at every turn; with more
// friction at rest the force jumps where the sides begin to slip.
TEST(KeyDerivativesTest, FrictionThatSticksAndBreaksAway) {
  struct Rubbing {
    double stiffness = 1, force = 0, normal = 1, mu = 0.5, mu_s = 1, belt = 0.2;
  };
  const auto family = [](double Rubbing::*key, Rubbing rubbing, double v, double end) {
    const auto make = [key, rubbing](double value) mutable {
      rubbing.*key = value;
      Model model = pushed_mass(1, rubbing.stiffness, 0.05, force_of(rubbing.force, 0.6));
      ContactSet contacts({testing::sliding_along_x(
          model, "block.head", "", testing::coulomb(rubbing.normal, rubbing.mu, rubbing.mu_s),
          rubbing.belt)});
      return Parts{std::move(model), std::move(contacts)};
    };
    return Family{.make = make,
                  .value = rubbing.*key,
                  .start = {.time = 0, .physical = vector_of({0.3, v})},
                  .end = end};
  };
  for (double Rubbing::*key :
       {&Rubbing::stiffness, &Rubbing::normal, &Rubbing::mu, &Rubbing::mu_s, &Rubbing::belt})
    for (const double end : {11.0, 16.5}) // in stick, in slip
      family(key, {}, 0.5, end).agrees_with_differences(3);
  // When it begins to slip depends on the force that holds it.
  family(&Rubbing::force, {.force = 0.1}, 0.5, 16.5).agrees_with_differences(3);
  for (double Rubbing::*key :
       {&Rubbing::stiffness, &Rubbing::normal, &Rubbing::mu, &Rubbing::mu_s, &Rubbing::force})
    family(key, {.force = 1, .normal = 0.6, .mu = 0.8, .belt = 0}, 0.5, 23)
        .agrees_with_differences(6);
}

TEST(KeyDerivativesTest, KeysThatChangeTheModelItselfAreRefused) {
  const auto family = [](std::function<double(double)> mass) {
    return Family{
        .make = [mass](double p) { return Parts{Model({single_mass("a", mass(p), 4, 0)})}; },
        .value = 1,
        .start = {.time = 0, .physical = vector_of({0.1, 0})}};
  };
  EXPECT_NO_THROW(family([](double p) { return p; }).linearised());
  EXPECT_THROW(family([](double p) { return p > 1 ? 2.0 : 1.0; }).linearised(), NumericalError);
  const Family more{
      .make =
          [](double p) {
            return p > 1 ? Parts{Model({single_mass("a", 1, 4, 0), single_mass("b", 1, 4, 0)})}
                         : Parts{Model({single_mass("a", 1, 4, 0)})};
          },
      .value = 1,
      .start = {.time = 0, .physical = vector_of({0.1, 0})}};
  EXPECT_THROW(more.linearised(), NumericalError);
}

} // namespace key_derivatives_tests
} // namespace vibroimpact::motion
