#include "output/contact_fields.h"

#include <gtest/gtest.h>

namespace vibroimpact::output {
namespace contact_fields_tests {

using Column = Eigen::Matrix<float, 6, 1>;

Column column(float fx, float fy, float fz, float gap, float peak, float state) {
  return (Column() << fx, fy, fz, gap, peak, state).finished();
}

/// At one instant; positive forces push the node of the first body along -z.
ContactTrace trace(int node, double gap, double force, double peak) {
  return {.nodes = {{.body = 0, .node = node, .push = -Vector3::UnitZ()}},
          .gap = {gap},
          .force = {force},
          .peak_force = {peak}};
}

Motion with(std::vector<ContactTrace> contacts) {
  Motion motion;
  motion.contacts = std::move(contacts);
  return motion;
}

TEST(ContactFields, SayWhereNothingTouchesWhereAContactIsOpenAndWhereAForceActs) {
  const ContactFields fields =
      contact_fields(with({trace(1, 0.25, 0, 3), trace(2, -0.5, 2, 4)}), 0, 3, 0);
  EXPECT_EQ(fields.col(0), column(0, 0, 0, 0, 0, 0));
  EXPECT_EQ(fields.col(1), column(0, 0, 0, 0.25, 3, 1));
  EXPECT_EQ(fields.col(2), column(0, 0, -2, -0.5, 4, 2));
}

// Kelvin-Voigt stops inside which the tension is cut off push with no force; others may pull.
TEST(ContactFields, TheForceDecidesNotTheGap) {
  const ContactFields fields =
      contact_fields(with({trace(0, -0.5, 0, 3), trace(1, 0.5, -2, 4)}), 0, 2, 0);
  EXPECT_EQ(fields(5, 0), 1);
  EXPECT_EQ(fields(5, 1), 2);
}

TEST(ContactFields, SeveralContactsOfANode) {
  const ContactFields fields =
      contact_fields(with({trace(0, -0.5, 2, 4), trace(0, 0.25, 0, 7)}), 0, 1, 0);
  EXPECT_EQ(fields.col(0), column(0, 0, -2, -0.5, 7, 2));
}

TEST(ContactFields, OtherBodiesAndContactsWithoutMeshes) {
  EXPECT_EQ(contact_fields(with({trace(0, 1, 2, 3)}), 1, 1, 0).col(0), column(0, 0, 0, 0, 0, 0));
  Motion motion = with({trace(0, 1, 2, 3)});
  motion.contacts[0].nodes.clear();
  EXPECT_EQ(contact_fields(motion, 0, 1, 0).cols(), 0);
}

/// One body whose two nodes are at x = 0 and 1.
std::vector<reduction::ReducedBody> rod() {
  std::vector<reduction::ReducedBody> bodies(1);
  bodies[0].recovery.nodes = Matrix::Zero(3, 2);
  bodies[0].recovery.nodes(0, 1) = 1;
  return bodies;
}

// A stop 5 mm above the node that has moved 3 mm towards it and 8 mm to the side.
TEST(ContactFieldsStops, StandAtTheClearanceWhateverTheNodeDoes) {
  Vector moved = Vector::Zero(12);
  moved.segment<3>(6) = Vector3(0.008, 0, 0.003);
  const std::vector<StopFace> faces = stop_faces(rod(), with({trace(1, 0.002, 0, 0)}), {moved}, 0);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0].place, Vector3(1, 0, 0));
  EXPECT_EQ(faces[0].normal, Vector3(0, 0, 1));
  EXPECT_NEAR((faces[0].displacement - Vector3(0, 0, 0.005)).norm(), 0, 1e-15);
  EXPECT_EQ(faces[0].contact[5], 1);
}

TEST(ContactFieldsStops, NoneBetweenMeshesAndNoneWithoutThem) {
  Motion motion = with({trace(1, 0.002, 0, 0)});
  motion.contacts[0].nodes.push_back(motion.contacts[0].nodes[0]);
  EXPECT_TRUE(stop_faces(rod(), motion, {Vector::Zero(12)}, 0).empty());
  motion.contacts[0].nodes.clear();
  EXPECT_TRUE(stop_faces(rod(), motion, {Vector::Zero(12)}, 0).empty());
}

} // namespace contact_fields_tests
} // namespace vibroimpact::output
