// Is there a jump of the settled response between two values of a parameter, and where?
//
// Both ends of a bracket hold a settled motion. The motion is settled at the middle, starting from
// the lower end's, and the middle replaces the end whose motion is nearer; near a fold this follows
// the branch as far as it exists. A response that changes continuously, be it over a grazing, a
// period doubling or on a steep flank, comes closer together with every halving, a jump does not:
// the search ends without one as soon as the two ends differ by less than the threshold. A slow
// transient just past a fold is still near the branch that ended there and belongs to it, so that a
// short dwell delays the jump but does not invent one.
#pragma once

#include "analyses/settling.h"

#include <functional>
#include <limits>

namespace vibroimpact {

/// Bracket of a jump in the direction of the sweep; NaN when there is none.
struct Jump {
  double from = std::numeric_limits<double>::quiet_NaN();
  double to = std::numeric_limits<double>::quiet_NaN();

  bool found() const { return from == from; }
};

/// A settled motion and the parameter it belongs to.
struct BranchPoint {
  double value = 0;
  SettledMotion motion;
};

/// Settles at `value` from a state. NumericalError.
using SettleAt = std::function<SettledMotion(double value, const MotionState &from)>;
/// Relative difference of two settled motions, see relative_distance().
using MotionDistance = std::function<double(const SettledMotion &, const SettledMotion &)>;

/// Halves the bracket until it is no wider than `width`. `threshold`: smallest difference that is a
/// jump. Of several jumps between the ends it finds one.
Jump find_jump(BranchPoint before, BranchPoint after, double width, double threshold,
               const SettleAt &settle_at, const MotionDistance &distance);

} // namespace vibroimpact
