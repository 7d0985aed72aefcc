// The reduced body against closed forms of beams.
#include "reduction/reduce.h"

#include "modes/solve_beam.h"
#include "reduction/beam_bodies.h"

#include <gtest/gtest.h>

namespace reduce_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

constexpr Index along_x = 0;

// 1/m_j = rho A L phi_j(tip)^2: modal mass relative to the beam's, for a unit tip displacement.
Vector inverse_modal_masses(const ReducedBody &body, const BeamDefinition &beam) {
  return beam_mass(beam) * body.point("head").rows.row(along_x).transpose().array().square();
}

} // namespace

TEST(Reduce, TunedCantileverHasTheModalMassesOfCaseS) {
  const BeamDefinition beam = tuned_cantilever(80);
  const Vector inverse = inverse_modal_masses(reduced(beam, 5), beam);
  const std::vector<double> reference = {1.32731649, 12.8740648, 34.4772176, 68.463925, 114.072661};
  for (Index j = 0; j < 5; ++j)
    EXPECT_NEAR(inverse[j] * reference[j], 1, 5e-6) << j;
}

TEST(Reduce, TunedCantileverHasTheContactComplianceOfCaseS) {
  const BeamDefinition beam = tuned_cantilever(400);
  const Vector inverse = inverse_modal_masses(reduced(beam, 100), beam);
  EXPECT_NEAR(inverse.head(1).sum(), 0.7533998, 1e-7);
  EXPECT_NEAR(inverse.head(5).sum(), 0.8834526, 1e-7);
  EXPECT_NEAR(inverse.head(10).sum(), 0.9009090, 1e-7);
  EXPECT_NEAR(inverse.sum(), 0.9164369, 1e-6);
}

TEST(Reduce, ModesArePositiveAtThePoint) {
  const ReducedBody body = reduced(tuned_cantilever(20), 6);
  EXPECT_GT(body.point("head").rows.row(along_x).minCoeff(), 0);
  EXPECT_EQ(body.point("head").position, Vector3(0, 0, 0.3));
}

TEST(Reduce, PointRowsAreThoseOfTheRecovery) {
  const ReducedBody body = reduced(tuned_cantilever(20), 6);
  EXPECT_EQ(body.recovery.nodes.cols(), 21);
  EXPECT_EQ(body.recovery.lines.size(), 20U);
  EXPECT_EQ(body.recovery.shapes.rows(), 126);
  EXPECT_EQ(body.point("head").rows, body.recovery.shapes.bottomRows(6));
  EXPECT_EQ(body.recovery.shapes.topRows(6).norm(), 0);
}

// The effective mass of mode j of a clamped-free beam is 4 sigma^2 / (beta L)^2 of the beam's, with
// sigma = (cosh x + cos x) / (sinh x + sin x) inverted: tanh-like factor close to 1.
TEST(Reduce, CantileverHasTheEffectiveMassesOfTheClosedForm) {
  const BeamDefinition beam = cantilever(200);
  const ReducedBody body = reduced(beam, 4);
  const std::vector<double> x = clamped_free(4);
  for (Index j = 0; j < 4; ++j) {
    const double sigma = (std::sinh(x[j]) - std::sin(x[j])) / (std::cosh(x[j]) + std::cos(x[j]));
    const double expected = 4 * sigma * sigma / (x[j] * x[j]) * beam_mass(beam);
    EXPECT_NEAR(body.effective_mass()(j, along_x) / expected, 1, 1e-6) << j;
  }
  EXPECT_LT(body.effective_mass().col(1).norm(), 1e-20);
}

TEST(Reduce, EffectiveMassesOfAllModesOfAFreeBodySumToItsMass) {
  BeamDefinition beam = square_beam(4);
  beam.supports.clear();
  const ReducedBody body = reduced(beam, 30);
  for (Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(body.total_mass[axis], beam_mass(beam) + 0.02, 1e-14);
    EXPECT_NEAR(body.effective_mass().col(axis).sum() / body.total_mass[axis], 1, 1e-10);
  }
}

// A clamped body keeps what its supports carry: the sum tends to the mass as the mesh is refined.
TEST(Reduce, EffectiveMassesOfAClampedBodyTendToItsMass) {
  double previous = 1;
  for (const int elements : {5, 10, 20}) {
    const BeamDefinition beam = cantilever(elements, 0.01);
    const ReducedBody body = reduced(beam, 2 * elements);
    const double missing = 1 - body.effective_mass().col(along_x).sum() / body.total_mass[along_x];
    EXPECT_GT(missing, 0);
    EXPECT_NEAR(previous / missing, elements == 5 ? previous / missing : 2, 0.01);
    previous = missing;
  }
}

