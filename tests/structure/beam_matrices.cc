// Matrices of a beam between its ends against closed forms.
#include "structure/beam_matrices.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace beam_matrices_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

constexpr double length = 0.8;
const Material steel{2e11, 0.25, 8000};

SectionShape bar(BeamTheory theory) { return {.width = 0.1, .thickness = 0.2, .theory = theory}; }

BeamMatrices matrices_of(const SectionShape &shape, const Releases &releases = {},
                         double axial_force = 0) {
  return beam_matrices(properties_along(shape, steel, axial_force, 0, 1), length, releases);
}

ElementMatrix stiffness_of(const BeamMatrices &matrices) {
  const auto rows = deformation_matrix(length);
  return rows.transpose() * matrices.stiffness * rows;
}

Releases released(std::initializer_list<int> rows) {
  Releases releases{};
  for (const int row : rows)
    releases[row] = true;
  return releases;
}

/// Rows v and rz of both ends: bending in the x-y plane.
Eigen::Matrix4d plane_xy(const ElementMatrix &matrix) {
  const std::array<int, 4> rows = {1, 5, 7, 11};
  return matrix(rows, rows);
}

double difference(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b) {
  return (a - b).norm() / b.norm();
}

/// Displacement of the second end along y (row 7) or z (row 8) by a force there, the first held.
double tip_flexibility(const SectionShape &shape, int row) {
  const Matrix held = stiffness_of(matrices_of(shape)).bottomRightCorner<6, 6>();
  return LuFactors<Matrix>(held).solve(Vector(Vector::Unit(6, row - 6)))[row - 6];
}

} // namespace

// EI / (L^3 (1 + phi)) with phi = 12 EI / (kappa G A L^2), see Przemieniecki, Theory of Matrix
// Structural Analysis, section 5.6.
TEST(BeamMatrices, TimoshenkoStiffnessIsExactForEndLoads) {
  const BeamProperties p = beam_properties(bar(BeamTheory::timoshenko), steel);
  const double phi = 12 * p.bending_stiffness_z * p.shear_flexibility_y / (length * length);
  const double l = length;
  Eigen::Matrix4d expected;
  expected << 12, 6 * l, -12, 6 * l,                       //
      6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l, //
      -12, -6 * l, 12, -6 * l,                             //
      6 * l, (2 - phi) * l * l, -6 * l, (4 + phi) * l * l;
  expected *= p.bending_stiffness_z / (l * l * l * (1 + phi));
  const ElementMatrix stiffness = stiffness_of(matrices_of(bar(BeamTheory::timoshenko)));
  EXPECT_LT(difference(plane_xy(stiffness), expected), 1e-13);
}

TEST(BeamMatrices, EulerBernoulliHasTheHermiteMatrices) {
  const double l = length;
  const BeamProperties p = beam_properties(bar(BeamTheory::euler_bernoulli), steel);
  Eigen::Matrix4d mass;
  mass << 156, 22 * l, 54, -13 * l,          //
      22 * l, 4 * l * l, 13 * l, -3 * l * l, //
      54, 13 * l, 156, -22 * l,              //
      -13 * l, -3 * l * l, -22 * l, 4 * l * l;
  mass *= p.mass_per_length * l / 420;
  Eigen::Matrix4d geometric;
  geometric << 36, 3 * l, -36, 3 * l,   //
      3 * l, 4 * l * l, -3 * l, -l * l, //
      -36, -3 * l, 36, -3 * l,          //
      3 * l, -l * l, -3 * l, 4 * l * l;
  geometric *= 5e4 / (30 * l);
  const BeamMatrices matrices = matrices_of(bar(BeamTheory::euler_bernoulli), {}, 5e4);
  EXPECT_LT(difference(plane_xy(matrices.mass), mass), 1e-13);
  EXPECT_LT(difference(plane_xy(matrices.geometric), geometric), 1e-13);
  EXPECT_NEAR(matrices.total_mass, p.mass_per_length * l, 1e-12);
}

// Both planes alike but for the sense of the rotation.
TEST(BeamMatrices, PlanesOfASquareAreAlike) {
  const SectionShape square{.width = 0.1,
                            .thickness = 0.1,
                            .theory = BeamTheory::timoshenko,
                            .end_width = 0.05,
                            .end_thickness = 0.05};
  const BeamMatrices matrices = matrices_of(square, {}, 1e5);
  const std::array<int, 4> xy = {1, 5, 7, 11};
  const std::array<int, 4> xz = {2, 4, 8, 10};
  const Eigen::Vector4d sense(1, -1, 1, -1);
  for (const ElementMatrix &m : {stiffness_of(matrices), matrices.mass, matrices.geometric})
    EXPECT_LT(
        difference(sense.asDiagonal() * Eigen::Matrix4d(m(xz, xz)) * sense.asDiagonal(), m(xy, xy)),
        1e-13);
}

