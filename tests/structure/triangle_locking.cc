// Triangles too large for the curvature of their surface.
#include "structure/triangle_locking.h"

#include "structure/shell_mesh.h"
#include "structure/surface_normals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace vibroimpact;
using namespace vibroimpact::structure;

// Of a cylinder: the normals at the corners turn by h / 2R against that of a triangle, which has
// its corners between h / 3 and h from its middle.
TEST(TriangleLocking, IsFoundByTheSagitta) {
  const Mesh mesh = generate_cylinder({.start = {0, 0, 0},
                                       .end = {0, 0, 1},
                                       .radius = 1,
                                       .angles = {0, 2 * M_PI},
                                       .zero = {},
                                       .elements = {24, 4},
                                       .shape = CellShape::triangle}); // h^2 / R = 0.069
  const auto locking = [](const Mesh &mesh, double thickness) {
    return find_locking(mesh, surface_normals(mesh), std::vector(mesh.surfaces.size(), thickness));
  };
  EXPECT_FALSE(locking(mesh, 0.1).has_value());
  const auto thin = locking(mesh, 0.01);
  ASSERT_TRUE(thin.has_value());
  EXPECT_EQ(thin->triangles, 192);
  EXPECT_EQ(thin->locking, 192);
  const auto thinner = locking(mesh, 0.005);
  EXPECT_NEAR(thinner->sagitta_to_thickness / thin->sagitta_to_thickness, 2, 1e-12);
  EXPECT_FALSE(
      locking(generate_plate(
                  {.first_end = {1, 0, 0}, .second_end = {0, 1, 0}, .shape = CellShape::triangle}),
              1e-6)
          .has_value());
  EXPECT_GT(thin->sagitta_to_thickness, 0.069 / 0.01 / 12);
  EXPECT_LT(thin->sagitta_to_thickness, 0.069 / 0.01 / 4);
}
