// Along or about what a point moves.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::model {

/// A displacement along a direction [m], or a rotation about it [rad].
struct MotionAxis {
  Vector3 direction; ///< unit vector
  bool rotation = false;

  /// A displacement along a direction, which is what most callers mean.
  template <typename Derived>
  MotionAxis(const Eigen::MatrixBase<Derived> &along, bool about = false)
      : direction(along), rotation(about) {}

  /// The first of the three rows of a point (displacements, then rotations) that count.
  Index first_row() const { return rotation ? 3 : 0; }
};

} // namespace vibroimpact::model
