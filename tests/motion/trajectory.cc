// Motions with known answers: impacts of single masses, free bodies, and the limits of stiff
// contact.
#include "motion/path/trajectory.h"
#include "common/error.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"
#include "contact/restitution_relation.h"
#include "motion/event/impact_log.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace trajectory_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

struct Outcome {
  std::vector<Impact> impacts;
  Accuracy accuracy;
  Vector state;
};

Outcome integrate(const Model &model, const ContactSet &contacts, const Vector &q, const Vector &v,
                  double duration, const Settings &settings = {}) {
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, q, v);
  trajectory.advance(duration, log);
  return {log.impacts(0), trajectory.accuracy(), trajectory.state()};
}

// m = 100 kg, k = 1e4 N/m at v = 1 m/s onto a stop of 1e6 N/m at clearance 0: while in contact the
// total stiffness is k + kn, so that the contact lasts pi sqrt(m / (k + kn)) exactly.
TEST(TrajectoryTest, SpringMassOnAStop) {
  const Model model({single_mass("block", 100, 1e4, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0, std::make_shared<LinearPenalty>(1e6))});
  const Outcome out = integrate(model, contacts, Vector::Zero(1), Vector::Constant(1, 1.0), 0.05);
  ASSERT_EQ(out.impacts.size(), 1u);
  const double omega = std::sqrt(1.01e6 / 100);
  EXPECT_NEAR(out.impacts[0].peak_force, 1e6 / omega, 1e-7 * 1e4);
  EXPECT_NEAR(out.impacts[0].peak_force, 9950.372, 5e-4);
  EXPECT_NEAR(out.impacts[0].duration, std::numbers::pi / omega, 1e-10);
  EXPECT_NEAR(out.impacts[0].impulse, 198.0198, 5e-5);
  EXPECT_NEAR(out.impacts[0].restitution_coefficient(), 1, 1e-9);
  EXPECT_LT(out.accuracy.energy_residual, 1e-8);
  EXPECT_LT(out.accuracy.event_residual, 1e-11);
}

struct TwoSpheres {
  double mass_a = 0.05;
  double mass_b = 0.12;
  HertzConstants constants{.stiffness = 1.3e10, .exponent = 1.5};
  double speed = 0.3;

  Impact collide(const std::shared_ptr<const ContactLaw> &law,
                 const Settings &settings = {}) const {
    const Model model({single_mass("a", mass_a, 0, 0), single_mass("b", mass_b, 0, 0)});
    const ContactSet contacts({contact_along_x(model, "a.head", "b.head", 1e-4, law)});
    Vector velocity(2);
    velocity << 0.75 * speed, -0.25 * speed;
    const Outcome out = integrate(model, contacts, Vector::Zero(2), velocity, 0.01, settings);
    EXPECT_EQ(out.impacts.size(), 1u);
    EXPECT_LT(out.accuracy.energy_residual, 100 * settings.relative_tolerance);
    return out.impacts.at(0);
  }
  double reduced_mass() const { return mass_a * mass_b / (mass_a + mass_b); }
};

// Energy at the deepest point gives the penetration, the first integral the duration
// 2.9432 delta / v (Goldsmith 1960).
TEST(TrajectoryTest, HertzBetweenTwoFreeSpheres) {
  const TwoSpheres spheres;
  const Impact impact = spheres.collide(std::make_shared<Hertz>(spheres.constants));
  const double depth = std::pow(1.25 * spheres.reduced_mass() * spheres.speed * spheres.speed /
                                    spheres.constants.stiffness,
                                0.4);
  const double factor = 0.8 * boost::math::beta(0.4, 0.5);
  EXPECT_NEAR(factor, 2.9432, 1e-4); // the textbook figure is cut off, not rounded
  EXPECT_NEAR(impact.maximum_penetration, depth, 1e-7 * depth);
  EXPECT_NEAR(impact.peak_force, spheres.constants.stiffness * std::pow(depth, 1.5),
              1e-7 * impact.peak_force);
  EXPECT_NEAR(impact.duration, factor * depth / spheres.speed, 1e-6 * impact.duration);
  EXPECT_NEAR(impact.restitution_coefficient(), 1, 1e-7);
  EXPECT_NEAR(impact.approach_speed, spheres.speed, 1e-9);
}

