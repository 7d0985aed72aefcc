#include "structure/quadrilateral_shell.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace vibroimpact::structure {

QuadrilateralShell::QuadrilateralShell(const std::array<int, 4> &nodes,
                                       const NodeVectors &positions,
                                       const NodeVectors &surface_normals,
                                       const ShellProperties &properties)
    : ShellElement({nodes.begin(), nodes.end()}, {positions.begin(), positions.end()}, properties),
      directors_(corner_normals(positions)), surface_normals_(surface_normals) {
  std::copy(this->positions().begin(), this->positions().end(), corners_.begin());
}

DirectorPoint QuadrilateralShell::at(double r, double s) const {
  const Shape shape = bilinear(r, s);
  return director_point(shape, shape, corners_, directors_);
}

MembraneQuadrilateral QuadrilateralShell::membrane() const {
  return {corners_, directors_, surface_normals_, properties()};
}

void QuadrilateralShell::add_bending_and_shear(NodalMatrix &stiffness) const {
  const StrainRow lower = shear_r(at(0, -1), directors_);
  const StrainRow upper = shear_r(at(0, 1), directors_);
  const StrainRow left = shear_s(at(-1, 0), directors_);
  const StrainRow right = shear_s(at(1, 0), directors_);
  for (const auto &[r, s] : gauss_points()) {
    const DirectorPoint point = at(r, s);
    const TangentBasis basis(point);
    const Eigen::Matrix<double, 3, 24> curvature =
        basis.in_plane * covariant_curvature(point, directors_);
    Eigen::Matrix<double, 2, 24> assumed;
    assumed << (1 - s) / 2 * lower + (1 + s) / 2 * upper, (1 - r) / 2 * left + (1 + r) / 2 * right;
    const Eigen::Matrix<double, 2, 24> shear = basis.shear * assumed;
    stiffness += basis.area * curvature.transpose() * properties().bending_stiffness * curvature;
    stiffness += basis.area * properties().shear_stiffness * shear.transpose() * shear;
  }
}

NodalMatrix QuadrilateralShell::stiffness() const {
  NodalMatrix stiffness = membrane().stiffness();
  add_bending_and_shear(stiffness);
  return (stiffness + stiffness.transpose()) / 2;
}

NodalMatrix QuadrilateralShell::mass() const {
  NodalMatrix mass = NodalMatrix::Zero(24, 24);
  const double g = std::sqrt(0.6); // 3 x 3 Gauss points
  for (const auto &[r, weight_r] : {std::pair(-g, 5.0 / 9), {0.0, 8.0 / 9}, {g, 5.0 / 9}})
    for (const auto &[s, weight_s] : {std::pair(-g, 5.0 / 9), {0.0, 8.0 / 9}, {g, 5.0 / 9}}) {
      const DirectorPoint point = at(r, s);
      const double along_r = (1 - r * r) / 2;
      const double along_s = (1 - s * s) / 2;
      const Eigen::Vector4d bows(along_r * (1 - s), along_s * (1 + r), along_r * (1 + s),
                                 along_s * (1 - r));
      const double area = point.tangent_r.cross(point.tangent_s).norm();
      add_mass(point.translation.value, bows, weight_r * weight_s * area, mass);
    }
  return (mass + mass.transpose()) / 2;
}

Matrix QuadrilateralShell::stress(int node) const {
  const DirectorPoint point = at(corner_r[node], corner_s[node]);
  const TangentBasis basis(point);
  return surface_stress(membrane().strain(corner_r[node], corner_s[node]),
                        basis.in_plane * covariant_curvature(point, directors_));
}

double QuadrilateralShell::area() const {
  double area = 0;
  for (const auto &[r, s] : gauss_points()) {
    const DirectorPoint point = at(r, s);
    area += point.tangent_r.cross(point.tangent_s).norm();
  }
  return area;
}

std::vector<Vector3> QuadrilateralShell::pressure_areas() const {
  const NodeVectors areas = corner_areas(corners_);
  return {areas.begin(), areas.end()};
}

std::shared_ptr<const Element> make_quadrilateral_shell(const CellPart &cell) {
  std::array<int, 4> nodes{};
  NodeVectors positions;
  NodeVectors normals;
  std::copy_n(cell.nodes.begin(), 4, nodes.begin());
  std::copy_n(cell.positions.begin(), 4, positions.begin());
  std::copy_n(cell.normals.begin(), 4, normals.begin());
  return std::make_shared<QuadrilateralShell>(nodes, positions, normals,
                                              shell_properties(cell.part));
}

} // namespace vibroimpact::structure
