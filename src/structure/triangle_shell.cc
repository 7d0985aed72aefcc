#include "structure/triangle_shell.h"

#include "structure/membrane_triangle.h"

#include <Eigen/Dense>

#include <algorithm>

namespace vibroimpact::structure {

namespace {

/// Weights sum to the area 1/2 of the unit triangle; exact to degree 4 (six points).
struct TrianglePoint {
  double r, s, weight;
};
std::array<TrianglePoint, 6> integration_points() {
  constexpr double a = 0.445948490915965;
  constexpr double b = 0.091576213509771;
  constexpr double weight_a = 0.223381589678011 / 2;
  constexpr double weight_b = 0.109951743655322 / 2;
  return {{{a, a, weight_a},
           {1 - 2 * a, a, weight_a},
           {a, 1 - 2 * a, weight_a},
           {b, b, weight_b},
           {1 - 2 * b, b, weight_b},
           {b, 1 - 2 * b, weight_b}}};
}

Shape linear(double r, double s) {
  Shape shape;
  shape.value << 1 - r - s, r, s, 0;
  shape.r << -1, 1, 0, 0;
  shape.s << -1, 0, 1, 0;
  return shape;
}

Shape with_bubble_function(double r, double s) {
  Shape shape = linear(r, s);
  shape.value[3] = 27 * r * s * (1 - r - s);
  shape.r[3] = 27 * s * (1 - 2 * r - s);
  shape.s[3] = 27 * r * (1 - r - 2 * s);
  return shape;
}

// Distance of three sampling points from the centre, the value of lee2014: the nearer they are to
// each other, the weaker the resistance against the twist of the shear field, yet it never
// vanishes.
constexpr double twist_distance = 1e-4;

} // namespace

TriangleShell::TriangleShell(const std::array<int, 3> &nodes,
                             const std::array<Vector3, 3> &positions,
                             const ShellProperties &properties)
    : ShellElement({nodes.begin(), nodes.end()}, {positions.begin(), positions.end()}, properties),
      normal_((positions[1] - positions[0]).cross(positions[2] - positions[0])) {
  for (int i = 0; i < 3; ++i)
    corners_[i] = this->positions()[i];
  corners_[3] = Vector3::Zero();
  directors_.fill(normal_.normalized());
}

DirectorPoint TriangleShell::at(double r, double s) const {
  return director_point(linear(r, s), with_bubble_function(r, s), corners_, directors_);
}

// Constant parts from points between the centre and the corners, which weaken the shear that
// bending brings in; linear parts from the twist around the centre.
Eigen::Matrix<double, 2, 24> TriangleShell::assumed_shear(double r, double s) const {
  const auto sample_r = [&](double x, double y) { return shear_r(at(x, y), directors_); };
  const auto sample_s = [&](double x, double y) { return shear_s(at(x, y), directors_); };
  constexpr double near = 1.0 / 6;
  constexpr double far = 2.0 / 3;
  constexpr double third = 1.0 / 3;
  constexpr double d = twist_distance;
  const StrainRow both = (sample_r(near, near) + sample_s(near, near)) / 3;
  const StrainRow constant_r = far * (sample_r(far, near) - sample_s(far, near) / 2) + both;
  const StrainRow constant_s = far * (sample_s(near, far) - sample_r(near, far) / 2) + both;
  const StrainRow twist = sample_r(third + d, third + d) - sample_r(third + d, third - 2 * d) -
                          sample_s(third + d, third + d) + sample_s(third - 2 * d, third + d);
  Eigen::Matrix<double, 2, 24> shear;
  shear << constant_r + (s - third) * twist, constant_s + (third - r) * twist;
  return shear;
}

Eigen::Matrix<double, 24, 24> TriangleShell::with_bubble() const {
  Eigen::Matrix<double, 24, 24> stiffness = Eigen::Matrix<double, 24, 24>::Zero();
  for (const TrianglePoint &p : integration_points()) {
    const DirectorPoint point = at(p.r, p.s);
    const TangentBasis basis(point);
    const Eigen::Matrix<double, 3, 24> curvature =
        basis.in_plane * covariant_curvature(point, directors_);
    const Eigen::Matrix<double, 2, 24> shear = basis.shear * assumed_shear(p.r, p.s);
    const double area = p.weight * basis.area;
    stiffness += area * curvature.transpose() * properties().bending_stiffness * curvature;
    stiffness += area * properties().shear_stiffness * shear.transpose() * shear;
  }
  return stiffness;
}

Eigen::Matrix<double, 9, 18> TriangleShell::to_plane(const TangentBasis &basis) const {
  Eigen::Matrix<double, 9, 18> rows = Eigen::Matrix<double, 9, 18>::Zero();
  for (int i = 0; i < 3; ++i) {
    rows.block<1, 3>(3 * i, 6 * i) = basis.first;
    rows.block<1, 3>(3 * i + 1, 6 * i) = basis.second;
    rows.block<1, 3>(3 * i + 2, 6 * i + 3) = directors_[i];
  }
  return rows;
}

std::array<Eigen::Vector2d, 3> TriangleShell::flat_corners(const TangentBasis &basis) const {
  std::array<Eigen::Vector2d, 3> flat;
  for (int i = 0; i < 3; ++i)
    flat[i] = {corners_[i].dot(basis.first), corners_[i].dot(basis.second)};
  return flat;
}

void TriangleShell::add_membrane(NodalMatrix &stiffness) const {
  const TangentBasis basis(at(1.0 / 3, 1.0 / 3));
  const Eigen::Matrix<double, 9, 18> rows = to_plane(basis);
  stiffness += rows.transpose() * membrane_triangle(flat_corners(basis), properties()) * rows;
}

NodalMatrix TriangleShell::stiffness() const {
  const Eigen::Matrix<double, 24, 24> full = with_bubble();
  Eigen::Matrix<double, 3, 2> in_plane; // the bubble turns about axes in the plane
  in_plane.col(0) = (corners_[1] - corners_[0]).normalized();
  in_plane.col(1) = directors_[0].cross(in_plane.col(0));
  const Eigen::Matrix<double, 18, 2> coupling = full.block<18, 3>(0, 21) * in_plane;
  const Eigen::Matrix2d bubble = in_plane.transpose() * full.block<3, 3>(21, 21) * in_plane;
  NodalMatrix stiffness =
      full.topLeftCorner<18, 18>() - coupling * bubble.inverse() * coupling.transpose();
  add_membrane(stiffness);
  return (stiffness + stiffness.transpose()) / 2;
}

NodalMatrix TriangleShell::mass() const {
  NodalMatrix mass = NodalMatrix::Zero(18, 18);
  for (const TrianglePoint &p : integration_points()) {
    const double t = 1 - p.r - p.s;
    add_mass({t, p.r, p.s, 0}, {4 * t * p.r, 4 * p.r * p.s, 4 * p.s * t, 0}, p.weight * 2 * area(),
             mass);
  }
  return (mass + mass.transpose()) / 2;
}

// At a corner the bubble does not bend the element.
Matrix TriangleShell::stress(int node) const {
  const DirectorPoint point = at(node == 1 ? 1 : 0, node == 2 ? 1 : 0);
  const TangentBasis basis(point);
  Eigen::Matrix<double, 3, 24> strain = Eigen::Matrix<double, 3, 24>::Zero();
  strain.leftCols<18>() = membrane_strain(flat_corners(basis)) * to_plane(basis);
  return surface_stress(strain, basis.in_plane * covariant_curvature(point, directors_));
}

double TriangleShell::area() const { return normal_.norm() / 2; }

std::vector<Vector3> TriangleShell::pressure_areas() const {
  return std::vector<Vector3>(3, normal_ / 6);
}

std::shared_ptr<const Element> make_triangle_shell(const CellPart &cell) {
  std::array<int, 3> nodes{};
  std::array<Vector3, 3> positions;
  std::copy_n(cell.nodes.begin(), 3, nodes.begin());
  std::copy_n(cell.positions.begin(), 3, positions.begin());
  return std::make_shared<TriangleShell>(nodes, positions, shell_properties(cell.part));
}

} // namespace vibroimpact::structure
