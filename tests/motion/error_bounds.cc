// Bounds and estimates of errors against the errors they stand for.
#include "contact/laws/linear_penalty.h"
#include "motion/path/exact_stepper.h"
#include "motion/path/trajectory.h"
#include "motion/steps/error_measure.h"
#include "motion/steps/high_order_stepper.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::motion {
namespace error_bounds_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The gap 1 - sin(w t) / w, of which the sixth derivative is w^5 sin(w t): it begins at zero, and a
// bound must hold up to the end of each interval. Once as a pair, once as a dense block.
TEST(ErrorBoundsTest, SixthDerivativesOfGuards) {
  for (const double omega : {3.0, 0.0}) {
    const Model model({single_mass("block", 1, omega * omega, 0)});
    const ContactSet contacts(
        {contact_along_x(model, "block.head", "", 1, std::make_shared<LinearPenalty>(1e3))});
    const Equations equations(model, contacts);
    ExactStepper stepper(equations, Settings{});
    Vector x = Vector::Zero(equations.layout().size());
    x[1] = 1;
    ASSERT_TRUE(stepper.handles(0));
    stepper.restart(0, x);
    stepper.step(0.3);
    const GuardCurves &curves = *stepper.guard_curves();
    const double end = stepper.time();
    for (const double from : {0.0, 0.25, 0.5, 0.9})
      for (const double to : {from + 0.01, from + 0.1}) {
        const double largest = std::pow(omega, 5) * std::sin(omega * to * end);
        const double bound = curves.sixth_derivative(0, from * end, to * end);
        EXPECT_GE(bound, largest * (1 - 1e-12)) << from << " to " << to;
        EXPECT_LE(bound, 2 * std::pow(omega, 5)) << from << " to " << to;
      }
    EXPECT_NEAR(curves.at(0, end).value, omega > 0 ? 1 - std::sin(omega * end) / omega : 1 - end,
                1e-15);
  }
}

// 64 eps times the sizes of all terms of a gap: clearance, displacement, and that of the base.
TEST(ErrorBoundsTest, RoundingOfAnIndicatorCountsEveryTerm) {
  Model model({single_mass("block", 1, 100, 0)});
  model.add_base_motion(
      "floor", std::make_shared<Harmonic>(Given::displacement, 0.3, 5, std::numbers::pi / 2), {0},
      Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0.25, std::make_shared<LinearPenalty>(1e3))});
  const Equations equations(model, contacts);
  Vector x = Vector::Zero(equations.layout().size());
  constexpr double unit = 64 * std::numeric_limits<double>::epsilon();
  const auto rounding = [&](const AffineForm &form, double time) {
    return equations.rounding(0, form, time, x) / unit;
  };
  EXPECT_NEAR(rounding({.gap = 1}, 0), 0.25 + 0.3, 1e-12);
  EXPECT_NEAR(rounding({.constant = -2, .gap = -1}, 0), 2 + 0.25 + 0.3, 1e-12);
  EXPECT_NEAR(rounding({.gap_rate = 3}, 0.1), 3 * 0.3 * 5 * std::sin(0.5), 1e-12);
  x[0] = -0.5;
  x[1] = 0.125;
  EXPECT_NEAR(rounding({.gap = 2, .gap_rate = 4}, 0), 2 * (0.25 + 0.3 + 0.5) + 4 * 0.125, 1e-12);
}

// A linear oscillator whose third derivative is known: what limits the steps of order 8 falls with
// the eighth power of their length, so that a million times the accuracy takes 10^(6/8) = 5.6 times
// the steps.
class Oscillator {
public:
  Oscillator() : model_({single_mass("mass", 1, 1, 0)}), equations_(model_, none_) {
    equations_.set_source_break(infinity);
  }
  HighOrderStepper stepper(double tolerance) const {
    Settings settings;
    settings.relative_tolerance = tolerance;
    settings.absolute_tolerance = 1e-3 * tolerance;
    HighOrderStepper stepper(equations_, settings);
    Vector x = Vector::Zero(equations_.layout().size());
    x[0] = 1;
    stepper.restart(0, x);
    return stepper;
  }

private:
  Model model_;
  ContactSet none_;
  Equations equations_;
};

TEST(ErrorBoundsTest, StepsOfOrderEight) {
  const Oscillator oscillator;
  const auto steps = [&](double tolerance) {
    HighOrderStepper stepper = oscillator.stepper(tolerance);
    long count = 0;
    for (; stepper.time() < 40; ++count)
      stepper.step(40);
    return static_cast<double>(count);
  };
  EXPECT_LT(steps(1e-12) / steps(1e-6), 1.3 * std::pow(10, 6.0 / 8));
}

// The end of a step that is moved by little is as good as another step: cos t.
TEST(ErrorBoundsTest, EndsThatAreMovedStayOnTheMotion) {
  const Oscillator oscillator;
  for (const double part : {-9e-6, -1e-6, 1e-6, 9e-6}) {
    HighOrderStepper stepper = oscillator.stepper(1e-14);
    stepper.step(1e-3);
    stepper.step(0.3); // begins at 1e-3
    const double end = stepper.time() + part * (stepper.time() - stepper.previous_time());
    stepper.shorten(end);
    ASSERT_EQ(stepper.time(), end);
    EXPECT_NEAR(stepper.state()[0], std::cos(end), 1e-15) << part;
    EXPECT_NEAR(stepper.state()[1], -std::sin(end), 1e-15) << part;
  }
}

