// A map of states, such as that of a forced motion over a period, in scaled entries that may be
// compared with each other.
#pragma once

#include "common/linear_algebra.h"

#include <functional>
#include <utility>

namespace vibroimpact::periodic {

/// From a state to the next one, both scaled. NumericalError where there is none.
using StateMap = std::function<Vector(const Vector &state)>;

/// The map applied so many times.
inline StateMap power_of(StateMap map, long times) {
  return [map = std::move(map), times](const Vector &state) {
    Vector image = state;
    for (long k = 0; k < times; ++k)
      image = map(image);
    return image;
  };
}

} // namespace vibroimpact::periodic
