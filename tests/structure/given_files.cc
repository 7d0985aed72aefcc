// Tables of degrees of freedom, matrices in text files and input decks.
#include "structure/dof_table.h"
#include "structure/input_deck.h"
#include "structure/matrix_file.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace given_files_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;
using vibroimpact::testing::TemporaryFolder;

namespace {

/// The whole matrix, or the message.
struct Read {
  Matrix matrix;
  std::string problem{};
};

Read read(const std::string &content, int size) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "a.sti";
  std::ofstream(file) << content;
  Read result{.matrix = Matrix::Zero(size, size)};
  try {
    for (const MatrixEntry &entry : read_matrix_file(file, "Stiffness", size, MPI_COMM_SELF))
      result.matrix(entry.row, entry.column) += entry.value;
  } catch (const DefinitionError &error) {
    result.problem = error.key() + " " + error.problem();
  }
  return result;
}

std::string table_problem(const std::string &content) {
  try {
    read_dof_table(content, "a.dof");
  } catch (const DefinitionError &error) {
    return error.key() + " " + error.problem();
  }
  return "";
}

std::string deck_problem(const std::string &content) {
  try {
    read_input_deck(content, 1, "a.inp");
  } catch (const DefinitionError &error) {
    return error.key() + " " + error.problem();
  }
  return "";
}

Mesh deck(const std::string &content) { return read_input_deck(content, 1, "a.inp"); }

const std::string cube = "*NODE, NSET=All\n1,0,0,0\n2,2,0,0\n3,2,2,0\n4,0,2,0\n"
                         "5,0,0,2\n6,2,0,2\n7,2,2,2\n8,0,2,2\n";

} // namespace

TEST(GivenFiles, OneTriangleIsTheWholeMatrix) {
  const Matrix expected = (Matrix(2, 2) << 2, -1, -1, 3).finished();
  EXPECT_EQ(read("1 1  2.0e+00\n1 2 -1.0e+00\n2 2 3\n", 2).matrix, expected);
  EXPECT_EQ(read("1 1 2\n2 1 -1\n2 2 +3", 2).matrix, expected);
  EXPECT_EQ(read("%%MatrixMarket matrix coordinate real symmetric\n% made by hand\n2 2 3\n"
                 "1 1 2\r\n2 1 -1\r\n2 2 3\r\n",
                 2)
                .matrix,
            expected);
  EXPECT_EQ(read("%%MatrixMarket matrix coordinate integer general\n2 2 4\n1 1 2\n2 1 -1\n"
                 "1 2 -1\n2 2 3\n",
                 2)
                .matrix,
            expected);
}

TEST(GivenFiles, BadMatricesAreRefusedWithTheirLine) {
  const auto expect = [](const std::string &content, const std::string &part) {
    const std::string problem = read(content, 2).problem;
    EXPECT_NE(problem.find("Stiffness must"), std::string::npos) << problem;
    EXPECT_NE(problem.find(part), std::string::npos) << problem;
  };
  expect("1 1 2\n1 x 3\n", "line 2 of a.sti is \"1 x 3\"");
  expect("1 1 2\n1 2\n", "line 2 of a.sti is \"1 2\"");
  expect("1 1 2\n\n3 1 1\n", "rows and columns from 1 to 2");
  expect("1 1 2\n\n3 1 1\n", "line 3 of a.sti is \"3 1 1\"");
  expect("0 1 2\n", "from 1 to 2");
  expect("1 1 nan\n", "finite");
  expect("1 1 1e999\n", "ROW COLUMN VALUE");
  expect("1 1 2\n1 2 1\n2 1 1\n", "line 2 of a.sti is above the diagonal and line 3 below");
  expect("%%MatrixMarket matrix array real symmetric\n", "coordinate real symmetric");
  expect("%%MatrixMarket matrix coordinate real symmetric\n2 x 3\n", "ROWS COLUMNS ENTRIES");
  expect("%%MatrixMarket matrix coordinate real symmetric\n", "ends before");
  expect("%%MatrixMarket matrix coordinate real symmetric\n3 3 1\n1 1 1\n", "3 x 3");
  expect("%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 1\n", "has 1");
  expect("", "there is none");
  expect("\n\n", "has none");
}

TEST(GivenFiles, TablesHaveNodeDirectionAndCoordinates) {
  const std::vector<TableRow> plain = read_dof_table("5.1\n5.3\n12.6\n", "a.dof");
  ASSERT_EQ(plain.size(), 3U);
  EXPECT_EQ(plain[1].node, 5);
  EXPECT_EQ(plain[2].component, 5);
  EXPECT_FALSE(plain[0].position);
  const std::vector<TableRow> placed = read_dof_table("# made\n\n7 ry 1 2 3\n7, 1, 1, 2, 3\n", "");
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_EQ(placed[0].component, 4);
  EXPECT_EQ(*placed[1].position, Vector3(1, 2, 3));
}

TEST(GivenFiles, BadTablesAreRefusedWithTheirLine) {
  for (const char *bad : {"5", "5.7", "5.0", "0.1", "x.1", "5 q", "5 1 2 3", "5 1 1 2 nan"}) {
    const std::string problem = table_problem(std::string("1.1\n") + bad + "\n");
    EXPECT_NE(problem.find("line 2 of a.dof is \"" + std::string(bad)), std::string::npos)
        << bad << ": " << problem;
  }
  EXPECT_NE(table_problem("# nothing\n").find("a.dof has none"), std::string::npos);
}

