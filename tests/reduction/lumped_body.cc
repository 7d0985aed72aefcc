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
  definition.masses = {
      {.name = "frame", .mass = 4, .axes = {0}, .mount = {.stiffness = 100, .damping = 3}},
      {.name = "ball", .mass = 0.5, .axes = {2}, .position = Vector3(1, 2, 3)}};
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

// A wheel of two coordinates, its centre along x and its rotation about y, with a point at its rim.
BodyDefinition wheel() {
  BodyDefinition definition;
  definition.name = "wheel";
  definition.type = BodyDefinition::Type::lumped;
  definition.masses = {{.name = "centre",
                        .mass = 2,
                        .axes = {0, 4},
                        .mount = {.stiffness = 50},
                        .position = Vector3(0, 0, 1),
                        .inertia = Vector3(1, 3, 5),
                        .rotational_mount = {.stiffness = 12},
                        .damping_ratio = 0.25}};
  definition.lumped_points = {{.name = "rim", .mass = "centre", .arm = Vector3(0.5, 7, -0.25)}};
  return definition;
}

TEST(LumpedBody, TurnsAboutAxes) {
  const ReducedBody body = lumped_body(wheel());
  EXPECT_EQ(body.mass, Vector(Eigen::Vector2d(2, 3)));
  EXPECT_EQ(body.omega(), Vector(Eigen::Vector2d(5, 2)));
  EXPECT_EQ(body.damping_ratio(), Vector(Eigen::Vector2d(0.25, 0.25)));
  EXPECT_EQ(body.total_mass, Vector3(2, 0, 0));
  EXPECT_EQ(body.base_participation.row(1), RowVector::Zero(3));
}

// theta about y moves the arm r by (theta r_z, 0, -theta r_x).
TEST(LumpedBody, CarriesPointsAtAnArm) {
  const ReducedBody body = lumped_body(wheel());
  Matrix expected = Matrix::Zero(6, 2);
  expected(0, 0) = expected(4, 1) = 1;
  EXPECT_EQ(body.point("centre").rows, expected);
  expected(0, 1) = -0.25;
  expected(2, 1) = -0.5;
  EXPECT_EQ(body.point("rim").rows, expected);
  EXPECT_EQ(body.point("rim").position, Vector3(0.5, 7, 0.75));
}

TEST(LumpedBody, WhatTurnsNeedsInertiaAndWhatIsCarriedACarrier) {
  BodyDefinition definition = wheel();
  definition.masses[0].inertia[1] = 0;
  EXPECT_THROW(lumped_body(definition), structure::DefinitionError);
  definition = wheel();
  definition.lumped_points[0].mass = "hub";
  EXPECT_THROW(lumped_body(definition), structure::DefinitionError);
}

} // namespace lumped_body_tests
