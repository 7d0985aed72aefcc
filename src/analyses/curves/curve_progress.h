// How far curves along a key have come: from their start to the end of the key ahead. Where they
// turn is not known beforehand, so that more may be left than it seems.
#pragma once

#include "continuation/problem.h"
#include "continuation/settings.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vibroimpact::analyses {

class CurveProgress {
public:
  /// `key`: number of the one whose range the curves run over. `note` is called at each point with
  /// the share that is done, at least; it may throw to end the run.
  CurveProgress(continuation::Range range, Index key, std::function<void(double share)> note)
      : range_(range), key_(key), note_(std::move(note)) {}

  /// The listener of a part from `start`, of which `add` takes the points: without the first one
  /// unless `with_start`, as where the other part of the curve has it. `left`: parts that are not
  /// finished.
  auto part(const continuation::Point &start, bool with_start, double left, auto add) {
    from_ = start.keys[key_];
    reached_ = 0;
    return [this, with_start, left, add](const auto &point) mutable {
      note_(at(point.point.keys[key_], left));
      if (with_start)
        add(point);
      with_start = true;
    };
  }
  void finish() {
    ++finished_;
    reached_ = 0;
  }

private:
  // The share of all parts that is done, never less than before.
  double at(double key, double left) {
    const double ahead = key > from_ ? range_.upper - from_ : from_ - range_.lower;
    if (ahead > 0)
      reached_ = std::max(reached_, std::min(1.0, std::abs(key - from_) / ahead));
    share_ = std::max(share_, (finished_ + reached_) / (finished_ + left));
    return share_;
  }

  continuation::Range range_;
  Index key_;
  std::function<void(double share)> note_;
  double from_ = 0, reached_ = 0, finished_ = 0, share_ = 0;
};

} // namespace vibroimpact::analyses
