// Gyroscopic systems against closed forms and an independent dense solver.
#include "model/whirl.h"

#include "model/spin_speed.h"
#include "model/turning_component.h"
#include "reduction/lumped_body.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

namespace vibroimpact::model {
namespace whirl_tests {

using reduction::BodyDefinition;

constexpr double disc_mass = 3, diametral = 0.4, polar = 0.7;

/// Displacements y, z and rotations ry, rz of a disc that spins about x.
std::shared_ptr<const reduction::ReducedBody> disc() {
  BodyDefinition definition;
  definition.name = "disc";
  definition.type = BodyDefinition::Type::lumped;
  definition.masses = {{.name = "hub",
                        .mass = disc_mass,
                        .axes = {1, 2, 4, 5},
                        .inertia = Vector3(polar, diametral, diametral)}};
  definition.lumped_spin = structure::SpinAxis{};
  return std::make_shared<reduction::ReducedBody>(reduction::lumped_body(definition));
}

void add_spring(Model &model, const RowVector &row, double stiffness, double damping = 0) {
  model.add_connection({.name = "spring",
                        .side_a = "disc.hub",
                        .side_b = "ground",
                        .elongation = {.row = row, .base_coefficients = {}},
                        .stiffness = stiffness,
                        .damping = damping});
}

// A clamped shaft without mass: 12 EI / l^3 w^2 / 2 and so on, as two springs in each plane. In the
// x-y plane the slope is rz, in the x-z plane -ry.
constexpr double shaft_stiffness = 900, shaft_length = 0.8;

Model overhung_disc(double speed) {
  Model model({disc()});
  model.add_spin({.name = "shaft", .speed = SpinSpeed(speed), .bodies = {0}});
  const double k = shaft_stiffness / std::pow(shaft_length, 3), l = shaft_length;
  RowVector row(4);
  for (const double sign : {-1.0, 1.0}) {
    const bool xy = sign > 0;
    // 12 (w - l s / 2)^2 + l^2 s^2, s the slope
    row << (xy ? 1.0 : 0.0), (xy ? 0.0 : 1.0), (xy ? 0 : l / 2), (xy ? -l / 2 : 0);
    add_spring(model, row, 12 * k);
    row << 0, 0, (xy ? 0 : l), (xy ? l : 0);
    add_spring(model, row, k);
  }
  return model;
}

// With w = exp(i lambda t) in the complex plane: (k11 - m l^2)(k22 - J l^2 + I W l) = k12^2.
// Positive roots whirl forward, negative ones backward.
double overhung_determinant(double lambda, double speed) {
  const double k = shaft_stiffness / std::pow(shaft_length, 3), l = shaft_length;
  const double k11 = 12 * k, k12 = -6 * k * l, k22 = 4 * k * l * l;
  return (k11 - disc_mass * lambda * lambda) *
             (k22 - diametral * lambda * lambda + polar * speed * lambda) -
         k12 * k12;
}

// Only they are in the damping matrix here.
TEST(WhirlTest, GyroscopicForcesStayWhereDampingIsLeftOut) {
  Model model = overhung_disc(60);
  const Matrix gyroscopic = model.damping().dense();
  model.change_damping(0, 0);
  EXPECT_GT(gyroscopic.norm(), 0);
  EXPECT_EQ(model.damping().dense(), gyroscopic);
}

TEST(WhirlTest, OverhungDiscOnShaftWithoutMass) {
  for (const double speed : {5.0, 60.0, -60.0}) {
    const Model model = overhung_disc(speed);
    const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
    EXPECT_FALSE(modes.modal_damping);
    const DampedModes damped = damped_modes(modes);
    ASSERT_EQ(damped.eigenvalues.size(), 4);
    const Vector whirl = whirl_numbers(model, damped.shapes);
    int forward = 0;
    for (Index j = 0; j < 4; ++j) {
      EXPECT_NEAR(std::abs(whirl[j]), 1, 1e-12);
      forward += whirl[j] > 0;
      const double lambda = damped.eigenvalues[j].imag() * (whirl[j] > 0 ? 1 : -1);
      const double scale = std::abs(overhung_determinant(0, speed));
      // Newton's step is the error of the root.
      const double slope = (overhung_determinant(lambda * (1 + 1e-7), std::abs(speed)) -
                            overhung_determinant(lambda * (1 - 1e-7), std::abs(speed))) /
                           (2e-7 * lambda);
      EXPECT_LT(std::abs(overhung_determinant(lambda, std::abs(speed)) / slope),
                1e-11 * std::abs(lambda))
          << speed << " " << scale;
    }
    EXPECT_EQ(forward, 2);
  }
}

TEST(WhirlTest, OtherSpeedsAreThoseOfAnotherModel) {
  const Model model = overhung_disc(20);
  const AssembledSystem system(model);
  const WhirlingSystem whirling(model, system, 0);
  for (const double speed : {0.0, 20.0, 55.0}) {
    const Model other = overhung_disc(speed);
    const DampedModes expected = damped_modes(assembled_modes(other, AssembledSystem(other)));
    const DampedModes damped = whirling.at(speed);
    for (Index j = 0; j < 4; ++j)
      EXPECT_NEAR(damped.eigenvalues[j].imag(), expected.eigenvalues[j].imag(),
                  1e-11 * expected.eigenvalues[j].imag());
  }
}

// Bearings that are stiff and damped differently in both directions, and joined across.
TEST(WhirlTest, RandomAsymmetricSystemsOfAnotherSolver) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0.2, 2);
  for (int trial = 0; trial < 20; ++trial) {
    Model model({disc()});
    model.add_spin({.name = "shaft", .speed = SpinSpeed(40 * uniform(generator)), .bodies = {0}});
    for (int k = 0; k < 6; ++k)
      add_spring(model, RowVector::Random(4), 500 * uniform(generator), uniform(generator));
    Matrix a = Matrix::Zero(8, 8), b = Matrix::Identity(8, 8);
    a.topRightCorner(4, 4).setIdentity();
    a.bottomLeftCorner(4, 4) = -model.stiffness().dense();
    Matrix damping = Matrix::Zero(4, 4);
    for (const Connection &spring : model.connections())
      damping += spring.damping * spring.elongation.row.transpose() * spring.elongation.row;
    damping(2, 3) += polar * model.spins()[0].speed.at(0);
    damping(3, 2) -= polar * model.spins()[0].speed.at(0);
    a.bottomRightCorner(4, 4) = -damping;
    b.bottomRightCorner(4, 4) = model.mass().asDiagonal();
    const Eigen::GeneralizedEigenSolver<Matrix> other(a, b);
    const DampedModes damped = damped_modes(assembled_modes(model, AssembledSystem(model)));
    for (Index j = 0; j < damped.eigenvalues.size(); ++j) {
      const std::complex<double> lambda = damped.eigenvalues[j];
      EXPECT_LT((other.eigenvalues().array() - lambda).abs().minCoeff(), 1e-11 * std::abs(lambda));
      EXPECT_LT(std::abs(whirl_numbers(model, damped.shapes)[j]), 1 + 1e-12);
    }
  }
}

