// The shell elements by themselves: patch tests on a distorted patch, rigid-body motions, inertia,
// and in-plane bending in closed form.
#include "common/decompositions.h"
#include "structure/quadrilateral_shell.h"
#include "structure/shell_definition.h"
#include "structure/shell_patches.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <functional>

namespace shell_elements_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

using Field = std::function<Eigen::Matrix<double, 6, 1>(const Vector3 &)>;

Eigen::Matrix<double, 6, 1> components(double u, double v, double w, double rx, double ry,
                                       double rz) {
  return (Eigen::Matrix<double, 6, 1>() << u, v, w, rx, ry, rz).finished();
}

struct Patch {
  std::vector<Vector3> nodes;
  Elements elements;
  Matrix rotation = Matrix::Identity(3, 3);

  Index size() const { return 6 * static_cast<Index>(nodes.size()); }

  Matrix assembled(const std::function<NodalMatrix(const Element &)> &matrix_of) const {
    Matrix matrix = Matrix::Zero(size(), size());
    for (const auto &element : elements) {
      const NodalMatrix values = matrix_of(*element);
      const auto own = element->nodes();
      for (std::size_t i = 0; i < own.size(); ++i)
        for (std::size_t j = 0; j < own.size(); ++j)
          matrix.block<6, 6>(6 * own[i], 6 * own[j]) +=
              values.block<6, 6>(6 * static_cast<Index>(i), 6 * static_cast<Index>(j));
    }
    return matrix;
  }
  Matrix stiffness() const {
    return assembled([](const Element &element) { return element.stiffness(); });
  }
  Matrix mass() const {
    return assembled([](const Element &element) { return element.mass(); });
  }
};

const Material material = {1e6, 0.25, 1000};

// The patch of MacNeal and Harder, 0.24 x 0.12: five distorted quadrilaterals around an inner one,
// or each cut into two triangles; turned in space, and warped when asked for.
Patch patch(CellShape shape, double thickness, bool warped = false) {
  Patch patch;
  patch.nodes = {{0, 0, 0},     {.24, 0, 0},   {.24, .12, 0}, {0, .12, 0},
                 {.04, .02, 0}, {.18, .03, 0}, {.16, .08, 0}, {.08, .08, 0}};
  if (warped) {
    patch.nodes[5].z() = 0.01;
    patch.nodes[7].z() = -0.015;
  }
  patch.rotation = Eigen::AngleAxisd(0.8, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  for (Vector3 &node : patch.nodes)
    node = patch.rotation * node;
  structure::Mesh mesh;
  mesh.nodes = patch.nodes;
  for (const auto &c : {std::vector{0, 1, 5, 4}, std::vector{1, 2, 6, 5}, std::vector{2, 3, 7, 6},
                        std::vector{3, 0, 4, 7}, std::vector{4, 5, 6, 7}})
    if (shape == CellShape::quadrilateral) {
      mesh.cells.push_back(cell_of(shape, c));
    } else {
      mesh.cells.push_back(cell_of(shape, {c[0], c[1], c[2]}));
      mesh.cells.push_back(cell_of(shape, {c[0], c[2], c[3]}));
    }
  patch.elements = examples::shell_elements(mesh, shell_properties(thickness, material, "", ""));
  return patch;
}

// The field, given in the axes of the patch before it was turned, at all nodes.
Vector values(const Patch &patch, const Field &field) {
  Vector u(patch.size());
  for (Index i = 0; i < u.size(); i += 6) {
    const Vector3 local = patch.rotation.transpose() * patch.nodes[i / 6];
    const Eigen::Matrix<double, 6, 1> value = field(local);
    u.segment<3>(i) = patch.rotation * value.head<3>();
    u.segment<3>(i + 3) = patch.rotation * value.tail<3>();
  }
  return u;
}

// The four outer nodes follow the field; with `held_rotations` the inner ones turn as it says, too.
// Largest error of the others, relative.
double patch_error(const Patch &patch, const Field &field, bool held_rotations = false) {
  const Vector exact = values(patch, field);
  std::vector<Index> held;
  std::vector<Index> free;
  for (Index i = 0; i < exact.size(); ++i)
    (i < 24 || (held_rotations && i % 6 >= 3) ? held : free).push_back(i);
  const Matrix k = patch.stiffness();
  const Matrix inner = k(free, free);
  const Matrix coupling = k(free, held);
  const Vector given = exact(held);
  const Vector expected = exact(free);
  const Vector found = LuFactors<Matrix>(inner).solve(Vector(-coupling * given));
  return (found - expected).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
}

const Field stretching = [](const Vector3 &x) {
  return components(1e-3 * (x[0] + x[1] / 2), 1e-3 * (x[1] + x[0] / 2), 0, 0, 0, 0);
};
const Field turning_in_plane = [](const Vector3 &x) {
  return components(1e-3 * (x[0] + x[1]), 1e-3 * (x[1] + 0.3 * x[0]), 0, 0, 0, -0.35e-3);
};
// w = (x^2 + x y + y^2) / 2, theta_x = w,y, theta_y = -w,x
const Field bending = [](const Vector3 &x) {
  return components(0, 0, (x[0] * x[0] + x[0] * x[1] + x[1] * x[1]) / 2, x[1] + x[0] / 2,
                    -x[0] - x[1] / 2, 0);
};
const Field shearing = [](const Vector3 &x) { return components(0, 0, x[0] + x[1] / 2, 0, 0, 0); };

constexpr std::array both = {CellShape::quadrilateral, CellShape::triangle};

Vector rising_eigenvalues(const Matrix &matrix) { return symmetric_eigen(matrix).values; }

} // namespace

