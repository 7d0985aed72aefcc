// Motions through breaks of their excitation: closed forms, the order of the method, one-sided
// values.
#include "contact/laws/linear_penalty.h"
#include "model/piecewise_function.h"
#include "model/pulse.h"
#include "model/recorded_history.h"
#include "model/sine_sweep.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace source_breaks_tests {

using namespace contact;
using namespace model;
using std::numbers::pi;
using testing::contact_along_x;
using testing::single_mass;

class LastStep : public Observer {
public:
  void step(const StepView &view) override {
    end = view.end();
    shortest = std::min(shortest, view.length());
  }
  double end = 0;
  double shortest = 1;
};

Model pushed_mass(TimeFunctionPointer force, double stiffness) {
  Model model({single_mass("block", 2, stiffness, 0)});
  model.add_force("push", std::move(force), {.body = 0, .point = 0}, Vector3::UnitX());
  return model;
}

Vector state_at(const Model &model, double time, const Settings &settings = {}) {
  const ContactSet contacts(std::vector<ContactPair>{});
  Trajectory trajectory(model, contacts, settings);
  LastStep last;
  trajectory.start(0, Vector::Zero(model.size()), Vector::Zero(model.size()));
  trajectory.advance(time, last);
  EXPECT_EQ(trajectory.time(), time);
  EXPECT_EQ(last.end, time);
  return trajectory.state();
}

// m = 2, k = 1800: omega = 30. Force 5 sin(p t') for pi / p = 0.07 s from t = 0.1 s on.
TEST(SourceBreaksTest, HalfSinePulseOnAnOscillator) {
  const double k = 1800;
  const double omega = 30;
  const double p = pi / 0.07;
  const auto during = [&](double t) -> Eigen::Vector2d {
    const double r = p / omega;
    return Eigen::Vector2d(std::sin(p * t) - r * std::sin(omega * t),
                           p * (std::cos(p * t) - std::cos(omega * t))) *
           (5 / k / (1 - r * r));
  };
  const Model model =
      pushed_mass(make_pulse(Given::displacement, PulseShape::half_sine, 5, 0.1, 0.07), k);
  EXPECT_EQ(state_at(model, 0.1).head(2).norm(), 0);
  EXPECT_LT((state_at(model, 0.14).head(2) - during(0.04)).norm(), 1e-9);
  EXPECT_LT((state_at(model, 0.1 + 0.07).head(2) - during(0.07)).norm(), 1e-9);
  const Eigen::Vector2d free = during(0.07);
  const double t = 0.5 - 0.17;
  const double x = free[0] * std::cos(omega * t) + free[1] / omega * std::sin(omega * t);
  EXPECT_NEAR(state_at(model, 0.5)[0], x, 1e-10);
}

// Between samples x'' + w^2 x = -(a + b t) has the solution -(a + b t) / w^2 + free vibration.
TEST(SourceBreaksTest, RecordedBaseAccelerationOnAnOscillator) {
  const Samples record{.time = {0, 0.1, 0.17, 0.4, 0.41, 0.8}, .value = {3, -4, 2, 7, -7, 1}};
  Model model({single_mass("block", 2, 1800, 0)});
  model.add_base_motion(
      "quake",
      make_recorded(Given::acceleration, record, Interpolation::linear, OutsideRecord::zero), {0},
      Vector3::UnitX());
  const double omega = 30;
  double x = 0;
  double v = 0;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const Vector state = i == 0 ? Vector::Zero(2) : Vector(state_at(model, record.time[i]).head(2));
    EXPECT_NEAR(state[0], x, 1e-10);
    EXPECT_NEAR(state[1], v, 1e-9);
    if (i + 1 == record.time.size())
      break;
    const double length = record.time[i + 1] - record.time[i];
    const double a = record.value[i] / (omega * omega);
    const double b = (record.value[i + 1] - record.value[i]) / length / (omega * omega);
    const double c = x + a;
    const double s = (v + b) / omega;
    const double angle = omega * length;
    x = -a - b * length + c * std::cos(angle) + s * std::sin(angle);
    v = -b + omega * (s * std::cos(angle) - c * std::sin(angle));
  }
}

// The same function, but it keeps its breaks to itself.
class Silent : public TimeFunction {
public:
  explicit Silent(TimeFunctionPointer function) : function_(std::move(function)) {}
  double value(double time) const override { return function_->value(time); }
  double rate(double time) const override { return function_->rate(time); }
  double acceleration(double time) const override { return function_->acceleration(time); }
  double period() const override { return 0; }
  double highest_frequency() const override { return function_->highest_frequency(); }
  TimeFunctionPointer with_frequency(double) const override { return nullptr; }

private:
  TimeFunctionPointer function_;
};

// Steps of fixed length: the tolerance is out of reach.
double error_with_step(const TimeFunctionPointer &force, double exact, double step) {
  Settings settings;
  settings.method = "rk"; // exact phases have no order
  settings.relative_tolerance = 1e3;
  settings.absolute_tolerance = 1e3;
  settings.maximum_step = step;
  return std::abs(state_at(pushed_mass(force, 1800), 0.5, settings)[0] - exact);
}

