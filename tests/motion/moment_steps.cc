// Steps that no contact change ends: against closed forms, and against the exact method for laws of
// every kind.
#include "common/error.h"
#include "contact/laws/newton_restitution.h"
#include "motion/moments/moment_step.h"
#include "motion/phase/exact_phases.h"
#include "support/beam_on_stops.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace moment_step_tests {

using namespace contact;
using namespace model;
using testing::BeamOnStops;
using testing::contact_along_x;
using testing::Seen;
using testing::single_mass;
using testing::StopLaw;

constexpr double pi = std::numbers::pi;

// Both ways to the responses, and where one takes over from the other.
TEST(MomentStepsResponseTest, IsTheIntegral) {
  for (const Complex z : {Complex(0, 0), Complex(-1e-3, 0.1), Complex(-1, 3.8), Complex(-1, 3.95),
                          Complex(-8, 0), Complex(-0.5, 30)})
    for (const double x : {0.07, 0.5, 1.0}) {
      const LegendreResponses found = legendre_responses(z, x);
      Matrix generator(2, 2);
      generator << z.real(), -z.imag(), z.imag(), z.real();
      const auto by_matrix = legendre_responses(generator, x);
      for (std::size_t k = 0; k < found.size(); ++k) {
        const auto part = [&](bool imaginary) {
          return boost::math::quadrature::gauss<double, 60>::integrate(
              [&](double s) {
                const Complex value = std::exp(z * (x - s)) * shifted_legendre(s)[k];
                return imaginary ? value.imag() : value.real();
              },
              0.0, x);
        };
        EXPECT_NEAR(found[k].real(), part(false), 2e-14) << z << " " << x << " " << k;
        EXPECT_NEAR(found[k].imag(), part(true), 2e-14) << z << " " << x << " " << k;
        EXPECT_NEAR(by_matrix[k](0, 0), found[k].real(), 5e-14);
        EXPECT_NEAR(by_matrix[k](1, 0), found[k].imag(), 5e-14);
      }
    }
}

// A gap that is a parabola, through a stop and back: the moments of its force are integrals of
// polynomials, and what the polynomial of the force lacks has no moments.
TEST(MomentStepsCourseTest, HasTheMomentsOfTheForce) {
  const LinearPenalty law(3);
  const auto gap = [](double x) { return (x - 0.3) * (x - 0.8); };
  constexpr double h = 0.2;
  PathValues values{.start = gap(0), .start_rate = -1.1 / h, .end = gap(1), .end_rate = 0.9 / h};
  for (std::size_t i = 0; i < n_moments; ++i)
    values.nodes[i] = gap(moment_nodes()[i]);
  ContactCourse course;
  course.take(0, DirectionCurve(values, h, 0));
  ASSERT_TRUE(course.follow(law, 0, {}, {0, 0}));
  ASSERT_EQ(course.stretches().size(), 3u);
  EXPECT_NEAR(course.stretches()[1].from, 0.3, 1e-14);
  EXPECT_NEAR(course.stretches()[1].to, 0.8, 1e-14);
  LawResponse response;
  const ContactCourse::Moments moments = course.moments(law, 0, response);
  EXPECT_NEAR(moments[0], 3 * std::pow(0.5, 3) / 6, 1e-15);
  EXPECT_NEAR(moments[1], 3 * 3 * std::pow(0.5, 3) / 6 * (2 * 0.55 - 1), 1e-15);
  course.sum_lacks(law, 0, moments.data(), response);
  const auto lacking = course.lacking(law, 0, moments.data(), 1, response);
  EXPECT_NEAR(lacking[0], 0, 1e-16);
  EXPECT_NEAR(lacking[1], 0, 1e-16);
  const double impulse =
      course
          .integrals(
              law, course.stretches()[1], [](std::size_t, double) { return 0.0; }, response)
          .force;
  EXPECT_NEAR(impulse, moments[0], 1e-15);
}

// Differences, over what the log holds at most; times over the duration.
struct ImpactErrors {
  double time = 0, speed = 0, peak = 0, impulse = 0;
};

ImpactErrors compare(const std::vector<Impact> &found, const std::vector<Impact> &exact,
                     double duration) {
  Impact most = exact.front();
  for (const Impact &impact : exact) {
    most.approach_speed = std::max(most.approach_speed, impact.approach_speed);
    most.peak_force = std::max(most.peak_force, impact.peak_force);
    most.impulse = std::max(most.impulse, impact.impulse);
  }
  ImpactErrors errors;
  const auto note = [](double &largest, double difference, double size) {
    largest = std::max(largest, std::abs(difference) / size);
  };
  for (std::size_t i = 0; i < exact.size(); ++i) {
    note(errors.time, found[i].start_time - exact[i].start_time, duration);
    note(errors.speed, found[i].approach_speed - exact[i].approach_speed, most.approach_speed);
    note(errors.peak, found[i].peak_force - exact[i].peak_force, most.peak_force);
    note(errors.impulse, found[i].impulse - exact[i].impulse, most.impulse);
  }
  return errors;
}

