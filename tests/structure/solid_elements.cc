// The eight-node solid element by itself: patch test on a distorted patch, rigid-body motions,
// inertia, stress, bending of a brick in closed form; and blocks and their checks.
#include "common/decompositions.h"
#include "structure/block_mesh.h"
#include "structure/cell_parts.h"
#include "structure/frame_element.h"
#include "structure/hexahedron.h"
#include "structure/mesh_check.h"
#include "structure/node_rotations.h"
#include "structure/solid_body.h"
#include "structure/solid_examples.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <functional>

namespace solid_elements_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

const Material material = {1e6, 0.25, 1000};

/// Of constant strain with all six components, and of a small rotation.
Vector3 linear_field(const Vector3 &x) {
  const Eigen::Matrix3d gradient =
      (Eigen::Matrix3d() << 1, 0.5, 0.3, 0.2, -0.7, 0.1, -0.4, 0.6, 0.9).finished();
  return 1e-3 * gradient * x;
}

struct SolidPatch {
  Mesh mesh;
  Elements elements;

  Index size() const { return 3 * static_cast<Index>(mesh.nodes.size()); }
  Matrix assembled(const std::function<NodalMatrix(const Element &)> &matrix_of) const {
    Matrix matrix = Matrix::Zero(size(), size());
    for (const auto &element : elements) {
      const NodalMatrix values = matrix_of(*element);
      const auto own = element->nodes();
      for (std::size_t i = 0; i < own.size(); ++i)
        for (std::size_t j = 0; j < own.size(); ++j)
          matrix.block<3, 3>(3 * own[i], 3 * own[j]) +=
              values.block<3, 3>(3 * static_cast<Index>(i), 3 * static_cast<Index>(j));
    }
    return matrix;
  }
  Matrix stiffness() const {
    return assembled([](const Element &element) { return element.stiffness(); });
  }
  Matrix mass() const {
    return assembled([](const Element &element) { return element.mass(); });
  }
  Vector values(const std::function<Vector3(const Vector3 &)> &field) const {
    Vector u(size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      u.segment<3>(3 * static_cast<Index>(i)) = field(mesh.nodes[i]);
    return u;
  }
};

SolidPatch on_mesh(Mesh mesh) {
  SolidPatch patch;
  for (const Cell &cell : mesh.cells)
    if (cell.shape == CellShape::hexahedron)
      patch.elements.push_back(element_on(mesh, cell, {}, {.name = "", .material = material}));
  patch.mesh = std::move(mesh);
  return patch;
}

/// The unit cube of MacNeal and Harder: seven distorted hexahedra, one of them inside the others.
SolidPatch distorted_patch() {
  Mesh mesh;
  mesh.nodes = {{0, 0, 0},          {1, 0, 0},          {1, 1, 0},          {0, 1, 0},
                {0, 0, 1},          {1, 0, 1},          {1, 1, 1},          {0, 1, 1},
                {.249, .342, .192}, {.826, .288, .288}, {.850, .649, .263}, {.273, .750, .230},
                {.320, .186, .643}, {.677, .305, .683}, {.788, .693, .644}, {.165, .745, .702}};
  for (const std::vector<int> &corners :
       {std::vector{8, 9, 10, 11, 12, 13, 14, 15}, std::vector{0, 1, 2, 3, 8, 9, 10, 11},
        std::vector{12, 13, 14, 15, 4, 5, 6, 7}, std::vector{0, 1, 9, 8, 4, 5, 13, 12},
        std::vector{1, 2, 10, 9, 5, 6, 14, 13}, std::vector{2, 3, 11, 10, 6, 7, 15, 14},
        std::vector{3, 0, 8, 11, 7, 4, 12, 15}})
    mesh.cells.push_back(cell_of(CellShape::hexahedron, corners));
  return on_mesh(std::move(mesh));
}

Vector rising_eigenvalues(const Matrix &matrix) { return symmetric_eigen(matrix).values; }

std::string problem_of(const std::function<void()> &action) {
  try {
    action();
  } catch (const DefinitionError &error) {
    return error.key() + " " + error.problem();
  }
  return "";
}

} // namespace

