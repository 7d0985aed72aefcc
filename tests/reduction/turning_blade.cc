// Blades in the rotating frame against published frequencies of rotating cantilevers and Ritz's
// method, and axial forces that change along a member against a column under its own weight.
#include "common/decompositions.h"
#include "common/error.h"
#include "reduction/beam_bodies.h"
#include "reduction/reduce.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace turning_blade_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

/// Bends along x alone, free to stretch along z, clamped at a hub of no radius. The axis is x for
/// bending out of the plane of rotation (flap), y for bending in it.
BeamDefinition blade(int elements, const Vector3 &axis) {
  BeamDefinition beam = thin_beam(elements);
  beam.supports.push_back({"plane", {"all", {}}, {false, true, false, true, false, true}, {}});
  clamp_start(beam);
  beam.spin = structure::SpinAxis{.direction = axis, .rotating_frame = true};
  return beam;
}

/// Of the stiffness alone, without Coriolis forces, rising, per frequency_scale().
Vector frequencies(const BeamDefinition &beam, const ReducedBody &body, double eta) {
  const double speed = eta * frequency_scale(beam);
  Matrix stiffness = body.stiffness.asDiagonal();
  stiffness += speed * speed * body.spin.centrifugal;
  return symmetric_eigen(stiffness).values.array().sqrt() / frequency_scale(beam);
}

/// Of p'' + G p' + diag(squared) p = 0, rising.
Vector coupled_frequencies(const Vector &squared, const Matrix &gyroscopic) {
  const Index n = squared.size();
  Matrix state = Matrix::Zero(2 * n, 2 * n);
  state.topRightCorner(n, n).diagonal() = squared.cwiseSqrt();
  state.bottomLeftCorner(n, n).diagonal() = -squared.cwiseSqrt();
  state.bottomRightCorner(n, n) = -gyroscopic;
  std::vector<double> list;
  for (const std::complex<double> lambda : eigenvalues(state))
    if (lambda.imag() > 0)
      list.push_back(lambda.imag());
  std::sort(list.begin(), list.end());
  return Eigen::Map<const Vector>(list.data(), static_cast<Index>(list.size()));
}

struct Published {
  double eta;
  std::array<double, 3> flap;
};

/// Wright et al. 1982, hub radius 0.
constexpr std::array published = {
    Published{0, {3.5160, 22.0345, 61.6972}}, Published{1, {3.6816, 22.1810, 61.8418}},
    Published{5, {6.4495, 25.4461, 65.2050}}, Published{10, {11.2023, 33.6404, 74.6493}},
    Published{12, {13.1702, 37.6031, 79.6145}}};

} // namespace

TEST(TurningBlade, FlapHasThePublishedFrequencies) {
  const BeamDefinition beam = blade(60, Vector3::UnitX()); // (beta h)^4 / 1440 is 2e-7
  const ReducedBody body = reduced(beam, 24);
  for (const Published &row : published) {
    const Vector found = frequencies(beam, body, row.eta);
    for (Index j = 0; j < 3; ++j)
      EXPECT_NEAR(found[j], row.flap[static_cast<std::size_t>(j)], 6e-5) << row.eta << " " << j;
  }
}

// In the plane of rotation the square of the speed is taken off.
TEST(TurningBlade, ChordwiseIsSofterByTheSquareOfTheSpeed) {
  const BeamDefinition beam = blade(20, Vector3::UnitX());
  const ReducedBody flap = reduced(beam, 12);
  const ReducedBody chord = reduced(blade(20, Vector3::UnitY()), 12);
  for (const double eta : {1.0, 5.0, 12.0}) {
    const Vector out_of_plane = frequencies(beam, flap, eta);
    const Vector in_plane = frequencies(beam, chord, eta);
    for (Index j = 0; j < 3; ++j)
      EXPECT_NEAR(in_plane[j] * in_plane[j], out_of_plane[j] * out_of_plane[j] - eta * eta,
                  1e-8 * out_of_plane[j] * out_of_plane[j]);
  }
}

TEST(TurningBlade, ConvergesWithOrderFour) {
  const auto second = [](int elements, int modes) {
    const BeamDefinition beam = blade(elements, Vector3::UnitX());
    return frequencies(beam, reduced(beam, modes), 6)[1];
  };
  const double fine = second(64, 20);
  EXPECT_GT(std::log2(std::abs((second(6, 11) - fine) / (second(12, 20) - fine))), 3.6);
}

// A mass m at the tip of a blade without mass: N = m W^2 l, and the load is m W^2 l along it.
TEST(TurningBlade, TipMassPulls) {
  BeamDefinition beam = blade(8, Vector3::UnitX());
  beam.material.density = 0;
  beam.points.push_back({"head", {"end", {}}, 0.05, Vector3::Zero()});
  const ReducedBody body = reduced(beam, 2); // bending, stretch
  const double length = beam_length(beam);
  const Vector load = body.spin.centrifugal_load;
  const RowVector along = body.point("head").rows.row(2);
  EXPECT_LT((load - 0.05 * length * along.transpose()).norm(), 1e-9 * load.norm());
  // With the static deflection 3 x^2 l - x^3 the work of N is 6/5 N w^2 / l.
  const double bending = body.point("head").rows(0, 0);
  EXPECT_NEAR(body.spin.centrifugal(0, 0), 1.2 * 0.05 * bending * bending, 1e-6);
}

