// What is known of a motion at one end of a step.
#pragma once

#include "common/linear_algebra.h"

#include <array>
#include <vector>

namespace vibroimpact::motion {

/// s, s', s'', s''', s'''' of a source; the last two where `EndPoint::higher` has columns.
using SourceValues = std::array<double, 5>;

struct EndPoint {
  double time = 0;
  Vector state; ///< x
  Vector rates; ///< dx/dt of the physical part
  /// Second and third time derivative of the physical part, one column each, where the method knows
  /// them; 0 columns otherwise.
  Matrix higher;
  std::vector<SourceValues> sources;
};

} // namespace vibroimpact::motion
