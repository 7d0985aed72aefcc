// Phases that are not linear: the method of order 8 against PETSc's Runge-Kutta method at its
// tightest, against closed forms, its orders of convergence, and its dense output.
#include "motion/steps/high_order_stepper.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/tsuji.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "motion/steps/time_transformation.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace high_order_stepper_tests {

using namespace contact;
using namespace model;

struct Motion {
  Vector state;
  std::vector<Impact> impacts;
  Accuracy accuracy;
};

// Two masses on springs, one of them driven, that meet across a gap.
Motion two_masses(const std::string &method, double tolerance,
                  const std::shared_ptr<const ContactLaw> &law, double end) {
  Model model({testing::single_mass("a", 1, 100, 1), testing::single_mass("b", 2, 150, 2)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 3, 9, 0.3),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts({testing::contact_along_x(model, "a.head", "b.head", 0.01, law)});
  Settings settings;
  settings.method = method;
  settings.relative_tolerance = tolerance;
  settings.absolute_tolerance = 1e-2 * tolerance;
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(2), Vector::Zero(2));
  trajectory.advance(end, log);
  return {trajectory.motion_state().physical, log.impacts(0), trajectory.accuracy()};
}

void compare(const std::shared_ptr<const ContactLaw> &law) {
  constexpr double end = 2.0;
  const Motion flight = two_masses("exact", 1e-11, law, end);
  const Motion rk = two_masses("rk", 1e-13, law, end);
  ASSERT_EQ(flight.impacts.size(), rk.impacts.size()) << law->name();
  ASSERT_GT(flight.impacts.size(), 2u) << law->name();
  for (std::size_t i = 0; i < rk.impacts.size(); ++i) {
    const Impact &a = flight.impacts[i];
    const Impact &b = rk.impacts[i];
    EXPECT_NEAR(a.start_time, b.start_time, 1e-9) << law->name();
    EXPECT_NEAR(a.duration, b.duration, 1e-7 * b.duration) << law->name();
    EXPECT_NEAR(a.peak_force, b.peak_force, 1e-6 * b.peak_force) << law->name();
    EXPECT_NEAR(a.maximum_penetration, b.maximum_penetration, 1e-7 * b.maximum_penetration)
        << law->name();
  }
  EXPECT_LT((flight.state - rk.state).norm(), 1e-8 * rk.state.norm()) << law->name();
  EXPECT_LT(flight.accuracy.energy_residual, 1e-9) << law->name();
  EXPECT_LT(flight.accuracy.steps, rk.accuracy.steps / 4) << law->name();
}

constexpr HertzConstants constants{.stiffness = 1e7, .exponent = 1.5};

TEST(HighOrderStepperTest, CoursesReachBothEndsAtTheirRate) {
  constexpr double start = 2.25;
  constexpr double end = 3;
  for (const TimeTransformation &course :
       {TimeTransformation::even(start, end), TimeTransformation::since(2, start, end),
        TimeTransformation::since(start, start, end), TimeTransformation::until(3.5, start, end),
        TimeTransformation::until(end, start, end)}) {
    EXPECT_NEAR(course.time(0), start, 1e-15);
    EXPECT_NEAR(course.time(1), end, 1e-15);
    // Time is a square of s, of which central differences are exact.
    for (const double s : {0.0, 0.3, 1.0})
      EXPECT_NEAR(course.rate(s), (course.time(s + 0.1) - course.time(s - 0.1)) / 0.2, 1e-13) << s;
  }
}

TEST(HighOrderStepperTest, AgreesWithRungeKutta) {
  compare(std::make_shared<Hertz>(constants));
  compare(std::make_shared<Hertz>(HertzConstants{.stiffness = 1e9, .exponent = 2.2}));
  compare(HuntCrossley::with_dissipation(constants, 0.8));
  compare(HuntCrossley::with_dimensionless_damping(constants, 0.6, 1e-6));
  compare(std::make_shared<Tsuji>(1e7, 0.3));
}

