// The rigid motion in the displacements of an element's nodes, which is taken out before the large
// entries of a stiffness matrix multiply what is left.
#pragma once

#include "structure/element.h"

namespace vibroimpact::structure {

class RigidPart {
public:
  /// Places of the nodes, not all on a line [m].
  explicit RigidPart(std::vector<Vector3> positions);

  /// From the mean of all [m].
  const std::vector<Vector3> &positions() const { return positions_; }
  /// `u` without the mean displacement and rotation of its nodes, column by column; 3 or 6 rows for
  /// each node.
  NodalMatrix removed_from(const NodalMatrix &u) const;

private:
  NodalVector deformation(const NodalVector &u) const;

  std::vector<Vector3> positions_;
  Eigen::Matrix3d inverse_inertia_;
};

} // namespace vibroimpact::structure
