// The four-node shell element, thin or thick, flat or warped.
//
// Bending and transverse shear are those of MITC4 (dvorkin1984, bathe1985): the shear strain along
// a coordinate line is taken from the mid-sides only, which removes shear locking without any zero
// energy mode and passes the patch tests of bending and shear on distorted meshes. The directors
// are the normals of the bilinear mid-surface at the nodes. The membrane is that of
// membrane_quadrilateral.h: it bends exactly within the plane of rectangles of any aspect ratio,
// has the drilling rotation, and lets warped elements bend without stretching.
#pragma once

#include "structure/membrane_quadrilateral.h"
#include "structure/shell_element.h"

namespace vibroimpact::structure {

class QuadrilateralShell : public ShellElement {
public:
  /// Nodes around the element; `positions` are theirs [m], `surface_normals` the unit normals there
  /// of the surface that the whole mesh stands for (see surface_normals.h).
  QuadrilateralShell(const std::array<int, 4> &nodes, const NodeVectors &positions,
                     const NodeVectors &surface_normals, const ShellProperties &properties);

  NodalMatrix stiffness() const override;
  NodalMatrix mass() const override;
  /// At the top and at the bottom.
  Matrix stress(int node) const override;
  double area() const override;
  std::vector<Vector3> pressure_areas() const override;

private:
  DirectorPoint at(double r, double s) const;
  MembraneQuadrilateral membrane() const;
  void add_bending_and_shear(NodalMatrix &stiffness) const;

  NodeVectors corners_;
  NodeVectors directors_;
  NodeVectors surface_normals_;
};

/// Throws like shell_properties().
std::shared_ptr<const Element> make_quadrilateral_shell(const CellPart &cell);

} // namespace vibroimpact::structure
