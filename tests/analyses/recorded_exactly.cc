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
  Observers flying({});
  Observer &also = by_steps ? static_cast<Observer &>(nobody) : flying;
  recording.run(periods_window(5 * period, period, 6), trajectory, also);
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
  const Recorded part_done = record(system, frequency, false);
  const Recorded stepped = record(system, frequency, true);
  const std::string where = law->name() + " at " + std::to_string(frequency) + " rad/s: ";
  EXPECT_EQ(part_done.accuracy.events, stepped.accuracy.events) << where;
  EXPECT_LT(part_done.accuracy.energy_residual, 1e-12) << where;
  EXPECT_LT(stepped.accuracy.energy_residual, 1e-10) << where;

  ASSERT_EQ(part_done.result.fields.size(), stepped.result.fields.size()) << where;
  for (std::size_t i = 0; i < part_done.result.fields.size(); ++i) {
    const Field &one = part_done.result.fields[i];
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
      EXPECT_NEAR(part_done.state[entry], stepped.state[entry], 1e-12 * (1 + turnover))
          << where << "entry " << entry;
    }
  EXPECT_LE(part_done.state[layout.absolute_input_work()], turnover * (1 + 1e-9)) << where;
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
class StepsApart : public Observer, private OutputMonitor {
public:
  void step(const StepView &view) override {
    const Equations &equations = view.equations();
    bool apart = true;
    for (std::size_t c = 0; c < equations.contacts().size(); ++c)
      apart = apart && !equations.mode(c).in_contact;
    count += apart ? 1 : 0;
  }
  void event(const ContactEvent & /*event*/) override { ++events; }
  OutputMonitor *output_monitor() override { return this; }

  long count = 0, events = 0;

private:
  void add_forms(const Equations & /*equations*/, std::vector<MonitoredForm> & /*forms*/) override {
  }
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

// One recorder that must see steps makes them for all; recorders of extreme values need none.
TEST(RecordedExactlyTest, OneRecorderThatNeedsStepsMakesThemForAll) {
  const System system = between_stops(std::make_shared<LinearPenalty>(20), 1.2);
  const ExtremeValues extremes(ObservedSelection{}, system);
  Observers none({});
  testing::Nobody nobody;
  Observers one({&nobody});
  EXPECT_EQ(none.step_observer(), nullptr);
  EXPECT_EQ(one.output_monitor(), nullptr);
  EXPECT_NE(one.step_observer(), nullptr);
}

} // namespace recorded_exactly_tests
} // namespace vibroimpact::analyses
