// Bodies of shells, their static displacements and attachment modes, from definition to reduced
// body.
#include "modes/solve_shell.h"
#include "reduction/beam_bodies.h"
#include "reduction/body_file.h"
#include "structure/shell_benchmarks.h"

#include <gtest/gtest.h>

#include <complex>
#include <sstream>

namespace shell_bodies_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

BodyDefinition body_of(const ShellDefinition &shell, int number) {
  BodyDefinition definition;
  definition.name = "plate";
  definition.type = BodyDefinition::Type::shell;
  definition.shell = shell;
  definition.selection.number = number;
  return definition;
}

ShellDefinition plate_with_middle(int elements, CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell = simply_supported_plate(elements, shape);
  shell.points.push_back({"middle", {"", Vector3(5, 5, 0)}, 0, {0, 0, 0}});
  return shell;
}

// Cantilever with its first modes and the answers to forces at the tip and in the middle.
BodyDefinition attached_beam(int number) {
  BeamDefinition beam = cantilever(20);
  beam.points = {{"head", {"end", {}}, 0, Vector3::Zero()},
                 {"belly", {"", Vector3(0, 0, 0.15)}, 0, Vector3::Zero()}};
  BodyDefinition definition = examples::body_of(beam, number);
  definition.attachments = {{"head", 0}, {"belly", 0}};
  return definition;
}

constexpr Index along_x = 0;

/// What reduce() warns of, one line each.
std::vector<std::string> warnings_of(const ShellDefinition &shell) {
  ::testing::internal::CaptureStdout();
  reduce(body_of(shell, 2), MPI_COMM_WORLD);
  std::istringstream text(::testing::internal::GetCapturedStdout());
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("warning: "))
      lines.push_back(line);
  return lines;
}

} // namespace

// One warning for the body, with how many, where, and what helps.
TEST(ShellBodies, TrianglesThatLockAreWarnedOf) {
  const std::vector<std::string> lines = warnings_of(hemisphere(8, CellShape::triangle));
  ASSERT_EQ(lines.size(), 1U);
  for (const char *words : {"body plate: 128 of 128 triangles", "around (", "Use quadrilaterals"})
    EXPECT_NE(lines[0].find(words), std::string::npos) << lines[0];
  EXPECT_TRUE(warnings_of(hemisphere(8)).empty());
  EXPECT_TRUE(warnings_of(square_plate(4, CellShape::triangle)).empty());
}

// NAFEMS 13H: the plate answers to a pressure of 100 Pa at its first frequency, with 2 % of
// critical damping, by 45.42 mm. A pressure p acts like a base acceleration p / (rho t).
TEST(ShellBodies, HarmonicPressureOf13H) {
  BodyDefinition definition = body_of(plate_with_middle(24), 16);
  definition.damping.ratios = {0.02};
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  double peak = 0;
  for (double frequency = 2.35; frequency < 2.41; frequency += 1e-4) {
    const double omega = 2 * M_PI * frequency;
    std::complex<double> answer = 0;
    for (Index j = 0; j < body.size(); ++j)
      answer += body.points[0].rows(2, j) * body.base_participation(j, 2) * 0.25 /
                std::complex<double>(body.stiffness[j] - omega * omega, body.damping(j, j) * omega);
    peak = std::max(peak, std::abs(answer));
  }
  EXPECT_NEAR(peak / 45.42e-3, 1, 0.01);
  EXPECT_NEAR(body.omega()[0] / (2 * M_PI) / 2.377, 1, 0.01);
}

TEST(ShellBodies, RecoveryHoldsTheMesh) {
  const ReducedBody quads = reduce(body_of(plate_with_middle(4), 3), MPI_COMM_WORLD);
  EXPECT_EQ(quads.type, "shell");
  EXPECT_TRUE(quads.modal());
  EXPECT_EQ(quads.recovery.nodes.cols(), 25);
  ASSERT_EQ(quads.recovery.cells.size(), 16U);
  EXPECT_EQ(quads.recovery.cells[0], structure::cell_of(CellShape::quadrilateral, {0, 1, 6, 5}));
  EXPECT_TRUE(quads.recovery.lines.empty());
  const ReducedBody triangles =
      reduce(body_of(plate_with_middle(4, CellShape::triangle), 3), MPI_COMM_WORLD);
  EXPECT_EQ(triangles.recovery.cells[0], structure::cell_of(CellShape::triangle, {0, 1, 6}));
}

TEST(ShellBodies, AllMassMovesWithTheBaseOfAFreePlate) {
  const ReducedBody body = reduce(body_of(square_plate(6), 20), MPI_COMM_WORLD);
  const double mass = 8000 * 100 * 0.05;
  for (Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(body.total_mass[axis] / mass, 1, 1e-12);
    EXPECT_NEAR(body.effective_mass().col(axis).sum() / mass, 1, 1e-9);
  }
}

