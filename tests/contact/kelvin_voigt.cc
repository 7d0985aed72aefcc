// A mass on a Kelvin-Voigt stop has a closed form for speed, duration of the force, and loss.
#include "contact/laws/kelvin_voigt.h"
#include "integration/impact_log.h"
#include "integration/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact {
namespace {

Impact impact_of_free_mass(double damping_ratio) {
  const double mass = 2, stiffness = 8e4, speed = 0.5;
  const double damping = 2 * damping_ratio * std::sqrt(stiffness * mass);
  const Model model({testing::single_mass("block", mass, 0, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "block.head", "", 1e-3, std::make_shared<KelvinVoigt>(stiffness, damping))});
  Trajectory trajectory(model, contacts, IntegrationSettings{});
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
  trajectory.advance(0.5, log);
  EXPECT_EQ(log.impacts(0).size(), 1u);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8);
  return log.impacts(0).at(0);
}

TEST(KelvinVoigtTest, AFreeMassLeavesAtTheClosedFormSpeed) {
  for (const double z : {0.0, 0.01, 0.2, 0.7, 0.99}) {
    const Impact impact = impact_of_free_mass(z);
    const double e = std::exp(-2 * z * std::acos(z) / std::sqrt(1 - z * z));
    EXPECT_NEAR(impact.restitution_coefficient(), e, 1e-8);
    EXPECT_NEAR(impact.impulse, 2 * 0.5 * (1 + e), 1e-8);
    EXPECT_NEAR(impact.dissipated_energy, 0.25 * (1 - e * e), 1e-8);
  }
}

TEST(KelvinVoigtTest, NeverPulls) {
  const KelvinVoigt law(8e4, 200);
  LawResponse response;
  law.evaluate(2, {.gap = -1e-3, .gap_rate = 3}, response);
  EXPECT_EQ(response.force, 0);
  EXPECT_DOUBLE_EQ(response.dissipated_power, 8e4 * 1e-3 * 3);
}

// The force and its derivatives against central differences.
TEST(KelvinVoigtTest, DerivativesAreThoseOfTheForce) {
  const KelvinVoigt law(8e4, 200);
  const auto force = [&](double gap, double gap_rate) {
    LawResponse response;
    law.evaluate(1, {.gap = gap, .gap_rate = gap_rate}, response);
    return response.force;
  };
  LawResponse response;
  law.evaluate(1, {.gap = -1e-3, .gap_rate = -0.1}, response);
  EXPECT_NEAR(response.force_by_gap, (force(-9e-4, -0.1) - force(-1.1e-3, -0.1)) / 2e-4, 1e-5);
  EXPECT_NEAR(response.force_by_gap_rate, (force(-1e-3, 0) - force(-1e-3, -0.2)) / 0.2, 1e-8);
}

} // namespace
} // namespace vibroimpact
