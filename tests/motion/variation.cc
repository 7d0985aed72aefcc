// The variational equation: closed forms without contact, finite differences of the flow through
// impacts with and without jumps of the force, resets and moving bases.
#include "common/decompositions.h"
#include "motion/variation/linearised_motion.h"

#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/tsuji.h"
#include "model/piecewise_function.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"
#include "support/motion_derivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace variation_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

constexpr double tolerance = 1e-11;

class Nothing : public Observer {};

// Counts contact changes beside the variation.
class Counter : public Observer {
public:
  void event(const ContactEvent & /*event*/) override { ++events; }
  int events = 0;
};

// A dashpot and a spring that begin and end with the overlap: the force jumps at both ends.
class DampedStop : public ContactLaw {
public:
  DampedStop(double stiffness, double damping)
      : ContactLaw(open_and_contact(AffineLaw{.force = {.gap = -stiffness, .gap_rate = -damping}}),
                   {}),
        stiffness_(stiffness), damping_(damping) {}
  std::string name() const override { return "damped stop"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override {
    const double on = mode == 1 ? 1 : 0;
    response.force = -on * (stiffness_ * state.gap + damping_ * state.gap_rate);
    response.force_by_gap = -on * stiffness_;
    response.force_by_gap_rate = -on * damping_;
    response.stored_energy = on * 0.5 * stiffness_ * state.gap * state.gap;
    response.dissipated_power = on * damping_ * state.gap_rate * state.gap_rate;
  }

private:
  double stiffness_, damping_;
};

struct Case {
  Model model;
  ContactSet contacts{};
  MotionState start{};
  double end = 1;
  int events = 0; ///< seen on the reference motion
  double relative_tolerance = tolerance;
  double variation_tolerance = 1e-10;
  double maximum_step = 0; ///< none

  Settings settings() const {
    return {.relative_tolerance = relative_tolerance,
            .absolute_tolerance = 1e-13,
            .event_tolerance = 1e-13,
            .maximum_step = maximum_step};
  }
  Vector flow(const Vector &physical) const {
    Trajectory trajectory(model, contacts, settings());
    trajectory.start({.time = start.time, .physical = physical});
    Nothing nothing;
    trajectory.advance(end, nothing);
    return trajectory.motion_state().physical;
  }
  Matrix by_variation() {
    Trajectory trajectory(model, contacts, settings());
    trajectory.start(start);
    const Index size = trajectory.layout().physical_size();
    Variation variation(trajectory, Vector::Ones(size), variation_tolerance);
    variation.set_columns(Matrix::Identity(size, size));
    Counter counter;
    Observers observers({&variation, &counter});
    trajectory.advance(end, observers);
    EXPECT_EQ(variation.tangential_events(), 0);
    events = counter.events;
    return variation.columns();
  }
  // Central differences, the error of order epsilon^2 taken out by a second one.
  Matrix by_differences(double epsilon) const {
    const Index size = start.physical.size();
    Matrix columns(size, size);
    for (Index j = 0; j < size; ++j) {
      const auto difference = [&](double e) -> Vector {
        return (flow(start.physical + e * Vector::Unit(size, j)) -
                flow(start.physical - e * Vector::Unit(size, j))) /
               (2 * e);
      };
      columns.col(j) = (4 * difference(epsilon / 2) - difference(epsilon)) / 3;
    }
    return columns;
  }
};

Vector state_of(std::initializer_list<double> values) {
  Vector state(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), state.begin());
  return state;
}

