#include "structure/gmsh_reader.h"
#include "structure/mesh_check.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace gmsh_reader_tests {

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

std::string content_of(const std::string &path) {
  std::ifstream file(VIBROIMPACT_SOURCE_DIR "/" + path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
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
  EXPECT_EQ(parse_gmsh(content).lines.size(), 2U);
}

TEST(GmshReader, OtherFormatsAreNamed) {
  expect_problem(replace(version_4, "4.1 0 8", "4.1 0 4"), "8 bytes");
  expect_problem(replace(version_4, "4.1 0 8\n", std::string("4.1 1 8\n\0\0\0\1", 12)),
                 "byte order");
  expect_problem(replace(version_4, "4.1 0 8", "4 0 8"), "version 2.2 or 4.1, but is 4");
  expect_problem("solid nothing", "$MeshFormat");
}

TEST(GmshReader, OtherCellsAreRefused) {
  expect_problem(replace(version_2, "3 1 2 2 2 2 3", "3 4 2 2 2 1 2 3 7"), "volumes");
  expect_problem(replace(version_2, "3 1 2 2 2 2 3", "3 8 2 2 2 1 2 3"), "-order 1");
  expect_problem(replace(version_2, "3 1 2 2 2 2 3", "3 9 2 2 2 1 2 3"), "type 9; gmsh: -order 1");
}

TEST(GmshReader, DamagedFilesAreRefused) {
  expect_problem(version_2.substr(0, version_2.find("$EndElements")), "$Elements does not end");
  expect_problem(replace(version_2, "4\n7 9", "40\n7 9"), "$Nodes");
  expect_problem(replace(version_2, "2 1 0 0", "2 1 zero 0"), "$Nodes");
  expect_problem(replace(version_2, "1 15 2", "x 15 2"), "$Elements");
  expect_problem(replace(version_2, "3 1 2 2 2 2 3", "3 1 2 2 2 2 8"), "node 8 is missing");
}

TEST(GmshReader, ACellTwiceInAGroupIsRefused) {
  expect_problem(replace(version_2, "4 1 2 5 1 1 2", "4 1 2 2 1 2 1"), "group arm has the one");
}

// Two triangles and a quadrilateral with a stiffened edge, written by Gmsh in all four forms: the
// same mesh must come out.
TEST(GmshReader, AllFourFormsGiveTheSameSurfaces) {
  const Mesh first = parse_gmsh(content_of("tests/structure/meshes/mixed-22-ascii.msh"));
  EXPECT_GT(first.cells.size(), 4U);
  EXPECT_GT(first.cell_groups.at("thick part").size(), 0U);
  EXPECT_GT(first.cell_groups.at("thin part").size(), 0U);
  EXPECT_EQ(first.groups.at("corner").size(), 1U);
  EXPECT_EQ(first.line_groups.at("left edge").size(), 3U);
  EXPECT_EQ(first.groups.at("left edge").size(), 4U);
  for (const char *form : {"22-binary", "41-ascii", "41-binary"}) {
    const Mesh other =
        parse_gmsh(content_of(std::string("tests/structure/meshes/mixed-") + form + ".msh"));
    EXPECT_EQ(other.cells, first.cells) << form;
    EXPECT_EQ(other.lines, first.lines) << form;
    EXPECT_EQ(other.groups, first.groups) << form;
    EXPECT_EQ(other.cell_groups, first.cell_groups) << form;
    EXPECT_EQ(other.line_groups, first.line_groups) << form;
    ASSERT_EQ(other.nodes.size(), first.nodes.size()) << form;
    for (std::size_t i = 0; i < first.nodes.size(); ++i)
      EXPECT_LT((other.nodes[i] - first.nodes[i]).norm(), 1e-14) << form;
  }
}

TEST(GmshReader, DamagedBinaryFilesAreRefused) {
  const std::string content = content_of("tests/structure/meshes/mixed-41-binary.msh");
  const std::size_t end = content.find("$EndElements");
  expect_problem(content.substr(0, end - 20) + content.substr(end), "$Elements breaks off");
  expect_problem(content.substr(0, end), "$Elements does not end");
}

TEST(GmshReader, TheShippedDoubleCrossIsRead) {
  const Mesh mesh = parse_gmsh(content_of("meshes/double-cross.msh"));
  EXPECT_EQ(mesh.nodes.size(), 161U);
  EXPECT_EQ(mesh.lines.size(), 160U);
  EXPECT_EQ(mesh.groups.at("ends").size(), 8U);
  EXPECT_EQ(mesh.groups.at("joint").size(), 1U);
  EXPECT_NO_THROW(check_line_mesh(mesh));
}

} // namespace gmsh_reader_tests
