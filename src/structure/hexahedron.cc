#include "structure/hexahedron.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace vibroimpact::structure {

namespace {

using Corners = Eigen::Matrix<double, 8, 3>;

/// r, s, t of the corners.
const Corners corners_of_cube = (Corners() << -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, //
                                 -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1)
                                    .finished();

struct WeightedPlace {
  Vector3 place;
  double weight = 0;
};

/// Of the product rule with these places and weights along each axis.
template <std::size_t n>
std::vector<WeightedPlace> gauss_rule(const std::array<std::pair<double, double>, n> &along) {
  std::vector<WeightedPlace> rule;
  for (const auto &[r, weight_r] : along)
    for (const auto &[s, weight_s] : along)
      for (const auto &[t, weight_t] : along)
        rule.push_back({{r, s, t}, weight_r * weight_s * weight_t});
  return rule;
}

/// 2 x 2 x 2, exact to the third power: the strain energy of a brick.
const std::vector<WeightedPlace> &eight_points() {
  static const auto rule = gauss_rule(
      std::array{std::pair(-1 / std::sqrt(3.0), 1.0), std::pair(1 / std::sqrt(3.0), 1.0)});
  return rule;
}

/// 3 x 3 x 3, exact to the fifth power: internal displacements squared.
const std::vector<WeightedPlace> &twenty_seven_points() {
  static const auto rule =
      gauss_rule(std::array{std::pair(-std::sqrt(0.6), 5.0 / 9), std::pair(0.0, 8.0 / 9),
                            std::pair(std::sqrt(0.6), 5.0 / 9)});
  return rule;
}

/// Functions of the corners and of the internal displacements.
Eigen::Matrix<double, 11, 1> solid_functions(const Vector3 &place) {
  Eigen::Matrix<double, 11, 1> values;
  for (int i = 0; i < 8; ++i)
    values[i] = (1 + corners_of_cube.row(i).transpose().array() * place.array()).prod() / 8;
  values.tail<3>() = 1 - place.array().square();
  return values;
}

/// Derivatives of the functions of the corners by r, s, t.
Corners corner_derivatives(const Vector3 &place) {
  Corners derivatives;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Array3d factor = 1 + corners_of_cube.row(i).transpose().array() * place.array();
    for (int axis = 0; axis < 3; ++axis)
      derivatives(i, axis) =
          corners_of_cube(i, axis) * factor[(axis + 1) % 3] * factor[(axis + 2) % 3] / 8;
  }
  return derivatives;
}

/// Columns dx/dr, dx/ds, dx/dt [m].
Eigen::Matrix3d solid_jacobian(std::span<const Vector3> positions, const Vector3 &place) {
  const Corners derivatives = corner_derivatives(place);
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 8; ++i)
    jacobian += positions[static_cast<std::size_t>(i)] * derivatives.row(i);
  return jacobian;
}

/// Of an isotropic material: with the shear modulus G and Lame's constant l, s = l tr(e) + 2 G e.
Eigen::Matrix<double, 6, 6> elasticity_of(const Material &material) {
  const double nu = material.poisson_ratio;
  const double shear = material.young_modulus / (2 * (1 + nu));
  Eigen::Matrix<double, 6, 6> elasticity = Eigen::Matrix<double, 6, 6>::Zero();
  elasticity.topLeftCorner<3, 3>().setConstant(2 * shear * nu / (1 - 2 * nu));
  elasticity.diagonal().head<3>().array() += 2 * shear;
  elasticity.diagonal().tail<3>().setConstant(shear);
  return elasticity;
}

void check_solid_material(const MeshPart &part) {
  const auto refuse = [&](const char *key, const char *problem) {
    throw DefinitionError(part.name.empty() ? "Material" : "Solid", part.name, key, problem);
  };
  if (!(part.material.young_modulus > 0))
    refuse("Young modulus", "must be greater than 0");
  if (!(part.material.poisson_ratio > -1 && part.material.poisson_ratio < 0.5))
    refuse("Poisson ratio", "must be greater than -1 and less than 0.5 for a solid");
  if (!(part.material.density >= 0))
    refuse("Density", "must not be negative");
}

} // namespace

Hexahedron::Hexahedron(const std::array<int, 8> &nodes, const std::array<Vector3, 8> &positions,
                       const Material &material)
    : nodes_(nodes), rigid_({positions.begin(), positions.end()}),
      elasticity_(elasticity_of(material)), density_(material.density) {}

