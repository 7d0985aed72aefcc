// A guard that is zero up to a remainder when its mode begins.
#pragma once

#include <cstddef>

namespace vibroimpact::motion {

struct ZeroGuard {
  std::size_t contact = 0;
  std::size_t guard = 0;
  double remainder = 0; ///< by which it is below zero
  double slack = 0; ///< by which it must fall further to count, where the modes are indeterminate
};

} // namespace vibroimpact::motion