TEST(TrajectoryTest, HuntCrossleyGivesTheExactRestitutionOfTwoFreeMasses) {
  const TwoSpheres spheres;
  for (const double e : {0.2, 0.5, 0.7, 0.9, 0.99}) {
    const double damping = dimensionless_damping("exact", e);
    const Impact fixed =
        spheres.collide(HuntCrossley::with_dissipation(spheres.constants, damping / spheres.speed));
    EXPECT_NEAR(fixed.restitution_coefficient(), e, 1e-6);
    const Impact own =
        spheres.collide(HuntCrossley::with_dimensionless_damping(spheres.constants, damping, 1e-9));
    EXPECT_NEAR(own.restitution_coefficient(), e, 1e-6);
    const double lost = 0.5 * spheres.reduced_mass() * spheres.speed * spheres.speed * (1 - e * e);
    EXPECT_NEAR(own.dissipated_energy, lost, 1e-6 * lost + 1e-12);
  }
}

// A linear spring between contact and mass: the bodies part at the speed they met; as the penalty
// grows the contact shrinks to Newton's instantaneous impact with restitution 1.
TEST(TrajectoryTest, PenaltyApproachesNewtonsImpact) {
  double previous = 1;
  for (const double stiffness : {1e4, 1e6, 1e8, 1e10}) {
    const Model model({single_mass("block", 1, 10, 0)});
    const ContactSet contacts({contact_along_x(model, "block.head", "", 0.1,
                                               std::make_shared<LinearPenalty>(stiffness))});
    const double duration = 0.25;
    const Outcome out =
        integrate(model, contacts, Vector::Zero(1), Vector::Constant(1, 1.0), duration);
    ASSERT_EQ(out.impacts.size(), 1u);
    const double omega = std::sqrt(10.0);
    const double hit = std::asin(0.1 * omega) / omega;
    // After the rigid impact the mass runs the same way back.
    const double rigid = std::sin(omega * (2 * hit - duration)) / omega;
    const double error = std::abs(out.state[0] - rigid);
    // It leaves later by the duration of the contact, which is shorter than pi sqrt(m/k).
    EXPECT_LT(error, std::numbers::pi / std::sqrt(stiffness));
    EXPECT_LT(error, 0.2 * previous);
    EXPECT_NEAR(out.impacts[0].restitution_coefficient(), 1, 1e-7);
    previous = error;
  }
}

TEST(TrajectoryTest, MethodsAgree) {
  const TwoSpheres spheres;
  const auto law = HuntCrossley::with_dissipation(spheres.constants, 1.0);
  const Impact reference =
      spheres.collide(law, {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-14});
  for (const char *method : {"bdf", "theta", "arkimex"}) {
    const Impact impact = spheres.collide(
        law, {.method = method, .relative_tolerance = 1e-6, .absolute_tolerance = 1e-11});
    EXPECT_NEAR(impact.peak_force, reference.peak_force, 2e-3 * reference.peak_force) << method;
    EXPECT_NEAR(impact.duration, reference.duration, 2e-3 * reference.duration) << method;
    EXPECT_NEAR(impact.restitution_coefficient(), reference.restitution_coefficient(), 2e-3)
        << method;
  }
}

TEST(TrajectoryTest, ErrorFollowsTheTolerance) {
  const TwoSpheres spheres;
  const auto law = std::make_shared<Hertz>(spheres.constants);
  const double depth = std::pow(1.25 * spheres.reduced_mass() * spheres.speed * spheres.speed /
                                    spheres.constants.stiffness,
                                0.4);
  const double exact = 0.8 * boost::math::beta(0.4, 0.5) * depth / spheres.speed;
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    const Impact impact = spheres.collide(
        law, {.relative_tolerance = tolerance, .absolute_tolerance = 1e-3 * tolerance * depth});
    EXPECT_LT(std::abs(impact.duration / exact - 1), 100 * tolerance);
  }
}

