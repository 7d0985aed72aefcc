// Sweeps of a mass between two stops by exact propagation and by the Runge-Kutta method: the same
// contacts, the same states. Near grazing too, and when nobody watches.
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace methods_agree_tests {

using namespace contact;
using namespace model;

constexpr double damping_ratio = 0.1;

struct Result {
  Vector state;
  std::size_t right = 0, left = 0;
  Accuracy accuracy;
};

Result integrate(const std::string &method, const std::shared_ptr<const ContactLaw> &law,
                 double clearance, double frequency, long periods, bool observed = true) {
  Model model({testing::single_mass("mass", 1, 1, 2 * damping_ratio)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 0.2, frequency, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  ContactPair right = testing::contact_along_x(model, "mass.head", "", clearance, law);
  ContactPair left = right;
  left.gap.row *= -1;
  const ContactSet contacts({right, left});
  Settings settings;
  settings.method = method;
  settings.relative_tolerance = method == "rk" ? 1e-12 : 1e-9;
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  const double end = static_cast<double>(periods) * 2 * std::numbers::pi / frequency;
  if (observed)
    trajectory.advance(end, log);
  else
    trajectory.advance(end);
  return {trajectory.motion_state().physical, log.begun(0), log.begun(1), trajectory.accuracy()};
}

void compare(const std::shared_ptr<const ContactLaw> &law, double clearance, double frequency) {
  const Result flight = integrate("exact", law, clearance, frequency, 12);
  const Result rk = integrate("rk", law, clearance, frequency, 12);
  const std::string where =
      law->name() + " " + std::to_string(clearance) + " " + std::to_string(frequency);
  EXPECT_EQ(flight.right, rk.right) << where;
  EXPECT_EQ(flight.left, rk.left) << where;
  EXPECT_EQ(flight.accuracy.events, rk.accuracy.events) << where;
  EXPECT_LT((flight.state - rk.state).norm(), 1e-9) << where;
  EXPECT_LT(flight.accuracy.energy_residual, 1e-10) << where;

  const Result unobserved = integrate("exact", law, clearance, frequency, 12, false);
  EXPECT_EQ(unobserved.accuracy.events, flight.accuracy.events) << where;
  EXPECT_LT((unobserved.state - flight.state).norm(), 1e-9) << where;
}

TEST(MethodsAgreeTest, OverASweep) {
  for (const auto &law : std::vector<std::shared_ptr<const ContactLaw>>{
           std::make_shared<LinearPenalty>(20), std::make_shared<KelvinVoigt>(5, 0.4),
           std::make_shared<KelvinVoigtBumper>(10, 1), std::make_shared<KelvinVoigtBumper>(0.5, 1)})
    for (int i = 0; i <= 12; ++i)
      compare(law, 0.4, 0.5 + 0.1 * i);
}

// Rigid stops: impacts, and rest where the force presses long enough. Without losses deviations of
// some of these motions grow by 1e5 in the twelve periods, and only those are left out.
TEST(MethodsAgreeTest, RigidStops) {
  for (const double restitution : {0.0, 0.4, 0.8})
    for (int i = 0; i <= 12; ++i)
      compare(std::make_shared<NewtonRestitution>(restitution), 0.1, 0.3 + 0.1 * i);
}

// The largest displacement in the first twelve periods without stops decides; the clearance is set
// just below and above it.
TEST(MethodsAgreeTest, NearGrazing) {
  class Largest : public Observer {
  public:
    void step(const StepView &view) override {
      value = std::max(value, view.coordinate(0).maximum());
    }
    double value = 0;
  };
  for (const double frequency : {0.7, 0.95, 1.2}) {
    Model model({testing::single_mass("mass", 1, 1, 2 * damping_ratio)});
    model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 0.2, frequency, 0),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    const ContactSet none(std::vector<ContactPair>{});
    Trajectory trajectory(model, none, {});
    Largest largest;
    trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
    trajectory.advance(12 * 2 * std::numbers::pi / frequency, largest);
    const auto law = std::make_shared<LinearPenalty>(20);
    for (const double factor : {1 - 1e-3, 1 - 1e-6, 1 + 1e-7, 1 + 1e-3})
      compare(law, factor * largest.value, frequency);
  }
}

} // namespace methods_agree_tests
} // namespace vibroimpact::motion
