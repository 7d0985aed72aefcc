// The energy balance of linear phases, however fast the damping of a contact eats the speed.
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "model/piecewise_function.h"
#include "model/recorded_history.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::motion {
namespace energy_balance_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

class Nobody : public Observer {};

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
TEST(EnergyBalanceTest, ClosesHoweverStrongTheDamping) {
  const double stiffness = 1e5;
  for (const double tolerance : {1e-12, 1e-9, 1e-6, 1e-3})
    for (double ratio = 0.01; ratio < 1500; ratio *= 3) {
      const double damping = 2 * ratio * std::sqrt(stiffness);
      for (const auto &law : std::vector<std::shared_ptr<const ContactLaw>>{
               std::make_shared<KelvinVoigt>(stiffness, damping),
               std::make_shared<BilinearStop>(stiffness, damping),
               std::make_shared<KelvinVoigtBumper>(stiffness, damping)}) {
        const Accuracy accuracy = shaken(law, tolerance);
        EXPECT_GT(accuracy.events, 0);
        EXPECT_LT(accuracy.energy_residual, 1e-10)
            << law->name() << ", damping ratio " << ratio << ", tolerance " << tolerance;
        EXPECT_EQ(accuracy.energy_threshold, 1e-10);
        EXPECT_TRUE(accuracy.balanced());
      }
    }
}

// Two free masses with a dashpot between them: their relative speed v falls with exp(-c t / mu),
// mu = m1 m2 / (m1 + m2), and what it loses of mu v^2 / 2 is the work of the damping.
TEST(EnergyBalanceTest, ADashpotBetweenTwoBodies) {
  Model model({single_mass("a", 2, 0, 0), single_mass("b", 3, 0, 0)});
  Projection elongation = model.displacement({.body = 1, .point = 0}, Vector3::UnitX(), false);
  elongation.row[0] = -1;
  model.add_connection({.name = "dashpot",
                        .side_a = "a.head",
                        .side_b = "b.head",
                        .elongation = elongation,
                        .damping = 0.7});
  const ContactSet none;
  Trajectory trajectory(model, none, Settings{});
  Nobody nobody;
  trajectory.start(0, Vector::Zero(2), Eigen::Vector2d(1, -0.5));
  trajectory.advance(1.5, nobody);
  const double mu = 2 * 3 / 5.0;
  const double lost = mu / 2 * 1.5 * 1.5 * (1 - std::exp(-2 * 0.7 / mu * 1.5));
  EXPECT_NEAR(trajectory.state()[trajectory.layout().damping_work()], lost, 1e-12 * lost);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-12);
}

// A ball under its weight on a stop that recovers ever faster: once that is over it sets neither
// steps nor the parts over which work is integrated.
TEST(EnergyBalanceTest, ADecayThatIsOverSetsNoSteps) {
  const double gravity = 9.81, stiffness = 1e4;
  for (const double recovery : {1e3, 1e5, 1e7, 1e9}) {
    Model model({single_mass("ball", 2, 0, 0)});
    model.add_gravity("weight", make_constant(Given::displacement, gravity), {0}, Vector3::UnitX());
    const ContactSet contacts(
        {contact_along_x(model, "ball.head", "", 0.3,
                         std::make_shared<KelvinVoigtBumper>(stiffness, stiffness / recovery))});
    Trajectory trajectory(model, contacts, Settings{});
    Nobody nobody;
    trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
    trajectory.advance(3, nobody);
    EXPECT_GT(trajectory.accuracy().events, 10) << recovery;
    EXPECT_LT(trajectory.accuracy().steps, 2000) << recovery;
    EXPECT_LT(trajectory.accuracy().energy_residual, 1e-12) << recovery;
  }
}

// Cubic polynomials of which the third derivative is h^-3 times the force: the response without the
// free vibration is (e h)^-3 = 300 to 15 000 times the motion. The state is rounded to that many
// times epsilon where the polynomial changes; the energies, in which it counts squared, must not
// be.
TEST(EnergyBalanceTest, ClosesUnderARecordThatIsFasterThanTheModes) {
  for (const double interval : {0.15, 0.08, 0.04}) {
    Samples force;
    for (int k = 0; k <= 1000; ++k) {
      force.time.push_back(interval * k);
      force.value.push_back(std::sin(0.7 * k) + std::cos(1.1 * k * k));
    }
    Model model({single_mass("block", 1, 1, 0.1)});
    model.add_force(
        "force",
        make_recorded(Given::displacement, force, Interpolation::cubic_spline, OutsideRecord::zero),
        {.body = 0, .point = 0}, Vector3::UnitX());
    const ContactSet none;
    Trajectory trajectory(model, none, Settings{});
    Nobody nobody;
    trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
    trajectory.advance(900 * interval, nobody);
    EXPECT_LT(trajectory.accuracy().energy_residual,
              8 * std::numeric_limits<double>::epsilon() / std::pow(interval, 3))
        << interval;
  }
}

// Steps with an error of the tolerance may leave a thousand times that.
TEST(EnergyBalanceTest, ThresholdFollowsTheToleranceWhereStepsAreNotExact) {
  const Model model({single_mass("block", 1, 100, 0.5)});
  const ContactSet none;
  const auto threshold = [&](const Settings &settings) {
    Trajectory trajectory(model, none, settings);
    Nobody nobody;
    trajectory.start(0, Vector::Constant(1, 0.1), Vector::Zero(1));
    trajectory.advance(0.1, nobody);
    return trajectory.accuracy().energy_threshold;
  };
  EXPECT_DOUBLE_EQ(threshold({.method = "rk", .relative_tolerance = 1e-7}), 1e-4);
  EXPECT_DOUBLE_EQ(threshold({.method = "rk", .relative_tolerance = 1e-14}), 1e-10);
  EXPECT_DOUBLE_EQ(threshold({.relative_tolerance = 1e-7}), 1e-10);
}

TEST(EnergyBalanceTest, ABalanceThatDoesNotCloseIsReported) {
  Accuracy accuracy{.energy_residual = 2e-10, .energy_threshold = 1e-10};
  EXPECT_FALSE(accuracy.balanced());
  accuracy.energy_residual = std::numeric_limits<double>::quiet_NaN(); // not observed
  EXPECT_TRUE(accuracy.balanced());
}

} // namespace energy_balance_tests
} // namespace vibroimpact::motion
