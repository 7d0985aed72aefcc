// Reduction to modes of the body held at its interface and constraint modes (Craig-Bampton).
#include "reduction/beam_bodies.h"
#include "reduction/body_file.h"
#include "structure/shell_examples.h"

#include <gtest/gtest.h>

namespace fixed_interface_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

constexpr Index along_x = 0;

/// A cantilever that can be touched at its head and in its middle.
BodyDefinition touched_beam(int number, int elements = 20) {
  BeamDefinition beam = cantilever(elements);
  beam.points = {{"head", {"end", {}}, 0, Vector3::Zero()},
                 {"belly", {"", Vector3(0, 0, 0.15)}, 0, Vector3::Zero()}};
  BodyDefinition definition = body_of(beam, number);
  definition.attachments = {{"head", along_x}, {"belly", along_x}};
  definition.reduction = BodyDefinition::Reduction::fixed_interface;
  return definition;
}

ReducedBody make(const BodyDefinition &definition) { return reduce(definition, MPI_COMM_WORLD); }

/// Static displacement along x of one point under a unit force at another, by the coordinates kept.
double flexibility(const ReducedBody &body, const std::string &point, const std::string &pushed) {
  return (body.point(point).rows.row(along_x).array() *
          body.point(pushed).rows.row(along_x).array() / body.stiffness.transpose().array())
      .sum();
}

std::string problem_of_definition(const BodyDefinition &definition) {
  try {
    make(definition);
  } catch (const structure::DefinitionError &error) {
    return error.kind() + "/" + error.key() + " " + error.problem();
  }
  return "";
}

} // namespace

// L^3 / 3EI at the head, L^3 / 24EI in the middle, 5 L^3 / 48EI across, whatever the modes.
TEST(FixedInterface, AStaticForceAtTheInterfaceIsAnsweredExactly) {
  for (const int number : {1, 4}) {
    const BodyDefinition definition = touched_beam(number);
    const ReducedBody body = make(definition);
    EXPECT_EQ(body.size(), number + 2);
    const double scale = std::pow(0.3, 3) / bending_stiffness(definition.beam);
    EXPECT_NEAR(flexibility(body, "head", "head") / scale, 1. / 3, 1e-9);
    EXPECT_NEAR(flexibility(body, "belly", "belly") / scale, 1. / 24, 1e-9);
    EXPECT_NEAR(flexibility(body, "belly", "head") / scale, 5. / 48, 1e-9);
    EXPECT_NEAR(body.flexibility_share(body.point("head"), Vector3::UnitX()), 1, 1e-9);
  }
}

TEST(FixedInterface, FrequenciesComeDownToThoseOfTheBody) {
  const Vector exact = reduced(cantilever(20), 8).omega();
  Vector previous = Vector::Constant(3, 1e300);
  for (const int number : {1, 2, 4, 8, 16}) {
    const Vector omega = make(touched_beam(number)).omega();
    for (Index j = 0; j < 3; ++j) {
      EXPECT_GT(omega[j], exact[j] * (1 - 1e-9)) << number;
      EXPECT_LT(omega[j], previous[j] * (1 + 1e-9)) << number;
    }
    previous = omega.head(3);
  }
  for (Index j = 0; j < 3; ++j)
    EXPECT_NEAR(previous[j] / exact[j], 1, 1e-4);
}

TEST(FixedInterface, AllModesTogetherAreTheBody) {
  const ReducedBody body = make(touched_beam(18, 10)); // 20 degrees of freedom, two of them held
  const ReducedBody whole = reduced(cantilever(10), 20);
  ASSERT_EQ(body.size(), 20);
  for (Index j = 0; j < 20; ++j)
    EXPECT_NEAR(body.omega()[j] / whole.omega()[j], 1, 1e-8) << j;
}

// The coordinates are those of the rest of the program: unit mass, effective masses that add up.
TEST(FixedInterface, TheBodyStaysInDiagonalForm) {
  BodyDefinition definition = touched_beam(6);
  definition.damping.ratios = {0.01, 0.02};
  definition.damping.attachment_ratio = 0.5;
  const ReducedBody body = make(definition);
  EXPECT_LT(body.orthogonality_residual, 1e-12);
  EXPECT_EQ((body.mass - Vector::Ones(8)).norm(), 0);
  Vector expected = Vector::Constant(8, 0.02);
  expected[0] = 0.01;
  expected.tail(2).setConstant(0.5);
  EXPECT_LT((body.damping_ratio() - expected).norm(), 1e-14);
  EXPECT_TRUE(body.eigen_residual.array().isNaN().all());
}