// Turned in space, round-off of the membrane meets the bending stiffness, (size / thickness)^2
// times smaller: some 1e4 for the thin patch.
TEST(ShellElements, MembranePatchTest) {
  for (const CellShape shape : both)
    for (const double thickness : {1e-3, 0.1}) {
      const double round_off = thickness < 0.01 ? 1e-9 : 1e-12;
      EXPECT_LT(patch_error(patch(shape, thickness), stretching), round_off);
      EXPECT_LT(patch_error(patch(shape, thickness), turning_in_plane), round_off);
    }
}

TEST(ShellElements, BendingPatchTest) {
  for (const CellShape shape : both)
    for (const double thickness : {1e-3, 0.1})
      EXPECT_LT(patch_error(patch(shape, thickness), bending), 1e-9);
}

// All rotations held, uniform transverse shear.
TEST(ShellElements, ShearPatchTest) {
  for (const double thickness : {1e-3, 0.1})
    EXPECT_LT(patch_error(patch(CellShape::quadrilateral, thickness), shearing, true), 1e-12);
}

// The bubble of the triangle gives way to a shear that no bending moment accompanies, which needs
// couples spread over the surface and does not occur. It does so by the square of size over
// thickness, and not at all in the limit.
TEST(ShellElements, ShearOfTrianglesIsExactInTheThickLimit) {
  const double thick = patch_error(patch(CellShape::triangle, 1), shearing, true);
  const double thicker = patch_error(patch(CellShape::triangle, 10), shearing, true);
  EXPECT_LT(thick, 1e-4);
  EXPECT_NEAR(std::log10(thick / thicker), 2, 0.05);
}

TEST(ShellElements, ExactlySixRigidBodyMotions) {
  for (const CellShape shape : both)
    for (const bool warped : {false, true}) {
      const Vector k = rising_eigenvalues(patch(shape, 0.01, warped).stiffness());
      EXPECT_LT(k.head(6).cwiseAbs().maxCoeff(), 1e-15 * k.maxCoeff());
      EXPECT_GT(k[6], 1e-8 * k.maxCoeff()) << "a mode without energy";
    }
}

TEST(ShellElements, RigidMotionCausesNoForce) {
  for (const CellShape shape : both) {
    const Patch body = patch(shape, 0.001, true);
    const Vector3 omega(0.3, -0.2, 0.5);
    for (const auto &element : body.elements) {
      const NodalMatrix stiffness = element->stiffness();
      NodalVector u(stiffness.rows());
      for (std::size_t i = 0; i < element->nodes().size(); ++i)
        u.segment<6>(6 * static_cast<Index>(i))
            << Vector3(100, 200, 300) + omega.cross(body.nodes[element->nodes()[i]]),
            omega;
      EXPECT_LT((stiffness * u).norm(), 1e-12 * stiffness.norm() * u.norm());
      // Displacements of some 100 m are known to 1e-14 m only.
      EXPECT_LT(element->force(stiffness, u).norm(), 3e-13 * stiffness.norm());
    }
  }
}

