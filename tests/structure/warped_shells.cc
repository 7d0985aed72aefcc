// The quadrilateral shell element where it is warped: bending without stretching, stresses, rigid
// motions, numbering.
#include "common/decompositions.h"
#include "structure/quadrilateral_shell.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <random>

namespace warped_shells_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

const Material material = {1e6, 0.25, 1000};

ShellProperties properties(double thickness) {
  return shell_properties(thickness, material, "", "");
}

QuadrilateralShell element(const NodeVectors &corners, double thickness) {
  return {{0, 1, 2, 3}, corners, corner_normals(corners), properties(thickness)};
}

/// Of the surface z = twist x y over a rectangle in the middle.
NodeVectors saddle(double twist, double length = 1, double width = 1) {
  NodeVectors corners;
  for (int i = 0; i < 4; ++i) {
    const double x = corner_r[i] * length / 2;
    const double y = corner_s[i] * width / 2;
    corners[i] = {x, y, twist * x * y};
  }
  return corners;
}

Vector rising_eigenvalues(const Matrix &matrix) { return symmetric_eigen(matrix).values; }

NodalVector rigid_motion(const NodeVectors &corners, const Vector3 &shift, const Vector3 &omega) {
  NodalVector u(24);
  for (int i = 0; i < 4; ++i)
    u.segment<6>(6 * i) << shift + omega.cross(corners[i]), omega;
  return u;
}

/// Corners of a square moved at random by up to 0.3 in each direction.
NodeVectors random_corners(std::mt19937 &random) {
  std::uniform_real_distribution<double> move(-0.3, 0.3);
  NodeVectors corners = saddle(0);
  for (Vector3 &corner : corners)
    corner += Vector3(move(random), move(random), move(random));
  return corners;
}

} // namespace

// The surface z = c x y bends without stretching by w = x^2 / 2 with u = -c x^2 y / 2,
// v = -c x^3 / 6, and turns by -c x^2 / 2 about z (slopes small). What is left is the energy of
// bending, D / 2 per area. A drilling that answers to this, or displacements that are not carried
// to the mean plane, cost (size^2 c / thickness)^2 of it: up to 1e4 here.
TEST(WarpedShells, BendingWithoutStretchingIsFree) {
  constexpr double twist = 0.03;
  for (const double thickness : {3e-3, 3e-4})
    for (const double width : {1.0, 0.5}) {
      const NodeVectors corners = saddle(twist, 1, width);
      NodalVector u(24);
      for (int i = 0; i < 4; ++i) {
        const double x = corners[i].x();
        const double y = corners[i].y();
        u.segment<6>(6 * i) << -twist * x * x * y / 2, -twist * x * x * x / 6, x * x / 2, 0, -x,
            -twist * x * x / 2;
      }
      const double exact = properties(thickness).bending_stiffness(0, 0) * width;
      EXPECT_NEAR(u.dot(element(corners, thickness).stiffness() * u) / exact, 1, 0.03)
          << thickness << " " << width;
    }
}

// Shear along the straight lines of z = c x y: u = g y / 2, v = g x / 2 stretches neither of them,
// at any warping. At a corner with the tangents (1, 0, c y) and (0, 1, c x) the strain is 2 e_rs =
// g.
TEST(WarpedShells, StressOfShearAlongStraightLines) {
  constexpr double twist = 0.4;
  constexpr double shear = 1e-3;
  const NodeVectors corners = saddle(twist);
  NodalVector u = NodalVector::Zero(24);
  for (int i = 0; i < 4; ++i) {
    u[6 * i] = shear / 2 * corners[i].y();
    u[6 * i + 1] = shear / 2 * corners[i].x();
    u[6 * i + 3] = -shear * twist / 2 * corners[i].y();
    u[6 * i + 4] = shear * twist / 2 * corners[i].x();
  }
  const QuadrilateralShell shell = element(corners, 1e-3);
  for (int i = 0; i < 4; ++i) {
    const Vector3 along_r = Vector3(1, 0, twist * corners[i].y());
    const Vector3 along_s = Vector3(0, 1, twist * corners[i].x());
    const Vector3 first = along_r.normalized();
    const Vector3 second = along_r.cross(along_s).cross(first).normalized();
    // From covariant components 0, 0, g / 2 to the axes first, second.
    const double s_1 = along_s.dot(first);
    const double s_2 = along_s.dot(second);
    const Vector3 strain(0, -shear * s_1 / (along_r.norm() * s_2 * s_2),
                         shear / (along_r.norm() * s_2));
    const Vector3 exact = properties(1e-3).membrane_stiffness / 1e-3 * strain;
    const Vector found = shell.stress(i) * u;
    EXPECT_LT(((found.head<3>() + found.tail<3>()) / 2 - exact).norm(), 0.02 * exact.norm()) << i;
  }
}

