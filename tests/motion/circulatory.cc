// Motions of shafts that turn at a constant speed: what gyroscopic and circulatory forces put in
// and take out, against closed forms and by every method.
#include "motion/path/trajectory.h"

#include "motion/system/equations.h"
#include "motion/system/equilibrium.h"
#include "support/circular_contacts.h"
#include "support/jeffcott.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vibroimpact::motion {
namespace circulatory_tests {

using model::Model;
using model::SpinSpeed;
using testing::bearing_at;
using testing::Jeffcott;

Settings settings_of(const std::string &method) {
  Settings settings;
  settings.method = method;
  settings.relative_tolerance = 1e-12;
  return settings;
}

/// A stop that is never reached: without any contact there is nothing for moments.
contact::ContactSet far_stop(const Model &model, const std::string &method) {
  if (method != "moments")
    return {};
  contact::ContactPair pair = testing::contact_along_x(
      model, "disc.hub", "", 1e3, std::make_shared<contact::LinearPenalty>(1.0));
  return contact::ContactSet({pair});
}

/// z(0) = a, in the shape that goes round with the shaft: the motion is a exp(lambda t).
void start_in_whirl(Trajectory &trajectory, double a, std::complex<double> lambda) {
  trajectory.start(0, Eigen::Vector2d(a, 0), a * Eigen::Vector2d(lambda.real(), lambda.imag()));
}

// Below, at and above the threshold. Power Re(conj(z') i W c_i z) = W c_i Im(lambda) |z|^2.
TEST(CirculatoryMotionTest, WhirlOfAJeffcottShaftAndItsWork) {
  const Jeffcott shaft;
  constexpr double a = 0.01, end = 1.7;
  for (const double share : {0.4, 1.0, 2.5})
    for (const std::string method : {"exact", "moments", "rk"}) {
      const double speed = share * shaft.threshold();
      const Model model = shaft.model(SpinSpeed(speed));
      const std::complex<double> lambda = shaft.forward(speed);
      const contact::ContactSet contacts = far_stop(model, method);
      Trajectory trajectory(model, contacts, settings_of(method));
      Observer nobody;
      start_in_whirl(trajectory, a, lambda);
      trajectory.advance(end, nobody);
      const std::complex<double> z = a * std::exp(lambda * end);
      const double accuracy = method == "rk" ? 1e-8 : 1e-10; // errors of its steps add up
      const Vector &state = trajectory.state();
      const double size = std::max(a, std::abs(z));
      EXPECT_NEAR(state[0], z.real(), accuracy * size) << method << " " << share;
      EXPECT_NEAR(state[1], z.imag(), accuracy * size) << method << " " << share;
      const double growth = 2 * lambda.real() * end;
      const double of_squares = a * a * end * (growth == 0 ? 1 : std::expm1(growth) / growth);
      const double work = speed * shaft.internal() * lambda.imag() * of_squares;
      const double lost = (shaft.internal() + shaft.external) * std::norm(lambda) * of_squares;
      const StateLayout &layout = trajectory.layout();
      EXPECT_NEAR(state[layout.input_work()], work, accuracy * work) << method << " " << share;
      EXPECT_NEAR(state[layout.damping_work()], lost, accuracy * lost) << method << " " << share;
      EXPECT_TRUE(trajectory.accuracy().balanced()) << method << " " << share;
    }
}

// The same along a run-up, where the forces change in time, against steps at a tighter tolerance.
TEST(CirculatoryMotionTest, RunUpThroughTheThreshold) {
  const Jeffcott shaft;
  const double threshold = shaft.threshold();
  const Model model = shaft.model(SpinSpeed(0.5 * threshold, 1.5 * threshold, 0.2, 1));
  EXPECT_TRUE(model.has_circulatory_forces());
  const contact::ContactSet none;
  const auto state_at_end = [&](double tolerance, double &residual) {
    Settings settings;
    settings.relative_tolerance = tolerance;
    Trajectory trajectory(model, none, settings);
    Observer nobody;
    trajectory.start(0, Eigen::Vector2d(0.01, 0), Eigen::Vector2d(0, 0.2));
    trajectory.advance(1.6, nobody);
    residual = trajectory.accuracy().energy_residual;
    return Vector(trajectory.state().head(4));
  };
  double coarse_residual = 0, fine_residual = 0;
  const Vector coarse = state_at_end(1e-8, coarse_residual);
  const Vector fine = state_at_end(1e-12, fine_residual);
  EXPECT_LT((coarse - fine).norm(), 1e-6 * fine.norm());
  EXPECT_LT(fine_residual, 1e-11);
  // z'' + (c/m) z' + (w^2 - i W(t) c_i / m) z = 0 by Runge and Kutta's method of order four.
  using State = std::array<std::complex<double>, 2>;
  const SpinSpeed &speed = model.spins()[0].speed;
  const auto rate = [&](double time, const State &x) -> State {
    const std::complex<double> k(shaft.stiffness, -speed.at(time) * shaft.internal());
    return {x[1], -(k * x[0] + (shaft.external + shaft.internal()) * x[1]) / shaft.mass};
  };
  State x = {0.01, std::complex<double>(0, 0.2)};
  constexpr int steps = 16000;
  constexpr double h = 1.6 / steps;
  const auto moved = [](const State &at, const State &by, double part) -> State {
    return {at[0] + part * by[0], at[1] + part * by[1]};
  };
  for (int i = 0; i < steps; ++i) {
    const State a = rate(i * h, x), b = rate((i + 0.5) * h, moved(x, a, h / 2)),
                c = rate((i + 0.5) * h, moved(x, b, h / 2)),
                d = rate((i + 1.0) * h, moved(x, c, h));
    for (std::size_t k = 0; k < 2; ++k)
      x[k] += h / 6 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
  }
  EXPECT_NEAR(fine[0], x[0].real(), 1e-9 * std::abs(x[0]));
  EXPECT_NEAR(fine[1], x[0].imag(), 1e-9 * std::abs(x[0]));
}

// Gyroscopic moments and Coriolis forces do no work: a disc without losses keeps its energy, and
// with an unbalance gains its work alone.
TEST(CirculatoryMotionTest, BalanceAtAConstantSpeed) {
  for (const bool rotating : {false, true})
    for (const std::string method : {"exact", "rk"}) {
      reduction::BodyDefinition definition;
      definition.name = "disc";
      definition.type = reduction::BodyDefinition::Type::lumped;
      if (rotating)
        definition.masses = {{.name = "hub", .mass = 3, .axes = {1, 2}, .mount = {900, 0}}};
      else
        definition.masses = {{.name = "hub",
                              .mass = 3,
                              .axes = {1, 2, 4, 5},
                              .mount = {900, 0},
                              .inertia = Vector3(0.7, 0.4, 0.4),
                              .rotational_mount = {250, 0}}};
      definition.lumped_spin = structure::SpinAxis{.rotating_frame = rotating};
      Model model({std::make_shared<reduction::ReducedBody>(reduction::lumped_body(definition))});
      model.add_spin({.name = "shaft", .speed = SpinSpeed(11), .bodies = {0}});
      const contact::ContactSet none;
      const Index n = model.size();
      Trajectory trajectory(model, none, settings_of(method));
      Observer nobody;
      Vector displacement = Vector::Constant(n, 0.02), velocity = Vector::LinSpaced(n, -1, 2);
      trajectory.start(0, displacement, velocity);
      const double before = (velocity.cwiseAbs2().dot(model.mass()) +
                             displacement.dot(model.stiffness().dense() * displacement)) /
                            2;
      trajectory.advance(20, nobody);
      const Vector &state = trajectory.state();
      const double after = (state.segment(n, n).cwiseAbs2().dot(model.mass()) +
                            state.head(n).dot(model.stiffness().dense() * state.head(n))) /
                           2;
      EXPECT_NEAR(after, before, 1e-8 * before) << rotating << " " << method;
      EXPECT_NEAR(state[trajectory.layout().damping_work()], 0, 1e-12 * before) << method;
      // The other loses energy at each of its many steps.
      EXPECT_TRUE(method != "exact" || trajectory.accuracy().balanced()) << rotating;
    }
}

// Above the threshold the shaft whirls in a ring of stiffness k_r, at c_i W / (c_e + c_i) = v,
// where the work of the circulatory forces is that of all dashpots, and
//
//   m v^2 = k + k_r (1 - c / r)
TEST(CirculatoryMotionTest, WhirlEndsInTheRingAsALimitCycle) {
  const Jeffcott shaft;
  constexpr double ring = 4000, clearance = 1e-3;
  const double rate = 1.5 * shaft.natural();
  const Model model =
      shaft.model(SpinSpeed(rate * (shaft.internal() + shaft.external) / shaft.internal()));
  const double pull = shaft.mass * rate * rate - shaft.stiffness;
  const double radius = ring * clearance / (ring - pull);
  const contact::ContactSet contacts({testing::ring_about_z(
      model, "disc.hub", "", clearance, std::make_shared<contact::LinearPenalty>(ring))});
  for (const double start : {0.01 * radius, radius}) {
    Trajectory trajectory(model, contacts, settings_of("exact"));
    Observer nobody;
    trajectory.start(0, Eigen::Vector2d(start, 0), Eigen::Vector2d(0, start * rate));
    trajectory.advance(40, nobody);
    const Vector &state = trajectory.state();
    EXPECT_NEAR(state.head(2).norm(), radius, 1e-9 * radius) << start;
    EXPECT_NEAR(state.segment(2, 2).norm(), radius * rate, 1e-9 * radius * rate) << start;
    EXPECT_GT(state[0] * state[3] - state[1] * state[2], 0) << start;
    EXPECT_LT(trajectory.accuracy().energy_residual, trajectory.accuracy().energy_threshold);
  }
}

// What implicit methods see, by differences: rates are linear in the state, powers quadratic.
TEST(CirculatoryMotionTest, JacobianOfRatesAndOfTheWork) {
  const Jeffcott shaft;
  Eigen::Matrix2d stiffness;
  stiffness << 100, 300, -200, 50;
  Model model = shaft.model(SpinSpeed(70));
  model.add_bearing(bearing_at(model, {}, stiffness, Eigen::Matrix2d::Identity()));
  const contact::ContactSet none;
  const Equations equations(model, none);
  const Index n = equations.layout().size(), work = equations.layout().input_work();
  Vector x = Vector::Zero(n);
  x.head(4) << 0.3, -0.2, 1.7, 0.9;
  Matrix jacobian;
  equations.jacobian(0, ConstVectorView(x.data(), n), jacobian);
  for (Index j = 0; j < 4; ++j) {
    const auto rates = [&](double step) {
      Vector at = x, result(n);
      at[j] += step;
      equations.rates(0, ConstVectorView(at.data(), n), VectorView(result.data(), n));
      return result;
    };
    const Vector slope = (rates(0.5) - rates(-0.5)).eval();
    EXPECT_LT((jacobian.col(j) - slope).head(4).norm(), 1e-12 * slope.norm()) << j;
    EXPECT_NEAR(jacobian(work, j), slope[work], 1e-12 * slope.norm()) << j;
  }
}

TEST(CirculatoryMotionTest, CrossCoupledFilmTurnsTheEquilibrium) {
  // (k, k_c; -k_c, k) u = f of a weight.
  const Jeffcott shaft{.external = 3, .retardation = 0};
  Model model = shaft.model(SpinSpeed(40));
  Eigen::Matrix2d stiffness;
  stiffness << 100, 300, -200, 50;
  model.add_bearing(bearing_at(model, {}, stiffness, Eigen::Matrix2d::Zero()));
  const Eigen::Vector2d weight(0, -20);
  const Equilibrium found = static_equilibrium(model, {}, weight);
  const Eigen::Matrix2d whole = shaft.stiffness * Eigen::Matrix2d::Identity() + stiffness;
  EXPECT_LT((found.displacement - whole.inverse() * weight).norm(), 1e-14);
}

} // namespace circulatory_tests
} // namespace vibroimpact::motion