// In tolerances. A single stiff stop is short against the beam's periods, and its kinks are not
// averaged.
void expect_agreement(const BeamOnStops &system, const Seen &found, const Seen &exact,
                      double tolerance) {
  const double factor = system.stops == 1 ? 1 : 0.2;
  EXPECT_LT(energy_difference(system, found.state, exact.state), 2 * factor * tolerance);
  EXPECT_EQ(found.accuracy.events, exact.accuracy.events);
  EXPECT_LT(found.accuracy.energy_residual, 0.2 * tolerance);
  ASSERT_EQ(found.impacts.size(), exact.impacts.size());
  ASSERT_GT(exact.impacts.size(), 0u);
  const ImpactErrors errors = compare(found.impacts, exact.impacts, system.duration);
  EXPECT_LT(errors.time, 0.1 * factor * tolerance);
  EXPECT_LT(errors.speed, 6 * factor * tolerance);
  EXPECT_LT(errors.peak, 6 * factor * tolerance);
  EXPECT_LT(errors.impulse, 6 * factor * tolerance);
}

class MomentStepsTest : public ::testing::TestWithParam<std::tuple<StopLaw, int>> {};

TEST_P(MomentStepsTest, AgreeWithTheExactMethod) {
  const auto &[law, stops] = GetParam();
  const BeamOnStops system{.stops = stops, .law = law.make(stops)};
  const Seen exact = move(system, "exact", 1e-12);
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    SCOPED_TRACE(tolerance);
    const Seen found = move(system, "moments", tolerance);
    expect_agreement(system, found, exact, tolerance);
    EXPECT_EQ(move(system, "moments", tolerance, false).state, found.state);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, MomentStepsTest,
                         ::testing::Combine(::testing::ValuesIn(testing::stop_laws()),
                                            ::testing::Values(1, 16)),
                         [](const auto &info) {
                           return std::string(std::get<0>(info.param).name) +
                                  std::to_string(std::get<1>(info.param));
                         });

TEST(MomentStepsTest, MoveWithTheBase) {
  const BeamOnStops system{
      .stops = 5, .law = std::make_shared<LinearPenalty>(4e5), .duration = 0.6, .shaken = true};
  expect_agreement(system, move(system, "moments", 1e-9), move(system, "exact", 1e-12), 1e-9);
}

// Equal steps, all of them with the sweeps carried to the end.
double error_of_equal_steps(const BeamOnStops &system, int count, const Vector &exact) {
  const Model model = system.model();
  const ContactSet contacts = system.contacts(model);
  Equations equations(model, contacts);
  equations.set_source_break(model.next_break(0));
  ExactPhases phases(equations, Settings());
  EXPECT_TRUE(phases.take_sources(0));
  MomentStep step(equations, 1e-11);
  step.begin();
  step.take(phases.excitation());
  step.start(Vector::Zero(equations.layout().size()), phases.excitation(), 0, equations.modes(), 0);
  const double h = system.duration / count;
  const MomentTables tables = step.tables(h);
  for (int i = 0; i < count; ++i) {
    if (i > 0)
      step.go_on(phases.excitation(), i * h);
    EXPECT_TRUE(step.attempt(h, tables));
  }
  return energy_difference(system, step.rows_at_end().head(2 * model.size()), exact);
}

// A force with a kink makes one of the third derivative of a gap, which its polynomial misses by
// h^3 in one step: order 4. A jump costs one order more, a power 3/2 half a one less. The phases of
// changes within steps are as good as random: a line is put through many lengths.
TEST(MomentStepsTest, HaveTheOrderOfTheirKinks) {
  for (const StopLaw &law : testing::stop_laws()) {
    const BeamOnStops system{.modes = 4, .stops = 16, .law = law.make(16), .duration = 0.12};
    const Vector exact = move(system, "exact", 1e-12).state;
    const std::vector<int> counts = {400, 500, 640, 800, 1000, 1280, 1600, 2000};
    Vector lengths(counts.size()), errors(counts.size());
    for (Index i = 0; i < errors.size(); ++i) {
      const int count = counts[static_cast<std::size_t>(i)];
      lengths[i] = -std::log(count);
      errors[i] = std::log(error_of_equal_steps(system, count, exact));
    }
    lengths.array() -= lengths.mean();
    const double order = lengths.dot(errors) / lengths.squaredNorm();
    EXPECT_GT(order, law.order - 0.4) << law.name;
    EXPECT_LT(order, law.order + 1.2) << law.name;
  }
}