// The eight outer nodes follow a linear field, and so do the inner ones.
TEST(SolidElements, PatchTest) {
  const SolidPatch patch = distorted_patch();
  const Vector exact = patch.values(linear_field);
  const Matrix k = patch.stiffness();
  const Vector found = LuFactors<Matrix>(k.bottomRightCorner(24, 24))
                           .solve(Vector(-k.bottomLeftCorner(24, 24) * exact.head(24)));
  EXPECT_LT((found - exact.tail(24)).cwiseAbs().maxCoeff(), 1e-14 * exact.cwiseAbs().maxCoeff());
}

TEST(SolidElements, ConstantStrainGivesItsStressEverywhere) {
  const double shear = 1e6 / 2.5;
  const double trace = 1.2e-3;
  Vector expected(6);
  expected << 1, -0.7, 0.9, 0.7, 0.7, -0.1; // xx, yy, zz, xy, yz, zx
  expected.head<3>() = 2e-3 * shear * expected.head<3>().array() + 2 * shear * 0.5 * trace;
  expected.tail<3>() *= 1e-3 * shear;
  const SolidPatch patch = distorted_patch();
  const Vector u = patch.values(linear_field);
  for (const auto &element : patch.elements) {
    Vector own(24);
    for (Index i = 0; i < 8; ++i)
      own.segment<3>(3 * i) = u.segment<3>(3 * element->nodes()[static_cast<std::size_t>(i)]);
    for (int node = 0; node < 8; ++node)
      EXPECT_LT((element->stress(node) * own - expected).norm(), 1e-13 * expected.norm());
  }
}

TEST(SolidElements, ExactlySixRigidBodyMotions) {
  const Vector k = rising_eigenvalues(distorted_patch().stiffness());
  EXPECT_LT(k.head(6).cwiseAbs().maxCoeff(), 1e-15 * k.maxCoeff());
  EXPECT_GT(k[6], 1e-3 * k.maxCoeff()) << "a mode without energy";
}

TEST(SolidElements, RigidMotionCausesNoForce) {
  const SolidPatch patch = distorted_patch();
  const Vector u = patch.values([](const Vector3 &x) -> Vector3 {
    return Vector3(100, 200, 300) + Vector3(0.3, -0.2, 0.5).cross(x);
  });
  for (const auto &element : patch.elements) {
    NodalVector own(24);
    for (Index i = 0; i < 8; ++i)
      own.segment<3>(3 * i) = u.segment<3>(3 * element->nodes()[static_cast<std::size_t>(i)]);
    const NodalMatrix stiffness = element->stiffness();
    // Displacements of some 100 m are known to 1e-14 m only.
    EXPECT_LT(element->force(stiffness, own).norm(), 3e-13 * stiffness.norm());
    const NodalVector other = NodalVector::LinSpaced(24, -1, 1).array().sin();
    const NodalVector product = stiffness * other;
    EXPECT_LT((element->force(stiffness, other) - product).norm(), 1e-12 * product.norm());
  }
}

// Internal displacements vanish in rigid motions: mass, centre and inertia are those of the cube.
TEST(SolidElements, RigidMotionsHaveTheInertiaOfTheBody) {
  const SolidPatch patch = distorted_patch();
  const Matrix mass = patch.mass();
  double total = 0;
  for (const auto &element : patch.elements)
    total += element->total_mass();
  EXPECT_NEAR(total, 1000, 1e-9);
  const Vector along = patch.values([](const Vector3 &) { return Vector3(0, 0, 1); });
  const Vector about_x = patch.values([](const Vector3 &x) { return Vector3::UnitX().cross(x); });
  EXPECT_NEAR(along.dot(mass * along), 1000, 1e-9);
  EXPECT_NEAR(along.dot(mass * about_x), 500, 1e-9);
  EXPECT_NEAR(about_x.dot(mass * about_x), 2000.0 / 3, 1e-9);
  EXPECT_GT(rising_eigenvalues(mass).minCoeff(), 0);
}

