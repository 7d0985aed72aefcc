// The last few of a sequence of states, the newest first.
#pragma once

#include "common/linear_algebra.h"

#include <algorithm>

namespace vibroimpact::analyses {

class LastStates {
public:
  /// At most so many states of so many entries are kept.
  LastStates(Index entries, Index most) : states_(entries, most) {}

  void clear() { seen_ = 0; }
  /// The newest one; the oldest goes when there are too many.
  template <class State> void add(const State &state) {
    states_.col(seen_++ % states_.cols()) = state;
  }
  Index count() const { return std::min(seen_, states_.cols()); }
  /// The state so many before the newest, age < count().
  auto operator[](Index age) const { return states_.col((seen_ - 1 - age) % states_.cols()); }
  /// Largest difference of the entries of two of them.
  double change(Index newer, Index older) const {
    return ((*this)[newer] - (*this)[older]).cwiseAbs().maxCoeff();
  }

private:
  Matrix states_;
  Index seen_ = 0;
};

} // namespace vibroimpact::analyses
