// The parts of a recorded window whose scatter gives standard errors: of whole forcing periods
// where the window has these.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/signals/block_means.h"

namespace vibroimpact::analyses {

class WindowBlocks {
public:
  /// Declares the key Blocks; `errors`: of what, "the standard errors of the work rates".
  static void declare(parameters::Section &section, const std::string &errors);

  /// The window is divided into `blocks` parts; forgets the one before.
  void begin(const Window &window, long blocks, Vector totals);
  /// Of a window without periods: a block ends with the part of the motion in which its end lies.
  bool ends_with(const motion::Interval &part) const;
  /// Of a window of periods, which has no more blocks than these; not of the last one.
  bool ends_with_period(long cycle) const;
  /// A block is over at `time` [s], the last one included.
  void end_block(double time, Vector totals) { means_.end_block(time, std::move(totals)); }

  /// Of the mean rate of each total (block_means.h).
  Vector standard_errors() const { return means_.standard_errors(); }

private:
  Window window_;
  long blocks_ = 1;
  BlockMeans means_;
};

} // namespace vibroimpact::analyses