namespace {

/// A stout blade in its plane of rotation, by polynomials along all of it (Ritz's method with
/// Gauss's rule): bending w = sum b_k z^(k+1), stretch u = sum a_k z^k, k = 1, 2..., with
///
///   m (w'' + 2 W u' - W^2 w) + E I d^4 w - d(N d w) = 0,   m (u'' - 2 W w' - W^2 u) - E A d^2 u =
///   0
///
/// d the derivative along z, N = m W^2 (l^2 - z^2) / 2. Frequencies per frequency_scale().
Vector frequencies_by_polynomials(const BeamDefinition &beam, double eta, bool coriolis) {
  constexpr Index count = 10;
  const double speed = eta * frequency_scale(beam), length = beam_length(beam);
  const double m = mass_per_length(beam), bending = bending_stiffness(beam);
  const double axial = beam.material.young_modulus * beam.section.width * beam.section.thickness;
  Matrix mass = Matrix::Zero(2 * count, 2 * count), stiffness = mass, gyroscopic = mass;
  using Rule = boost::math::quadrature::gauss<double, 30>;
  const auto add = [&](double z, double weight) {
    Vector w(count), slope(count), curvature(count), u(count), strain(count);
    for (Index k = 0; k < count; ++k) {
      const auto p = static_cast<double>(k);
      const double s = z / length;
      w[k] = std::pow(s, p + 2);
      slope[k] = (p + 2) * std::pow(s, p + 1) / length;
      curvature[k] = (p + 2) * (p + 1) * std::pow(s, p) / (length * length);
      u[k] = std::pow(s, p + 1);
      strain[k] = (p + 1) * std::pow(s, p) / length;
    }
    const double pull = m * speed * speed * (length * length - z * z) / 2;
    mass.topLeftCorner(count, count) += weight * m * w * w.transpose();
    mass.bottomRightCorner(count, count) += weight * m * u * u.transpose();
    stiffness.topLeftCorner(count, count) +=
        weight * (bending * curvature * curvature.transpose() + pull * slope * slope.transpose() -
                  m * speed * speed * w * w.transpose());
    stiffness.bottomRightCorner(count, count) +=
        weight * (axial * strain * strain.transpose() - m * speed * speed * u * u.transpose());
    if (coriolis)
      gyroscopic.topRightCorner(count, count) += weight * 2 * m * speed * w * u.transpose();
  };
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
    for (const double sign : {-1.0, 1.0})
      add(length * (1 + sign * Rule::abscissa()[i]) / 2, length / 2 * Rule::weights()[i]);
  gyroscopic -= gyroscopic.transpose().eval();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> rest(stiffness, mass);
  return coupled_frequencies(rest.eigenvalues(),
                             rest.eigenvectors().transpose() * gyroscopic * rest.eigenvectors()) /
         frequency_scale(beam);
}

BeamDefinition stout_blade(int elements) {
  BeamDefinition beam = blade(elements, Vector3::UnitY());
  beam.section.thickness = 0.06;
  return beam;
}

/// The whole equations of the program, all modes kept.
Vector frequencies_of_blade(int elements, double eta) {
  const BeamDefinition beam = stout_blade(elements);
  const ReducedBody body = reduced(beam, 3 * elements);
  const double speed = eta * frequency_scale(beam);
  Matrix stiffness = body.stiffness.asDiagonal();
  stiffness += speed * speed * body.spin.centrifugal;
  const SymmetricEigen modes = symmetric_eigen(stiffness);
  return coupled_frequencies(modes.values, speed * modes.vectors.transpose() *
                                               body.spin.gyroscopic * modes.vectors) /
         frequency_scale(beam);
}

} // namespace

// Radial and tangential motion, which Coriolis forces couple.
TEST(TurningBlade, CoriolisForcesCoupleStretchAndBending) {
  constexpr double eta = 6;
  const Vector exact = frequencies_by_polynomials(stout_blade(1), eta, true);
  const Vector uncoupled = frequencies_by_polynomials(stout_blade(1), eta, false);
  const Vector coarse = frequencies_of_blade(10, eta), fine = frequencies_of_blade(20, eta);
  for (Index j = 0; j < 4; ++j) {
    const double error = std::abs(fine[j] - exact[j]);
    EXPECT_GT(std::abs(uncoupled[j] - exact[j]), 50 * error) << j;
    EXPECT_GT(std::log2(std::abs(coarse[j] - exact[j]) / error), 1.8) << j;
  }
}

// A column under its own weight buckles at rho A g l^3 / EI = 7.83735 (Greenhill).
TEST(TurningBlade, ForceThatChangesAlongAColumn) {
  const auto column = [](double load) {
    BeamDefinition beam = cantilever(20);
    const double length = beam_length(beam);
    structure::Member member{.name = "column"};
    member.section = beam.section;
    member.material = beam.material;
    member.axial_force = {-load * bending_stiffness(beam) / (length * length), 0};
    beam.members.push_back(member);
    return beam;
  };
  const auto squared = [&](double load) { return reduced(column(load), 1).stiffness[0]; };
  EXPECT_LT(squared(7.8373) / squared(0), 1e-5);
  EXPECT_ANY_THROW(reduced(column(7.8375), 1));
}

} // namespace turning_blade_tests
