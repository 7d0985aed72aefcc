// Rigid pieces that turn against differences of their kinetic energy.
#include "structure/beam_spin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vibroimpact::structure {
namespace beam_spin_tests {

const Vector3 axis = Vector3(0.3, -0.5, 0.8).normalized();

Eigen::Matrix3d second_moments() {
  Eigen::Matrix3d half;
  half << 0.3, 0.1, -0.2, 0, 0.5, 0.1, 0, 0, 0.4;
  return half * half.transpose();
}

Eigen::Matrix3d rotation(const Vector3 &theta) {
  return theta.isZero(0) ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                         : Eigen::AngleAxisd(theta.norm(), theta.normalized()).toRotationMatrix();
}

/// By differences in two of the components.
double mixed(const std::function<double(const Vector3 &, const Vector3 &)> &energy, int i, int j) {
  constexpr double h = 1e-4;
  double sum = 0;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0})
      sum += a * b * energy(a * h * Vector3::Unit(i), b * h * Vector3::Unit(j));
  return sum / (4 * h * h);
}

TEST(BeamSpin, PieceHasTheSecondOrderOfItsEnergy) {
  const TurningPiece piece = turning_piece(second_moments(), axis);
  const Eigen::Matrix3d a = cross_matrix(axis);
  const auto centrifugal = [&](const Vector3 &theta) {
    const Eigen::Matrix3d moved = a * rotation(theta);
    return (moved * second_moments() * moved.transpose()).trace() / 2;
  };
  constexpr double h = 1e-4;
  // tr(R' P (A R)^T), R' along the rate
  const auto coriolis = [&](const Vector3 &rate, const Vector3 &theta) {
    const Eigen::Matrix3d turned =
        (rotation(theta + h * rate) - rotation(theta - h * rate)) / (2 * h);
    return (turned * second_moments() * (a * rotation(theta)).transpose()).trace();
  };
  for (int i = 0; i < 3; ++i) {
    const Vector3 step = h * Vector3::Unit(i);
    EXPECT_NEAR(piece.load[i], (centrifugal(step) - centrifugal(-step)) / (2 * h), 1e-8);
    for (int j = 0; j < 3; ++j) {
      const double second =
          mixed([&](const Vector3 &x, const Vector3 &y) { return centrifugal(x + y); }, i, j);
      EXPECT_NEAR(piece.centrifugal(i, j), -second, 1e-6);
      EXPECT_NEAR(piece.gyroscopic(i, j), mixed(coriolis, i, j) - mixed(coriolis, j, i), 1e-5);
    }
  }
}

// A round piece about its own axis, from the rotating frame: gyroscopic moment I_p less what the
// turning of the frame itself has, 2 I_d.
TEST(BeamSpin, RoundPieceAboutItsAxis) {
  const TurningPiece piece = turning_piece(Vector3(0, 0.7, 0.7).asDiagonal(), Vector3::UnitX());
  EXPECT_NEAR(piece.gyroscopic(1, 2), 0, 1e-15);
  EXPECT_NEAR(piece.load.norm(), 0, 1e-15);
  EXPECT_NEAR(piece.centrifugal(1, 1), 0.7, 1e-15);
}

} // namespace beam_spin_tests
} // namespace vibroimpact::structure
