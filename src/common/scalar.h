// Numbers and functions of one number that the standard library has no short name for.
#pragma once

#include <limits>

namespace vibroimpact {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr double square(double x) { return x * x; }

} // namespace vibroimpact
