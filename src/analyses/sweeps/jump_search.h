// Is there a jump of the settled response between two values of a parameter, and where?
//
// Both ends of a bracket hold a settled motion. The motion is settled at the middle, starting from
// the lower end's, and the middle replaces the end whose motion is nearer; near a fold this follows
// the branch as far as it exists. A response that changes continuously, be it over a grazing, a
// period doubling or on a steep flank, comes closer together with every halving, a jump does not:
// the search ends without one as soon as the two ends differ by less than the threshold. A slow
// transient just past a fold is still near the branch that ended there and belongs to it, so that a
// short dwell delays the jump but does not invent one. The bracket is therefore that of the motion
// with its settling, not of the fold.
//
// A step is itself a disturbance and can throw a motion off a branch that goes on. A narrow bracket
// is therefore tried once more: when the motion that settles at its far end from the near one is
// still on the branch, the search goes on from there. When that is so at the far end of the whole
// interval, there is no jump in it, and the far end is to be started from the state next to it.
#pragma once

#include "analyses/sweeps/settling.h"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace vibroimpact::analyses {

/// Where the motion jumps, settled as it was, in the direction of the sweep; NaN when it does not.
struct Jump {
  double from = std::numeric_limits<double>::quiet_NaN();
  double to = std::numeric_limits<double>::quiet_NaN();
  /// The branch goes on at the far end, which is reached from this state.
  std::optional<motion::MotionState> start_on_branch{};

  bool found() const { return !std::isnan(from); }
};

/// A settled motion and the parameter it belongs to.
struct BranchPoint {
  double value = 0;
  SettledMotion motion;
};

/// Settles at `value` from a state. NumericalError.
using SettleAt = std::function<SettledMotion(double value, const motion::MotionState &from)>;
/// Relative difference of two settled motions, see relative_distance().
using MotionDistance = std::function<double(const SettledMotion &, const SettledMotion &)>;

/// Halves the bracket until it is no wider than `width`. `threshold`: smallest difference that is a
/// jump. Of several jumps between the ends it finds one.
Jump find_jump(BranchPoint before, BranchPoint after, double width, double threshold,
               const SettleAt &settle_at, const MotionDistance &distance);

} // namespace vibroimpact::analyses