TEST(FixedInterface, AFreeBodyKeepsItsRigidMotions) {
  BeamDefinition beam = thin_beam(20);
  hold_plane(beam);
  beam.points = {{"left", {"start", {}}, 0, Vector3::Zero()},
                 {"right", {"end", {}}, 0, Vector3::Zero()}};
  BodyDefinition definition = body_of(beam, 6);
  definition.attachments = {{"left", along_x}, {"right", along_x}};
  const Vector exact = make(definition).omega();
  definition.reduction = BodyDefinition::Reduction::fixed_interface;
  const ReducedBody body = make(definition);
  EXPECT_EQ(body.omega()[0], 0);
  EXPECT_EQ(body.omega()[1], 0);
  EXPECT_NEAR(body.effective_mass().topRows(2).col(along_x).sum() / beam_mass(beam), 1, 1e-9);
  EXPECT_NEAR(body.omega()[2] / exact[2], 1, 1e-4);
  EXPECT_GT(body.omega()[2], exact[2] * (1 - 1e-9));
}

// Equal frequencies in two planes: the number cuts a pair, and the basis is still unique.
TEST(FixedInterface, DoubleFrequenciesOnAnyNumberOfRanks) {
  BodyDefinition definition = body_of(square_beam(20), 5);
  definition.attachments = {{"head", 0}, {"head", 1}, {"head", 2}};
  definition.reduction = BodyDefinition::Reduction::fixed_interface;
  definition.damping.ratios = {0.01};
  const ReducedBody together = make(definition);
  const ReducedBody alone = reduce(definition, MPI_COMM_SELF);
  const Matrix difference = together.points[0].rows - alone.points[0].rows;
  EXPECT_LT(difference.topRows(3).cwiseAbs().maxCoeff(),
            1e-8 * alone.points[0].rows.topRows(3).cwiseAbs().maxCoeff());
  const std::string own = to_bytes(together, "");
  EXPECT_EQ(own, broadcast(own, MPI_COMM_WORLD));
}

TEST(FixedInterface, APlateAnswersAtItsCorner) {
  BodyDefinition definition;
  definition.name = "plate";
  definition.type = BodyDefinition::Type::shell;
  definition.shell = square_plate(8, CellShape::quadrilateral);
  definition.shell.supports.push_back(
      {"left", {"left", {}}, {true, true, true, true, true, true}, {}});
  definition.shell.points.push_back({"corner", {"", Vector3(10, 10, 0)}, 0, Vector3::Zero()});
  definition.attachments = {{"corner", 2}};
  definition.selection.number = 5;
  definition.reduction = BodyDefinition::Reduction::fixed_interface;
  const ReducedBody body = make(definition);
  EXPECT_NEAR(body.flexibility_share(body.point("corner"), Vector3::UnitZ()), 1, 1e-8);
  definition.reduction = BodyDefinition::Reduction::free_interface;
  definition.attachments.clear();
  const Vector exact = make(definition).omega();
  for (Index j = 0; j < 3; ++j) {
    EXPECT_NEAR(body.omega()[j] / exact[j], 1, 0.01);
    EXPECT_GT(body.omega()[j], exact[j] * (1 - 1e-9));
  }
}

TEST(FixedInterface, ImpossibleInterfacesNameTheKey) {
  BodyDefinition none = touched_beam(3);
  none.attachments.clear();
  EXPECT_NE(problem_of_definition(none).find("Modes/Attachments must name at least one"),
            std::string::npos);
  BodyDefinition held = touched_beam(3);
  held.beam.points.push_back({"foot", {"start", {}}, 0, Vector3::Zero()});
  held.attachments = {{"foot", along_x}};
  EXPECT_NE(problem_of_definition(held).find("that no support holds"), std::string::npos);
  BodyDefinition loose = touched_beam(3);
  loose.beam.supports.clear();
  hold_plane(loose.beam);
  loose.attachments = {{"head", along_x}};
  EXPECT_NE(problem_of_definition(loose).find("against every rigid motion"), std::string::npos);
  EXPECT_NE(problem_of_definition(touched_beam(19, 10)).find("with mass, 18"), std::string::npos);
}

} // namespace fixed_interface_tests
