// What all contacts see of the motion, packed for products.
#pragma once

#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

/// One row for each direction of each contact, those of a contact one behind the other:
/// position = offset + row q + base s, rate = speed + the rate of that.
struct ContactRows {
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  explicit ContactRows(const Equations &equations);

  Index size() const { return rows.rows(); }
  Index first(std::size_t contact) const { return places[contact]; }
  Index directions(std::size_t contact) const { return places[contact + 1] - places[contact]; }
  /// From y and sources in the order of the rows of a phase (phase/exact_phase.h); without internal
  /// states.
  contact::LocalState local(std::size_t contact, const Vector &of) const;

  std::vector<Index> places;
  RowMatrix rows;       ///< rows x n
  RowMatrix base;       ///< rows x sources
  Vector offsets;       ///< [m]
  Vector speeds;        ///< of surfaces [m/s]
  Vector flexibilities; ///< row M^-1 row^T [1/kg]
  Vector largest;       ///< of each coordinate, |row| over all rows
};

} // namespace vibroimpact::motion