// Pure bending of one brick, flat or slender: u = x y, v = -x^2/2 - nu (y^2 - z^2)/2, w = -nu y z,
// of stress E y alone. Its corners do not show -x^2/2; the energy is that of a beam,
// E I L / 2 for the curvature 1.
TEST(SolidElements, ABrickBendsExactly) {
  for (const double length : {0.1, 1.0, 20.0}) {
    const Vector3 size(length, 0.5, 0.2);
    const SolidPatch brick = on_mesh(generate_block(examples::block(size, {1, 1, 1})));
    const double nu = material.poisson_ratio;
    const Vector u = brick.values([&](const Vector3 &place) {
      const Vector3 x = place - size / 2;
      return Vector3(x[0] * x[1], -x[0] * x[0] / 2 - nu * (x[1] * x[1] - x[2] * x[2]) / 2,
                     -nu * x[1] * x[2]);
    });
    const double second_moment = size[2] * std::pow(size[1], 3) / 12;
    const double energy = material.young_modulus * second_moment * length / 2;
    const Element &element = *brick.elements[0];
    Vector own(24);
    for (Index i = 0; i < 8; ++i)
      own.segment<3>(3 * i) = u.segment<3>(3 * element.nodes()[static_cast<std::size_t>(i)]);
    EXPECT_NEAR(own.dot(Vector(element.force(element.stiffness(), own))) / 2, energy,
                1e-12 * energy);
  }
}

// Rods of the wave equation, held at one end, without Poisson effect: sqrt(E / rho) / (4 L), too
// high by (k h)^2 / 24.
TEST(SolidElements, FrequenciesOfARodConvergeWithTheSecondOrder) {
  const auto error = [](int elements) {
    SolidPatch rod = on_mesh(generate_block(examples::block({1, 0.1, 0.1}, {elements, 1, 1})));
    for (auto &element : rod.elements)
      element = element_on(rod.mesh,
                           rod.mesh.cells[static_cast<std::size_t>(&element - rod.elements.data())],
                           {}, {.name = "", .material = {1, 0, 1}});
    Matrix basis = Matrix::Zero(rod.size(), elements);
    for (std::size_t node = 0; node < rod.mesh.nodes.size(); ++node)
      if (const auto plane = std::lround(elements * rod.mesh.nodes[node].x()); plane > 0)
        basis(3 * static_cast<Index>(node), plane - 1) = 1;
    const Matrix k = basis.transpose() * rod.stiffness() * basis;
    const Matrix m = basis.transpose() * rod.mass() * basis;
    const double least =
        Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>(k, m).eigenvalues().minCoeff();
    return std::sqrt(least) / (M_PI / 2) - 1;
  };
  EXPECT_NEAR(error(16), std::pow(M_PI / 32, 2) / 24, 1e-6);
  EXPECT_NEAR(std::log2(error(8) / error(16)), 2, 0.01);
}

