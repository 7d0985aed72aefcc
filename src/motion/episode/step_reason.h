// Why a nonlinear contact is integrated in steps instead of being solved as a whole.
#pragma once

#include <array>
#include <cstddef>

namespace vibroimpact::motion {

enum class StepReason {
  method,      ///< the method of the motion has steps only
  system,      ///< the phase before it is not linear
  undecided,   ///< in a linear phase, but where a step had to find out what happens
  law,         ///< its law does not say how its force begins and ends, or a gap is held
  interrupted, ///< a window, a break of a source or Maximum step ends within it
  fast,        ///< a mode turns too far within it
  shape,       ///< its force is no single hump, or too coarse with the most nodes
  neighbour,   ///< another contact may change within it
  shallow,     ///< its two instants, or its release, are not told apart
  pause,       ///< one shortly before was left for its shape or a fast mode
};
constexpr std::size_t n_step_reasons = 10;

/// Numbers of contacts, by the reason.
using StepReasons = std::array<long, n_step_reasons>;

} // namespace vibroimpact::motion