TEST(Reduce, FreeBodyHasRigidModesWithTheirInertia) {
  BeamDefinition beam = thin_beam(30);
  hold_plane(beam);
  const ReducedBody body = reduced(beam, 4);
  EXPECT_EQ(body.omega()[0], 0);
  EXPECT_EQ(body.omega()[1], 0);
  EXPECT_GT(body.omega()[2], 0);
  EXPECT_NEAR(body.effective_mass().topRows(2).col(along_x).sum(), beam_mass(beam), 1e-12);
}

// The tip of a cantilever moves by L^3 / (3 EI) per unit force, whatever else loads the body.
TEST(Reduce, FlexibilityIsThatOfThePointWithAndWithoutALoad) {
  BeamDefinition beam = cantilever(10);
  const double exact = std::pow(beam_length(beam), 3) / (3 * bending_stiffness(beam));
  Matrix expected = Matrix::Zero(3, 3);
  expected(along_x, along_x) = exact;
  EXPECT_LT((reduced(beam, 2).point("head").flexibility - expected).norm(), 1e-9 * exact);
  beam.loads.push_back({.name = "pull", .at = {"end", {}}, .force = {7, 0, 0}});
  const ReducedBody loaded = reduced(beam, 2);
  EXPECT_LT((loaded.point("head").flexibility - expected).norm(), 1e-9 * exact);
  EXPECT_NEAR(loaded.point("head").static_displacement[along_x] / (7 * exact), 1, 1e-9);
}

TEST(Reduce, DampingRatiosRepeatTheLastOne) {
  BodyDefinition definition = body_of(tuned_cantilever(20), 4);
  definition.damping.ratios = {0.01, 0.03};
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  const Vector expected = (Vector(4) << 0.01, 0.03, 0.03, 0.03).finished();
  EXPECT_LT((body.damping_ratio() - expected).norm(), 1e-15);
  EXPECT_EQ(body.damping(0, 1), 0);
}

TEST(Reduce, RayleighDampingHasItsRatios) {
  BodyDefinition definition = body_of(tuned_cantilever(20), 4);
  definition.damping = {.model = Damping::Model::rayleigh, .alpha = 0.4, .beta = 1e-5};
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  for (Index j = 0; j < 4; ++j)
    EXPECT_NEAR(body.damping_ratio()[j], 0.2 / body.omega()[j] + 0.5e-5 * body.omega()[j], 1e-14);
}

// Phi^T M Phi = I holds with the head's mass m, so what is left of the distributed part is
// I - m phi(head) phi(head)^T.
TEST(Reduce, ViscousDampingLeavesOutTheLumpedMass) {
  BodyDefinition definition = body_of(tuned_cantilever(40), 6);
  definition.damping = {.model = Damping::Model::viscous, .viscous_constant = 0.2};
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  const Vector head = body.point("head").rows.row(along_x).transpose();
  const double beam = beam_mass(definition.beam);
  const double mass = definition.beam.points[0].mass;
  const Matrix expected = 0.2 / beam * (Matrix::Identity(6, 6) - mass * head * head.transpose());
  EXPECT_LT((body.damping - expected).norm(), 1e-12 * expected.norm());
  EXPECT_EQ((body.damping - body.damping.transpose()).norm(), 0);
}

TEST(Reduce, ABandKeepsItsModes) {
  BodyDefinition definition = body_of(tuned_cantilever(40), 5);
  const double hertz = 2 * M_PI;
  definition.selection.band = {{20 * hertz, 250 * hertz}};
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  ASSERT_EQ(body.size(), 3);
  EXPECT_NEAR(body.omega()[0] / hertz, 31.75296, 1e-4);
  EXPECT_NEAR(body.omega()[2] / hertz, 206.18120, 1e-3);
}

TEST(Reduce, ImpossibleSelectionsNameTheKey) {
  const auto key_of = [](BodyDefinition definition) -> std::string {
    try {
      reduce(definition, MPI_COMM_WORLD);
    } catch (const structure::DefinitionError &error) {
      return error.kind() + "/" + error.key() + " " + error.problem();
    }
    return "";
  };
  EXPECT_NE(key_of(body_of(cantilever(3), 7)).find("Modes/Number must not exceed"),
            std::string::npos);
  EXPECT_NE(key_of(body_of(cantilever(3), 7)).find("mass, 6"), std::string::npos);
  BodyDefinition empty_band = body_of(tuned_cantilever(10), 5);
  empty_band.selection.band = {{1, 2}};
  EXPECT_NE(key_of(empty_band).find("Modes/Band"), std::string::npos);
  BodyDefinition massless = body_of(cantilever(10, 0.2), 1);
  massless.beam.material.density = 0;
  massless.damping = {.model = Damping::Model::viscous, .viscous_constant = 1};
  EXPECT_NE(key_of(massless).find("Modes/Damping model"), std::string::npos);
}

} // namespace reduce_tests
