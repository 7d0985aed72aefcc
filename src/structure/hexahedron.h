// The eight-node solid element: trilinear displacements and, within the element, the displacements
//
//   (1 - r^2) a_1 + (1 - s^2) a_2 + (1 - t^2) a_3
//
// of Wilson, which bend a brick exactly. Their gradients are taken with the metric of the middle,
// times j_0 / j for the determinant j of the Jacobian, so that they vanish in the mean and the
// element passes the patch test on any mesh (taylor1976). The nine a follow from the nodes such
// that no force acts on them, a = A u, and are eliminated.
//
// The mass is consistent with these displacements, a = A u included: M = T^T M_33 T, T = (1; A). In
// a bending wave that takes most of the error of plain trilinear displacements away, whose kinetic
// energy misses that of the deflection between the nodes.
#pragma once

#include "structure/rigid_part.h"
#include "structure/shell_definition.h"

namespace vibroimpact::structure {

class Hexahedron : public Element {
public:
  /// Nodes around the base, then above them; `positions` are theirs [m].
  Hexahedron(const std::array<int, 8> &nodes, const std::array<Vector3, 8> &positions,
             const Material &material);

  std::span<const int> nodes() const override { return nodes_; }
  int components() const override { return 3; }
  NodalMatrix stiffness() const override;
  NodalMatrix mass() const override;
  NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness, const NodalMatrix &u) const override;
  Matrix stress(int node) const override;
  int stress_components() const override { return 6; }
  double total_mass() const override;

private:
  /// Rows and columns of the nodes, then of the internal displacements.
  using FullMatrix = Eigen::Matrix<double, 33, 33>;
  /// Gradients of the functions of the corners and of the internal ones [1/m].
  struct Point {
    Eigen::Matrix<double, 11, 3> gradients;
    double volume = 0; ///< per volume of the cube of r, s, t [m^3]
  };

  Point at(const Vector3 &place) const;
  Eigen::Matrix<double, 6, 33> strain(const Point &point) const;
  FullMatrix full_stiffness() const;
  Eigen::Matrix<double, 33, 24> with_internal(const FullMatrix &stiffness) const;

  std::array<int, 8> nodes_;
  RigidPart rigid_;
  Eigen::Matrix<double, 6, 6> elasticity_; ///< [Pa], rows xx, yy, zz, xy, yz, zx
  double density_;                         ///< [kg/m^3]
};

/// The least determinant of the Jacobian at the corners and at the Gauss points, over the product
/// of the lengths of its three columns: 1 for bricks; 0 and less where the element is flat, folded
/// or numbered inside out.
double least_jacobian(std::span<const Vector3> positions);

/// Throws DefinitionError for a material out of range.
std::shared_ptr<const Element> make_hexahedron(const CellPart &cell);

} // namespace vibroimpact::structure
