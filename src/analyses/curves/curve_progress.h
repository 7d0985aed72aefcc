// How far curves along a key have come: from their start to the end of the key ahead. Where they
// turn is not known beforehand, so that more may be left than it seems.
#pragma once

#include "continuation/settings.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

class CurveProgress {
public:
  explicit CurveProgress(continuation::Range range) : range_(range) {}

  /// A part begins at this value of the key.
  void begin(double key) {
    from_ = key;
    reached_ = 0;
  }
  void finish() {
    ++finished_;
    reached_ = 0;
  }
  /// The share of all parts that is done, never less than before. `left`: parts that are not
  /// finished.
  double at(double key, double left) {
    const double ahead = key > from_ ? range_.upper - from_ : from_ - range_.lower;
    if (ahead > 0)
      reached_ = std::max(reached_, std::min(1.0, std::abs(key - from_) / ahead));
    share_ = std::max(share_, (finished_ + reached_) / (finished_ + left));
    return share_;
  }

private:
  continuation::Range range_;
  double from_ = 0, reached_ = 0, finished_ = 0, share_ = 0;
};

} // namespace vibroimpact::analyses
