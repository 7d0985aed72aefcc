// The normals of the surface that a mesh stands for.
#include "structure/surface_normals.h"

#include "structure/shell_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace surface_normals_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

Mesh one_strip(double height) { // two squares with a fold between them
  Mesh mesh;
  mesh.nodes = {{-1, 0, 0}, {0, 0, 0}, {1, 0, height}, {-1, 1, 0}, {0, 1, 0}, {1, 1, height}};
  mesh.cells = {cell_of(CellShape::quadrilateral, {0, 1, 4, 3}),
                cell_of(CellShape::quadrilateral, {1, 2, 5, 4})};
  return mesh;
}

} // namespace

// A cylinder of 24 elements around: inside the mesh the normals are radial.
TEST(SurfaceNormals, AreThoseOfTheSmoothSurface) {
  const Mesh mesh = generate_cylinder({.start = {0, 0, 0},
                                       .end = {0, 0, 3},
                                       .radius = 0.5,
                                       .angles = {0, 2 * M_PI},
                                       .zero = {},
                                       .elements = {24, 3},
                                       .shape = CellShape::quadrilateral});
  const std::vector<std::array<Vector3, 4>> normals = surface_normals(mesh);
  for (std::size_t number = 0; number < mesh.cells.size(); ++number)
    for (int i = 0; i < 4; ++i) {
      const Vector3 &at = mesh.nodes[mesh.cells[number].corners[i]];
      EXPECT_LT((normals[number][i] - Vector3(2 * at.x(), 2 * at.y(), 0)).norm(), 1e-14);
    }
}

TEST(SurfaceNormals, EndAtFoldsAndFollowTheNumbering) {
  Mesh mesh = one_strip(0.5); // 26.6 degrees
  const double half = std::atan(0.5) / 2;
  const Vector3 mean(-std::sin(half), 0, std::cos(half));
  EXPECT_LT((surface_normals(mesh)[0][1] - mean).norm(), 1e-14);
  EXPECT_LT((surface_normals(mesh)[0][0] - Vector3::UnitZ()).norm(), 1e-14);
  std::swap(mesh.cells[1].corners[1], mesh.cells[1].corners[3]);
  EXPECT_LT((surface_normals(mesh)[0][1] - mean).norm(), 1e-14);
  EXPECT_LT((surface_normals(mesh)[1][0] + mean).norm(), 1e-14);
  EXPECT_LT((surface_normals(one_strip(0.6))[0][1] - Vector3::UnitZ()).norm(), 1e-14); // 31 degrees
}

} // namespace surface_normals_tests
