// A stop with a compression of its own: pushed in, let go, hit again before it has recovered.
#include "contact/laws/kelvin_voigt_bumper.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "motion/system/equilibrium.h"
#include "support/law_checks.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vibroimpact::contact {
namespace kelvin_voigt_bumper_tests {

using namespace motion;
using namespace model;

constexpr double mass = 2;
constexpr double stiffness = 8e4;
constexpr double speed = 0.5;

TEST(KelvinVoigtBumperTest, AFreeMassLeavesLikeFromKelvinVoigtAndTheStopRecovers) {
  for (const double x : {0.05, 0.4, 0.9}) {
    const double damping = 2 * x * std::sqrt(stiffness * mass);
    const Model model({testing::single_mass("block", mass, 0, 0)});
    const ContactSet contacts({testing::contact_along_x(
        model, "block.head", "", 1e-3, std::make_shared<KelvinVoigtBumper>(stiffness, damping))});
    Trajectory trajectory(model, contacts, Settings{});
    ImpactLog log(contacts, 0);
    testing::GuardWatch guards;
    Observers observers({&log, &guards});
    trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
    trajectory.advance(0.04, observers);
    ASSERT_EQ(log.impacts(0).size(), 1u) << x;
    EXPECT_EQ(trajectory.accuracy().events, 2) << x;
    const Impact &impact = log.impacts(0)[0];
    const double root = std::sqrt(1 - x * x);
    const double e = std::exp(-2 * x * std::acos(x) / root);
    const double frequency = std::sqrt(stiffness / mass);
    EXPECT_NEAR(impact.restitution_coefficient(), e, 1e-8) << x;
    EXPECT_NEAR(impact.duration, 2 * std::acos(x) / (frequency * root), 1e-9) << x;
    // At release k z = c e v; from there the compression decays at the rate k / c.
    const double left = 0.04 - impact.start_time - impact.duration;
    EXPECT_NEAR(trajectory.state()[2],
                damping * e * speed / stiffness * std::exp(-stiffness / damping * left), 1e-11);
    EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8) << x;
  }
}

// The stop is still pushed in when the mass returns: contact begins where gap + z is zero.
TEST(KelvinVoigtBumperTest, IsHitAgainBeforeItHasRecovered) {
  const double damping = 4e4; // recovers with 0.5 s
  const Model model({testing::single_mass("block", mass, 400, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "block.head", "", 0, std::make_shared<KelvinVoigtBumper>(stiffness, damping))});
  Trajectory trajectory(model, contacts, Settings{});
  struct Touches : Observer {
    std::vector<double> distance, compression;
    void event(const ContactEvent &event) override {
      if (event.to != 1)
        return;
      compression.push_back((*event.state)[2]);
      distance.push_back(event.gap + compression.back());
    }
  } touches;
  testing::GuardWatch guards;
  Observers observers({&touches, &guards});
  trajectory.start(0, Vector::Constant(1, -0.1), Vector::Zero(1));
  trajectory.advance(3, observers);
  ASSERT_GE(touches.distance.size(), 3u);
  EXPECT_GT(touches.compression[1], 1e-5);
  for (const double distance : touches.distance)
    EXPECT_NEAR(distance, 0, 1e-11);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-8);
}

// At the release, force zero, the end of the stop has the speed v of the mass and recovers with
// exp(-t/tau), tau = c/k; a push against the stop slows the mass by a. With s = t/tau the distance
// between them is tau v (s - b s^2 / 2 - 1 + exp(-s)), b = a tau / v: for b = 0.9 the stop catches
// up a mass that still moves away.
TEST(KelvinVoigtBumperTest, CatchesUpAMassThatStillMovesAway) {
  constexpr double compression = 0.5, k = 100, c = 10, tau = c / k, v = compression / tau;
  const double push = 0.9 * v / tau;
  double before = 0.1;
  double after = 1;
  for (int i = 0; i < 60; ++i) {
    const double s = (before + after) / 2;
    (s - 0.45 * s * s - 1 + std::exp(-s) > 0 ? before : after) = s;
  }
  Model model({testing::single_mass("block", 1, 0, 0)});
  model.add_force("push", make_constant(Given::displacement, push), {}, Vector3::UnitX());
  const ContactSet contacts({testing::contact_along_x(model, "block.head", "", 0,
                                                      std::make_shared<KelvinVoigtBumper>(k, c))});
  Trajectory trajectory(model, contacts, Settings{});
  testing::Events events;
  trajectory.start({.time = 0, .physical = Vector3(compression, -v, compression)});
  trajectory.advance(0.9 * tau, events);
  const auto meeting = std::find_if(events.list.begin(), events.list.end(),
                                    [](const auto &event) { return event.to == 1; });
  ASSERT_NE(meeting, events.list.end());
  EXPECT_NEAR(meeting->time, tau * before, 1e-9 * tau);
  EXPECT_NEAR(meeting->gap_rate, v * (1 - 0.9 * before), 1e-9 * v);
  EXPECT_GT(meeting->gap_rate, 0.5 * v);
}