TEST(GivenFiles, DecksHaveNodesSetsAndOuterFaces) {
  const Mesh mesh = deck(cube + "9,0,0,4\n10,2,0,4\n11,2,2,4\n12,0,2,4\n"
                                "** two cubes, one on the other\n"
                                "*Element, type=C3D8I, elset=e\n1,1,2,3,4,5,6,7,8\n"
                                "2,5,6,7,8,\n9,10,11,12\n"
                                "*NSET, NSET=foot\n1,2,3,\n4\n*NSET, NSET=both, GENERATE\n1,11,5\n"
                                "*NSET, NSET=more\nfoot, 12\n*STEP\n*FREQUENCY\n10\n");
  EXPECT_EQ(mesh.nodes.size(), 12U);
  EXPECT_EQ(mesh.cells.size(), 10U);
  EXPECT_EQ(mesh.numbers.at(12), 11);
  EXPECT_EQ(mesh.groups.at("FOOT"), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.groups.at("BOTH"), (std::vector<int>{0, 5, 10}));
  EXPECT_EQ(mesh.groups.at("MORE"), (std::vector<int>{0, 1, 2, 3, 11}));
  EXPECT_EQ(mesh.groups.at("ALL").size(), 12U);
  EXPECT_NEAR(mesh.extent(), std::sqrt(4 + 4 + 16), 1e-12);
}

// The outer normals of the faces close: the volume by the divergence theorem is that of the solid.
TEST(GivenFiles, FacesOfSolidsLieAroundThem) {
  const auto volume = [](const Mesh &mesh) {
    double sum = 0;
    for (const Cell &surface : mesh.cells)
      for (int i = 1; i + 1 < surface.size; ++i) {
        const Vector3 a = mesh.nodes[surface.corners[0]];
        const Vector3 b = mesh.nodes[surface.corners[i]];
        const Vector3 c = mesh.nodes[surface.corners[i + 1]];
        sum += a.dot(b.cross(c)) / 6;
      }
    return sum;
  };
  const std::string middles = "9,1,0,0\n10,2,1,0\n11,1,2,0\n12,0,1,0\n13,1,0,2\n14,2,1,2\n"
                              "15,1,2,2\n16,0,1,2\n17,0,0,1\n18,2,0,1\n19,2,2,1\n20,0,2,1\n";
  EXPECT_NEAR(volume(deck(cube + "*ELEMENT,TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n")), 8, 1e-12);
  const Mesh bricks = deck(cube + middles +
                           "*ELEMENT,TYPE=C3D20R\n1,1,2,3,4,5,6,7,8,9,10,11,12,"
                           "13,14,15,\n16,17,18,19,20\n");
  EXPECT_NEAR(volume(bricks), 8, 1e-12);
  EXPECT_EQ(bricks.cells.size(), 30U);
  EXPECT_NEAR(volume(deck(cube + "*ELEMENT,TYPE=C3D6\n1,1,2,3,5,6,7\n")), 4, 1e-12);
  EXPECT_NEAR(volume(deck(cube + "9,1,0,0\n10,2,1,0\n11,1,1,0\n12,1,0,2\n13,2,1,2\n14,1,1,2\n"
                                 "15,0,0,1\n16,2,0,1\n17,2,2,1\n*ELEMENT,TYPE=C3D15\n"
                                 "1,1,2,3,5,6,7,9,10,11,12,13,14,15,16,17\n")),
              4, 1e-12);
  EXPECT_NEAR(volume(deck(cube + "*ELEMENT,TYPE=C3D4\n1,1,2,3,5\n")), 4. / 3, 1e-12);
  EXPECT_NEAR(volume(deck(cube + "9,1,0,0\n10,2,1,0\n11,1,1,0\n12,0,0,1\n13,1,0,1\n14,1,1,1\n"
                                 "*ELEMENT,TYPE=C3D10\n1,1,2,3,5,9,10,11,12,13,14\n")),
              4. / 3, 1e-12);
}

TEST(GivenFiles, ShellsAndBeamsOfDecks) {
  const Mesh mesh = deck(cube + "*ELEMENT,TYPE=S4R\n1,1,2,3,4\n*ELEMENT,TYPE=S3\n2,5,6,7\n"
                                "*ELEMENT,TYPE=B32R\n3,1,5,8\n*ELEMENT,TYPE=SPRINGA\n4,2,6\n");
  ASSERT_EQ(mesh.cells.size(), 2U);
  EXPECT_EQ(mesh.cells[0].size + mesh.cells[1].size, 7);
  EXPECT_EQ(mesh.lines, (std::vector<std::array<int, 2>>{{0, 4}, {4, 7}}));
}

TEST(GivenFiles, BadDecksAreRefusedWithTheirLine) {
  const auto expect = [](const std::string &content, const std::string &part) {
    const std::string problem = deck_problem(content);
    EXPECT_NE(problem.find(part), std::string::npos) << problem;
  };
  expect("*NODE\n1,0,x,0\n", "line 2 of a.inp is \"1,0,x,0\"");
  expect("*NODE\n1,0,nan,0\n", "line 2 of a.inp");
  expect("*NODE\n-1,0,0,0\n", "from 1 on");
  expect("*NODE\n1,0,0,0\n*ELEMENT,TYPE=B31\n1,1,2\n", "names under *NODE before");
  expect("*NODE\n1,0,0,0\n*ELEMENT,TYPE=S4\n1,1,1\n*STEP\n", "4 nodes for each element");
  expect("*NODE\n1,0,0,0\n*NSET,NSET=a\nb\n", "from 1 on");
  expect("*INCLUDE, INPUT=mesh.inp\n", "without *INCLUDE");
  expect("*STEP\n", "a.inp has none");
}

} // namespace given_files_tests
