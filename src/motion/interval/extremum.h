// Where the largest value of something lies: inside a step, where it is flat, or at an event, where
// it has a kink or a jump and the side counts.
#pragma once

#include "motion/interval/step_view.h"

#include <cmath>
#include <limits>

namespace vibroimpact::motion {

/// The largest value seen. Nothing seen: the value is -infinity.
struct Extremum {
  enum class Side { inside, start, end }; ///< of its step

  double value = -std::numeric_limits<double>::infinity();
  double time = 0;   ///< [s]
  double beside = 0; ///< another instant, close by in the same step [s]
  Side side = Side::inside;

  bool seen() const { return std::isfinite(value); }
  /// A polynomial along a step.
  void include(const StepView &view, const Bernstein &curve);
  /// The normal force of a contact that touches.
  void include_force(const StepView &view, std::size_t contact);
};

} // namespace vibroimpact::motion
