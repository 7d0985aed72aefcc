#include "structure/frame_element.h"
#include "common/decompositions.h"

#include <gtest/gtest.h>

namespace frame_element_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

BeamProperties properties() {
  return beam_properties({.kind = SectionShape::Kind::given,
                          .area = 2e-3,
                          .second_moment_y = 3e-7,
                          .second_moment_z = 8e-7,
                          .torsion_constant = 5e-7},
                         {2e11, 0.25, 8000});
}

PropertiesAlong uniform(const BeamProperties &properties) {
  return [properties](double) { return properties; };
}

FrameElement element_of(const ElementFrame &frame, const Vector3 &offset = Vector3::Zero()) {
  return {{0, 1}, uniform(properties()), frame, offset};
}

ElementMatrix stiffness_matrix(const ElementFrame &frame) { return element_of(frame).stiffness(); }
ElementMatrix mass_matrix(const ElementFrame &frame) { return element_of(frame).mass(); }

const Vector3 first(0.3, -0.2, 0.1);
const Vector3 second(1.1, 0.5, 0.9);

ElementFrame skew_frame() { return element_frame(first, second, Vector3(0.2, 1, -0.4)); }

// Nodal displacements of a small rigid motion about the origin.
ElementVector rigid_motion(const Vector3 &translation, const Vector3 &rotation) {
  ElementVector u;
  u << translation + rotation.cross(first), rotation, translation + rotation.cross(second),
      rotation;
  return u;
}

// Tip displacements of the element clamped at its first node under a tip load, in local axes.
Eigen::Matrix<double, 6, 1> tip_response(const ElementFrame &frame, int component) {
  const ElementMatrix stiffness = stiffness_matrix(frame);
  Eigen::Matrix<double, 6, 1> load = Eigen::Matrix<double, 6, 1>::Zero();
  load.segment<3>(component / 3 * 3) = frame.axes.row(component % 3).transpose();
  const Vector tip = LuFactors<Matrix>(stiffness.bottomRightCorner<6, 6>()).solve(Vector(load));
  Eigen::Matrix<double, 6, 1> local;
  local << frame.axes * tip.head<3>(), frame.axes * tip.tail<3>();
  return local;
}

} // namespace

TEST(FrameElement, MatricesAreSymmetricAndMassIsPositive) {
  const ElementMatrix k = stiffness_matrix(skew_frame());
  const ElementMatrix m = mass_matrix(skew_frame());
  EXPECT_EQ((k - k.transpose()).norm(), 0);
  EXPECT_EQ((m - m.transpose()).norm(), 0);
  EXPECT_GT(symmetric_eigen(m).values.minCoeff(), 0);
}

TEST(FrameElement, StiffnessHasRankSix) {
  const ElementMatrix k = stiffness_matrix(skew_frame());
  const ElementVector values = symmetric_eigen(k).values;
  EXPECT_LT(values.head<6>().cwiseAbs().maxCoeff(), 1e-12 * values[11]);
  EXPECT_GT(values[6], 1e-6 * values[11]);
}

TEST(FrameElement, RigidMotionCausesNoForce) {
  const ElementVector u = rigid_motion({0.1, -0.2, 0.3}, {0.02, 0.05, -0.03});
  const NodalMatrix force = element_of(skew_frame()).force(Matrix(), NodalMatrix(u));
  EXPECT_LT(force.norm(), 1e-14 * stiffness_matrix(skew_frame()).norm());
}

TEST(FrameElement, RigidTranslationMovesTheWholeMass) {
  const ElementFrame frame = skew_frame();
  const ElementMatrix m = mass_matrix(frame);
  const double mass = properties().mass_per_length * frame.length;
  for (int axis = 0; axis < 3; ++axis) {
    const ElementVector u = rigid_motion(Vector3::Unit(axis), Vector3::Zero());
    EXPECT_NEAR(u.dot(m * u), mass, 1e-14 * mass);
  }
}

// A rod of mass m has the moment of inertia m L^2 / 3 about its end.
TEST(FrameElement, RigidRotationHasTheInertiaOfARod) {
  const ElementFrame frame = element_frame(Vector3::Zero(), Vector3(2, 0, 0), {});
  const ElementMatrix m = mass_matrix(frame);
  ElementVector u = ElementVector::Zero();
  u[5] = u[11] = 1;
  u[7] = 2;
  const double expected = properties().mass_per_length * 8 / 3;
  EXPECT_NEAR(u.dot(m * u), expected, 1e-14 * expected);
}

// Nodes on the x axis, the beam a height h above them along z. A rigid turn about a line along x at
// the depth d below the nodes moves the mass m at the radius h + d: its inertia is m (h + d)^2 +
// the polar one. With the axis on the other side of the nodes it would be m (h - d)^2.
TEST(FrameElement, OffsetIsFromTheNodesToTheAxis) {
  constexpr double height = 0.3, depth = 0.2, length = 2;
  const ElementFrame frame = element_frame(Vector3::Zero(), Vector3(length, 0, 0), {});
  const FrameElement element = element_of(frame, Vector3(0, 0, height));
  const Vector3 turn = Vector3::UnitX();
  ElementVector u;
  u << turn.cross(Vector3(0, 0, depth)), turn, turn.cross(Vector3(length, 0, depth)), turn;
  const double mass = properties().mass_per_length * length;
  const double expected =
      mass * (height + depth) * (height + depth) + properties().polar_inertia * length;
  EXPECT_NEAR(u.dot(element.mass() * u), expected, 1e-13 * expected);
}