// An oscillator that hits a stop once in each cycle, recorded or not, step by step or in flight: as
// many contact changes as it makes are allowed, one less is not.
TEST(TrajectoryTest, StopsAtTheMostContactChanges) {
  const Model model({single_mass("block", 1, 1, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0.5, std::make_shared<LinearPenalty>(10))});
  const auto run = [&](const std::string &method, bool recorded, long most) {
    Settings settings;
    settings.method = method;
    settings.maximum_events = most;
    Trajectory trajectory(model, contacts, settings);
    ImpactLog log(contacts, 0);
    trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 1.0));
    if (recorded)
      trajectory.advance(50, log);
    else
      trajectory.advance(50);
    return trajectory.accuracy().events;
  };
  for (const char *method : {"exact", "rk"})
    for (const bool recorded : {true, false}) {
      const long changes = run(method, recorded, 0);
      EXPECT_GT(changes, 10) << method;
      EXPECT_EQ(run(method, recorded, changes), changes) << method;
      EXPECT_THROW(run(method, recorded, changes - 1), NumericalError) << method;
    }
}

// Harmonic forcing, closed form between impacts: the grazing amplitude of a damped oscillator.
TEST(TrajectoryTest, GrazingAmplitudeDecidesAboutContact) {
  const double omega = 0.8;
  const double grazing = std::sqrt(std::pow(1 - omega * omega, 2) + 0.01 * omega * omega);
  for (const double factor : {0.999999, 1.000001}) {
    Model model({single_mass("block", 1, 1, 0.1)});
    PointReference head;
    model.find_point("block.head", head);
    model.add_force("shaker",
                    std::make_shared<Harmonic>(Given::displacement, factor * grazing, omega, 0),
                    head, Vector3::UnitX());
    const ContactSet contacts(
        {contact_along_x(model, "block.head", "", 1, std::make_shared<LinearPenalty>(1e4))});
    // Start on the steady motion: x = A/R sin(wt - p), R e^{ip} = 1 - w^2 + 0.1 i w.
    const double phase = std::atan2(0.1 * omega, 1 - omega * omega);
    const Outcome out = integrate(model, contacts, Vector::Constant(1, -factor * std::sin(phase)),
                                  Vector::Constant(1, factor * omega * std::cos(phase)),
                                  2 * std::numbers::pi / omega);
    EXPECT_EQ(out.impacts.size(), factor > 1 ? 1u : 0u);
  }
}

TEST(TrajectoryTest, RefusesToStartPenetrated) {
  const Model model({single_mass("block", 1, 1, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0.1, std::make_shared<LinearPenalty>(1e4))});
  Trajectory trajectory(model, contacts, {});
  EXPECT_THROW(trajectory.start(0, Vector::Constant(1, 0.2), Vector::Zero(1)), InputError);
  EXPECT_NO_THROW(trajectory.start(0, Vector::Constant(1, 0.1), Vector::Zero(1)));
}

// A weight at rest on a stop, and let go from just above it: no endless changes, right force.
TEST(TrajectoryTest, RestsInStaticEquilibrium) {
  Model model({single_mass("block", 2, 0, 3)});
  PointReference head;
  model.find_point("block.head", head);
  class Constant : public TimeFunction {
  public:
    double value(double) const override { return 2 * 9.81; }
    double rate(double) const override { return 0; }
    double acceleration(double) const override { return 0; }
    double period() const override { return 0; }
    double highest_frequency() const override { return 0; }
    std::shared_ptr<const TimeFunction> with_frequency(double) const override { return nullptr; }
  };
  model.add_force("weight", std::make_shared<Constant>(), head, Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0, std::make_shared<LinearPenalty>(1e4))});
  const Outcome out = integrate(model, contacts, Vector::Zero(1), Vector::Zero(1), 20);
  EXPECT_NEAR(out.state[0], 2 * 9.81 / 1e4, 1e-9);
}

} // namespace trajectory_tests
} // namespace vibroimpact::motion
