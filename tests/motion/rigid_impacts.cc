// Rigid impacts one by one and several at once, against closed forms; the rigid limit of finite
// laws.
#include "common/error.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace rigid_impacts_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::newton;
using testing::settings_of;
using testing::single_mass;
using testing::vector_of;

double energy(const Trajectory &trajectory) {
  const Vector &x = trajectory.state();
  return trajectory.equations().stored_energy(trajectory.time(),
                                              ConstVectorView(x.data(), x.size()));
}

class RigidImpactsTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, RigidImpactsTest, ::testing::Values("exact", "rk"));

TEST_P(RigidImpactsTest, FreeMassLosesOneMinusESquared) {
  for (const double e : {0.0, 0.3, 1.0}) {
    const double mass = 3, speed = 2, clearance = 0.5;
    const Model model({single_mass("ball", mass, 0, 0)});
    const ContactSet contacts({contact_along_x(model, "ball.head", "", clearance, newton(e))});
    const Settings settings = settings_of(GetParam());
    Trajectory trajectory(model, contacts, settings);
    ImpactLog log(contacts, 0);
    trajectory.start(0, vector_of({0}), vector_of({speed}));
    trajectory.advance(1, log);
    EXPECT_NEAR(trajectory.state()[1], -e * speed, 1e-14) << e;
    EXPECT_NEAR(trajectory.state()[0], clearance - e * speed * 0.75, 1e-12) << e;
    const StateLayout &layout = trajectory.layout();
    EXPECT_NEAR(trajectory.state()[layout.impulse(0)], (1 + e) * mass * speed, 1e-12);
    EXPECT_NEAR(trajectory.state()[layout.contact_work(0)], (1 - e * e) * mass * speed * speed / 2,
                1e-12);
    EXPECT_LT(trajectory.accuracy().energy_residual, 1e-13);
    ASSERT_EQ(log.impacts(0).size(), 1U);
    const Impact &impact = log.impacts(0)[0];
    EXPECT_NEAR(impact.start_time, 0.25, 1e-12);
    EXPECT_EQ(impact.duration, 0);
    EXPECT_NEAR(impact.restitution_coefficient(), e, 1e-13);
    EXPECT_NEAR(impact.impulse, (1 + e) * mass * speed, 1e-12);
    EXPECT_NEAR(impact.dissipated_energy, (1 - e * e) * mass * speed * speed / 2, 1e-12);
  }
}

// A mass on a spring between two stops, never at rest.
TEST_P(RigidImpactsTest, ElasticImpactsConserveEnergy) {
  const Model model({single_mass("block", 2, 50, 0)});
  ContactPair right = contact_along_x(model, "block.head", "", 0.1, newton(1));
  ContactPair left = right;
  left.gap.row *= -1;
  const ContactSet contacts({right, left});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, vector_of({0.03}), vector_of({4}));
  const double initial = energy(trajectory);
  trajectory.advance(20, log);
  EXPECT_GT(log.begun(0), 195U);
  EXPECT_LE(std::abs(static_cast<double>(log.begun(0)) - static_cast<double>(log.begun(1))), 1);
  EXPECT_NEAR(energy(trajectory) / initial, 1, std::string(GetParam()) == "rk" ? 1e-10 : 1e-12);
}

