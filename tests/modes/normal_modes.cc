// What the eigen-solution promises whatever the body: completeness, accuracy, rigid-body modes.
#include "modes/normal_modes.h"

#include "modes/rayleigh_ritz.h"
#include "modes/solve_beam.h"
#include "modes/spectrum_slicing.h"

#include <gtest/gtest.h>

namespace normal_modes_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;
using modes::NormalModes;

TEST(NormalModes, AreOrthonormalAndBoundTheirError) {
  const NormalModes modes = solve_beam(cantilever(50), {20, {}});
  EXPECT_EQ(modes.number, 20);
  EXPECT_LT(modes.orthogonality_residual, 1e-13);
  EXPECT_LT(modes.error_bounds.maxCoeff(), 1e-11);
}

// The accuracy left when the discretisation error, known to fall by 2^4, is taken out: with 400
// elements the matrix alone would lose five more digits.
TEST(NormalModes, LowFrequenciesOfFineMeshesAreAccurate) {
  const double scale = std::pow(frequency_scale(thin_beam(1)), 2);
  const NormalModes modes = solve_beam(cantilever(400), {5, {}});
  const std::vector<double> exact = clamped_free(2);
  EXPECT_NEAR(modes.eigenvalues[0] / (scale * std::pow(exact[0], 4)), 1, 1e-11);
  EXPECT_NEAR(modes.eigenvalues[1] / (scale * std::pow(exact[1], 4)), 1, 1e-10);
}

// A bar on a spring so soft that it moves as a rigid body: omega^2 = k / m up to k L / (3 E A).
// That lies far below the shift of the spectrum. The error is known relative to the distance from
// the shift, so that relative to the eigenvalue it grows as that falls.
TEST(NormalModes, BoundsHoldBelowTheShift) {
  const auto bound = [](double spring) {
    BeamDefinition bar = thin_beam(2);
    bar.supports.push_back({"line", {"all", {}}, {true, true, false, true, true, true}, {}});
    bar.supports.push_back({"spring", {"end", {}}, {}, {0, 0, spring, 0, 0, 0}});
    const NormalModes modes = solve_beam(bar, {1, {}});
    const double softness = spring * beam_length(bar) / (3 * 206e9 * 0.03 * 0.00075);
    const double error = std::abs(modes.eigenvalues[0] / (spring / beam_mass(bar)) - 1);
    EXPECT_LE(error, modes.error_bounds[0] + softness) << spring;
    return modes.error_bounds[0];
  };
  EXPECT_LT(bound(1e-6), 1e-13);
  EXPECT_GT(bound(1e-12), 1e-13);
  EXPECT_GT(bound(1e-14), 10 * bound(1e-12));
}

TEST(NormalModes, AllModesOfABodyCanBeTaken) {
  const NormalModes modes = solve_beam(cantilever(30), {60, {}});
  EXPECT_EQ(modes.number, 60);
  EXPECT_EQ(modes.shapes.rows(), 60);
  EXPECT_LT(modes.error_bounds.maxCoeff(), 1e-9);
}

TEST(NormalModes, HalfOfTheModesOfABodyCanBeTaken) {
  const NormalModes modes = solve_beam(cantilever(100), {100, {}});
  EXPECT_EQ(modes.number, 100);
  EXPECT_LT(modes.orthogonality_residual, 1e-13);
  EXPECT_LT(modes.error_bounds.maxCoeff(), 1e-9);
}

TEST(NormalModes, OneElementIsEnough) {
  EXPECT_EQ(solve_beam(cantilever(1), {2, {}}).eigenvalues.size(), 2);
  EXPECT_EQ(solve_beam(cantilever(1), {1, {}}).number, 1);
}

TEST(NormalModes, MoreThanThereAreIsRefused) {
  try {
    solve_beam(cantilever(3), {7, {}});
    FAIL();
  } catch (const modes::TooManyModes &error) {
    EXPECT_EQ(error.available, 6);
  }
}

TEST(NormalModes, AFreeBodyHasSixRigidBodyModes) {
  BeamDefinition beam = thin_beam(20);
  beam.line.start = {0.1, 0.2, 0.3};
  beam.line.end = {0.2, 0.5, 0.1};
  const NormalModes modes = solve_beam(beam, {9, {}});
  for (int j = 0; j < 6; ++j)
    EXPECT_EQ(modes.eigenvalues[j], 0) << j;
  EXPECT_GT(modes.eigenvalues[6], 0);
}

