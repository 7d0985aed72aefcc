// Rest on rigid contacts as a constraint of larger systems: linear phases stay exact, nonlinear
// ones keep it too.
#include "motion/event/collision.h"
#include "motion/system/linear_system.h"
#include "support/rigid_contacts.h"
#include "support/rotor_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace resting_systems_tests {

using namespace model;
using contact::ContactSet;
using testing::add_weight;
using testing::contact_along_x;
using testing::Events;
using testing::newton;
using testing::settings_of;
using testing::single_mass;
using testing::vector_of;

class RestingSystemsTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, RestingSystemsTest, ::testing::Values("exact", "rk"));

void join(Model &model, double stiffness, double cubic = 0) {
  Projection elongation = model.displacement({.body = 1, .point = 0}, Vector3::UnitX(), false);
  elongation.row -= model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false).row;
  model.add_connection({.name = "spring",
                        .side_a = "held.head",
                        .side_b = "free.head",
                        .elongation = elongation,
                        .stiffness = stiffness,
                        .cubic_stiffness = cubic});
}

// The first mass is pressed on a stop, the second one swings on the spring between them.
TEST_P(RestingSystemsTest, NeighbourSwingsOnAHeldMass) {
  const double mass = 3, stiffness = 200, joint = 1000, load = 50, amplitude = 0.03;
  Model model({single_mass("held", 2, 0, 0), single_mass("free", mass, stiffness, 0)});
  model.add_force("load", make_constant(Given::displacement, load), {.body = 0, .point = 0},
                  Vector3::UnitX());
  join(model, joint);
  const ContactSet contacts({contact_along_x(model, "held.head", "", 0, newton(0.5))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, vector_of({0, amplitude}), vector_of({0, 0}));
  trajectory.advance(20, events);
  EXPECT_TRUE(events.list.empty());
  const double omega = std::sqrt((stiffness + joint) / mass);
  const bool exact = std::string(GetParam()) == "exact";
  const double tolerance = exact ? 1e-13 : 1e-8;
  EXPECT_NEAR(trajectory.state()[0], 0, tolerance);
  EXPECT_NEAR(trajectory.state()[1], amplitude * std::cos(omega * 20), tolerance);
  EXPECT_NEAR(trajectory.state()[trajectory.layout().impulse(0)],
              load * 20 + joint * amplitude * std::sin(omega * 20) / omega, 10 * tolerance);
  EXPECT_LT(trajectory.accuracy().energy_residual, exact ? 1e-13 : 1e-8);
}

// The projected system of a structure that is held has all its eigenvectors.
TEST(RestingSystemsTest, HeldSystemIsDiagonalizable) {
  Model model({single_mass("held", 2, 500, 1), single_mass("free", 3, 200, 0.4)});
  join(model, 1000);
  const ContactSet contacts({contact_along_x(model, "held.head", "", 0, newton(0.5))});
  Equations equations(model, contacts);
  equations.set_mode(0, 1);
  const LinearSystem system(equations);
  const ModalForm form(system.matrix());
  const double omega = std::sqrt(1200.0 / 3);
  bool found = false;
  for (const ModalBlock &block : form.blocks()) {
    EXPECT_NE(block.kind, BlockKind::dense);
    found = found || (block.kind == BlockKind::pair &&
                      std::abs(std::abs(block.exponent) - omega) < 1e-11 * omega);
  }
  EXPECT_TRUE(found);
  // Its force presses as much as the spring and the stop's own do.
  const Vector y = vector_of({0, 0.1, 0, 0});
  ASSERT_EQ(system.constraint_forces().constants.size(), 1);
  EXPECT_NEAR(system.constraint_forces().rows.row(0).head(4).dot(y), 100, 1e-11);
}

// Three modes of a body with one point; a constant force presses the point on a stop. It comes to
// rest bent: phi . q = clearance with q = K^-1 phi (f - F).
TEST_P(RestingSystemsTest, ModalBodySettlesOnAStop) {
  auto body = std::make_shared<reduction::ReducedBody>();
  const Vector phi = vector_of({1.1, -1.3, 1.2});
  const Vector omega = vector_of({12, 75, 210});
  body->name = "beam";
  body->type = "beam";
  body->mass = Vector::Ones(3);
  body->stiffness = omega.cwiseAbs2();
  body->damping = (2 * 0.08 * omega).asDiagonal();
  body->base_participation = Matrix::Zero(3, 3);
  body->total_mass = Vector3::Ones();
  Matrix rows = Matrix::Zero(6, 3);
  rows.row(0) = phi;
  body->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
  Model model({body});
  const double load = 30, clearance = 0.1;
  model.add_force("load", make_constant(Given::displacement, load), {.body = 0, .point = 0},
                  Vector3::UnitX());
  const ContactSet contacts({contact_along_x(model, "beam.head", "", clearance, newton(0.7))});
  const Settings settings = settings_of(GetParam());
  Trajectory trajectory(model, contacts, settings);
  Events events;
  trajectory.start(0, Vector::Zero(3), Vector::Zero(3));
  trajectory.advance(30, events);
  EXPECT_GE(events.list.size(), 5U);
  const Vector flexibility = phi.cwiseQuotient(body->stiffness);
  const double force = load - clearance / flexibility.dot(phi);
  EXPECT_GT(force, 0);
  EXPECT_LT((trajectory.state().head(3) - flexibility * (load - force)).norm(), 1e-10);
  const Vector before = trajectory.state();
  trajectory.advance(31, events);
  const Index impulse = trajectory.layout().impulse(0);
  EXPECT_NEAR(trajectory.state()[impulse] - before[impulse], force, 1e-9 * force);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

// With a cubic spring the force that holds is no linear form of the state.
TEST(RestingSystemsTest, CubicSpringPullsAHeldMassOff) {
  const double cubic = 4e4, load = 20;
  Model model({single_mass("held", 2, 0, 0), single_mass("free", 3, 900, 0)});
  model.add_force("load", make_constant(Given::displacement, load), {.body = 0, .point = 0},
                  Vector3::UnitX());
  join(model, 0, cubic);
  const ContactSet contacts({contact_along_x(model, "held.head", "", 0, newton(0.5))});
  class Watch : public Observer {
  public:
    explicit Watch(double load, double cubic) : load_(load), cubic_(cubic) {}
    void step(const StepView &view) override {
      if (!view.equations().mode(0).holds_gap)
        return;
      for (const double tau : {0.0, 0.3, 1.0}) {
        const double q = view.coordinate(1)(tau);
        EXPECT_NEAR(view.force(0, tau), load_ + cubic_ * q * q * q, 1e-6);
      }
      ++steps;
    }
    int steps = 0;

  private:
    double load_, cubic_;
  } watch(load, cubic);
  Events events;
  Observers observers({&watch, &events});
  Trajectory trajectory(model, contacts, {});
  trajectory.start(0, vector_of({0, 0.1}), vector_of({0, 0}));
  trajectory.advance(2, observers);
  EXPECT_GT(watch.steps, 10);
  ASSERT_FALSE(events.list.empty());
  EXPECT_EQ(events.list[0].from, 1); // it was held until the spring pulled with the load
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-7);
}

// An unbalanced rotor lifts its casing off the ground: its mass takes part in every impact.
TEST(RestingSystemsTest, RotorJumpsOnTheGround) {
  Model model({testing::plane_mass("casing", 5, 100, 2), testing::rotation("rotor", 0.02)});
  add_weight(model, 9.81, {0});
  testing::put_rotor(model, 1, "casing.head", 1, 0.05);
  const ContactSet contacts({contact_along_x(model, "casing.head", "", 0, newton(0.4))});
  Trajectory trajectory(model, contacts, {});
  ImpactLog log(contacts, 0);
  Events events;
  Observers observers({&log, &events});
  Vector velocity = Vector::Zero(3);
  velocity[2] = 45; // m e w^2 = 101 N against a weight of 59 N
  trajectory.start(0, Vector::Zero(3), velocity);
  trajectory.advance(2, observers);
  EXPECT_GT(log.begun(0), 3U);
  EXPECT_GT(trajectory.state()[trajectory.layout().contact_work(0)], 0.1);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-7);
}