TEST(SourceBreaksTest, AStepOrAKinkDoesNotSpoilTheOrder) {
  const double omega = 30;
  const double begin = 0.1234;
  const double length = 0.0789;
  const auto step_response = [&](double t) { return (1 - std::cos(omega * t)) / 1800; };
  const auto ramp_response = [&](double t) { return (t - std::sin(omega * t) / omega) / 1800; };
  const double after = 0.5 - begin;
  const double rectangular = 5 * (step_response(after) - step_response(after - length));
  const double triangular = 10 / length *
                            (ramp_response(after) - 2 * ramp_response(after - length / 2) +
                             ramp_response(after - length));
  for (const auto &[shape, exact] : {std::pair(PulseShape::rectangular, rectangular),
                                     std::pair(PulseShape::triangular, triangular)}) {
    const auto force = make_pulse(Given::displacement, shape, 5, begin, length);
    const double coarse = error_with_step(force, exact, 4e-3);
    const double fine = error_with_step(force, exact, 2e-3);
    EXPECT_NEAR(std::log2(coarse / fine), 5, 0.6);
    const auto inactive = std::make_shared<Silent>(force);
    EXPECT_GT(error_with_step(inactive, exact, 2e-3), 100 * fine);
  }
}

// A base that is jerked under a mass between a stop fixed in space and its spring: the gap carries
// the base's motion, and all work is accounted for.
TEST(SourceBreaksTest, EnergyIsKeptThroughJumpsOfTheBaseAcceleration) {
  Model model({single_mass("block", 2, 1800, 3)});
  model.add_base_motion("jerk",
                        make_pulse(Given::acceleration, PulseShape::rectangular, 20, 0.01, 0.05),
                        {0}, Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 5e-3, std::make_shared<LinearPenalty>(1e6))});
  Trajectory trajectory(model, contacts, {});
  LastStep last;
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  trajectory.advance(0.07, last);
  EXPECT_GE(trajectory.accuracy().events, 2);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8);
}

// A trajectory that is started anew sees the breaks before the place where it stood.
TEST(SourceBreaksTest, AMotionCanBeStartedAnew) {
  const Model model =
      pushed_mass(make_pulse(Given::displacement, PulseShape::rectangular, 5, 0.1, 0.2), 0);
  const ContactSet contacts(std::vector<ContactPair>{});
  Trajectory trajectory(model, contacts, {});
  LastStep last;
  for (int i = 0; i < 2; ++i) {
    trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
    trajectory.advance(0.1, last);
    trajectory.advance(0.3, last);
    EXPECT_NEAR(trajectory.state()[1], 0.5, 1e-13);
  }
  trajectory.start(1, Vector::Zero(1), Vector::Zero(1));
  trajectory.advance(2, last);
  EXPECT_EQ(trajectory.state()[1], 0);
}

// Breaks so near each other that no step fits between them, and a contact change at a break.
TEST(SourceBreaksTest, BreaksWithinRounding) {
  const double next = std::nextafter(0.1, 1);
  const auto force =
      make_recorded(Given::displacement, {.time = {0, 0.1, next, 0.2}, .value = {0, 0, 4, 4}},
                    Interpolation::linear, OutsideRecord::zero);
  EXPECT_NEAR(state_at(pushed_mass(force, 0), 0.2)[1], 0.2, 1e-12);
}

// From rest under a sweep that fades in, s ~ t^4, relative errors of the work are the same for
// first steps of every length. Of x'' + w^2 x = -s'' Duhamel's integral is x(t).
TEST(SourceBreaksTest, ASweepThatFadesIn) {
  const double omega = 30, fade_in = 0.5, end = 1.2;
  const auto sweep = std::make_shared<SineSweep>(SweepDefinition{.given = Given::displacement,
                                                                 .amplitude = 0.01,
                                                                 .from = 5,
                                                                 .to = 40,
                                                                 .duration = 2,
                                                                 .fade_in = fade_in});
  Model model({single_mass("block", 2, 2 * omega * omega, 0)});
  model.add_base_motion("shaker", sweep, {0}, Vector3::UnitX());
  const auto integrand = [&](double t) {
    return -sweep->acceleration(t) * std::sin(omega * (end - t)) / omega;
  };
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double exact = Quadrature::integrate(integrand, 0, fade_in, 10, 1e-13) +
                       Quadrature::integrate(integrand, fade_in, end, 10, 1e-13);
  for (const char *method : {"exact", "rk"}) {
    Settings settings;
    settings.method = method;
    settings.relative_tolerance = 1e-10;
    EXPECT_NEAR(state_at(model, end, settings)[0], exact, 1e-10) << method;
  }
}

// A mass of 2 kg flies at 1 m/s and touches a stop 0.1 m away just when a force of it ends.
TEST(SourceBreaksTest, AContactThatBeginsAtABreak) {
  const Model model =
      pushed_mass(make_pulse(Given::displacement, PulseShape::triangular, 1e-9, 0, 0.1), 0);
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0.1, std::make_shared<LinearPenalty>(2e4))});
  Trajectory trajectory(model, contacts, {});
  LastStep last;
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 1.0));
  trajectory.advance(0.1 + pi / 100 + 0.05, last);
  EXPECT_EQ(trajectory.accuracy().events, 2);
  EXPECT_NEAR(trajectory.state()[0], 0.05, 1e-8);
}

} // namespace source_breaks_tests
} // namespace vibroimpact::motion
