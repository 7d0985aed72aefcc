#include "motion/variation/low_rank_map.h"

#include "common/decompositions.h"

namespace vibroimpact::motion {

void LowRankMap::add(const Vector &direction, const RowVector &factor) {
  const Index r = rank();
  left.conservativeResize(direction.size(), r + 1);
  right.conservativeResize(r + 1, factor.size());
  left.col(r) = direction;
  right.row(r) = factor;
}

void LowRankMap::apply(Matrix &columns) const {
  if (rank() == 1)
    for (Index k = 0; k < columns.cols(); ++k)
      columns.col(k) += left.col(0) * right.row(0).dot(columns.col(k));
  else if (rank() > 1)
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
  if (r == 1)
    return 1 + right.row(0).dot(left.col(0));
  return vibroimpact::determinant(Matrix::Identity(r, r) + right * left);
}

} // namespace vibroimpact::motion