// A body comes to the floor, and at the same instant another one to its top, by 1e-9 m/s faster.
// Only the body at rest gives that chatter an end, after 2 u / (g (1 - e)) with u = e 1e-9 m/s: it
// is completed with the impact.
TEST(RestingSystemsTest, AChatterThatARestMakesPossible) {
  const double gravity = 9.81, restitution = 0.5, faster = 1e-9;
  Model model({single_mass("lower", 1, 0, 0), single_mass("upper", 1, 0, 0)});
  add_weight(model, gravity, {0, 1});
  const ContactSet contacts(
      {contact_along_x(model, "lower.head", "", 1, newton(0)),
       contact_along_x(model, "upper.head", "lower.head", 0, newton(restitution))});
  const Settings settings;
  Equations equations(model, contacts);
  Vector state = Vector::Zero(equations.layout().size());
  state[0] = state[1] = 1;
  state[equations.layout().velocity()] = 1;
  state[equations.layout().velocity() + 1] = 1 + faster;
  ContactScales scales(equations, settings);
  scales.begin(0, state);
  Collisions collisions(equations, settings, scales);
  const Collisions::Outcome outcome =
      collisions.resolve(0, settings.event_tolerance, 0, false, state);
  EXPECT_EQ(outcome.record.modes_after, (std::vector<int>{1, 1}));
  ASSERT_EQ(outcome.changes.size(), 2U);
  const double expected = 2 * restitution * faster / (gravity * (1 - restitution));
  EXPECT_NEAR(outcome.changes[1].chatter_duration, expected, 1e-6 * expected);
}

} // namespace resting_systems_tests
} // namespace vibroimpact::motion