// A free mass on a Hertz stop: u_max^(n+1) = (n+1) m v^2 / (2 k), and the contact lasts
// 2 sqrt(pi) / (n+1) Gamma(1/(n+1)) / Gamma(1/2 + 1/(n+1)) u_max / v.
TEST(HighOrderStepperTest, FreeMassOnHertzStop) {
  const double speed = 0.3;
  const double n = constants.exponent;
  Model model({testing::single_mass("mass", 2, 0, 0)});
  const ContactSet contacts(
      {testing::contact_along_x(model, "mass.head", "", 1e-3, std::make_shared<Hertz>(constants))});
  Settings settings;
  settings.relative_tolerance = 1e-11;
  settings.absolute_tolerance = 1e-15;
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
  trajectory.advance(0.1, log);
  ASSERT_EQ(log.impacts(0).size(), 1u);
  const Impact &impact = log.impacts(0)[0];
  const double deepest =
      std::pow((n + 1) * 2 * speed * speed / (2 * constants.stiffness), 1 / (n + 1));
  const double p = 1 / (n + 1);
  const double duration = 2 * std::sqrt(std::numbers::pi) * p * boost::math::tgamma(p) /
                          boost::math::tgamma(0.5 + p) * deepest / speed;
  EXPECT_NEAR(impact.maximum_penetration, deepest, 1e-8 * deepest);
  EXPECT_NEAR(impact.duration, duration, 1e-7 * duration);
  EXPECT_NEAR(impact.separation_speed, speed, 1e-9 * speed);
  EXPECT_NEAR(impact.impulse, 2 * 2 * speed, 1e-9);
}

// q'' + q + q^3 = 0 from 1 at rest, step by step without error control: both ends of a step of
// length h given, what is left of the error of the ends falls like h^9, of the polynomial between
// them like h^6 (it knows two derivatives there).
class Duffing {
public:
  Duffing() : model_(make()), equations_(model_, contacts_) {
    equations_.set_source_break(std::numeric_limits<double>::infinity());
    settings_.relative_tolerance = 1e-2;
    settings_.absolute_tolerance = 1e-2;
  }
  static Model make(double damping = 0) {
    Model model({testing::single_mass("mass", 1, 1, damping)});
    Projection elongation = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
    model.add_connection({.name = "cubic",
                          .side_a = "mass.head",
                          .side_b = "ground",
                          .elongation = elongation,
                          .cubic_stiffness = 1});
    return model;
  }
  // The state at `h`, and the dense output at h / 2.
  std::pair<Vector, double> step(double h) {
    HighOrderStepper stepper(equations_, settings_);
    Vector x = Vector::Zero(equations_.layout().size());
    x[0] = 1;
    x[1] = 0.4;
    stepper.restart(0, x);
    stepper.step(1e-3);
    stepper.shorten(h);
    const StepView view(equations_, stepper.start_point(), stepper.end_point());
    return {stepper.state().head(2), view.coordinate(0)(0.5)};
  }

private:
  Model model_;
  ContactSet contacts_;
  Equations equations_;
  Settings settings_;
};

// Fifty short steps, each of which errs below rounding.
Vector exact(double time) {
  Settings settings;
  Model model = Duffing::make();
  const ContactSet none(std::vector<ContactPair>{});
  settings.absolute_tolerance = 1e-16;
  settings.relative_tolerance = 1e-14;
  settings.maximum_step = time / 50;
  Trajectory trajectory(model, none, settings);
  trajectory.start(0, Vector::Constant(1, 1), Vector::Constant(1, 0.4));
  trajectory.advance(time);
  return trajectory.motion_state().physical;
}

TEST(HighOrderStepperTest, OrdersOfConvergence) {
  Duffing system;
  const double coarse = 0.3;
  const auto [state, middle] = system.step(coarse);
  const auto [half_state, half_middle] = system.step(coarse / 2);
  const double error = (state - exact(coarse)).norm();
  const double half_error = (half_state - exact(coarse / 2)).norm();
  EXPECT_GT(std::log2(error / half_error), 8);
  EXPECT_LT(std::log2(error / half_error), 10.5);
  const double dense = std::abs(middle - exact(coarse / 2)[0]);
  const double half_dense = std::abs(half_middle - exact(coarse / 4)[0]);
  EXPECT_NEAR(std::log2(dense / half_dense), 6, 0.7);
}

