#include "structure/members.h"

#include "structure/body_model.h"

#include <gtest/gtest.h>

namespace members_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

BeamDefinition line_of(int elements) {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(2, 0, 0), elements};
  beam.section.width = beam.section.thickness = 0.1;
  beam.material = {2e11, 0.3, 8000};
  beam.points = {{"end", {"end", {}}, 0, Vector3::Zero()}};
  return beam;
}

Member part(const std::string &name, double from, double to) {
  Member member{.name = name, .between = {{from, to}}};
  member.section.width = member.section.thickness = 0.05;
  member.material = {2e11, 0.3, 8000};
  return member;
}

/// Section, name and key of the error.
std::string refused(const BeamDefinition &beam) {
  try {
    build_frame(beam);
  } catch (const DefinitionError &error) {
    return error.kind() + " " + error.name() + "/" + error.key();
  }
  return "accepted";
}

/// Three lines that meet in node 1.
Mesh branching() {
  Mesh mesh;
  mesh.nodes = {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(2, 0, 0), Vector3(1, 1, 0)};
  mesh.lines = {{0, 1}, {1, 2}, {3, 1}};
  return mesh;
}

} // namespace

TEST(Members, NodesLieWherePositionsAndPartsAskForThem) {
  BeamDefinition beam = line_of(10);
  beam.points.push_back({"head", {"", Vector3(0.37, 0, 0)}, 0, Vector3::Zero()});
  beam.members = {part("root", 0, 1.5)};
  const BodyModel model = build_frame(beam);
  EXPECT_NEAR(model.mesh.nodes[model.points[1].node][0], 0.37, 1e-15);
  EXPECT_LT(
      (model.mesh.nodes[model.mesh.nearest_node(Vector3(1.5, 0, 0))] - Vector3(1.5, 0, 0)).norm(),
      1e-15);
  for (std::size_t line = 0; line < model.mesh.lines.size(); ++line)
    EXPECT_LE(model.mesh.line_length(line), 0.2 * (1 + 1e-6));
  EXPECT_NEAR(model.total_mass(), 8000 * (0.0025 * 1.5 + 0.01 * 0.5), 1e-9);
}

TEST(Members, PlacesAtNodesLeaveTheElementsEqual) {
  BeamDefinition beam = line_of(10);
  beam.points.push_back({"head", {"", Vector3(0.6, 0, 0)}, 0, Vector3::Zero()});
  const BodyModel model = build_frame(beam);
  ASSERT_EQ(model.mesh.lines.size(), 10U);
  for (std::size_t line = 0; line < 10; ++line)
    EXPECT_NEAR(model.mesh.line_length(line), 0.2, 1e-15);
}

TEST(Members, ChainsOfATaperedMember) {
  const Mesh mesh = branching();
  const auto places = places_on_chains(mesh, {0, 1}, "Member", "arm");
  EXPECT_EQ(places[0], (std::array<double, 2>{0, 0.5}));
  EXPECT_EQ(places[1], (std::array<double, 2>{0.5, 1}));
  EXPECT_THROW(places_on_chains(mesh, {0, 1, 2}, "Member", "arm"), DefinitionError);
  Mesh ring = branching();
  ring.lines = {{0, 1}, {1, 3}, {3, 0}};
  EXPECT_THROW(places_on_chains(ring, {0, 1, 2}, "Member", "arm"), DefinitionError);
}

TEST(Members, MistakesNameTheirKey) {
  BeamDefinition beam = line_of(4);
  beam.members = {part("root", 0, 1.5), part("tip", 1.4, 2)};
  EXPECT_EQ(refused(beam), "Member tip/Between");
  beam.members = {part("root", 0.5, 2.5)};
  EXPECT_EQ(refused(beam), "Member root/Between");
  beam.members = {part("root", 0, 1)};
  beam.members[0].section.width = 0;
  EXPECT_EQ(refused(beam), "Member root/Width");
  beam.members[0] = part("root", 0, 1);
  beam.members[0].material.young_modulus = -1;
  EXPECT_EQ(refused(beam), "Member root/Young modulus");
  beam.members[0] = part("root", 0, 1);
  beam.members[0].local_y = Vector3(1, 0, 0);
  EXPECT_EQ(refused(beam), "Member root/Orientation");
  beam.members[0].local_y.reset();
  beam.members[0].between.reset();
  beam.members[0].on = "legs";
  EXPECT_EQ(refused(beam), "Member root/On");
}

TEST(Members, HingesMustLeaveTheirNodesHeld) {
  BeamDefinition beam = line_of(4);
  beam.members = {part("root", 0, 1)};
  const Location middle{"", Vector3(1, 0, 0)};
  beam.hinges = {{"joint", "root", middle, {false, false, false, false, false, true}}};
  EXPECT_EQ(refused(beam), "accepted");
  beam.hinges[0].at = {"", Vector3(0.5, 0, 0)}; // inside the member: nothing holds the node
  EXPECT_EQ(refused(beam), "Hinge joint/Free");
  beam.hinges[0].at = {"", Vector3(2, 0, 0)};
  EXPECT_EQ(refused(beam), "Hinge joint/Position");
  beam.hinges[0].at = middle;
  beam.hinges[0].member = "leg";
  EXPECT_EQ(refused(beam), "Hinge joint/Member");
  beam.hinges[0].member = "root";
  beam.hinges.push_back({"root", "root", {"start", {}}, {true, false, false, true, false, false}});
  EXPECT_EQ(refused(beam), "Hinge root/Free");
  beam.supports = {{"base", {"start", {}}, {true, true, true, true, true, true}, {}}};
  EXPECT_EQ(refused(beam), "accepted");
}

TEST(Members, APlaneHoldsEverythingOutOfIt) {
  BeamDefinition beam = line_of(4);
  beam.plane_normal = 1;
  for (const std::array<bool, 6> &fixed : build_frame(beam).fixed)
    EXPECT_EQ(fixed, (std::array<bool, 6>{false, true, false, true, false, true}));
}

// A mass m at (a, b, c) from its node: the moment about z of a unit turn is m (a^2 + b^2) + J_z,
// the coupling of x and y rotations -m a b - J_xy, the momentum along y by a turn about z m a.
TEST(Members, MassesHaveAnArmAndAFullTensor) {
  BeamDefinition beam = line_of(4);
  beam.points[0] = {.name = "end",
                    .at = {"end", {}},
                    .mass = 3,
                    .rotary_inertia = Vector3(1, 2, 4),
                    .products_of_inertia = Vector3(0.5, 0, 0),
                    .offset = Vector3(0.1, 0.2, 0.3)};
  const BodyModel model = build_frame(beam);
  ASSERT_EQ(model.lumped_masses.size(), 1U);
  const LumpedMass &mass = model.lumped_masses.at(4);
  EXPECT_NEAR(mass(5, 5), 3 * (0.01 + 0.04) + 4, 1e-14);
  EXPECT_NEAR(mass(3, 4), -3 * 0.1 * 0.2 - 0.5, 1e-14);
  EXPECT_NEAR(mass(1, 5), 3 * 0.1, 1e-14);
  EXPECT_NEAR(mass(0, 5), -3 * 0.2, 1e-14);
  EXPECT_EQ((mass - mass.transpose()).norm(), 0);
}

} // namespace members_tests