// m q'' + k q = 0 with one stop at q = 0: half a period, an impact, and so on.
TEST_P(RigidImpactsTest, StopAtTheRestPosition) {
  const double omega = 5, e = 0.8, speed = 3;
  const Model model({single_mass("block", 2, 2 * omega * omega, 0)});
  const ContactSet contacts({contact_along_x(model, "block.head", "", 0, newton(e))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, vector_of({0}), vector_of({-speed}));
  trajectory.advance(20.5 * std::numbers::pi / omega, log);
  ASSERT_EQ(log.impacts(0).size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    const auto n = static_cast<double>(i);
    EXPECT_NEAR(log.impacts(0)[i].start_time, (n + 1) * std::numbers::pi / omega, 1e-10);
    EXPECT_NEAR(log.impacts(0)[i].approach_speed, speed * std::pow(e, n), 1e-9);
  }
}

struct Balls {
  Model model;
  ContactSet contacts;
};

// Balls of the given masses along x with gaps between neighbours.
Balls row_of_balls(const std::vector<double> &masses, double gap, double e) {
  std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
  for (std::size_t i = 0; i < masses.size(); ++i)
    bodies.push_back(single_mass("ball" + std::to_string(i), masses[i], 0, 0));
  Balls balls{.model = Model(std::move(bodies)), .contacts = {}};
  std::vector<ContactPair> pairs;
  for (std::size_t i = 0; i + 1 < masses.size(); ++i)
    pairs.push_back(contact_along_x(balls.model, "ball" + std::to_string(i) + ".head",
                                    "ball" + std::to_string(i + 1) + ".head", i == 0 ? 0.01 : gap,
                                    newton(e)));
  balls.contacts = ContactSet(std::move(pairs));
  return balls;
}

Vector velocities_after(const Balls &balls, double time, const std::string &method = "exact") {
  const Settings settings = settings_of(method);
  Trajectory trajectory(balls.model, balls.contacts, settings);
  ImpactLog log(balls.contacts, 0);
  const Index n = balls.model.size();
  trajectory.start(0, Vector::Zero(n), Vector::Unit(n, 0));
  trajectory.advance(time, log);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-12);
  return trajectory.state().segment(n, n);
}

// All contacts at once: the balls that were at rest leave together.
TEST_P(RigidImpactsTest, RowOfEqualBallsThatTouch) {
  const Vector v = velocities_after(row_of_balls({1, 1, 1, 1, 1}, 0, 1), 0.02, GetParam());
  EXPECT_NEAR(v[0], 2.0 / 5 - 1, 1e-13);
  for (Index i = 1; i < 5; ++i)
    EXPECT_NEAR(v[i], 2.0 / 5, 1e-13);
}

// The smallest gap makes it one impact after the other: the last ball takes all.
TEST_P(RigidImpactsTest, RowOfEqualBallsThatAlmostTouch) {
  const Vector v = velocities_after(row_of_balls({1, 1, 1, 1, 1}, 1e-7, 1), 0.02, GetParam());
  for (Index i = 0; i < 4; ++i)
    EXPECT_NEAR(v[i], 0, 1e-13);
  EXPECT_NEAR(v[4], 1, 1e-13);
}

TEST_P(RigidImpactsTest, PlasticRowMovesOnTogether) {
  const Vector v = velocities_after(row_of_balls({1, 2, 3}, 0, 0), 0.5, GetParam());
  for (Index i = 0; i < 3; ++i)
    EXPECT_NEAR(v[i], 1.0 / 6, 1e-13);
}

// One mass meets two others at the same instant; they do not touch each other.
TEST_P(RigidImpactsTest, OneMassHitsTwoAtOnce) {
  const double e = 0.6;
  const Model model({single_mass("hammer", 2, 0, 0), single_mass("light", 1, 0, 0),
                     single_mass("heavy", 5, 0, 0)});
  const ContactSet contacts({contact_along_x(model, "hammer.head", "light.head", 0.01, newton(e)),
                             contact_along_x(model, "hammer.head", "heavy.head", 0.01, newton(e))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(3), vector_of({1, 0, 0}));
  trajectory.advance(0.02, log);
  // Both leave with e relative to the hammer: v + e; momentum 2 = 2 v + 6 (v + e).
  const double v = (2 - 6 * e) / 8;
  EXPECT_NEAR(trajectory.state()[3], v, 1e-13);
  EXPECT_NEAR(trajectory.state()[4], v + e, 1e-13);
  EXPECT_NEAR(trajectory.state()[5], v + e, 1e-13);
  EXPECT_EQ(log.begun(0), 1U);
  EXPECT_EQ(log.begun(1), 1U);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-12);
}

