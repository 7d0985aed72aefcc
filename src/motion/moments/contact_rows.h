// The gaps of all contacts as rows of the motion.
#pragma once

#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

/// gap = clearance + row q + base s
struct ContactRows {
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  explicit ContactRows(const Equations &equations);

  Index size() const { return rows.rows(); }
  /// From y and sources in the order of the rows of a phase (phase/exact_phase.h).
  contact::LocalState local(Index contact, const Vector &of) const;

  RowMatrix rows;       ///< contacts x n
  RowMatrix base;       ///< contacts x sources
  Vector clearances;    ///< [m]
  Vector flexibilities; ///< row M^-1 row^T of each contact [1/kg]
  Vector largest;       ///< of each coordinate, |row| over all contacts
};

} // namespace vibroimpact::motion
