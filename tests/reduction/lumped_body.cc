#include "reduction/lumped_body.h"

#include "reduction/reduce.h"

#include <gtest/gtest.h>

namespace lumped_body_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;

namespace {

BodyDefinition two_masses() {
  BodyDefinition definition;
  definition.name = "absorber";
  definition.type = BodyDefinition::Type::lumped;
  definition.masses = {{.name = "frame", .mass = 4, .axes = {0}, .stiffness = 100, .damping = 3},
                       {.name = "ball",
                        .mass = 0.5,
                        .axes = {2},
                        .stiffness = 0,
                        .damping = 0,
                        .position = Vector3(1, 2, 3)}};
  return definition;
}

} // namespace

TEST(LumpedBody, HasOneCoordinatePerMass) {
  const ReducedBody body = reduce(two_masses(), MPI_COMM_SELF);
  EXPECT_FALSE(body.modal());
  ASSERT_EQ(body.size(), 2);
  EXPECT_EQ(body.omega(), Vector(Eigen::Vector2d(5, 0)));
  EXPECT_DOUBLE_EQ(body.damping_ratio()[0], 3.0 / (2 * 4 * 5));
  EXPECT_EQ(body.damping(0, 1), 0);
}

TEST(LumpedBody, MassesAreNamedPointsThatMoveAlongTheirAxis) {
  const ReducedBody body = lumped_body(two_masses());
  Matrix expected = Matrix::Zero(6, 2);
  expected(2, 1) = 1;
  EXPECT_EQ(body.point("ball").rows, expected);
  EXPECT_EQ(body.point("ball").position, Vector3(1, 2, 3));
}

TEST(LumpedBody, AMassOfSeveralAxesHasACoordinateForEach) {
  BodyDefinition definition = two_masses();
  definition.masses[0].axes = {1, 0};
  const ReducedBody body = lumped_body(definition);
  ASSERT_EQ(body.size(), 3);
  EXPECT_EQ(body.total_mass, Vector3(4, 4, 0.5));
  Matrix expected = Matrix::Zero(6, 3);
  expected(1, 0) = expected(0, 1) = 1;
  EXPECT_EQ(body.point("frame").rows, expected);
}

TEST(LumpedBody, BaseMotionMovesTheMassesOfItsAxis) {
  const ReducedBody body = lumped_body(two_masses());
  EXPECT_EQ(body.total_mass, Vector3(4, 0, 0.5));
  EXPECT_EQ(body.effective_mass().colwise().sum().transpose(), Vector(body.total_mass));
}

TEST(LumpedBody, MassesOfOneAxisAddUp) {
  BodyDefinition definition = two_masses();
  definition.masses[1].axes = {0};
  const ReducedBody body = lumped_body(definition);
  EXPECT_EQ(body.total_mass, Vector3(4.5, 0, 0));
  EXPECT_EQ(body.effective_mass().colwise().sum().transpose(), Vector(body.total_mass));
}

TEST(LumpedBody, MissingMassesAreRefused) {
  BodyDefinition definition = two_masses();
  definition.masses[1].mass = 0;
  EXPECT_THROW(lumped_body(definition), structure::DefinitionError);
  definition.masses.clear();
  EXPECT_THROW(lumped_body(definition), structure::DefinitionError);
}

} // namespace lumped_body_tests