// The same with a dashpot and a harmonic force instead of the cubic spring: the third derivative is
// known, and with it the polynomial errs like h^8.
TEST(HighOrderStepperTest, DenseOutputOfLinearModels) {
  Model model({testing::single_mass("mass", 1, 1, 0.2)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 1, 2, 0.1),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet none(std::vector<ContactPair>{});
  Equations equations(model, none);
  equations.set_source_break(std::numeric_limits<double>::infinity());
  Settings settings;
  const auto middle_error = [&](double h) {
    HighOrderStepper stepper(equations, settings);
    Vector x = Vector::Zero(equations.layout().size());
    x[0] = 1;
    stepper.restart(0, x);
    stepper.step(1e-3);
    stepper.shorten(h);
    const StepView view(equations, stepper.start_point(), stepper.end_point());
    Trajectory exact(model, none, settings); // linear: closed form
    exact.start(0, Vector::Constant(1, 1), Vector::Zero(1));
    exact.advance(h / 2);
    return std::abs(view.coordinate(0)(0.5) - exact.state()[0]);
  };
  EXPECT_NEAR(std::log2(middle_error(0.8) / middle_error(0.4)), 8, 0.7);
}

// A tolerance relative to the largest value is relative to that of the last steps, not to the
// amplitude with which the motion began, here ten thousand times that at the end.
TEST(HighOrderStepperTest, ForgetsTheAmplitudeOfLongAgo) {
  const Model model = Duffing::make(0.4);
  const ContactSet none(std::vector<ContactPair>{});
  const auto at_the_end = [&](double tolerance) {
    Settings settings;
    settings.relative_tolerance = tolerance;
    settings.absolute_tolerance = 1e-16;
    Trajectory trajectory(model, none, settings);
    trajectory.start(0, Vector::Constant(1, 1), Vector::Zero(1));
    trajectory.advance(46);
    return trajectory.motion_state().physical;
  };
  const Vector state = at_the_end(1e-13);
  ASSERT_LT(state.norm(), 2e-4);
  EXPECT_LT((at_the_end(1e-6) - state).norm(), 1e-5 * state.norm());
}

// Far beyond its stability a step ends in numbers whose squares overflow: no energy measures them.
TEST(HighOrderStepperTest, StepsThatOverflowAreRejected) {
  const Model model({testing::single_mass("mass", 2, 3, 0)});
  const ContactSet contacts({testing::contact_along_x(model, "mass.head", "", -0.05,
                                                      std::make_shared<Hertz>(constants))});
  Equations equations(model, contacts);
  equations.set_mode(0, 1);
  const auto point = [&](double time, double size) {
    EndPoint at;
    at.time = time;
    at.state = at.rates = Vector::Constant(equations.layout().size(), size);
    return at;
  };
  ErrorMeasure measure(equations, 1e-9, 0);
  measure.begin(point(0, 0));
  const Vector ones = Vector::Ones(equations.layout().size());
  for (const double size : {1e-3, 1e100, 1e160, 1e300}) {
    measure.set_step(point(0, 0), point(0.01, size));
    EXPECT_GT(measure.of_step(size * ones), 1) << size;
    EXPECT_GT(measure.of_dense(size * Vector::Ones(1)), 1) << size;
  }
  measure.set_step(point(0, 0), point(0.01, 1e-3));
  EXPECT_GT(measure.of_step(std::nan("") * ones), 1);
}

TEST(HighOrderStepperTest, MotionsDoNotDependOnEarlierOnes) {
  const auto law = std::make_shared<Hertz>(constants);
  const Motion once = two_masses("exact", 1e-9, law, 1.0);
  const Motion again = two_masses("exact", 1e-9, law, 1.0);
  EXPECT_EQ(once.state, again.state);
  EXPECT_EQ(once.accuracy.steps, again.accuracy.steps);
}

// A load presses a mass towards a rigid stop against a Hertz spring, which does not part there:
// every flight back to the stop, e = 1, ends with the same speed but for a tolerance each. The
// spring opens and closes on the way, but no flight ends at the root of its force.
TEST(HighOrderStepperTest, RigidImpactsWithinAnotherContact) {
  const double speed = 0.02, load = 60, tolerance = 1e-10;
  Model model({testing::single_mass("mass", 2, 0, 0)});
  model.add_force("load", make_constant(Given::displacement, load), {.body = 0, .point = 0},
                  Vector3::UnitX());
  const ContactSet contacts(
      {testing::contact_along_x(model, "mass.head", "", 0, testing::newton(1)),
       testing::contact_along_x(
           model, "mass.head", "", -1e-3,
           std::make_shared<Hertz>(HertzConstants{.stiffness = 1e6, .exponent = 1.5}))});
  Trajectory trajectory(model, contacts, {.relative_tolerance = tolerance});
  ImpactLog log(contacts, 0);
  trajectory.start({.time = 0, .physical = testing::vector_of({0, -speed})});
  trajectory.advance(1, log);
  ASSERT_GT(log.impacts(0).size(), 100U);
  for (const Impact &impact : log.impacts(0))
    ASSERT_NEAR(impact.approach_speed / speed, 1,
                static_cast<double>(log.impacts(0).size()) * tolerance);
}

// Half a vibration on a Hertz spring while a stop far behind recovers at another rate: once that is
// over it bounds no step.
TEST(HighOrderStepperTest, ADecayThatIsOverBoundsNoStep) {
  const Model model({testing::single_mass("mass", 2, 0, 0)});
  const double stiffness = 1e4, compression = 1e-3;
  for (const double recovery : {1e4, 1e6, 1e8, 1e10}) {
    const ContactSet contacts(
        {testing::contact_along_x(model, "mass.head", "", 0, std::make_shared<Hertz>(constants)),
         testing::contact_along_x(
             model, "mass.head", "", 1,
             std::make_shared<KelvinVoigtBumper>(stiffness, stiffness / recovery))});
    Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-10});
    trajectory.start({.time = 0, .physical = testing::vector_of({1e-4, 0.1, compression})});
    trajectory.advance(2e-3);
    EXPECT_EQ(trajectory.accuracy().events, 0);
    const Accuracy accuracy = trajectory.accuracy();
    EXPECT_LT(accuracy.steps + accuracy.rejected_steps, 150) << recovery;
    EXPECT_NEAR(trajectory.motion_state().physical[2], compression * std::exp(-recovery * 2e-3),
                1e-15)
        << recovery;
  }
}

// Steps that one motion has learned are of no use to the next one, which must come out the same
// whatever was computed before it.
TEST(HighOrderStepperTest, AMotionDoesNotDependOnTheOneBefore) {
  const Model model({testing::single_mass("a", 1, 100, 1), testing::single_mass("b", 2, 150, 2)});
  const ContactSet contacts({testing::contact_along_x(
      model, "a.head", "b.head", 0.01, HuntCrossley::with_dissipation(constants, 0.8))});
  const auto run = [&](Trajectory &trajectory, double speed) {
    trajectory.start(0, Vector::Zero(2), Vector{{speed, 0}});
    trajectory.advance(0.5);
    EXPECT_GT(trajectory.accuracy().events, 1);
    return trajectory.motion_state().physical;
  };
  Trajectory used(model, contacts, {});
  run(used, 30);
  Trajectory fresh(model, contacts, {});
  EXPECT_EQ(run(used, 0.7), run(fresh, 0.7));
  EXPECT_EQ(used.accuracy().steps, fresh.accuracy().steps);
}

} // namespace high_order_stepper_tests
} // namespace vibroimpact::motion