TEST(SolidElements, BlocksHaveFacesEdgesAndOutwardNormals) {
  for (const double depth : {0.4, -0.4}) { // the second one is left-handed
    Block block = examples::block({1, 0.6, 0.4}, {4, 3, 2});
    block.ends[2].z() = depth;
    const Mesh mesh = generate_block(block);
    check_solid_mesh(mesh);
    ASSERT_EQ(mesh.nodes.size(), 60U);
    EXPECT_EQ(mesh.groups.at("right").size(), 12U);
    EXPECT_EQ(mesh.groups.at("left bottom").size(), 3U);
    EXPECT_EQ(mesh.groups.at("top front").size(), 5U);
    double volume = 0; // by the divergence theorem
    for (const std::vector<int> &face : visible_faces(std::span(mesh.cells).first(24))) {
      const auto at = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(face[i])]; };
      volume += (at(2) - at(0)).cross(at(3) - at(1)).dot(at(0) + at(1) + at(2) + at(3)) / 24;
    }
    EXPECT_NEAR(volume, 0.24, 1e-14);
    for (const int cell : mesh.cell_groups.at("front")) {
      const Cell &face = mesh.cells[static_cast<std::size_t>(cell)];
      const Vector3 first = mesh.nodes[face.corners[1]] - mesh.nodes[face.corners[0]];
      const Vector3 second = mesh.nodes[face.corners[2]] - mesh.nodes[face.corners[1]];
      EXPECT_GT(first.cross(second).z() * depth, 0);
    }
  }
}

TEST(SolidElements, PressurePushesAgainstFaces) {
  SolidDefinition solid = examples::solid_block({1, 0.6, 0.4}, {4, 3, 2}, material);
  const auto force = [&](const std::string &on) {
    solid.loads = {{.name = "p", .at = {}, .pressure = 10, .on = on}};
    Vector3 sum = Vector3::Zero();
    for (const auto &load : build_solid(solid).load)
      sum += Vector3(load[0], load[1], load[2]);
    return sum;
  };
  EXPECT_LT((force("right") - Vector3(-2.4, 0, 0)).norm(), 1e-14);
  EXPECT_LT((force("back") - Vector3(0, 0, 6)).norm(), 1e-14);
  EXPECT_LT(force("all").norm(), 1e-14);
}

TEST(SolidElements, DegenerateSolidsAreNamed) {
  Mesh mesh = generate_block(examples::block({2, 1, 1}, {2, 1, 1}));
  mesh.nodes[2] = mesh.nodes[1]; // of the second
  EXPECT_NE(problem_of([&] { check_solid_mesh(mesh); }).find("number 2, the one around ("),
            std::string::npos);
  Mesh inside_out = generate_block(examples::block({2, 1, 1}, {2, 1, 1}));
  std::reverse(inside_out.cells[0].corners.begin(), inside_out.cells[0].corners.end());
  std::swap_ranges(inside_out.cells[1].corners.begin(), inside_out.cells[1].corners.begin() + 4,
                   inside_out.cells[1].corners.begin() + 4);
  EXPECT_NE(problem_of([&] { check_solid_mesh(inside_out); }).find("number 2, "),
            std::string::npos);
  EXPECT_NE(problem_of([] {
              generate_block(examples::block({1, 1, 0}, {1, 1, 1}));
            }).find("Block must have three edges"),
            std::string::npos);
}

// Where a beam stands at a node of a solid, that node turns; the others do not.
TEST(SolidElements, NodesOfBeamsKeepTheirRotations) {
  const SolidDefinition solid = examples::solid_block({1, 1, 1}, {1, 1, 1}, material);
  BodyModel model = build_solid(solid);
  for (const std::array<bool, 6> &fixed : model.fixed)
    EXPECT_EQ(fixed, (std::array{false, false, false, true, true, true}));
  model.mesh.nodes.emplace_back(2, 1, 1);
  const PropertiesAlong properties =
      properties_along({.width = 0.01, .thickness = 0.01}, material, 0, 0, 0);
  const ElementFrame frame = element_frame({1, 1, 1}, {2, 1, 1}, std::nullopt);
  model.elements.push_back(std::make_shared<FrameElement>(std::array{7, 8}, properties, frame));
  const BodyParts parts{.supports = solid.supports,
                        .points = solid.points,
                        .interfaces = solid.interfaces,
                        .loads = solid.loads};
  add_parts(parts, model);
  hold_idle_rotations(model, parts, {});
  for (std::size_t node = 0; node < 9; ++node)
    EXPECT_EQ(model.fixed[node][4], node < 7);
}

} // namespace solid_elements_tests
