#include "structure/mesh_check.h"

#include <gtest/gtest.h>

namespace mesh_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

Mesh unit_line() { return generate_line({Vector3::Zero(), Vector3(0, 0, 1), 4}); }

std::string problem_of(const Mesh &mesh) {
  try {
    check_line_mesh(mesh);
  } catch (const DefinitionError &error) {
    return error.problem();
  }
  return "";
}

} // namespace

TEST(Mesh, GeneratedLineHasEqualElementsAndNamedEnds) {
  const Mesh mesh = unit_line();
  ASSERT_EQ(mesh.nodes.size(), 5U);
  ASSERT_EQ(mesh.lines.size(), 4U);
  for (std::size_t cell = 0; cell < 4; ++cell)
    EXPECT_DOUBLE_EQ(mesh.line_length(cell), 0.25);
  EXPECT_EQ(find_nodes(mesh, {"start", {}}, "Support", "a"), std::vector<int>{0});
  EXPECT_EQ(find_nodes(mesh, {"end", {}}, "Support", "a"), std::vector<int>{4});
  EXPECT_EQ(find_nodes(mesh, {"all", {}}, "Support", "a").size(), 5U);
  EXPECT_EQ(problem_of(mesh), "");
}

TEST(Mesh, ImpossibleLinesAreRefused) {
  EXPECT_THROW(generate_line({Vector3::Ones(), Vector3::Ones(), 4}), DefinitionError);
  EXPECT_THROW(generate_line({Vector3::Zero(), Vector3::Ones(), 0}), DefinitionError);
}

TEST(Mesh, PositionsMeetNodesWithinATolerance) {
  EXPECT_EQ(find_nodes(unit_line(), {"", Vector3(0, 1e-8, 0.5)}, "Point", "p"),
            std::vector<int>{2});
}

TEST(Mesh, AMissedPositionNamesTheNearestNode) {
  try {
    find_nodes(unit_line(), {"", Vector3(0, 0, 0.7)}, "Point", "p");
    FAIL();
  } catch (const DefinitionError &error) {
    EXPECT_EQ(error.kind(), "Point");
    EXPECT_EQ(error.name(), "p");
    EXPECT_EQ(error.key(), "Position");
    EXPECT_NE(error.problem().find("(0, 0, 0.75) m"), std::string::npos) << error.problem();
  }
}

TEST(Mesh, AnUnknownGroupNamesTheKnownOnes) {
  try {
    find_nodes(unit_line(), {"middle", {}}, "Support", "s");
    FAIL();
  } catch (const DefinitionError &error) {
    EXPECT_EQ(error.key(), "At");
    EXPECT_NE(error.problem().find("end, start, all"), std::string::npos) << error.problem();
  }
}

TEST(Mesh, SeparatePartsAreCounted) {
  Mesh mesh = unit_line();
  mesh.nodes.insert(mesh.nodes.end(), {Vector3(1, 0, 0), Vector3(1, 1, 0)});
  mesh.lines.push_back({5, 6});
  EXPECT_NE(problem_of(mesh).find("2 parts"), std::string::npos);
}

TEST(Mesh, CellsWithoutLengthAndEmptyMeshesAreRefused) {
  Mesh mesh = unit_line();
  mesh.nodes[1] = mesh.nodes[0];
  EXPECT_NE(problem_of(mesh).find("positive length"), std::string::npos);
  EXPECT_NE(problem_of({}).find("line cells"), std::string::npos);
}

} // namespace mesh_tests
