// Maps of deviations that change them in a few directions only, as events do:
//
//   d+ = d- + L R d-,   L n x r, R r x n,   det(1 + L R) = det(1 + R L)   (Sylvester)
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::motion {

struct LowRankMap {
  Matrix left, right; ///< L, R; without columns: the identity

  Index rank() const { return left.cols(); }
  /// Adds a direction and what it is multiplied by.
  void add(const Vector &direction, const RowVector &factor);
  void apply(Matrix &columns) const;
  /// row <- row (1 + L R)
  void apply_from_right(RowVector &row) const;
  double determinant() const;
};

} // namespace vibroimpact::motion