// Mass on a massless beam: one mode, omega^2 = 3 EI / (m L^3).
TEST(NormalModes, MasslessBeamsMoveWithTheirLumpedMasses) {
  BeamDefinition beam = cantilever(10, 0.2);
  beam.material.density = 0;
  const NormalModes modes = solve_beam(beam, {1, {}});
  const double expected = 3 * bending_stiffness(beam) / (0.2 * std::pow(0.3, 3));
  EXPECT_NEAR(modes.eigenvalues[0] / expected, 1, 1e-10);
  EXPECT_THROW(solve_beam(beam, {2, {}}), modes::TooManyModes);
}

// A square beam bends alike in both planes: every bending frequency is double.
TEST(NormalModes, DoubleFrequenciesAreComplete) {
  BeamDefinition beam = thin_beam(20);
  beam.section.width = beam.section.thickness = 0.005;
  clamp_start(beam);
  const NormalModes modes = solve_beam(beam, {4, {}});
  const double scale = std::pow(frequency_scale(beam), 2);
  for (int j = 0; j < 4; ++j)
    EXPECT_NEAR(modes.eigenvalues[j] / (scale * std::pow(clamped_free(2)[j / 2], 4)), 1, 1e-5);
}

TEST(NormalModes, AGroupOfEqualFrequenciesIsNotCut) {
  BeamDefinition beam = thin_beam(20);
  beam.section.width = beam.section.thickness = 0.005;
  clamp_start(beam);
  const NormalModes modes = solve_beam(beam, {3, {}});
  EXPECT_EQ(modes.number, 3);
  EXPECT_EQ(modes.eigenvalues.size(), 4);
}

TEST(NormalModes, ABandHoldsTheModesOfTheClosedForm) {
  const double scale = frequency_scale(thin_beam(1));
  const double lower = 1000;
  const double upper = 40000;
  int below = 0;
  int inside = 0;
  for (const double x : clamped_free(40)) {
    below += scale * x * x < lower;
    inside += scale * x * x >= lower && scale * x * x <= upper;
  }
  const NormalModes modes = solve_beam(cantilever(200), {5, {{lower, upper}}});
  EXPECT_EQ(modes.first, below);
  EXPECT_EQ(modes.number, inside);
  EXPECT_GT(inside, 10);
}

// A mode exactly on either edge belongs to the band, one just outside does not.
TEST(NormalModes, ABandEndsWithTheModesOnItsEdges) {
  const NormalModes modes = solve_beam(cantilever(20), {5, {}});
  const double first = std::sqrt(modes.eigenvalues[1]);
  const double last = std::sqrt(modes.eigenvalues[3]);
  const NormalModes band = solve_beam(cantilever(20), {5, {{first, last}}});
  EXPECT_EQ(band.first, 1);
  EXPECT_EQ(band.number, 3);
  const NormalModes inside =
      solve_beam(cantilever(20), {5, {{first * (1 + 1e-7), last * (1 - 1e-7)}}});
  EXPECT_EQ(inside.first, 2);
  EXPECT_EQ(inside.number, 1);
}

TEST(NormalModes, ABandWithoutModesIsEmpty) {
  EXPECT_EQ(solve_beam(cantilever(20), {5, {{50, 100}}}).number, 0);
  EXPECT_EQ(solve_beam(cantilever(20), {5, {{1, 2}}}).number, 0);
}

TEST(NormalModes, SpectrumSlicingFindsTheSameModes) {
  const structure::AssembledBody body =
      structure::assemble(structure::build_frame(cantilever(60)), MPI_COMM_WORLD);
  const modes::EigenProblem problem = eigen_problem(body);
  const NormalModes lowest = modes::normal_modes(problem, {12, {}});
  const double gap = (lowest.eigenvalues[9] + lowest.eigenvalues[10]) / 2;
  const modes::Eigenpairs sliced = modes::rayleigh_ritz(
      problem, modes::eigenvectors_between(problem.stiffness, problem.mass, -1, gap));
  ASSERT_EQ(sliced.values.size(), 10);
  for (int j = 0; j < 10; ++j)
    EXPECT_NEAR(sliced.values[j] / lowest.eigenvalues[j], 1, 1e-8);
}

// Distributed solutions against the one that each rank finds by itself.
TEST(NormalModes, DoNotDependOnTheNumberOfRanks) {
  const BeamDefinition beam = tuned_cantilever(100);
  const NormalModes together = solve_beam(beam, {10, {}}, MPI_COMM_WORLD);
  const NormalModes alone = solve_beam(beam, {10, {}}, MPI_COMM_SELF);
  for (int j = 0; j < 10; ++j)
    EXPECT_NEAR(std::sqrt(together.eigenvalues[j] / alone.eigenvalues[j]), 1, 1e-10);
}

} // namespace normal_modes_tests