// It fits exactly: the stop it leaves takes no part in the impact on the other one.
TEST_P(RigidImpactsTest, MassThatFillsTheGapBetweenTwoStops) {
  const Model model({single_mass("block", 2, 0, 0)});
  ContactPair right = contact_along_x(model, "block.head", "", 0, newton(0.5));
  ContactPair left = right;
  left.gap.row *= -1;
  const ContactSet contacts({right, left});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, vector_of({0}), vector_of({3}));
  trajectory.advance(1, log);
  // Speeds below the absolute tolerance count as none.
  EXPECT_NEAR(trajectory.state()[0], 0, 1e-12);
  EXPECT_NEAR(trajectory.state()[1], 0, 1e-12);
  EXPECT_NEAR(trajectory.state()[trajectory.layout().contact_work(0)] +
                  trajectory.state()[trajectory.layout().contact_work(1)],
              9, 1e-12);
}

TEST_P(RigidImpactsTest, SqueezedBetweenTwoMassesThatClose) {
  const Model model({single_mass("left", 1, 0, 0), single_mass("middle", 1, 0, 0),
                     single_mass("right", 1, 0, 0)});
  const ContactSet contacts({contact_along_x(model, "left.head", "middle.head", 0.01, newton(1)),
                             contact_along_x(model, "middle.head", "right.head", 0.01, newton(1))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(3), vector_of({1, 0, -1}));
  trajectory.advance(0.02, log);
  EXPECT_NEAR(trajectory.state()[3], -1, 1e-13);
  EXPECT_NEAR(trajectory.state()[4], 0, 1e-13);
  EXPECT_NEAR(trajectory.state()[5], 1, 1e-13);
}

// As the stop becomes stiffer its motion tends to the rigid one, with the time in contact.
Vector state_with(const std::shared_ptr<const ContactLaw> &law) {
  Model model({single_mass("block", 1, 30, 0.2)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 5, 4, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts({contact_along_x(model, "block.head", "", 0.1, law)});
  Trajectory trajectory(model, contacts, {});
  ImpactLog log(contacts, 0);
  trajectory.start(0, vector_of({-0.2}), vector_of({0}));
  trajectory.advance(3, log);
  EXPECT_GE(log.begun(0), 2U);
  return trajectory.state().head(2);
}

void expect_limit(const Vector &rigid, const std::function<Vector(double)> &finite) {
  double previous = 0;
  for (const double stiffness : {1e6, 1e8, 1e10}) {
    const double difference = (finite(stiffness) - rigid).norm();
    if (previous > 0) {
      EXPECT_NEAR(previous / difference, 10, 1.5) << stiffness;
    }
    previous = difference;
  }
  EXPECT_LT(previous, 1e-3);
}

TEST(RigidImpactsTest, LimitOfLinearPenalty) {
  expect_limit(state_with(newton(1)), [](double stiffness) {
    return state_with(std::make_shared<LinearPenalty>(stiffness));
  });
}

TEST(RigidImpactsTest, LimitOfKelvinVoigt) {
  const double e = 0.7;
  const auto defect = [&](double z) {
    return std::exp(-2 * z * std::acos(z) / std::sqrt(1 - z * z)) - e;
  };
  std::uintmax_t iterations = 100;
  const double z = boost::math::tools::toms748_solve(
                       defect, 1e-6, 0.99, boost::math::tools::eps_tolerance<double>(), iterations)
                       .first;
  expect_limit(state_with(newton(e)), [&](double stiffness) {
    return state_with(std::make_shared<KelvinVoigt>(stiffness, 2 * z * std::sqrt(stiffness)));
  });
}

} // namespace rigid_impacts_tests
} // namespace vibroimpact::motion