// Extreme values of what it is asked for, by steps or not.
class Ranges : public Observer {
public:
  Ranges(const Model &model, std::size_t contacts, bool in_steps) : in_steps_(in_steps) {
    const Projection head = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
    forms_ = {PointForm{head}, PointForm{head, 1}};
    for (std::size_t c = 0; c < contacts; ++c)
      forms_.insert(forms_.end(), {GapForm{c}, ForceForm{c}});
    ranges.resize(forms_.size());
  }
  void outputs(const Equations & /*equations*/, std::vector<Output> &list) override {
    for (std::size_t i = 0; i < forms_.size(); ++i)
      list.push_back({&forms_[i], &ranges[i]});
  }
  bool sees_steps(const Equations & /*equations*/) const override { return in_steps_; }
  void step(const StepView &view) override {
    ++steps;
    interval(view);
  }
  void interval(const Interval &part) override { shown += part.length(); }

  std::vector<ValueRange> ranges;
  double shown = 0; ///< [s]
  long steps = 0;

private:
  bool in_steps_;
  std::vector<OutputForm> forms_;
};

Ranges ranges_of(const BeamOnStops &system, double tolerance, bool in_steps) {
  const Model model = system.model();
  const ContactSet contacts = system.contacts(model);
  Settings settings;
  settings.method = "moments";
  settings.relative_tolerance = tolerance;
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(0, Vector::Zero(model.size()), Vector::Zero(model.size()));
  Ranges ranges(model, contacts.size(), in_steps);
  trajectory.advance(system.duration, ranges);
  return ranges;
}

// What is shown as a whole has the extreme values of the steps, also of stops that nothing touches;
// free motions over many periods of a mode are shown in steps.
TEST(MomentStepsTest, HaveTheSameExtremeValuesInPartsAsInSteps) {
  for (const StopLaw &law : testing::stop_laws()) {
    SCOPED_TRACE(law.name);
    const BeamOnStops system{.stops = 16, .law = law.make(16)};
    for (const double tolerance : {1e-6, 1e-9}) {
      const Ranges parts = ranges_of(system, tolerance, false);
      const Ranges steps = ranges_of(system, tolerance, true);
      EXPECT_LT(parts.steps, steps.steps);
      EXPECT_NEAR(parts.shown, system.duration, 1e-12);
      std::array<double, 4> sizes{}; // displacement, velocity, gaps, forces
      const auto kind = [](std::size_t i) { return i < 2 ? i : 2 + i % 2; };
      for (std::size_t i = 0; i < steps.ranges.size(); ++i)
        sizes[kind(i)] = std::max(sizes[kind(i)], steps.ranges[i].peak());
      for (std::size_t i = 0; i < steps.ranges.size(); ++i) {
        EXPECT_NEAR(parts.ranges[i].maximum, steps.ranges[i].maximum,
                    2 * tolerance * sizes[kind(i)])
            << i;
        EXPECT_NEAR(parts.ranges[i].minimum, steps.ranges[i].minimum,
                    2 * tolerance * sizes[kind(i)])
            << i;
      }
    }
  }
}

// Where 256 Hertz contacts touch together `exact` goes over to such steps, with one it does not.
TEST(MomentStepsTest, TakeOverFromManyNonlinearContacts) {
  const StopLaw law = testing::stop_laws()[2];
  for (const int stops : {1, 256}) {
    const BeamOnStops system{.stops = stops, .law = law.make(stops)};
    const Seen found = move(system, "exact", 1e-8);
    EXPECT_EQ(found.accuracy.moment_steps > 0, stops > 1);
    EXPECT_EQ(move(system, "exact", 1e-8, false).state, found.state);
    const Seen known = move(system, stops > 1 ? "moments" : "exact", 1e-11);
    EXPECT_LT(energy_difference(system, found.state, known.state), 1e-8);
    EXPECT_EQ(found.accuracy.events, known.accuracy.events);
  }
}

// A free mass between two stops: rigid motion is a group of its own.
TEST(MomentStepsTest, AFreeMassBetweenStops) {
  const Model model({single_mass("block", 2, 0, 0)});
  const auto law = std::make_shared<LinearPenalty>(8e4);
  ContactPair other = contact_along_x(model, "block.head", "", 0.01, law);
  other.gap.row *= -1;
  const ContactSet contacts({contact_along_x(model, "block.head", "", 0.01, law), other});
  Settings settings;
  settings.method = "moments";
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 0.5));
  // Flights of 0.02 m and contacts of half a period of 200 rad/s.
  const double period = 2 * (0.02 / 0.5 + pi / 200);
  trajectory.advance(25 * period);
  EXPECT_NEAR(trajectory.state()[0], 0, 1e-8);
  EXPECT_NEAR(trajectory.state()[1], 0.5, 1e-8);
  EXPECT_EQ(trajectory.events(), 100);
}

// What cannot be done so is said.
TEST(MomentStepsTest, RefuseRigidContacts) {
  const Model model({single_mass("block", 1, 1, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0, std::make_shared<NewtonRestitution>(0.5))});
  Settings settings;
  settings.method = "moments";
  EXPECT_THROW(Trajectory(model, contacts, settings), InputError);
}

} // namespace moment_step_tests
} // namespace vibroimpact::motion
