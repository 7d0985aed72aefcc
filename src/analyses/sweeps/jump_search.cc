#include "analyses/sweeps/jump_search.h"

#include "common/error.h"

#include <cmath>

namespace vibroimpact::analyses {

namespace {

constexpr int most_restarts = 32; // of a search that found its branch to go on

bool is_narrow(const BranchPoint &before, const BranchPoint &after, double width) {
  const double middle = before.value + (after.value - before.value) / 2;
  return std::abs(after.value - before.value) <= width || middle == before.value ||
         middle == after.value;
}

// At the middle, or beside it where the motion cannot be computed there, as at an exact grazing.
BranchPoint settle_inside(const BranchPoint &before, const BranchPoint &after,
                          const SettleAt &settle_at) {
  const auto at = [&](double share) {
    const double value = before.value + (after.value - before.value) * share;
    return BranchPoint{.value = value, .motion = settle_at(value, before.motion.state)};
  };
  for (const double share : {0.5, 0.375})
    try {
      return at(share);
    } catch (const NumericalError &) {
      continue;
    }
  return at(0.625);
}

} // namespace

Jump find_jump(BranchPoint before, BranchPoint after, double width, double threshold,
               const SettleAt &settle_at, const MotionDistance &distance) {
  // Two motions that do not repeat differ by chance.
  if (!before.motion.steady() && !after.motion.steady())
    return {};
  const auto nearer_before = [&](const SettledMotion &motion) {
    return distance(before.motion, motion) <= distance(motion, after.motion);
  };
  const BranchPoint far_end = after;
  for (int restarts = 0; distance(before.motion, after.motion) >= threshold;) {
    const bool narrow = is_narrow(before, after, width);
    BranchPoint point = narrow
                            ? BranchPoint{after.value, settle_at(after.value, before.motion.state)}
                            : settle_inside(before, after, settle_at);
    const bool goes_on = nearer_before(point.motion);
    // Where one of the two does not repeat, such as at the edge of chaos, there is no branch that
    // would be worth following in small steps.
    const bool repeats = before.motion.steady() && after.motion.steady();
    if (narrow && (!goes_on || !repeats || restarts++ == most_restarts))
      return {.from = before.value, .to = after.value};
    if (narrow && after.value == far_end.value)
      return {.start_on_branch = before.motion.state};
    (goes_on ? before : after) = std::move(point);
    if (narrow)
      after = far_end;
  }
  return {};
}

} // namespace vibroimpact::analyses