TEST(ShellBodies, FilesKeepSurfacesAndStatics) {
  ShellDefinition shell = plate_with_middle(4);
  shell.loads.push_back(weight({0, 0, -9.81}));
  const ReducedBody body = reduce(body_of(shell, 3), MPI_COMM_WORLD);
  EXPECT_LT(body.points[0].static_displacement[2], 0);
  EXPECT_EQ(body.points[0].static_displacement,
            body.recovery.static_displacement.segment(6 * 12, 6));
  std::string reason;
  const auto copy = from_bytes(to_bytes(body, ""), "", reason);
  ASSERT_TRUE(copy) << reason;
  EXPECT_EQ(copy->recovery.cells, body.recovery.cells);
  EXPECT_EQ(copy->recovery.static_displacement, body.recovery.static_displacement);
  EXPECT_EQ(copy->points[0].flexibility, body.points[0].flexibility);
}

TEST(ShellBodies, LoadsNeedSupports) {
  ShellDefinition shell = square_plate(3);
  shell.loads.push_back(weight({0, 0, -9.81}));
  try {
    reduce(body_of(shell, 8), MPI_COMM_WORLD);
    FAIL();
  } catch (const structure::DefinitionError &error) {
    EXPECT_NE(error.problem().find("must have supports against"), std::string::npos);
  }
}

// w = P L^3 / 3 E I at the tip; the first mode carries 12 / (beta L)^4 of it.
TEST(ShellBodies, FlexibilityOfACantilever) {
  BodyDefinition definition = attached_beam(1);
  definition.attachments.clear();
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  const BodyPoint &head = body.point("head");
  const double exact = std::pow(0.3, 3) / (3 * bending_stiffness(definition.beam));
  EXPECT_NEAR(head.flexibility(along_x, along_x) / exact, 1, 1e-9);
  EXPECT_NEAR(body.flexibility_share(head, Vector3::UnitX()), 12 / std::pow(clamped_free(1)[0], 4),
              1e-5);
  EXPECT_EQ(body.flexibility_share(head, Vector3::UnitY()), 1) << "held, nothing to carry";
}

TEST(ShellBodies, AttachmentModesCompleteTheFlexibility) {
  const ReducedBody body = reduce(attached_beam(2), MPI_COMM_WORLD);
  ASSERT_EQ(body.size(), 4);
  EXPECT_GT(body.stiffness[2], body.stiffness[1]);
  for (const BodyPoint &point : body.points)
    EXPECT_NEAR(body.flexibility_share(point, Vector3::UnitX()), 1, 1e-9);
  // The displacement of one point under a force at the other, too.
  const RowVector head = body.point("head").rows.row(along_x);
  const RowVector belly = body.point("belly").rows.row(along_x);
  const double found = (head.array() * belly.array() / body.stiffness.transpose().array()).sum();
  const double length = 0.3;
  const double middle = length / 2;
  const double exact =
      middle * middle * (3 * length - middle) / (6 * bending_stiffness(cantilever(1)));
  EXPECT_NEAR(found / exact, 1, 1e-9);
}

// External viscous damping spread like the mass is c / m times Phi^T M Phi.
TEST(ShellBodies, AttachmentModesAreOrthonormal) {
  BodyDefinition definition = attached_beam(3);
  definition.damping = {.model = Damping::Model::viscous, .viscous_constant = 2};
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  const Matrix identity = beam_mass(definition.beam) / 2 * body.damping;
  EXPECT_LT((identity - Matrix::Identity(5, 5)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ShellBodies, AttachmentModesHaveTheirOwnDamping) {
  BodyDefinition definition = attached_beam(3);
  definition.damping.ratios = {0.01, 0.02};
  definition.damping.attachment_ratio = 0.3;
  const Vector own = reduce(definition, MPI_COMM_WORLD).damping_ratio();
  EXPECT_LT((own - (Vector(5) << 0.01, 0.02, 0.02, 0.3, 0.3).finished()).norm(), 1e-14);
  definition.damping.attachment_ratio.reset();
  EXPECT_NEAR(reduce(definition, MPI_COMM_WORLD).damping_ratio()[4], 0.02, 1e-15);
}

TEST(ShellBodies, WithAllModesThereIsNothingToAttach) {
  BodyDefinition definition = attached_beam(1);
  definition.beam.line.elements = 2;
  definition.selection.number = 4;
  EXPECT_EQ(reduce(definition, MPI_COMM_WORLD).size(), 4);
}

// A free beam that is pushed at its end: what its elastic modes answer, with the inertia of its
// rigid motion. From the closed form of a free beam under P and uniform rigid accelerations the tip
// bends relative to its mean motion by P L^3 / (105 E I).
TEST(ShellBodies, AttachmentModesOfAFreeBody) {
  BodyDefinition definition = attached_beam(3);
  definition.beam.supports.clear();
  hold_plane(definition.beam);
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  ASSERT_EQ(body.size(), 5);
  const RowVector head = body.point("head").rows.row(along_x).tail(3);
  const double found = (head.array().square() / body.stiffness.tail(3).transpose().array()).sum();
  const double exact = std::pow(0.3, 3) / (105 * bending_stiffness(definition.beam));
  EXPECT_NEAR(found / exact, 1, 1e-4);
}

TEST(ShellBodies, AttachmentModesOfAFreeBodyNeedAnElasticMode) {
  BodyDefinition definition = attached_beam(2);
  definition.beam.supports.clear();
  hold_plane(definition.beam);
  EXPECT_THROW(reduce(definition, MPI_COMM_WORLD), structure::DefinitionError);
}

} // namespace shell_bodies_tests