// However slowly a block comes to a stop, the instant is known better than the tolerance, or as
// well as rounding lets it be, which counts as known.
TEST(ErrorBoundsTest, UncertaintyOfSlowContacts) {
  const Model model({single_mass("block", 1, 0, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 1e-3, std::make_shared<LinearPenalty>(1e3))});
  Trajectory trajectory(model, contacts, Settings{});
  for (double speed = 1e-2; speed > 1e-9; speed /= 3) {
    trajectory.start(0, Vector::Constant(1, 1e-3 - 0.37 * speed), Vector::Constant(1, speed));
    trajectory.advance(1); // half a period of the contact is 0.1 s
    EXPECT_EQ(trajectory.accuracy().events, 2) << speed;
    EXPECT_LE(trajectory.accuracy().event_residual, 1e-12) << speed;
  }
}

// What a step's errors are measured against, at a state that does not move.
class Measured {
public:
  Measured(const Equations &equations, double tolerance)
      : equations_(equations), measure_(equations, tolerance, 0) {
    start_.state = Vector::Zero(equations.layout().size());
  }
  /// Begins there, with its rates.
  void begin() {
    start_.rates.resize(start_.state.size());
    equations_.rates(0, ConstVectorView(start_.state.data(), start_.state.size()),
                     VectorView(start_.rates.data(), start_.rates.size()));
    measure_.begin(start_);
  }
  /// An error of one entry over its tolerance, in a step that adds `work`.
  double of_step(Index entry, double error, double work = 0) {
    const StateLayout &layout = equations_.layout();
    EndPoint end = start_;
    end.time = 1e-9;
    end.state[layout.input_work()] = end.state[layout.absolute_input_work()] = work;
    measure_.set_step(start_, end);
    return measure_.of_step(error * Vector::Unit(start_.state.size(), entry));
  }
  Vector &state() { return start_.state; }

private:
  const Equations &equations_;
  ErrorMeasure measure_;
  EndPoint start_;
};

// Where a force works against a damper alone no energy shows what is turned over: the error of the
// work is measured against the work of the step itself.
TEST(ErrorBoundsTest, ErrorsOfWorkAreRelativeToTheWorkOfTheStep) {
  constexpr double tolerance = 1e-6, work = 3;
  const Model model({single_mass("mass", 1, 0, 0)});
  const ContactSet none;
  const Equations equations(model, none);
  Measured measured(equations, tolerance);
  measured.begin();
  EXPECT_NEAR(measured.of_step(equations.layout().input_work(), tolerance * work, work), 1, 1e-6);
}

// Two masses of one body on a contact of the first, at its deepest penetration: its energy is that
// of the body, a thousandth of the speed that this could give the second mass being what the error
// of its speed is measured against.
TEST(ErrorBoundsTest, AContactHoldsEnergyOfItsBody) {
  constexpr double tolerance = 1e-6, mass = 2, stiffness = 1e3, penetration = 0.1;
  auto body = std::make_shared<reduction::ReducedBody>(*single_mass("body", mass, 0, 0));
  body->mass = Vector::Constant(2, mass);
  body->stiffness = Vector::Zero(2);
  body->damping = Matrix::Zero(2, 2);
  body->base_participation = Matrix::Zero(2, 3);
  body->points[0].rows = Matrix::Zero(6, 2);
  body->points[0].rows(0, 0) = 1;
  const Model model({body});
  const ContactSet contacts(
      {contact_along_x(model, "body.head", "", 0, std::make_shared<LinearPenalty>(stiffness))});
  Equations equations(model, contacts);
  equations.set_mode(0, 1);
  Measured measured(equations, tolerance);
  measured.state()[0] = penetration;
  measured.begin();
  const double energy = stiffness * penetration * penetration / 2;
  const double error = tolerance * 1e-3 * std::sqrt(2 * energy / mass);
  EXPECT_NEAR(measured.of_step(equations.layout().velocity() + 1, error), 1, 1e-3);
}

// Without a tolerance the impulse of a contact is as good as the rounding of the momentum
// sqrt(2 m E) that the motion's energy gives its mass.
TEST(ErrorBoundsTest, RoundingOfAnImpulse) {
  constexpr double stiffness = 1e3, penetration = 0.1;
  for (const double mass : {1e-6, 1.0, 1e6}) {
    const Model model({single_mass("mass", mass, 0, 0)});
    const ContactSet contacts(
        {contact_along_x(model, "mass.head", "", 0, std::make_shared<LinearPenalty>(stiffness))});
    Equations equations(model, contacts);
    equations.set_mode(0, 1);
    Measured measured(equations, 0);
    measured.state()[0] = penetration;
    measured.begin();
    const double momentum = std::sqrt(mass * stiffness) * penetration;
    const double error = 16 * std::numeric_limits<double>::epsilon() * momentum;
    EXPECT_NEAR(measured.of_step(equations.layout().impulse(0), error), 1, 0.1) << mass;
  }
}

} // namespace error_bounds_tests
} // namespace vibroimpact::motion
