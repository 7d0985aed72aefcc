// The same window recorded in closed form and step by step: the same extreme values,
// impacts and energies.
#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/impacts.h"
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "support/recorded_windows.h"
#include "support/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace vibroimpact::analyses {
namespace recorded_exactly_tests {

using namespace contact;
using namespace motion;

struct Recorded {
  PointResult result;
  Accuracy accuracy;
  Vector state; ///< with the work integrals
};

// A mass between two stops on a shaken base.
System between_stops(const std::shared_ptr<const ContactLaw> &law, double frequency) {
  model::Model model({testing::single_mass("mass", 2, 3, 0.4)});
  model.add_base_motion(
      "base", std::make_shared<model::Harmonic>(model::Given::acceleration, 0.3, frequency, 0), {0},
      Vector3::UnitX());
  ContactPair right = testing::contact_along_x(model, "mass.head", "", 0.2, law);
  ContactPair left = testing::contact_along_x(model, "mass.head", "", 0.3, law);
  right.name = "right";
  left.name = "left";
  left.gap.row *= -1;
  for (double &base_coefficients : left.gap.base_coefficients)
    base_coefficients *= -1;
  System system = testing::system_of(std::move(model), ContactSet({right, left}));
  // For the second derivative of the dense output, which loses some digits.
  system.integration.relative_tolerance = 1e-13;
  return system;
}

// Five settling periods, six recorded ones. Nobody must see steps for them to be taken.
Recorded record(const System &system, double frequency, bool by_steps) {
  const double period = 2 * std::numbers::pi / frequency;
  Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  trajectory.advance(5 * period);
  WindowRecording recording(
      {[](const System &s) { return std::make_unique<ExtremeValues>(ObservedSelection{}, s); },
       [](const System &s) { return std::make_unique<Impacts>(s); }},
      system);
  testing::Nobody nobody;
  recording.run(periods_window(5 * period, period, 6), trajectory,
                by_steps ? std::vector<Observer *>{&nobody} : std::vector<Observer *>());
  Recorded recorded{.result = {}, .accuracy = trajectory.accuracy(), .state = trajectory.state()};
  recording.add_fields(recorded.result);
  return recorded;
}

// Of the steps: the acceleration is the second derivative of a polynomial that is right to 1e-13.
double step_error(const std::string &field) {
  return field.find("acceleration") == std::string::npos ? 5e-11 : 1e-9;
}

void compare(const std::shared_ptr<const ContactLaw> &law, double frequency) {
  const System system = between_stops(law, frequency);
  const Recorded whole = record(system, frequency, false);
  const Recorded stepped = record(system, frequency, true);
  const std::string where = law->name() + " at " + std::to_string(frequency) + " rad/s: ";
  EXPECT_EQ(whole.accuracy.events, stepped.accuracy.events) << where;
  EXPECT_LT(whole.accuracy.energy_residual, 1e-12) << where;
  EXPECT_LT(stepped.accuracy.energy_residual, 1e-10) << where;

  ASSERT_EQ(whole.result.fields.size(), stepped.result.fields.size()) << where;
  for (std::size_t i = 0; i < whole.result.fields.size(); ++i) {
    const Field &one = whole.result.fields[i];
    const Field &other = stepped.result.fields[i];
    ASSERT_EQ(one.name(), other.name()) << where;
    if (std::isnan(other.values[0])) {
      EXPECT_TRUE(std::isnan(one.values[0])) << where << one.name();
    } else {
      EXPECT_NEAR(one.values[0], other.values[0],
                  step_error(one.name()) * (1 + std::abs(other.values[0])))
          << where << one.name();
    }
  }

  const StateLayout layout = Equations(system.model, system.contacts).layout();
  const double turnover = stepped.state[layout.absolute_input_work()];
  for (Index entry = 0; entry < layout.size(); ++entry)
    if (entry != layout.absolute_input_work()) {
      EXPECT_NEAR(whole.state[entry], stepped.state[entry], 1e-12 * (1 + turnover))
          << where << "entry " << entry;
    }
  EXPECT_LE(whole.state[layout.absolute_input_work()], turnover * (1 + 1e-9)) << where;
}

TEST(RecordedExactlyTest, AreTheSteppedOnes) {
  for (const auto &law : std::vector<std::shared_ptr<const ContactLaw>>{
           std::make_shared<LinearPenalty>(20), std::make_shared<KelvinVoigt>(5, 0.4),
           std::make_shared<BilinearStop>(8, 0.5), std::make_shared<KelvinVoigtBumper>(10, 1),
           std::make_shared<KelvinVoigtBumper>(0.5, 1),
           std::make_shared<Hertz>(HertzConstants{.stiffness = 50, .exponent = 1.5}),
           std::make_shared<NewtonRestitution>(0.6)})
    for (const double frequency : {0.3, 0.8, 1.2, 1.5, 2.1, 4.0})
      if (!(law->rigid() && frequency == 0.3)) // the speeds of bounces that die out are rounding
        compare(law, frequency);
}

// Counts the steps it is shown with no contact closed; needs extreme values only.
class StepsApart : public Observer {
public:
  void step(const StepView &view) override {
    const Equations &equations = view.equations();
    bool apart = true;
    for (std::size_t c = 0; c < equations.contacts().size(); ++c)
      apart = apart && !equations.mode(c).in_contact;
    count += apart ? 1 : 0;
  }
  void event(const ContactEvent & /*event*/) override { ++events; }
  bool sees_steps(const Equations & /*equations*/) const override { return false; }

