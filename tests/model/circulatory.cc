// Circulatory forces, of damping that turns and of bearings that join two directions, against
// closed forms and another solver.
#include "model/piecewise_function.h"
#include "model/whirl.h"

#include "support/jeffcott.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace vibroimpact::model {
namespace circulatory_tests {

using testing::bearing_at;
using testing::Jeffcott;

/// The vibration that goes round with the spin.
std::complex<double> forward_eigenvalue(const Model &model, const DampedModes &damped) {
  const Vector whirl = whirl_numbers(model, damped.shapes);
  Index forward = 0;
  whirl.maxCoeff(&forward);
  EXPECT_NEAR(whirl[forward], 1, 1e-12);
  return damped.eigenvalues[forward];
}

DampedModes damped_motions(const Model &model) {
  return damped_modes(assembled_modes(model, AssembledSystem(model)));
}

TEST(CirculatoryTest, JeffcottShaftGrowsAboveTheThreshold) {
  const Jeffcott shaft;
  for (const double share : {0.1, 0.5, 0.999, 1.0, 1.001, 3.0}) {
    const double speed = share * shaft.threshold();
    const Model model = shaft.model(SpinSpeed(speed));
    const std::complex<double> found = forward_eigenvalue(model, damped_motions(model));
    EXPECT_LT(std::abs(found - shaft.forward(speed)), 1e-13 * shaft.natural()) << share;
  }
  const Model model = shaft.model(SpinSpeed(shaft.threshold()));
  const std::complex<double> found = forward_eigenvalue(model, damped_motions(model));
  EXPECT_NEAR(found.real(), 0, 1e-13 * shaft.natural());
  EXPECT_NEAR(found.imag(), shaft.natural(), 1e-13 * shaft.natural());
}

TEST(CirculatoryTest, OtherSpeedsAreThoseOfAnotherModel) {
  const Jeffcott shaft;
  const Model model = shaft.model(SpinSpeed(7));
  const AssembledSystem system(model);
  const WhirlingSystem whirling(model, system, 0);
  for (const double speed : {2.0, 7.0, 90.0})
    EXPECT_LT(std::abs(forward_eigenvalue(model, whirling.at(speed)) - shaft.forward(speed)),
              1e-13 * shaft.natural())
        << speed;
  // From rest, where there are no such forces.
  const Model rest = shaft.model(SpinSpeed(0));
  EXPECT_FALSE(rest.has_circulatory_forces());
  const AssembledSystem standing(rest);
  EXPECT_LT(std::abs(forward_eigenvalue(rest, WhirlingSystem(rest, standing, 0).at(90)) -
                     shaft.forward(90)),
            1e-13 * shaft.natural());
}

// In the frame that turns with the shaft its damping is that of any spring.
TEST(CirculatoryTest, RotatingFrameHasNone) {
  reduction::BodyDefinition definition;
  definition.name = "disc";
  definition.type = reduction::BodyDefinition::Type::lumped;
  constexpr double mass = 2, stiffness = 800, speed = 31, retardation = 1e-3;
  definition.masses = {
      {.name = "hub", .mass = mass, .axes = {1, 2}, .mount = {.stiffness = stiffness}}};
  definition.lumped_spin =
      structure::SpinAxis{.rotating_frame = true, .internal_damping = retardation};
  Model model({std::make_shared<reduction::ReducedBody>(reduction::lumped_body(definition))});
  model.add_spin({.name = "shaft", .speed = SpinSpeed(speed), .bodies = {0}});
  EXPECT_FALSE(model.has_circulatory_forces());
  // exp(lambda t) of the fixed frame is exp((lambda - i W) t) there.
  const Jeffcott same{
      .mass = mass, .stiffness = stiffness, .external = 0, .retardation = retardation};
  const std::complex<double> expected = same.forward(speed) - std::complex<double>(0, speed);
  double nearest = 1e9;
  for (const std::complex<double> found : damped_motions(model).eigenvalues)
    nearest =
        std::min({nearest, std::abs(found - expected), std::abs(std::conj(found) - expected)});
  EXPECT_LT(nearest, 1e-12 * same.natural());
}

TEST(CirculatoryTest, DampingLeftOutTakesThemAlong) {
  const Jeffcott shaft;
  Model model = shaft.model(SpinSpeed(40));
  const Matrix whole = model.circulatory();
  EXPECT_EQ(whole(0, 1), -whole(1, 0));
  EXPECT_NEAR(whole(0, 1), 40 * shaft.internal(), 1e-12 * shaft.stiffness);
  model.change_damping(0.25, 0);
  EXPECT_LT((model.circulatory() - 0.25 * whole).norm(), 1e-15 * whole.norm());
  EXPECT_NEAR(model.damping().dense()(0, 0), 0.25 * (shaft.external + shaft.internal()), 1e-14);
  model.change_damping(0, 0);
  EXPECT_FALSE(model.has_circulatory_forces());
  EXPECT_EQ(model.stiffness().dense(), Matrix(shaft.stiffness * Matrix::Identity(2, 2)));
  // Those of a bearing are no losses.
  Eigen::Matrix2d across;
  across << 0, 30, -30, 0;
  model.add_bearing(bearing_at(model, {}, across, Eigen::Matrix2d::Identity()));
  model.change_damping(0, 0);
  EXPECT_EQ(model.circulatory(), Matrix(across));
  EXPECT_TRUE(model.damping().dense().isZero(0));
}

// m l^2 + c l + k = +-i k_c, on a shaft that itself has no damping: unstable where k_c > c w.
TEST(CirculatoryTest, CrossCoupledBearing) {
  Jeffcott shaft{.external = 0, .retardation = 0};
  constexpr double damping = 5;
  const double w = shaft.natural();
  for (const double share : {-2.0, 0.5, 1.0, 1.5}) {
    Model model = shaft.model(SpinSpeed(40));
    const double across = share * damping * w;
    Eigen::Matrix2d stiffness;
    stiffness << 0, across, -across, 0;
    model.add_bearing(bearing_at(model, {}, stiffness, damping * Eigen::Matrix2d::Identity()));
    const std::complex<double> found = forward_eigenvalue(model, damped_motions(model));
    const std::complex<double> k(shaft.stiffness, -across);
    const std::complex<double> root = std::sqrt(damping * damping - 4 * shaft.mass * k);
    const std::complex<double> expected =
        (-damping + (root.imag() > 0 ? root : -root)) / (2 * shaft.mass);
    EXPECT_LT(std::abs(found - expected), 1e-13 * w) << share;
    if (share != 1)
      EXPECT_EQ(found.real() > 0, share > 1) << share;
    else
      EXPECT_LT(std::abs(found - std::complex<double>(0, w)), 1e-13 * w);
  }
}

// Any coefficients, with gyroscopic moments, by another solver.
TEST(CirculatoryTest, RandomBearingsOfAnotherSolver) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    Jeffcott shaft{.external = 1 + uniform(generator), .retardation = 1e-3};
    Model model = shaft.model(SpinSpeed(60 * uniform(generator)));
    const Eigen::Matrix2d stiffness =
        300 * Eigen::Matrix2d::NullaryExpr([&] { return uniform(generator); });
    const Eigen::Matrix2d damping =
        4 * Eigen::Matrix2d::NullaryExpr([&] { return uniform(generator); });
    model.add_bearing(bearing_at(model, {}, stiffness, damping));
    Matrix across = Matrix::Zero(2, 2);
    across(0, 1) = model.spins()[0].speed.at(0) * shaft.internal();
    across(1, 0) = -across(0, 1);
    Matrix state = Matrix::Zero(4, 4);
    state.topRightCorner(2, 2).setIdentity();
    state.bottomLeftCorner(2, 2) =
        -(shaft.stiffness * Matrix::Identity(2, 2) + stiffness + across) / shaft.mass;
    state.bottomRightCorner(2, 2) =
        -((shaft.external + shaft.internal()) * Matrix::Identity(2, 2) + damping) / shaft.mass;
    const Eigen::EigenSolver<Matrix> other(state);
    for (const std::complex<double> found : damped_motions(model).eigenvalues)
      EXPECT_LT((other.eigenvalues().array() - found).abs().minCoeff(), 1e-12 * std::abs(found));
  }
}

// K e of the base that moves pulls at the shaft, with all coefficients.
TEST(CirculatoryTest, BearingOnAMovingBase) {
  const Jeffcott shaft;
  Model model({shaft.disc()});
  Eigen::Matrix2d stiffness, damping;
  stiffness << 1, 2, 3, 4;
  damping << 5, 6, 7, 8;
  model.add_base_motion("shake", make_constant(Given::displacement, 1), {0}, Vector3::UnitY());
  Bearing bearing = bearing_at(model, {}, stiffness, damping);
  for (std::size_t d = 0; d < 2; ++d)
    bearing.elongation[d] = model.displacement(
        {}, d == 0 ? Vector3(Vector3::UnitX()) : Vector3(Vector3::UnitY()), true);
  model.add_bearing(bearing);
  EXPECT_EQ(model.sources()[0].load, Vector(Eigen::Vector2d(-2, -4)));
  EXPECT_EQ(model.sources()[0].rate_load, Vector(Eigen::Vector2d(-6, -8)));
}

} // namespace circulatory_tests
} // namespace vibroimpact::model
