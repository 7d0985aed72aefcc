// What the reader of an analysis must not overlook: points that failed, and why, or are doubtful.
#pragma once

#include "common/result_sink.h"
#include "output/summary_list.h"
#include "output/yield_excess.h"

#include <string>
#include <utility>
#include <vector>

namespace vibroimpact::output {

class PointTotals {
public:
  explicit PointTotals(YieldStresses yield_stresses = {}) : yield_(std::move(yield_stresses)) {}

  void add(const PointResult &point);

  /// Adds `PREFIX.failed_points = 3 [1]` and others, only for what there is. Below them, for the
  /// first distinct reasons, `PREFIX.failed_points[1] = 2 [1]  why`.
  void add_to(SummaryList &list, const std::string &prefix) const;

  /// "1 of 3 points failed:" and the reasons, one below the other; empty when none did.
  std::string failures() const;
  /// How many points were recorded before they were steady; empty when all were steady.
  std::string unsettled() const;
  /// How many unstable periodic orbits are not where their motion had settled; empty when none.
  std::string settled_elsewhere() const;
  /// Stresses beyond those at which bodies yield.
  const YieldExcess &yield() const { return yield_; }
  /// True when a point holds the motion of its bodies.
  bool has_motion() const { return has_motion_; }

private:
  struct Reason {
    std::string kind; ///< the text without its numbers
    std::string text; ///< of the first point
    std::size_t points = 0;
  };
  std::size_t listed_reasons() const;

  std::size_t points_ = 0, failed_ = 0, unsettled_ = 0, elsewhere_ = 0, unbalanced_ = 0;
  double undecided_ = 0;
  bool has_motion_ = false;
  YieldExcess yield_;
  std::vector<Reason> reasons_; ///< in the order of the points
};

} // namespace vibroimpact::output
