// Generated plates and cylinders, and the checks every surface mesh goes through.
#include "structure/shell_mesh.h"

#include "structure/mesh_check.h"
#include "structure/shell_examples.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <functional>

namespace shell_mesh_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

Plate unit_plate(int columns, int rows, CellShape shape = CellShape::quadrilateral) {
  return {.corner = {0, 0, 0},
          .first_end = {2, 0, 0},
          .second_end = {0, 1, 0},
          .elements = {columns, rows},
          .shape = shape};
}

Cylinder half_pipe() {
  return {.start = {0, 0, 0},
          .end = {0, 0, 3},
          .radius = 0.5,
          .angles = {0, M_PI},
          .zero = {},
          .elements = {8, 3},
          .shape = CellShape::quadrilateral};
}

std::string problem_of(const std::function<void()> &action) {
  try {
    action();
  } catch (const DefinitionError &error) {
    return error.key() + " " + error.problem();
  }
  return "";
}

void expect_problem(const Mesh &mesh, const std::string &words,
                    const std::vector<int> &beams = {}) {
  const std::string problem = problem_of([&] { check_surface_mesh(mesh, beams); });
  EXPECT_NE(problem.find(words), std::string::npos) << problem;
}

} // namespace

TEST(ShellMesh, APlateHasItsNodesEdgesAndNormals) {
  const Mesh mesh = generate_plate(unit_plate(4, 2));
  EXPECT_EQ(mesh.nodes.size(), 15U);
  EXPECT_EQ(mesh.cells.size(), 8U);
  EXPECT_EQ(mesh.groups.at("left").size(), 3U);
  EXPECT_EQ(mesh.groups.at("top").size(), 5U);
  EXPECT_EQ(mesh.groups.at("edges").size(), 12U);
  for (const int node : mesh.groups.at("right"))
    EXPECT_EQ(mesh.nodes[node].x(), 2);
  for (const int node : mesh.groups.at("top"))
    EXPECT_EQ(mesh.nodes[node].y(), 1);
  EXPECT_EQ(mesh.line_groups.at("bottom").size(), 4U);
  EXPECT_EQ(mesh.line_groups.at("edges").size(), 12U);
  EXPECT_NO_THROW(check_surface_mesh(mesh, {}));
  const auto n = mesh.cells[0].nodes();
  EXPECT_GT((mesh.nodes[n[1]] - mesh.nodes[n[0]]).cross(mesh.nodes[n[2]] - mesh.nodes[n[0]]).z(),
            0);
}

TEST(ShellMesh, TrianglesCoverTheSameArea) {
  const Mesh mesh = generate_plate(unit_plate(4, 2, CellShape::triangle));
  EXPECT_EQ(mesh.cells.size(), 16U);
  double area = 0;
  for (const Cell &surface : mesh.cells) {
    const auto n = surface.nodes();
    area +=
        (mesh.nodes[n[1]] - mesh.nodes[n[0]]).cross(mesh.nodes[n[2]] - mesh.nodes[n[0]]).z() / 2;
  }
  EXPECT_NEAR(area, 2, 1e-14);
}

TEST(ShellMesh, ACylinderClosesItself) {
  Cylinder pipe = half_pipe();
  EXPECT_EQ(generate_cylinder(pipe).nodes.size(), 36U);
  EXPECT_EQ(generate_cylinder(pipe).groups.at("left").size(), 4U);
  pipe.angles = {0, 2 * M_PI};
  const Mesh closed = generate_cylinder(pipe);
  EXPECT_EQ(closed.nodes.size(), 32U);
  EXPECT_FALSE(closed.groups.contains("left"));
  EXPECT_EQ(closed.groups.at("top").size(), 8U);
  for (const Vector3 &node : closed.nodes)
    EXPECT_NEAR(std::hypot(node.x(), node.y()), 0.5, 1e-15);
  EXPECT_NO_THROW(check_surface_mesh(closed, {}));
}

TEST(ShellMesh, ACylinderStartsWhereItIsTold) {
  Cylinder pipe = half_pipe();
  pipe.zero = Vector3(0, 3, 1);
  EXPECT_LT((generate_cylinder(pipe).nodes[0] - Vector3(0, 0.5, 0)).norm(), 1e-15);
}

