// Triangles too large for the curvature of their surface.
#include "structure/triangle_locking.h"

#include "structure/shell_mesh.h"
#include "structure/surface_normals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace triangle_locking_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

/// z = curvature (x^2 + kind y^2) / 2 over a unit square of n x n squares, each cut in two.
Mesh bowl(int n, double curvature, double kind) {
  Mesh mesh = generate_plate({.corner = {-0.5, -0.5, 0},
                              .first_end = {0.5, -0.5, 0},
                              .second_end = {-0.5, 0.5, 0},
                              .elements = {n, n},
                              .shape = CellShape::triangle});
  for (Vector3 &node : mesh.nodes)
    node.z() = curvature / 2 * (node.x() * node.x() + kind * node.y() * node.y());
  return mesh;
}

std::optional<TriangleLocking> locking(const Mesh &mesh, double thickness) {
  return find_locking(mesh, surface_normals(mesh), std::vector(mesh.cells.size(), thickness));
}

} // namespace

// size^2 / (R t) = 1 with size 1/10 and R = 10 and t = 1e-3, for domes as for saddles.
TEST(TriangleLocking, IsAMatterOfSizeRadiusAndThickness) {
  for (const double kind : {1.0, -1.0}) {
    const auto found = locking(bowl(10, 0.1, kind), 1e-3);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->triangles, 200);
    EXPECT_GT(found->locking, 100);
    EXPECT_NEAR(found->size_ratio, 1, 0.05);
    EXPECT_FALSE(locking(bowl(10, 0.1, kind), 4.2e-3).has_value());
    EXPECT_FALSE(locking(bowl(21, 0.1, kind), 1e-3).has_value());
  }
}

// Cylinders and plates do not lock.
TEST(TriangleLocking, NeedsCurvatureBothWays) {
  EXPECT_FALSE(locking(bowl(10, 0.1, 0), 1e-5).has_value());
  EXPECT_FALSE(locking(bowl(10, 0, 0), 1e-5).has_value());
  EXPECT_FALSE(locking(generate_cylinder({.start = {0, 0, 0},
                                          .end = {0, 0, 1},
                                          .radius = 0.05,
                                          .angles = {0, 2 * M_PI},
                                          .zero = {},
                                          .elements = {24, 20},
                                          .shape = CellShape::triangle}),
                       3e-4)
                   .has_value());
}

TEST(TriangleLocking, IsSaidWithNumberPlaceAndAdvice) {
  const std::string text = locking_sentence(
      {.triangles = 200, .locking = 7, .size_ratio = 4, .place = Vector3(1, 2, 3)});
  for (const char *words : {"7 of 200 triangles", "around (1, 2, 3) m", "= 4; up to 0.25",
                            "quadrilaterals", "smaller by a factor of 4 there"})
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

} // namespace triangle_locking_tests