  long count = 0, events = 0;
};

// Where a contact is not linear, exact propagation ends with its beginning and goes on behind it.
TEST(RecordedExactlyTest, ReachFromContactToContact) {
  for (const auto &law : std::vector<std::shared_ptr<const ContactLaw>>{
           std::make_shared<Hertz>(HertzConstants{.stiffness = 50, .exponent = 1.5}),
           std::make_shared<NewtonRestitution>(0.6)}) {
    const System system = between_stops(law, 1.2);
    Trajectory trajectory(system.model, system.contacts, system.integration);
    trajectory.start(0, system.initial.displacement, system.initial.velocity);
    StepsApart steps;
    trajectory.advance(100, steps);
    EXPECT_GT(steps.events, 15) << law->name();
    EXPECT_EQ(steps.count, 0) << law->name();
  }
}

// Counts what it is shown while the contacts are affine, and elsewhere.
class Parts : public Observer {
public:
  explicit Parts(bool in_steps) : in_steps_(in_steps) {}
  bool sees_steps(const Equations & /*equations*/) const override { return in_steps_; }
  void step(const StepView &view) override { ++(linear(view) ? steps : contact_steps); }
  void interval(const Interval &interval) override { ++(linear(interval) ? wholes : contacts); }

  long steps = 0, contact_steps = 0, wholes = 0, contacts = 0;

private:
  static bool linear(const Interval &interval) {
    return interval.equations().mode(0).affine && interval.equations().mode(1).affine;
  }
  bool in_steps_;
};

// Who must see steps makes them for itself in linear phases, and for all in contacts that are
// solved as a whole.
TEST(RecordedExactlyTest, EachObserverSeesLinearPhasesAsItAsks) {
  System system = between_stops(
      std::make_shared<Hertz>(HertzConstants{.stiffness = 5e4, .exponent = 1.5}), 1.2);
  system.integration.relative_tolerance = 1e-9; // contacts are solved as a whole
  Parts alone(false), beside(false), stepped(true);
  for (const Observers &observers : {Observers(alone), Observers({&beside, &stepped})}) {
    Trajectory trajectory(system.model, system.contacts, system.integration);
    trajectory.start(0, system.initial.displacement, system.initial.velocity);
    trajectory.advance(100, observers);
    EXPECT_GT(trajectory.accuracy().contact_episodes, 5);
    EXPECT_EQ(trajectory.accuracy().stepped_contacts(), 0);
  }
  EXPECT_EQ(alone.steps + alone.contact_steps, 0);
  EXPECT_GT(alone.contacts, 5);
  EXPECT_EQ(beside.steps + beside.contacts, 0);
  EXPECT_EQ(beside.wholes, alone.wholes);
  EXPECT_GT(stepped.steps, 3 * beside.wholes);
  EXPECT_EQ(beside.contact_steps, stepped.contact_steps);
  EXPECT_GT(stepped.contact_steps, 3 * alone.contacts);
  EXPECT_EQ(stepped.wholes + stepped.contacts, 0);
}

} // namespace recorded_exactly_tests
} // namespace vibroimpact::analyses