TEST(ShellMesh, ImpossibleGeometriesNameTheKey) {
  const auto plate_problem = [](const Plate &plate) {
    return problem_of([&] { generate_plate(plate); });
  };
  const auto pipe_problem = [](const Cylinder &pipe) {
    return problem_of([&] { generate_cylinder(pipe); });
  };
  Plate flat = unit_plate(2, 2);
  flat.second_end = {1, 0, 0};
  EXPECT_EQ(plate_problem(flat).rfind("Plate must have two edges", 0), 0U);
  EXPECT_EQ(plate_problem(unit_plate(0, 2)).rfind("Divisions", 0), 0U);
  Cylinder pipe = half_pipe();
  pipe.angles = {0, 7};
  EXPECT_EQ(pipe_problem(pipe).rfind("Angles", 0), 0U);
  pipe.angles = {0, 2 * M_PI};
  pipe.elements = {2, 2};
  EXPECT_EQ(pipe_problem(pipe).rfind("Divisions must be at least 3", 0), 0U);
  pipe = half_pipe();
  pipe.radius = 0;
  EXPECT_EQ(pipe_problem(pipe).rfind("Radius", 0), 0U);
  pipe = half_pipe();
  pipe.end = pipe.start;
  EXPECT_EQ(pipe_problem(pipe).rfind("Cylinder", 0), 0U);
  pipe = half_pipe();
  pipe.zero = Vector3::UnitZ();
  EXPECT_EQ(pipe_problem(pipe).rfind("Orientation", 0), 0U);
}

TEST(ShellMesh, BadCellsAreFoundWithTheirPlace) {
  const Mesh sound = generate_plate(unit_plate(2, 1));
  expect_problem({}, "triangles or quadrilaterals");
  Mesh mesh = sound;
  std::swap(mesh.cells[0].corners[0], mesh.cells[0].corners[1]);
  expect_problem(mesh, "inverted or folded");
  mesh = sound;
  mesh.nodes[0] = {0.9, 0.9, 0};
  expect_problem(mesh, "the one around (0.725, 0.725, 0) m");
  mesh = generate_plate(unit_plate(2, 1, CellShape::triangle));
  mesh.nodes[3] = {0, 0.02, 0};
  expect_problem(mesh, "an angle below 3 or above 177 degrees");
  mesh = sound;
  mesh.nodes[0] = {0, 0, 3};
  expect_problem(mesh, "warped by more than 60 degrees");
  mesh = sound;
  mesh.cells[1].corners[2] = mesh.cells[1].corners[1];
  expect_problem(mesh, "has one twice");
}

TEST(ShellMesh, LooseNodesAndPartsAreFound) {
  Mesh mesh = generate_plate(unit_plate(2, 1));
  mesh.nodes.emplace_back(5, 5, 5);
  expect_problem(mesh, "belong to no surface or beam, the first at (5, 5, 5) m");
  mesh.nodes.emplace_back(6, 5, 5);
  const auto first = static_cast<int>(mesh.nodes.size()) - 2;
  mesh.lines.push_back({first, first + 1});
  expect_problem(mesh, "2 parts that share no node", {static_cast<int>(mesh.lines.size()) - 1});
}

TEST(ShellMesh, ALineMeshHasNoSurfaces) {
  const std::string problem = problem_of([] { check_line_mesh(generate_plate(unit_plate(2, 1))); });
  EXPECT_NE(problem.find("lines only"), std::string::npos) << problem;
}

TEST(ShellMesh, OppositeNormalsAreFound) {
  Mesh mesh = generate_plate(unit_plate(2, 1));
  const std::vector<int> all = {0, 1};
  EXPECT_NO_THROW(check_orientation(mesh, all, "Load", "wind", "Pressure"));
  std::swap(mesh.cells[0].corners[1], mesh.cells[0].corners[3]);
  const std::string problem =
      problem_of([&] { check_orientation(mesh, all, "Load", "wind", "Pressure"); });
  EXPECT_NE(problem.find("Pressure must act on surfaces whose normals"), std::string::npos);
}

} // namespace shell_mesh_tests
