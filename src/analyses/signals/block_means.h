// Mean rates of growing totals over a window, with the standard errors that the scatter of its
// parts tells.
#pragma once

#include "common/linear_algebra.h"

#include <vector>

namespace vibroimpact::analyses {

class BlockMeans {
public:
  /// The window begins at `time` [s]; forgets the one before.
  void begin(double time, Vector totals);
  /// A block is over, the next begins.
  void end_block(double time, Vector totals);

  double last_end() const { return times_.back(); }

  /// Of the mean rate of each total from the start to the end of the last block: with d_b the
  /// durations and r_b the mean rates of B blocks, D and r those of all,
  /// sqrt(B / (B - 1) sum (d_b / D)^2 (r_b - r)^2). NaN where there are fewer than two blocks. The
  /// blocks must be longer than the memory of the motion.
  Vector standard_errors() const;

private:
  std::vector<double> times_; ///< ends of the blocks, behind the start
  std::vector<Vector> totals_;
};

} // namespace vibroimpact::analyses