// A rigid turn about the first end has the inertia m L^2 / 3 + rho I L.
TEST(BeamMatrices, RotaryInertiaOfARigidTurn) {
  const BeamProperties p = beam_properties(bar(BeamTheory::timoshenko), steel);
  ElementVector turn = ElementVector::Zero();
  turn[5] = turn[11] = 1;
  turn[7] = length;
  const double inertia = p.mass_per_length * std::pow(length, 3) / 3 + p.rotary_inertia_z * length;
  const BeamMatrices matrices = matrices_of(bar(BeamTheory::timoshenko));
  EXPECT_NEAR(turn.dot(matrices.mass * turn) / inertia, 1, 1e-13);
}

// Whatever the ratio of depth to length: the inertia of the inside must not make a mass negative.
TEST(BeamMatrices, MassStaysPositiveDefinite) {
  for (double depth = 1e-3; depth < 100; depth *= 3) {
    const SectionShape shape{.width = depth, .thickness = depth, .theory = BeamTheory::timoshenko};
    const ElementMatrix mass = matrices_of(shape).mass;
    const ElementVector scale = mass.diagonal().array().rsqrt();
    const ElementMatrix scaled = scale.asDiagonal() * mass * scale.asDiagonal();
    EXPECT_GT(symmetric_eigen(scaled).values[0], 1e-6) << depth;
  }
}

// v = F / E int (L - x)^2 / I dx; with the depth h (1 - x/2L) of a rectangle and u = 1 - x/2L this
// is 12 F L^3 / (E b h^3) int_{1/2}^1 2 (2u - 1)^2 / u^3 du, the integral 2 (4 ln 2 - 5/2 ...) in
// closed form: 4/u - 4/u^2 + 1/u^3 integrates to 4 ln 2 - 4 + 3/2.
TEST(BeamMatrices, TaperedCantilever) {
  const double depth = 0.2;
  const double width = 0.1;
  const SectionShape shape{.width = width, .thickness = depth, .end_thickness = depth / 2};
  const double integral = 2 * (4 * std::log(2.0) - 4 + 1.5);
  const double expected = 12 * std::pow(length, 3) / (2e11 * width * std::pow(depth, 3)) * integral;
  EXPECT_NEAR(tip_flexibility(shape, 8) / expected, 1, 1e-9);
}

// A propped cantilever: 3 EI / L^3 at the released end, and no moment there.
TEST(BeamMatrices, HingeAtOneEnd) {
  const BeamProperties p = beam_properties(bar(BeamTheory::euler_bernoulli), steel);
  const BeamMatrices matrices = matrices_of(bar(BeamTheory::euler_bernoulli), released({11}));
  const ElementMatrix stiffness = stiffness_of(matrices);
  EXPECT_NEAR(stiffness(7, 7) * std::pow(length, 3) / (3 * p.bending_stiffness_z), 1, 1e-12);
  EXPECT_LT(stiffness.row(11).norm(), 1e-12 * stiffness.norm());
  EXPECT_LT(matrices.mass.row(11).norm(), 1e-12 * matrices.mass.norm());
  // The end itself turns by 3/2 of the chord.
  EXPECT_NEAR(matrices.ends(11, 7) * length, 1.5, 1e-12);
}

TEST(BeamMatrices, SlidingEndPassesOnNoAxialForce) {
  const BeamMatrices matrices = matrices_of(bar(BeamTheory::euler_bernoulli), released({0}));
  EXPECT_LT(stiffness_of(matrices).row(6).norm(), 1e-12 * stiffness_of(matrices).norm());
  EXPECT_NEAR(matrices.mass(6, 6) / matrices.total_mass, 1, 1e-12); // goes with the second end
}

TEST(BeamMatrices, LooseBeamsAreRefused) {
  const SectionShape shape = bar(BeamTheory::timoshenko);
  EXPECT_NO_THROW(matrices_of(shape, released({4, 5, 10, 11})));
  EXPECT_THROW(matrices_of(shape, released({3, 9})), NumericalError);
  EXPECT_THROW(matrices_of(shape, released({5, 7, 11})), NumericalError);
}

} // namespace beam_matrices_tests
