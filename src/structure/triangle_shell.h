// The three-node shell element, thin or thick, flat.
//
// Bending and transverse shear are those of MITC3+ (lee2014): a bubble adds to the rotations in the
// middle of the element and is eliminated again, and the shear strains are assumed fields that no
// numbering of the corners prefers. It bends as well as a four-node element, where the plain MITC3
// (lee2004) is too stiff. The membrane, with drilling rotations, is that of membrane_triangle.h.
#pragma once

#include "structure/director_kinematics.h"
#include "structure/shell_element.h"

namespace vibroimpact::structure {

class TriangleShell : public ShellElement {
public:
  /// `positions` are those of the nodes [m].
  TriangleShell(const std::array<int, 3> &nodes, const std::array<Vector3, 3> &positions,
                const ShellProperties &properties);

  NodalMatrix stiffness() const override;
  NodalMatrix mass() const override;
  /// At the top and at the bottom.
  Matrix stress(int node) const override;
  double area() const override;
  std::vector<Vector3> pressure_areas() const override;

private:
  DirectorPoint at(double r, double s) const;
  /// From the in-plane displacements and the drilling of the corners in the axes of a basis.
  Eigen::Matrix<double, 9, 18> to_plane(const TangentBasis &basis) const;
  std::array<Eigen::Vector2d, 3> flat_corners(const TangentBasis &basis) const;
  void add_membrane(NodalMatrix &stiffness) const;
  Eigen::Matrix<double, 2, 24> assumed_shear(double r, double s) const;
  /// Rows 18 ... 23 are the bubble; those of its displacement vanish.
  Eigen::Matrix<double, 24, 24> with_bubble() const;

  Vector3 normal_; ///< twice the area long
  NodeVectors corners_;
  NodeVectors directors_;
};

/// Throws like shell_properties().
std::shared_ptr<const Element> make_triangle_shell(const CellPart &cell);

} // namespace vibroimpact::structure
