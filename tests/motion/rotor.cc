// Unbalanced rotors: conservation laws, the unbalance response, the motor, and the derivatives.
#include "model/piecewise_function.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/rotor_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace rotor_tests {

using namespace model;
using contact::ContactSet;
using testing::plane_mass;
using testing::put_rotor;
using testing::rotation;

class Silent : public Observer {};

// Free base_coefficients and free rotor: momentum of the common centre, moment of momentum and
// energy stay.
TEST(RotorTest, FreeRotorKeepsMomentumAndEnergy) {
  const double base_coefficients = 3, mass = 2, eccentricity = 0.25, inertia = 0.4;
  Model model({plane_mass("frame", base_coefficients, 0, 0), rotation("disc", inertia)});
  put_rotor(model, 1, "frame.head", mass, eccentricity);
  const ContactSet contacts;
  Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-11});
  const Vector q = Eigen::Vector3d(0.1, -0.2, 0.7);
  const Vector v = Eigen::Vector3d(1.5, -0.4, 9);
  const auto centre_velocity = [&](const Vector &x) {
    const double phi = x[2], speed = x[5];
    return Eigen::Vector2d(x[3] - eccentricity * speed * std::sin(phi),
                           x[4] + eccentricity * speed * std::cos(phi));
  };
  const auto momentum = [&](const Vector &x) {
    return Eigen::Vector2d(base_coefficients * x.segment(3, 2) + mass * centre_velocity(x));
  };
  const auto moment = [&](const Vector &x) {
    const Eigen::Vector2d centre(x[0] + eccentricity * std::cos(x[2]),
                                 x[1] + eccentricity * std::sin(x[2]));
    const Eigen::Vector2d u = centre_velocity(x);
    return base_coefficients * (x[0] * x[4] - x[1] * x[3]) +
           mass * (centre[0] * u[1] - centre[1] * u[0]) + inertia * x[5];
  };
  trajectory.start(0, q, v);
  const Vector before = trajectory.state();
  Silent observer;
  trajectory.advance(3, observer);
  const Vector after = trajectory.state();
  EXPECT_TRUE(momentum(after).isApprox(momentum(before), 1e-9));
  EXPECT_NEAR(moment(after), moment(before), 1e-9 * std::abs(moment(before)));
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-9);
  EXPECT_GT(std::abs(after[3] - before[3]), 0.01); // the base_coefficients is really shaken
}

// Gravity takes base_coefficients and rotor alike, in both directions of its plane, and turns
// nothing.
TEST(RotorTest, FreeRotorFallsWithItsCarrier) {
  Model model({plane_mass("frame", 3, 0, 0), rotation("disc", 0.4)});
  const Eigen::Vector2d gravity(6, -8);
  model.add_gravity("weight", make_constant(Given::displacement, 10), {0, 1},
                    Vector3(0.6, -0.8, 0));
  put_rotor(model, 1, "frame.head", 2, 0.25);
  const ContactSet contacts;
  Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-10});
  trajectory.start(0, Eigen::Vector3d(0, 0, 0.7), Vector::Zero(3));
  Silent observer;
  trajectory.advance(0.5, observer);
  EXPECT_TRUE(trajectory.state().head(2).isApprox(gravity * 0.5 * 0.5 / 2, 1e-9));
  EXPECT_NEAR(trajectory.state()[2], 0.7, 1e-10);
}

// A rotor too heavy to be slowed shakes its base_coefficients with m e w^2: amplitude
// m e w^2 / sqrt((k - (M + m) w^2)^2 + (c w)^2) in each direction.
TEST(RotorTest, UnbalanceResponse) {
  const double base_coefficients = 3, mass = 2, eccentricity = 0.01, k = 800, c = 60, w = 15;
  Model model({plane_mass("frame", base_coefficients, k, c), rotation("disc", 1e9)});
  put_rotor(model, 1, "frame.head", mass, eccentricity);
  const ContactSet contacts;
  Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-10});
  trajectory.start(0, Vector::Zero(3), Eigen::Vector3d(0, 0, w));
  Silent observer;
  trajectory.advance(40 * 2 * std::numbers::pi / w, observer);
  const double radius = trajectory.state().head(2).norm();
  const double expected =
      mass * eccentricity * w * w / std::hypot(k - (base_coefficients + mass) * w * w, c * w);
  EXPECT_NEAR(radius, expected, 1e-7 * expected);
}

// Without eccentricity the motor alone: tau M' + M = M_Z - k_M w, J w' = M, a linear system whose
// speed from rest follows in closed form.
TEST(RotorTest, MotorRunsUp) {
  const double inertia = 5, start = 100, slope = 8, tau = 0.1;
  Model model({plane_mass("frame", 1, 1, 0), rotation("disc", inertia)});
  put_rotor(model, 1, "frame.head", 1, 0,
            Motor{.starting_torque = start, .slope = slope, .time_constant = tau});
  const ContactSet contacts;
  Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-11});
  trajectory.start(0, Vector::Zero(3), Vector::Zero(3));
  Silent observer;
  const double t = 0.37;
  trajectory.advance(t, observer);
  // w'' + w'/tau + slope/(J tau) w = start/(J tau)
  const double a = 1 / (2 * tau);
  const double d = std::sqrt(std::complex<double>(a * a - slope / (inertia * tau))).real();
  const double final_speed = start / slope;
  const double speed =
      final_speed * (1 - std::exp(-a * t) * (std::cosh(d * t) + a / d * std::sinh(d * t)));
  EXPECT_NEAR(trajectory.state()[5], speed, 1e-9 * speed);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-9);
}

TEST(RotorTest, JacobianIsTheDerivativeOfTheRates) {
  Model model({plane_mass("frame", 3, 50, 2), rotation("disc", 0.4), rotation("fan", 0.2)});
  model.add_base_motion("ground", std::make_shared<Harmonic>(Given::displacement, 0.1, 3, 0.3), {0},
                        Vector3::UnitY());
  put_rotor(model, 1, "frame.head", 2, 0.25,
            Motor{.starting_torque = 10, .slope = 2, .time_constant = 0.2});
  put_rotor(model, 2, "frame.head", 1, 0.1);
  model.add_connection(
      {.name = "spring",
       .side_a = "frame.head",
       .side_b = "ground",
       .elongation = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), true),
       .cubic_stiffness = 40});
  const ContactSet contacts;
  const Equations equations(model, contacts);
  const Index size = equations.layout().size();
  const Index physical = equations.layout().physical_size();
  ASSERT_EQ(physical, 9);
  Vector x = Vector::Zero(size);
  x.head(physical) << 0.2, -0.1, 0.6, 2.1, 0.7, -0.4, 5, -3, 1.5;
  Matrix jacobian;
  const double time = 0.4;
  equations.jacobian(time, ConstVectorView(x.data(), size), jacobian);
  const auto rates = [&](const Vector &state) {
    Vector result(size);
    equations.rates(time, ConstVectorView(state.data(), size), VectorView(result.data(), size));
    return result;
  };
  const double h = 1e-6;
  for (Index j = 0; j < physical; ++j) {
    Vector up = x, down = x;
    up[j] += h;
    down[j] -= h;
    const Vector slope = ((rates(up) - rates(down)) / (2 * h)).head(physical);
    EXPECT_LT((jacobian.col(j).head(physical) - slope).cwiseAbs().maxCoeff(), 1e-7)
        << "column " << j;
  }
}

} // namespace rotor_tests
} // namespace vibroimpact::motion
