// Rigid pieces that turn against differences of their kinetic energy; shafts in circular whirl
// against closed forms.
#include "structure/beam_spin.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

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

/// Simply supported, along x; local y and z are those of the frame.
struct Shaft {
  double length = 0.6, diameter = 0.1, young_modulus = 2e11, density = 7800;
  double second_moment() const { return std::numbers::pi * std::pow(diameter, 4) / 64; }
  double area() const { return std::numbers::pi * diameter * diameter / 4; }
  /// (k r)^2 / 4 of the half-wave, by which rotary inertia counts.
  double slenderness() const {
    return std::pow(std::numbers::pi / length, 2) * second_moment() / area();
  }
  double rest() const { ///< of a beam without rotary inertia [rad/s]
    return std::pow(std::numbers::pi / length, 2) *
           std::sqrt(young_modulus * second_moment() / (density * area()));
  }
  BeamProperties properties() const {
    const double bending = young_modulus * second_moment();
    return {.axial_stiffness = young_modulus * area(),
            .torsional_stiffness = bending / 1.3,
            .bending_stiffness_y = bending,
            .bending_stiffness_z = bending,
            .mass_per_length = density * area(),
            .polar_inertia = 2 * density * second_moment(),
            .rotary_inertia_y = density * second_moment(),
            .rotary_inertia_z = density * second_moment()};
  }
};

/// The half-wave that goes round from y to z: v = sin k x, w = -i sin k x, and their slopes.
using WhirlShape = Eigen::Matrix<std::complex<double>, 12, 1>;
WhirlShape forward_whirl(const Shaft &shaft, double start, double length) {
  constexpr std::complex<double> i(0, 1);
  const double k = std::numbers::pi / shaft.length;
  WhirlShape shape = WhirlShape::Zero();
  for (const int end : {0, 6}) {
    const double x = end == 0 ? start : start + length;
    shape[end + 1] = std::sin(k * x);
    shape[end + 2] = -i * std::sin(k * x);
    shape[end + 4] = i * k * std::cos(k * x);
    shape[end + 5] = k * std::cos(k * x);
  }
  return shape;
}

/// q^H (matrix) q of the whole shaft.
struct WhirlSums {
  std::complex<double> mass = 0, stiffness = 0, gyroscopic = 0, circulatory = 0;
};
WhirlSums sums_of_whirl(const Shaft &shaft, int elements, double direction) {
  const double length = shaft.length / elements;
  const PropertiesAlong properties = [&](double /*along*/) { return shaft.properties(); };
  const BeamMatrices beam = beam_matrices(properties, length, {});
  const BeamSpin spin = beam_spin(properties, length, {}, {.axis = direction * Vector3::UnitX()});
  const ElementMatrix stiffness =
      deformation_matrix(length).transpose() * beam.stiffness * deformation_matrix(length);
  WhirlSums sums;
  for (int e = 0; e < elements; ++e) {
    const WhirlShape q = forward_whirl(shaft, e * length, length);
    const auto form = [&](const ElementMatrix &matrix) -> std::complex<double> {
      return q.dot(matrix.cast<std::complex<double>>() * q);
    };
    sums.mass += form(beam.mass);
    sums.stiffness += form(stiffness);
    sums.gyroscopic += form(spin.gyroscopic);
    sums.circulatory += form(spin.circulatory);
  }
  return sums;
}

/// Frequency of q exp(i w t), from -w^2 M + i w W G + K; the negative one whirls backward.
double whirl_frequency(const WhirlSums &sums, double speed, double sign) {
  const double m = sums.mass.real(), k = sums.stiffness.real();
  const double g = speed * (std::complex<double>(0, 1) * sums.gyroscopic).real();
  return (g + sign * std::sqrt(g * g + 4 * m * k)) / (2 * m);
}

/// w^2 (1 + b) - 2 b W w - w0^2 = 0 of a shaft with rotary inertia: forward whirl is the faster.
double exact_whirl(const Shaft &shaft, double speed, double sign) {
  const double b = shaft.slenderness();
  return (b * speed +
          sign * std::sqrt(b * b * speed * speed + (1 + b) * std::pow(shaft.rest(), 2))) /
         (1 + b);
}

// In the shape of the half-wave, so that the direction of the whirl is given.
TEST(BeamSpin, ForwardWhirlRisesWithTheSpeedAsTheQuadraticHasIt) {
  const Shaft shaft;
  constexpr double speed = 9000;
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> errors;
    for (const int elements : {8, 16}) {
      const WhirlSums sums = sums_of_whirl(shaft, elements, 1);
      errors.push_back(
          std::abs(whirl_frequency(sums, speed, sign) / exact_whirl(shaft, speed, sign) - 1));
      EXPECT_GT(whirl_frequency(sums, speed, sign), whirl_frequency(sums, 0, sign));
      EXPECT_GT(exact_whirl(shaft, speed, sign) - exact_whirl(shaft, 0, sign),
                1e3 * errors.back() * shaft.rest());
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 3.7);
    EXPECT_LT(std::log2(errors[0] / errors[1]), 4.3);
  }
  const WhirlSums along = sums_of_whirl(shaft, 8, 1), against = sums_of_whirl(shaft, 8, -1);
  EXPECT_EQ(along.gyroscopic, -against.gyroscopic);
}

// A circle that turns with the shaft does not strain it: R q = i q, and so q^H K R q = i q^H K q.
TEST(BeamSpin, StrainRateOfAWhirlVanishesWhereItTurnsWithTheShaft) {
  const Shaft shaft;
  for (const double direction : {1.0, -1.0}) {
    const WhirlSums sums = sums_of_whirl(shaft, 3, direction);
    const double size = sums.stiffness.real();
    EXPECT_NEAR(sums.circulatory.real(), 0, 1e-14 * size);
    EXPECT_NEAR(sums.circulatory.imag(), -direction * size, 1e-14 * size);
  }
  const PropertiesAlong properties = [&](double /*along*/) { return shaft.properties(); };
  const BeamSpin spin = beam_spin(properties, 0.2, {}, {.axis = Vector3::UnitX()});
  // Neither a stretch nor a twist is turned into anything.
  for (const int row : {0, 3, 6, 9})
    EXPECT_EQ(spin.circulatory.row(row).norm(), 0);
}

} // namespace beam_spin_tests
} // namespace vibroimpact::structure
