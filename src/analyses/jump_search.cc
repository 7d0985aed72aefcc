#include "analyses/jump_search.h"

#include <cmath>

namespace vibroimpact {

Jump find_jump(BranchPoint before, BranchPoint after, double width, double threshold,
               const SettleAt &settle_at, const MotionDistance &distance) {
  // Two motions that do not repeat differ by chance.
  if (!before.motion.steady() && !after.motion.steady())
    return {};
  while (distance(before.motion, after.motion) >= threshold) {
    const double middle = before.value + (after.value - before.value) / 2;
    const bool narrow = std::abs(after.value - before.value) <= width;
    if (narrow || middle == before.value || middle == after.value)
      return {.from = before.value, .to = after.value};
    BranchPoint point{.value = middle, .motion = settle_at(middle, before.motion.state)};
    const bool nearer_before =
        distance(before.motion, point.motion) <= distance(point.motion, after.motion);
    (nearer_before ? before : after) = std::move(point);
  }
  return {};
}

} // namespace vibroimpact
