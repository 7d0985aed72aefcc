#include "structure/gmsh_reader.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

// A bent line 1-2-3 with a lonely node 7, a named point group and a named line group; the first
// line stands in two physical groups, which version 2.2 writes as two elements.
const std::string version_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
0 1 "the tip"
1 2 "arm"
$EndPhysicalNames
$Nodes
4
7 9 9 9
1 0 0 0
2 1 0 0
3 1 2.5e0 0
$EndNodes
$Elements
4
1 15 2 1 3 3
2 1 2 2 1 1 2
3 1 2 2 2 2 3
4 1 2 5 1 1 2
$EndElements
)";

const std::string version_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
0 1 "the tip"
1 2 "arm"
$EndPhysicalNames
$Entities
3 2 0 0
1 0 0 0 0
2 1 0 0 0
3 1 2.5 0 1 1
1 0 0 0 1 0 0 2 2 5 2 1 -2
2 1 0 0 1 2.5 0 1 -2 2 2 -3
$EndEntities
$Nodes
3 4 1 7
0 1 0 2
1
7
0 0 0
9 9 9
0 2 0 1
2
1 0 0
1 2 1 1
3
1 2.5 0 0.5
$EndNodes
$Elements
3 3 1 3
0 3 15 1
1 3
1 1 1 1
2 1 2
1 2 1 1
3 2 3
$EndElements
)";

std::string replace(std::string text, const std::string &from, const std::string &to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string problem_of(const std::string &content) {
  try {
    parse_gmsh(content);
  } catch (const DefinitionError &error) {
    return error.problem();
  }
  return "";
}

void expect_problem(const std::string &content, const std::string &words) {
  EXPECT_NE(problem_of(content).find(words), std::string::npos) << problem_of(content);
}

} // namespace

TEST(GmshReader, BothVersionsGiveTheSameMesh) {
  for (const std::string &content : {version_2, version_4}) {
    const Mesh mesh = parse_gmsh(content);
    ASSERT_EQ(mesh.nodes.size(), 3U);
    EXPECT_EQ(mesh.nodes[2], Vector3(1, 2.5, 0));
    ASSERT_EQ(mesh.lines.size(), 2U);
    EXPECT_EQ(mesh.lines[0], (std::array<int, 2>{0, 1}));
    EXPECT_EQ(mesh.lines[1], (std::array<int, 2>{1, 2}));
    EXPECT_EQ(mesh.groups.at("the tip"), std::vector<int>{2});
    EXPECT_EQ(mesh.groups.at("arm"), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(mesh.groups.at("5"), (std::vector<int>{0, 1}));
  }
}

TEST(GmshReader, WindowsLineEndsAreRead) {
  std::string content;
  for (const char letter : version_4)
    content += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  EXPECT_EQ(parse_gmsh(content).cells.size(), 2U);
}

TEST(GmshReader, OtherFormatsAreNamed) {
  expect_problem(replace(version_4, "4.1 0 8", "4.1 1 8"), "binary");
  expect_problem(replace(version_4, "4.1 0 8", "4 0 8"), "version 2.2 or 4.1, but is 4");
  expect_problem("solid nothing", "$MeshFormat");
}

TEST(GmshReader, OtherCellsAreRefused) {
  expect_problem(replace(version_2, "3 1 2 2 2 2 3", "3 2 2 2 2 1 2 3"), "element type 2");
  expect_problem(replace(version_2, "3 1 2 2 2 2 3", "3 8 2 2 2 1 2 3"), "-order 1");
}

TEST(GmshReader, DamagedFilesAreRefused) {
  expect_problem(version_2.substr(0, version_2.find("$EndElements")), "$Elements does not end");
  expect_problem(replace(version_2, "4\n7 9", "40\n7 9"), "$Nodes");
  expect_problem(replace(version_2, "2 1 0 0", "2 1 zero 0"), "$Nodes");
  expect_problem(replace(version_2, "1 15 2", "x 15 2"), "$Elements");
  expect_problem(replace(version_2, "3 1 2 2 2 2 3", "3 1 2 2 2 2 8"), "node 8 is missing");
}

TEST(GmshReader, TheShippedDoubleCrossIsRead) {
  std::ifstream file(VIBROIMPACT_SOURCE_DIR "/meshes/double-cross.msh");
  std::ostringstream content;
  content << file.rdbuf();
  const Mesh mesh = parse_gmsh(content.str());
  EXPECT_EQ(mesh.nodes.size(), 161U);
  EXPECT_EQ(mesh.lines.size(), 160U);
  EXPECT_EQ(mesh.groups.at("ends").size(), 8U);
  EXPECT_EQ(mesh.groups.at("joint").size(), 1U);
  EXPECT_NO_THROW(check_mesh(mesh));
}
