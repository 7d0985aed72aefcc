// A mass on a Kelvin-Voigt stop has a closed form for speed, duration of the force, and loss.
#include "contact/laws/kelvin_voigt.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::contact {
namespace kelvin_voigt_tests {

using namespace motion;
using model::Model;

constexpr double mass = 2;
constexpr double stiffness = 8e4;
constexpr double speed = 0.5;

Impact impact_of_free_mass(double damping_ratio) {
  const double damping = 2 * damping_ratio * std::sqrt(stiffness * mass);
  const Model model({testing::single_mass("block", mass, 0, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "block.head", "", 1e-3, std::make_shared<KelvinVoigt>(stiffness, damping))});
  Trajectory trajectory(model, contacts, Settings{});
  ImpactLog log(contacts, 0);
  testing::GuardWatch guards;
  Observers observers({&log, &guards});
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
  trajectory.advance(0.5, observers);
  EXPECT_EQ(log.impacts(0).size(), 1u);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8);
  return log.impacts(0).at(0);
}

double closed_form(double z) {
  if (z < 1)
    return std::exp(-2 * z * std::acos(z) / std::sqrt(1 - z * z));
  return std::exp(-2 * z * std::acosh(z) / std::sqrt(z * z - 1));
}

TEST(KelvinVoigtTest, AFreeMassLeavesAtTheClosedFormSpeed) {
  for (const double z : {0.0, 0.01, 0.2, 0.7, 0.99, 1.5}) {
    const Impact impact = impact_of_free_mass(z);
    const double e = closed_form(z);
    EXPECT_NEAR(impact.restitution_coefficient(), e, 1e-8) << z;
    EXPECT_NEAR(impact.impulse, mass * speed * (1 + e), 1e-8) << z;
    EXPECT_NEAR(impact.dissipated_energy, 0.5 * mass * speed * speed * (1 - e * e), 1e-8) << z;
  }
}

// The force sets in with the jump c v; with z > 1/2 it only falls from there.
TEST(KelvinVoigtTest, TheForceBeginsWithAJump) {
  const double z = 0.7;
  EXPECT_NEAR(impact_of_free_mass(z).peak_force, 2 * z * std::sqrt(stiffness * mass) * speed, 1e-6);
}

// The force k u + c u' of a mass with speed v at touch: u = v / w_d e^(-z w t) sin(w_d t). Its
// derivative is zero at tan(w_d t) = sqrt(1 - z^2) (1 - 4 z^2) / (z (3 - 4 z^2)) for z < 1/2.
TEST(KelvinVoigtTest, TheInstantOfThePeak) {
  const double w = std::sqrt(stiffness / mass);
  const Model model({testing::single_mass("block", mass, 0, 0)});
  for (const double z : {0.0, 0.1, 0.3, 0.7}) {
    const ContactSet contacts({testing::contact_along_x(
        model, "block.head", "", 1e-3,
        std::make_shared<KelvinVoigt>(stiffness, 2 * z * std::sqrt(stiffness * mass)))});
    Trajectory trajectory(model, contacts, Settings{});
    ImpactLog log(contacts, 0, true);
    trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
    trajectory.advance(0.5, log);
    const double s = std::sqrt(1 - z * z);
    const double after =
        z < 0.5 ? std::atan2(s * (1 - 4 * z * z), z * (3 - 4 * z * z)) / (w * s) : 0;
    EXPECT_NEAR(log.impacts(0).at(0).peak_time, 1e-3 / speed + after, 1e-6 / w) << z;
  }
}

// Half a half sine: 1 - cos of the whole impulse, and all of the energy lost is none.
TEST(KelvinVoigtTest, AnImpactThatLastsIsListedAtTheEndOfTheRecord) {
  const double w = std::sqrt(stiffness / mass);
  const Model model({testing::single_mass("block", mass, 0, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "block.head", "", 1e-3, std::make_shared<KelvinVoigt>(stiffness, 0))});
  Trajectory trajectory(model, contacts, Settings{});
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
  trajectory.advance(1e-3 / speed + 1 / w, log);
  EXPECT_TRUE(log.impacts(0).empty());
  log.end_record(trajectory.time(), trajectory.state(), trajectory.layout());
  ASSERT_EQ(log.impacts(0).size(), 1u);
  const Impact &impact = log.impacts(0)[0];
  EXPECT_FALSE(impact.finished);
  EXPECT_NEAR(impact.duration, 1 / w, 1e-9);
  EXPECT_NEAR(impact.impulse, mass * speed * (1 - std::cos(1.0)), 1e-8);
  EXPECT_NEAR(impact.peak_force, std::sqrt(stiffness * mass) * speed * std::sin(1.0), 1e-6);
  EXPECT_TRUE(std::isnan(impact.restitution_coefficient()));
}

TEST(KelvinVoigtTest, NeverPulls) {
  const KelvinVoigt law(8e4, 200);
  const LawResponse response = testing::response_of(law, {.mode = 2, .gap = -1e-3, .gap_rate = 3});
  EXPECT_EQ(response.force, 0);
  EXPECT_EQ(response.stored_energy, 0);
}

TEST(KelvinVoigtTest, DerivativesPowerAndAffineForm) {
  const KelvinVoigt law(8e4, 200);
  for (const int mode : {0, 1, 2})
    for (const double rate : {-0.3, 0.4})
      testing::check_law(law, {.mode = mode, .gap = mode == 0 ? 1e-3 : -1e-3, .gap_rate = rate});
}

// Three states: a second mass drives the first one back while it still overlaps the stop without
// force. The force comes on again where k u + c u' rises through zero, and all of it is one impact.
TEST(KelvinVoigtTest, ComesOnAgainInsideTheOverlap) {
  const double damping = 1.4 * std::sqrt(stiffness * mass);
  const Model model(
      {testing::single_mass("block", mass, 0, 0), testing::single_mass("hammer", 20, 0, 0)});
  ContactPair stop = testing::contact_along_x(model, "block.head", "", 0,
                                              std::make_shared<KelvinVoigt>(stiffness, damping));
  ContactPair blow = testing::contact_along_x(model, "hammer.head", "block.head", 3.3e-3,
                                              std::make_shared<KelvinVoigt>(1e8, 0));
  const ContactSet contacts({stop, blow});
  Trajectory trajectory(model, contacts, Settings{});
  struct Sequence : Observer {
    std::vector<int> entered;
    std::vector<double> force; ///< that the formula gives at each change
    double damping = 0;
    void event(const ContactEvent &event) override {
      if (event.contact != 0)
        return;
      entered.push_back(event.to);
      force.push_back(-stiffness * event.gap - damping * event.gap_rate);
    }
  } sequence;
  sequence.damping = damping;
  ImpactLog log(contacts, 0);
  Observers observers({&log, &sequence});
  Vector velocity(2);
  velocity << speed, 0.3;
  trajectory.start(0, Vector::Zero(2), velocity);
  trajectory.advance(0.2, observers);
  ASSERT_EQ(sequence.entered, (std::vector<int>{1, 2, 1, 2, 0}));
  for (const std::size_t change : {1, 3})
    EXPECT_NEAR(sequence.force[change], 0, 1e-6);
  EXPECT_GT(sequence.force[2], -1e-6);
  EXPECT_EQ(log.impacts(0).size(), 1u);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-7);
}

} // namespace kelvin_voigt_tests
} // namespace vibroimpact::contact