// The second node turns by t about y and steps back along x by h t: the end of the beam above it
// stays where it is along x, so that the beam bends without being stretched.
TEST(FrameElement, AnArmThatTurnsMovesTheEndOfTheAxis) {
  constexpr double height = 0.3, length = 2, t = 1e-3;
  const ElementFrame frame = element_frame(Vector3::Zero(), Vector3(length, 0, 0), {});
  const FrameElement element = element_of(frame, Vector3(0, 0, height));
  NodalMatrix u = ElementVector::Zero();
  u(6) = -height * t;
  u(10) = t;
  const double moment = 4 * properties().bending_stiffness_y / length * t;
  for (const NodalMatrix &force :
       {NodalMatrix(element.stiffness() * u), element.force(element.stiffness(), u)}) {
    EXPECT_NEAR(force(6), 0, 1e-9 * moment);
    EXPECT_NEAR(force(10) / moment, 1, 1e-12);
    EXPECT_NEAR(force(4) / moment, 0.5, 1e-12);
  }
}

TEST(FrameElement, TwistingInertiaIsThePolarOne) {
  const ElementFrame frame = element_frame(Vector3::Zero(), Vector3(2, 0, 0), {});
  ElementVector u = ElementVector::Zero();
  u[3] = u[9] = 1;
  const double expected = 8000 * (3e-7 + 8e-7) * 2;
  EXPECT_NEAR(u.dot(mass_matrix(frame) * u), expected, 1e-14 * expected);
}

TEST(FrameElement, TipLoadsGiveTheTextbookDeflections) {
  const ElementFrame frame = skew_frame();
  const BeamProperties p = properties();
  const double l = frame.length;
  EXPECT_NEAR(tip_response(frame, 0)[0] * p.axial_stiffness / l, 1, 1e-12);
  EXPECT_NEAR(tip_response(frame, 3)[3] * p.torsional_stiffness / l, 1, 1e-12);
  EXPECT_NEAR(tip_response(frame, 1)[1] * 3 * p.bending_stiffness_z / (l * l * l), 1, 1e-12);
  EXPECT_NEAR(tip_response(frame, 2)[2] * 3 * p.bending_stiffness_y / (l * l * l), 1, 1e-12);
  EXPECT_NEAR(tip_response(frame, 1)[5] * 2 * p.bending_stiffness_z / (l * l), 1, 1e-12);
  EXPECT_NEAR(tip_response(frame, 2)[4] * 2 * p.bending_stiffness_y / (l * l), -1, 1e-12);
}

TEST(FrameElement, LocalAxesAreRightHandedAndFollowTheOrientation) {
  const ElementFrame frame = element_frame(Vector3::Zero(), Vector3(0, 0, 2), Vector3(3, 0, 1));
  EXPECT_DOUBLE_EQ(frame.length, 2);
  EXPECT_LT((frame.axes.row(0).transpose() - Vector3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((frame.axes.row(1).transpose() - Vector3::UnitX()).norm(), 1e-15);
  EXPECT_LT((frame.axes.row(2).transpose() - Vector3::UnitY()).norm(), 1e-15);
}

TEST(FrameElement, DefaultOrientationIsGlobalYOrZ) {
  const auto local_y = [](const Vector3 &end) {
    return Vector3(element_frame(Vector3::Zero(), end, {}).axes.row(1));
  };
  EXPECT_LT((local_y({1, 0, 0}) - Vector3::UnitY()).norm(), 1e-15);
  EXPECT_LT((local_y({0, 0, 1}) - Vector3::UnitY()).norm(), 1e-15);
  EXPECT_LT((local_y({0, 1, 0}) - Vector3::UnitZ()).norm(), 1e-15);
}

TEST(FrameElement, ParallelOrZeroOrientationIsRefused) {
  EXPECT_THROW(element_frame(first, second, second - first), DefinitionError);
  EXPECT_THROW(element_frame(first, second, Vector3::Zero()), DefinitionError);
}

// An axis beside the line of the nodes: local y of a beam along x is global y, and the offset
// counts in global axes.
TEST(FrameElement, OutlineStandsAroundTheAxis) {
  const SectionShape bar{.width = 0.06, .thickness = 0.02};
  const auto places = std::make_shared<const SectionPlaces>(
      SectionPlaces{extreme_fibres(bar), section_outline(bar)});
  const ElementFrame along_x = element_frame(Vector3::Zero(), Vector3(2, 0, 0), {});
  const Matrix outline =
      FrameElement({0, 1}, uniform(properties()), along_x, Vector3(0, 0.1, 0.5), {places, places})
          .outline();
  ASSERT_EQ(outline.cols(), 4);
  EXPECT_NEAR(outline.row(1).minCoeff(), 0.07, 1e-15);
  EXPECT_NEAR(outline.row(1).maxCoeff(), 0.13, 1e-15);
  EXPECT_NEAR(outline.row(2).minCoeff(), 0.49, 1e-15);
  EXPECT_NEAR(outline.row(2).maxCoeff(), 0.51, 1e-15);
}

} // namespace frame_element_tests