// In-plane bending of a rectangle, curvature 1: stress E y along it and none across, which the
// incompatible displacements bring about.
TEST(WarpedShells, StressOfInPlaneBending) {
  const NodeVectors corners = saddle(0, 2, 0.5);
  NodalVector u = NodalVector::Zero(24);
  for (int i = 0; i < 4; ++i) {
    const double x = corners[i].x();
    const double y = corners[i].y();
    u[6 * i] = -x * y;
    u[6 * i + 1] = x * x / 2 + 0.25 * y * y / 2;
    u[6 * i + 5] = x;
  }
  for (int i = 0; i < 4; ++i) {
    const Vector stress = element(corners, 0.01).stress(i) * u;
    const Vector3 exact(-1e6 * corners[i].y(), 0, 0);
    EXPECT_LT((stress.head<3>() - exact).norm(), 1e-6) << i;
    EXPECT_LT((stress.tail<3>() - exact).norm(), 1e-6) << i;
  }
}

TEST(WarpedShells, AnyElementHasExactlySixRigidMotions) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const NodeVectors corners = random_corners(random);
    const Matrix stiffness = element(corners, 0.05).stiffness();
    const Vector k = rising_eigenvalues(stiffness);
    EXPECT_LT(k.head(6).cwiseAbs().maxCoeff(), 1e-13 * k.maxCoeff());
    EXPECT_GT(k[6], 1e-6 * k.maxCoeff()) << "a mode without energy";
    for (int axis = 0; axis < 3; ++axis) {
      const NodalVector turned = rigid_motion(corners, {1, 2, 3}, Vector3::Unit(axis));
      EXPECT_LT((stiffness * turned).norm(), 1e-13 * k.maxCoeff() * turned.norm());
      EXPECT_LT((element(corners, 0.05).stress(axis) * turned).norm(), 1e-8);
    }
  }
}

// From any corner on and in either sense.
TEST(WarpedShells, TheNumberingDoesNotCount) {
  std::mt19937 random(8);
  const NodeVectors corners = random_corners(random);
  const Matrix expected = element(corners, 0.05).stiffness();
  for (const auto &order : {std::array{1, 2, 3, 0}, std::array{2, 3, 0, 1}, std::array{3, 2, 1, 0},
                            std::array{0, 3, 2, 1}}) {
    NodeVectors other;
    for (int i = 0; i < 4; ++i)
      other[i] = corners[order[i]];
    const Matrix found = element(other, 0.05).stiffness();
    Matrix in_order(24, 24);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        in_order.block<6, 6>(6 * order[i], 6 * order[j]) = found.block<6, 6>(6 * i, 6 * j);
    EXPECT_LT((in_order - expected).norm(), 1e-13 * expected.norm());
  }
}

// gamma = 1 / (1 + (10 s/t)^2) with the sagitta s = c h^2 / 4 of z = c x y over a square, to the
// first order in the slope.
TEST(WarpedShells, DrillingYieldsWhereTheSurfaceCurvesWithinAnElement) {
  const auto share = [](double twist, double thickness) {
    const NodeVectors corners = saddle(twist);
    const NodeVectors normals = corner_normals(corners);
    return MembraneQuadrilateral(corners, normals, normals, properties(thickness)).drilling_share();
  };
  EXPECT_EQ(share(0, 1e-3), 1);
  EXPECT_NEAR(share(0.01, 0.025), 0.5, 1e-3);
  EXPECT_NEAR(share(0.01, 0.0025) * 101, 1, 1e-3);
}

} // namespace warped_shells_tests
