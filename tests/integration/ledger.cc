// The energy balance of linear phases, however fast the damping of a contact eats the speed.
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/piecewise_stop.h"
#include "contact/laws/relaxing_stop.h"
#include "integration/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vibroimpact {
namespace {

using testing::contact_along_x;
using testing::single_mass;

class Nobody : public Observer {
public:
  void step(const StepView & /*view*/) override {}
};

Accuracy shaken(const std::shared_ptr<const ContactLaw> &law, double relative_tolerance) {
  Model model({single_mass("block", 1, 100, 0.5)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 20, 7, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts({contact_along_x(model, "block.head", "", 0.05, law)});
  Trajectory trajectory(model, contacts, {.relative_tolerance = relative_tolerance});
  Nobody nobody;
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  trajectory.advance(10 * 2 * std::numbers::pi / 7, nobody);
  return trajectory.accuracy();
}

// Damping ratios of the contact from 0.01 to 1000, at loose and tight tolerances.
TEST(LedgerTest, ClosesHoweverStrongTheDamping) {
  const double stiffness = 1e5;
  for (const double tolerance : {1e-12, 1e-9, 1e-6, 1e-3})
    for (double ratio = 0.01; ratio < 1500; ratio *= 3) {
      const double damping = 2 * ratio * std::sqrt(stiffness);
      for (const auto &law : std::vector<std::shared_ptr<const ContactLaw>>{
               std::make_shared<KelvinVoigt>(stiffness, damping),
               std::make_shared<PiecewiseStop>(stiffness, damping),
               std::make_shared<RelaxingStop>(stiffness, damping)}) {
        const Accuracy accuracy = shaken(law, tolerance);
        EXPECT_GT(accuracy.events, 0);
        EXPECT_LT(accuracy.energy_residual, 1e-10)
            << law->name() << ", damping ratio " << ratio << ", tolerance " << tolerance;
        EXPECT_EQ(accuracy.energy_threshold, 1e-10);
        EXPECT_TRUE(accuracy.balanced());
      }
    }
}

TEST(LedgerTest, ABalanceThatDoesNotCloseIsTold) {
  Accuracy accuracy{.energy_residual = 2e-10, .energy_threshold = 1e-10};
  EXPECT_FALSE(accuracy.balanced());
  accuracy.energy_residual = std::numeric_limits<double>::quiet_NaN(); // nobody watched
  EXPECT_TRUE(accuracy.balanced());
}

} // namespace
} // namespace vibroimpact