TEST(KelvinVoigtBumperTest, DerivativesPowerAndAffineForm) {
  const KelvinVoigtBumper law(8e4, 200);
  for (const int mode : {0, 1, 2})
    for (const double rate : {-0.3, 0.4})
      testing::check_law(law, {.mode = mode, .gap = -1e-3, .gap_rate = rate, .internal = {1.5e-3}});
}

// Where a motion goes on: in contact, just let go, and away from the stop.
TEST(KelvinVoigtBumperTest, InitialModes) {
  const KelvinVoigtBumper law(8e4, 200);
  const auto mode = [&law](double gap, double rate, double compression) {
    const std::vector<double> internal = {compression};
    return law.initial_mode({.gap = gap, .gap_rate = rate, .internal = internal});
  };
  EXPECT_EQ(mode(-1e-3, 0.1, 1e-3 * (1 + 1e-15)), 1);
  EXPECT_EQ(mode(-1e-3, 0.5, 1e-3 * (1 + 1e-15)), 2); // 80 N of the spring, -100 N of the dashpot
  EXPECT_EQ(mode(-0.5e-3, -0.1, 1e-3), 0);
  EXPECT_EQ(mode(0, 0, 0), 0);
  EXPECT_EQ(mode(-1e-3, 0, 0), 0); // the guard takes it over:
  const std::vector<double> fresh = {0.0};
  const SettledMode settled = settle(law, {.gap = -1e-3, .gap_rate = 0, .internal = fresh});
  EXPECT_EQ(settled.mode, 1);
  EXPECT_EQ(settled.internal, std::vector<double>{1e-3});
}

// Pressed against the stop from the start: at rest where spring and stop balance, z is the overlap.
TEST(KelvinVoigtBumperTest, PressedFromTheStart) {
  const Model model({testing::single_mass("block", mass, 2e4, 0)});
  ContactPair pair = testing::contact_along_x(model, "block.head", "", -1e-3,
                                              std::make_shared<KelvinVoigtBumper>(stiffness, 200));
  pair.accept_initial_penetration = true;
  const ContactSet contacts({pair});
  Trajectory trajectory(model, contacts, Settings{});
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Constant(1, -0.8e-3), Vector::Zero(1));
  trajectory.advance(0.1, log);
  EXPECT_NEAR(trajectory.state()[0], -0.8e-3, 1e-12);
  EXPECT_NEAR(trajectory.state()[2], 0.2e-3, 1e-12);
  EXPECT_TRUE(log.impacts(0).empty());
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

// A load presses the mass into the stop: 2e4 q + 8e4 (q - 1 mm) = 60 N.
TEST(KelvinVoigtBumperTest, CarriesAStaticLoad) {
  const Model model({testing::single_mass("block", mass, 2e4, 0)});
  const ContactSet contacts({testing::contact_along_x(
      model, "block.head", "", 1e-3, std::make_shared<KelvinVoigtBumper>(stiffness, 200))});
  const Equilibrium found = static_equilibrium(model, contacts, Vector::Constant(1, 60.0));
  EXPECT_NEAR(found.displacement[0], 1.4e-3, 1e-15);
}

TEST(KelvinVoigtBumperTest, NamesItsState) {
  const KelvinVoigtBumper law(8e4, 200);
  ASSERT_EQ(law.internal_states().size(), 1u);
  EXPECT_EQ(law.internal_states()[0].name, "stop_deformation");
  EXPECT_EQ(law.internal_states()[0].unit, "m");
}

} // namespace kelvin_voigt_bumper_tests
} // namespace vibroimpact::contact