double relative_difference(const Matrix &a, const Matrix &b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

std::shared_ptr<const TimeFunction> sine(Given given, double amplitude, double omega) {
  return std::make_shared<Harmonic>(given, amplitude, omega, 0.3);
}

TEST(VariationTest, DampedOscillatorHasItsExponential) {
  const double omega = 3, zeta = 0.2;
  Case free{.model = Model({single_mass("block", 2, 2 * omega * omega, 4 * zeta * omega)}),
            .start = {.time = 0.5, .physical = state_of({0.3, -0.2})},
            .end = 2.0};
  const double t = free.end - free.start.time;
  const double damped = omega * std::sqrt(1 - zeta * zeta);
  const double decay = std::exp(-zeta * omega * t);
  const double c = std::cos(damped * t), s = std::sin(damped * t);
  Matrix exact(2, 2);
  exact << c + zeta * omega / damped * s, s / damped, -omega * omega / damped * s,
      c - zeta * omega / damped * s;
  exact *= decay;
  EXPECT_LT(relative_difference(free.by_variation(), exact), 1e-9);
}

// The force is continuous, so the variation is too; only the stiffness changes.
TEST(VariationTest, BilinearOscillatorThroughManyImpacts) {
  Case bilinear{.model = Model({single_mass("block", 1, 40, 0.1)}), .end = 6};
  bilinear.contacts = ContactSet({contact_along_x(bilinear.model, "block.head", "", 0.05,
                                                  std::make_shared<LinearPenalty>(2000))});
  bilinear.start.physical = state_of({-0.2, 0.4});
  const Matrix columns = bilinear.by_variation();
  EXPECT_GE(bilinear.events, 8);
  EXPECT_LT(relative_difference(columns, bilinear.by_differences(1e-4)), 1e-6);
}

TEST(VariationTest, JumpOfTheForceOnAMovingBase) {
  Case stop{.model = Model({single_mass("block", 1, 40, 0.5)}), .end = 4};
  stop.model.add_base_motion("shake", sine(Given::displacement, 0.05, 7), {0}, Vector3::UnitX());
  stop.contacts = ContactSet(
      {contact_along_x(stop.model, "block.head", "", 0.03, std::make_shared<DampedStop>(500, 12))});
  stop.start.physical = state_of({-0.1, 0.3});
  const Matrix columns = stop.by_variation();
  EXPECT_GE(stop.events, 6);
  EXPECT_LT(relative_difference(columns, stop.by_differences(1e-5)), 1e-6);
}

// This Hunt-Crossley contact keeps the approach speed as a state, reset where contact begins. Its
// stiffness begins with a root of the penetration: there the rates of the variation depend on time
// almost alone, and a method whose error estimate overlooks that is off by 1e-4.
TEST(VariationTest, ResetOfAnInternalState) {
  Case impact{.model = Model({single_mass("a", 1, 40, 0.5), single_mass("b", 2, 10, 0.1)}),
              .end = 3};
  impact.model.add_base_motion("shake", sine(Given::acceleration, 2, 9), {0}, Vector3::UnitX());
  impact.contacts = ContactSet({contact_along_x(
      impact.model, "a.head", "b.head", 0.02,
      HuntCrossley::with_dimensionless_damping({.stiffness = 2e4, .exponent = 1.5}, 0.4, 1e-9))});
  const Vector internal = impact.contacts.initial_internal();
  impact.start.physical.resize(4 + internal.size());
  impact.start.physical << state_of({-0.1, 0.05, 0.8, -0.2}), internal;
  EXPECT_GE(internal.size(), 1);
  const auto difference = [&impact](double tolerance) {
    impact.relative_tolerance = tolerance;
    return relative_difference(impact.by_variation(), impact.by_differences(1e-5));
  };
  EXPECT_LT(difference(1e-9), 1e-7);
  EXPECT_LT(difference(1e-12), 1e-7);
  EXPECT_GE(impact.events, 4);
}

// Where these contacts begin and end the slope of the force is infinite, u^(-1/2) and u^(-3/4).
// Short steps keep the error of the motion itself, which differences see, below 1e-8: with its own
// steps it is 8e-8 for Kuwabara and Kono.
TEST(VariationTest, SlopesThatAreInfiniteWhereContactBegins) {
  const std::vector<std::shared_ptr<const contact::ContactLaw>> laws = {
      std::make_shared<contact::KuwabaraKono>(1e5, 1e-3),
      std::make_shared<contact::Tsuji>(1e5, 40)};
  for (const auto &law : laws) {
    Case impact{.model = Model({single_mass("block", 1, 40, 0.1)}),
                .end = 0.8,
                .relative_tolerance = 1e-12,
                .variation_tolerance = 1e-12,
                .maximum_step = 1e-3};
    impact.contacts = ContactSet({contact_along_x(impact.model, "block.head", "", 0.03, law)});
    impact.start.physical = state_of({-0.1, 0.3});
    const Matrix columns = impact.by_variation();
    EXPECT_GE(impact.events, 2);
    for (Index j = 0; j < 2; ++j) {
      const testing::NumericalDerivative differences = testing::numerical_derivative(
          [&](double by) {
            return std::optional<Vector>(
                impact.flow(impact.start.physical + by * Vector::Unit(2, j)));
          },
          1e-2);
      EXPECT_LT(differences.error, 1e-8) << law->name();
      EXPECT_LT((columns.col(j) - differences.value).norm(), 2e-8 * differences.value.norm())
          << law->name();
    }
  }
}

// A prestressed Tsuji stop ends contact where the gap is some 1e-18 m, of either sign: more than
// its own rounding, but no more than that of the instant, 1e-16 s, times its rate. Seen as still
// open, the slope u^(-3/4) at the end is integrated into, and no step is found.
TEST(VariationTest, EndOfContactAtTheRoundingOfTheInstant) {
  const double stiffness = 592021, damping = 0.355 * std::sqrt(5.383 * stiffness);
  Case thrown{.model = Model({single_mass("block", 1.146, 0, 0)}),
              .relative_tolerance = 1e-12,
              .variation_tolerance = 1e-12};
  thrown.model.add_force("weight", make_constant(Given::displacement, -1.146 * 9.81),
                         {.body = 0, .point = 0}, Vector3::UnitX());
  thrown.model.add_force("push", std::make_shared<Harmonic>(Given::displacement, 19.8, 18.45, 0),
                         {.body = 0, .point = 0}, Vector3::UnitX());
  ContactPair stop = contact_along_x(thrown.model, "block.head", "", -3.536e-5,
                                     std::make_shared<Tsuji>(stiffness, damping));
  stop.gap.row *= -1;
  thrown.contacts = ContactSet({stop});
  thrown.end = 0.7;
  for (int i = 0; i < 40; ++i) {
    thrown.start = {.time = 0.613, .physical = state_of({-0.00525, 0.49 + 1e-4 * i})};
    Trajectory trajectory(thrown.model, thrown.contacts, thrown.settings());
    LinearisedMotion motion;
    Lineariser linearise(trajectory, {.scale = Vector::Ones(2), .tolerance = 1e-12});
    ASSERT_NO_THROW(motion = linearise(thrown.start, thrown.end)) << i;
    EXPECT_GE(motion.events, 2);
    EXPECT_NEAR(determinant(motion.by_state) / motion.determinant.value(), 1, 1e-9) << i;
  }
}

// A contact is found to begin up to 1e-12 s late, where a force with a fourth root of the
// penetration has 1e-4 of its size already: what deviations do in between belongs to the part
// behind the event.
TEST(VariationTest, BeginOfContactAsCloseAsEventsAreLocated) {
  for (int i = 0; i < 20; ++i) {
    Case impact{.model = Model({single_mass("block", 1, 40, 0.1)}), .end = 0.45};
    impact.contacts = ContactSet(
        {contact_along_x(impact.model, "block.head", "", 0.03, std::make_shared<Tsuji>(2e3, 5))});
    const MotionState start{.time = 0, .physical = state_of({-0.1, 0.3 + 0.01 * i})};
    Matrix columns[2];
    for (const bool closely : {true, false}) {
      const Settings settings{.method = closely ? "exact" : "rk",
                              .relative_tolerance = closely ? 1e-13 : 1e-11,
                              .event_tolerance = closely ? 1e-15 : 1e-12};
      Trajectory trajectory(impact.model, impact.contacts, settings);
      Lineariser linearise(trajectory, {.scale = Vector::Ones(2), .tolerance = 1e-12});
      const LinearisedMotion motion = linearise(start, impact.end);
      EXPECT_GE(motion.events, 1);
      columns[closely ? 0 : 1] = motion.by_state;
    }
    EXPECT_LT(relative_difference(columns[1], columns[0]), 1e-8) << i;
  }
}

// It begins where a stop with a dashpot begins: further out it meets the force later, and
// deviations into the stop meet it at once as the motion itself does. The variation is that of the
// former.
TEST(VariationTest, StartAtTheFirstTouch) {
  Case touching{.model = Model({single_mass("block", 1, 40, 0.5)}), .end = 0.05};
  touching.contacts = ContactSet({contact_along_x(touching.model, "block.head", "", 0.03,
                                                  std::make_shared<DampedStop>(500, 12))});
  touching.start.physical = state_of({0.03, 0.3});
  const Vector column = touching.by_variation().col(0);
  EXPECT_EQ(touching.events, 1);
  const auto one_sided = [&](double e) -> Vector {
    const Vector out = e * Vector::Unit(2, 0);
    return (4 * (touching.flow(touching.start.physical - out / 2) -
                 touching.flow(touching.start.physical)) -
            (touching.flow(touching.start.physical - out) -
             touching.flow(touching.start.physical))) /
           -e;
  };
  const double e = 1e-4;
  const Vector outside = (4 * one_sided(e / 2) - one_sided(e)) / 3; // errors of e^2 and of e^3
  EXPECT_LT((column - outside).norm(), 1e-6 * column.norm());
}

// Of a few steps the last is far shorter than those before and taken together with them again.
TEST(VariationTest, DeterminantAfterAShortPart) {
  const double damping = 3;
  Case hertz{.model = Model({single_mass("block", 1, 50, damping)}), .end = 0.11};
  hertz.contacts = ContactSet({contact_along_x(
      hertz.model, "block.head", "", 0.01,
      std::make_shared<Hertz>(HertzConstants{.stiffness = 1e4, .exponent = 1.5}))});
  hertz.start.physical = state_of({0.02, 0.4});
  Trajectory trajectory(hertz.model, hertz.contacts, hertz.settings());
  trajectory.start(hertz.start);
  Variation variation(trajectory, Vector::Ones(2), 1e-12);
  variation.set_columns(Matrix::Identity(2, 2));
  for (const double end : {0.03, 0.03 + 1e-6}) {
    trajectory.advance(end, variation);
    EXPECT_NEAR(variation.determinant().logarithm, -damping * end, 1e-10);
  }
}

// Three bodies touch their stops at one instant. The first force begins without a jump; of the
// other two, which do jump, deviating motions meet one after the other.
TEST(VariationTest, TwoJumpsBehindATouchWithoutOne) {
  Case three{.model = Model({single_mass("a", 1, 0, 0), single_mass("b", 1, 0, 0),
                             single_mass("c", 1, 0, 0)})};
  const auto stop = [&](const char *side, std::shared_ptr<const ContactLaw> law) {
    return contact_along_x(three.model, side, "", 0.1, std::move(law));
  };
  const auto damped = std::make_shared<DampedStop>(500, 12);
  three.contacts = ContactSet({stop("a.head", std::make_shared<LinearPenalty>(500)),
                               stop("b.head", damped), stop("c.head", damped)});
  Trajectory trajectory(three.model, three.contacts, three.settings());
  trajectory.start(0, Vector::Zero(3), Vector::Ones(3));
  Variation variation(trajectory, Vector::Ones(6), 1e-10);
  variation.set_columns(Matrix::Identity(6, 6));
  trajectory.advance(0.11, variation);
  EXPECT_EQ(variation.tangential_events(), 1);
}

// The product of the multipliers is exp(-c/m t) for any conservative contact (Liouville).
TEST(VariationTest, DeterminantOfHertzContact) {
  Case hertz{.model = Model({single_mass("block", 2, 50, 0.6)}), .end = 5};
  hertz.contacts = ContactSet({contact_along_x(
      hertz.model, "block.head", "", 0.01,
      std::make_shared<Hertz>(HertzConstants{.stiffness = 1e5, .exponent = 1.5}))});
  hertz.start.physical = state_of({-0.2, 0.0});
  EXPECT_NEAR(determinant(hertz.by_variation()) / std::exp(-0.3 * 5), 1, 1e-6);
  EXPECT_GE(hertz.events, 4);
}

} // namespace variation_tests
} // namespace vibroimpact::motion