// A mass on equal springs has the frequency w0 in the fixed frame: in a frame that turns |w0 +- W|.
TEST(WhirlTest, MassInRotatingFrame) {
  BodyDefinition definition;
  definition.name = "disc";
  definition.type = BodyDefinition::Type::lumped;
  constexpr double mass = 2, stiffness = 50, speed = 1.7;
  definition.masses = {{.name = "hub",
                        .mass = mass,
                        .axes = {0, 1},
                        .mount = {.stiffness = stiffness},
                        .position = Vector3(0.3, 0, 7)}};
  definition.lumped_spin =
      structure::SpinAxis{.direction = Vector3::UnitZ(), .rotating_frame = true};
  Model model({std::make_shared<reduction::ReducedBody>(reduction::lumped_body(definition))});
  model.add_spin({.name = "hub", .speed = SpinSpeed(speed), .bodies = {0}});
  const DampedModes damped = damped_modes(assembled_modes(model, AssembledSystem(model)));
  const double rest = std::sqrt(stiffness / mass);
  EXPECT_NEAR(damped.eigenvalues[0].imag(), rest - speed, 1e-13);
  EXPECT_NEAR(damped.eigenvalues[1].imag(), rest + speed, 1e-13);
  // k x = m W^2 (r + x)
  const Vector load = model.static_load();
  EXPECT_NEAR(load[0], mass * speed * speed * 0.3, 1e-15);
  EXPECT_NEAR(model.stiffness().dense()(0, 0), stiffness - mass * speed * speed, 1e-14);
}

// s'' against differences of s' and s' against those of s; the ramp joins smoothly.
TEST(WhirlTest, TurningComponentsDifferentiate) {
  const SpinSpeed ramp(3, 11, 0.5, 2);
  const TurningComponent component(ramp, 0.4);
  constexpr double h = 1e-5;
  for (const double t : {0.2, 0.5 + 2 * h, 1.3, 2.4, 3.1}) {
    EXPECT_NEAR(component.rate(t), (component.value(t + h) - component.value(t - h)) / (2 * h),
                1e-7);
    EXPECT_NEAR(component.acceleration(t),
                (component.rate(t + h) - component.rate(t - h)) / (2 * h), 1e-6);
  }
  EXPECT_EQ(component.next_break(0), 0.5);
  EXPECT_EQ(component.next_break(0.5), 2.5);
  EXPECT_NEAR(ramp.angle(2.5), 3 * 0.5 + 7 * 2, 1e-14);
  ASSERT_TRUE(component.exponential_form(2.6));
  EXPECT_FALSE(component.exponential_form(1));
  EXPECT_NEAR(component.exponential_form(2.6)->value(2.9), component.value(2.9), 1e-13);
}

} // namespace whirl_tests
} // namespace vibroimpact::model
