#include "motion/variation/low_rank_map.h"

#include <Eigen/LU>

namespace vibroimpact::motion {

void LowRankMap::add(const Vector &direction, const RowVector &factor) {
  const Index r = rank();
  left.conservativeResize(direction.size(), r + 1);
  right.conservativeResize(r + 1, factor.size());
  left.col(r) = direction;
  right.row(r) = factor;
}

void LowRankMap::apply(Matrix &columns) const {
  if (rank() > 0)
    columns += left * (right * columns).eval();
}

void LowRankMap::apply_from_right(RowVector &row) const {
  if (rank() > 0)
    row += (row * left).eval() * right;
}

double LowRankMap::determinant() const {
  const Index r = rank();
  if (r == 0)
    return 1;
  const Matrix small = Matrix::Identity(r, r) + right * left;
  return r == 1 ? small(0, 0) : small.partialPivLu().determinant();
}

} // namespace vibroimpact::motion