TEST(ShellElements, ForceIsTheProductOfTheMatrix) {
  for (const CellShape shape : both)
    for (const auto &element : patch(shape, 0.02, true).elements) {
      const NodalMatrix stiffness = element->stiffness();
      NodalVector u(stiffness.rows());
      for (Index i = 0; i < u.size(); ++i)
        u[i] = std::sin(7.0 * static_cast<double>(i));
      const NodalVector product = stiffness * u;
      EXPECT_LT((element->force(stiffness, u) - product).norm(), 1e-12 * product.norm());
    }
}

// Mass, centre of mass and moments of inertia: area moments of the rectangle, and rho t^3 / 12 per
// area for the thickness.
TEST(ShellElements, RigidMotionsHaveTheInertiaOfThePlate) {
  for (const CellShape shape : both) {
    const Patch plate = patch(shape, 0.01);
    const Matrix mass = plate.mass();
    const double total = 1000 * 0.01 * 0.24 * 0.12;
    const Vector along =
        values(plate, [](const Vector3 &) { return components(0, 0, 1, 0, 0, 0); });
    EXPECT_NEAR(along.dot(mass * along), total, 1e-12 * total);
    const Vector about_x =
        values(plate, [](const Vector3 &x) { return components(0, 0, x[1], 1, 0, 0); });
    const double inertia = total * (0.12 * 0.12 / 3 + 0.01 * 0.01 / 12);
    EXPECT_NEAR(about_x.dot(mass * about_x), inertia, 1e-12 * inertia);
    EXPECT_NEAR(along.dot(mass * about_x), total * 0.06, 1e-12 * total);
    EXPECT_GT(rising_eigenvalues(mass).minCoeff(), 0);
  }
}

TEST(ShellElements, PressureActsOnTheArea) {
  for (const CellShape shape : both) {
    Vector3 sum = Vector3::Zero();
    double area = 0;
    const Patch plate = patch(shape, 0.01);
    for (const auto &element : plate.elements) {
      const auto &shell = dynamic_cast<const ShellElement &>(*element);
      area += shell.area();
      for (const Vector3 &part : shell.pressure_areas())
        sum += part;
    }
    EXPECT_NEAR(area, 0.24 * 0.12, 1e-15);
    EXPECT_LT((sum - area * plate.rotation.col(2)).norm(), 1e-15);
  }
}

// In-plane bending of a rectangle, curvature 1: u = -x y, v = x^2 / 2 + nu y^2 / 2, drilling x. Its
// energy is E t h^3 / 12 times the length; the one of bilinear displacements would grow with the
// square of the aspect ratio.
TEST(ShellElements, InPlaneBendingIsExactForAllAspectRatios) {
  for (const double nu : {0.0, 0.3, 0.49})
    for (const double length : {0.3, 1.0, 20.0}) {
      const ShellProperties properties = shell_properties(0.01, {1e7, nu, 1}, "", "");
      const NodeVectors corners = {Vector3(0, -0.5, 0), Vector3(length, -0.5, 0),
                                   Vector3(length, 0.5, 0), Vector3(0, 0.5, 0)};
      const QuadrilateralShell element({0, 1, 2, 3}, corners, corner_normals(corners), properties);
      NodalVector u = NodalVector::Zero(24);
      for (int i = 0; i < 4; ++i) {
        const double x = corners[i].x() - length / 2;
        const double y = corners[i].y();
        u[6 * i] = -x * y;
        u[6 * i + 1] = x * x / 2 + nu * y * y / 2;
        u[6 * i + 5] = x;
      }
      const double exact = 1e7 * 0.01 / 12 * length;
      EXPECT_NEAR(u.dot(element.stiffness() * u) / exact, 1, 1e-10) << nu << " " << length;
    }
}

TEST(ShellElements, ImpossiblePropertiesNameTheKey) {
  const auto key_of = [](double thickness, const Material &bad) -> std::string {
    try {
      shell_properties(thickness, bad, "Shell", "deck");
    } catch (const DefinitionError &error) {
      return error.name() + "/" + error.key();
    }
    return "";
  };
  EXPECT_EQ(key_of(0, material), "deck/Thickness");
  EXPECT_EQ(key_of(1, {0, 0.3, 1}), "deck/Young modulus");
  EXPECT_EQ(key_of(1, {1, 0.6, 1}), "deck/Poisson ratio");
  EXPECT_EQ(key_of(1, {1, 0.3, -1}), "deck/Density");
}

} // namespace shell_elements_tests