Hexahedron::Point Hexahedron::at(const Vector3 &place) const {
  const Eigen::Matrix3d jacobian = solid_jacobian(rigid_.positions(), place);
  const Eigen::Matrix3d middle = solid_jacobian(rigid_.positions(), Vector3::Zero());
  Point point;
  point.volume = jacobian.determinant();
  point.gradients.topRows<8>() = corner_derivatives(place) * jacobian.inverse();
  point.gradients.bottomRows<3>() =
      (-2 * middle.determinant() / point.volume * place).asDiagonal() *
      Eigen::Matrix3d(middle.inverse());
  return point;
}

Eigen::Matrix<double, 6, 33> Hexahedron::strain(const Point &point) const {
  Eigen::Matrix<double, 6, 33> strain = Eigen::Matrix<double, 6, 33>::Zero();
  for (int i = 0; i < 11; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3;
      strain(axis, 3 * i + axis) = point.gradients(i, axis);
      strain(3 + axis, 3 * i + axis) = point.gradients(i, next);
      strain(3 + axis, 3 * i + next) = point.gradients(i, axis);
    }
  return strain;
}

Hexahedron::FullMatrix Hexahedron::full_stiffness() const {
  FullMatrix stiffness = FullMatrix::Zero();
  for (const auto &[place, weight] : eight_points()) {
    const Point point = at(place);
    const Eigen::Matrix<double, 6, 33> rows = strain(point);
    stiffness += weight * point.volume * rows.transpose() * (elasticity_ * rows);
  }
  return stiffness;
}

/// (1; A): the internal displacements on which no force acts.
Eigen::Matrix<double, 33, 24> Hexahedron::with_internal(const FullMatrix &stiffness) const {
  Eigen::Matrix<double, 33, 24> motion;
  motion.topRows<24>().setIdentity();
  motion.bottomRows<9>() =
      -stiffness.bottomRightCorner<9, 9>().ldlt().solve(stiffness.bottomLeftCorner<9, 24>());
  return motion;
}

NodalMatrix Hexahedron::stiffness() const {
  const FullMatrix full = full_stiffness();
  const Eigen::Matrix<double, 24, 24> stiffness =
      full.topLeftCorner<24, 24>() +
      full.topRightCorner<24, 9>() * with_internal(full).bottomRows<9>();
  return (stiffness + stiffness.transpose()) / 2;
}

NodalMatrix Hexahedron::mass() const {
  const Eigen::Matrix<double, 33, 24> motion = with_internal(full_stiffness());
  Eigen::Matrix<double, 24, 24> mass = Eigen::Matrix<double, 24, 24>::Zero();
  for (const auto &[place, weight] : twenty_seven_points()) {
    const Eigen::Matrix<double, 11, 1> functions = solid_functions(place);
    Eigen::Matrix<double, 3, 24> displacement = Eigen::Matrix<double, 3, 24>::Zero();
    for (int i = 0; i < 11; ++i)
      displacement += functions[i] * motion.middleRows<3>(3 * i);
    const double volume = weight * solid_jacobian(rigid_.positions(), place).determinant();
    mass += density_ * volume * displacement.transpose() * displacement;
  }
  return (mass + mass.transpose()) / 2;
}

NodalMatrix Hexahedron::force(const Eigen::Ref<const Matrix> &stiffness,
                              const NodalMatrix &u) const {
  return stiffness.lazyProduct(rigid_.removed_from(u));
}

Matrix Hexahedron::stress(int node) const {
  const Point corner = at(corners_of_cube.row(node));
  return elasticity_ * strain(corner) * with_internal(full_stiffness());
}

double Hexahedron::total_mass() const {
  double volume = 0;
  for (const auto &[place, weight] : eight_points())
    volume += weight * solid_jacobian(rigid_.positions(), place).determinant();
  return density_ * volume;
}

double least_jacobian(std::span<const Vector3> positions) {
  double least = 1;
  const auto look_at = [&](const Vector3 &place) {
    const Eigen::Matrix3d jacobian = solid_jacobian(positions, place);
    const double lengths = jacobian.colwise().norm().prod();
    least = std::min(least, lengths > 0 ? jacobian.determinant() / lengths : 0);
  };
  for (int i = 0; i < 8; ++i)
    look_at(corners_of_cube.row(i));
  for (const auto &[place, weight] : eight_points())
    look_at(place);
  return least;
}

std::shared_ptr<const Element> make_hexahedron(const CellPart &cell) {
  check_solid_material(cell.part);
  std::array<int, 8> nodes{};
  std::array<Vector3, 8> positions;
  std::copy_n(cell.nodes.begin(), 8, nodes.begin());
  std::copy_n(cell.positions.begin(), 8, positions.begin());
  return std::make_shared<Hexahedron>(nodes, positions, cell.part.material);
}

} // namespace vibroimpact::structure
