// A guard that is zero up to a remainder when its mode begins.
#pragma once

#include <cstddef>

namespace vibroimpact::integration {

struct ZeroGuard {
  std::size_t contact = 0;
  std::size_t guard = 0;
  double remainder = 0; ///< by which it is below zero
};

} // namespace vibroimpact::integration
