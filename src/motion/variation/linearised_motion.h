// A motion from one instant to another together with its derivatives: what shooting, continuation
// and sensitivities are made of.
#pragma once

#include "motion/path/trajectory.h"
#include "motion/variation/variation.h"

#include <optional>
#include <utility>
#include <vector>

namespace vibroimpact::motion {

struct LinearisedMotion {
  MotionState end;
  /// d(state at the end)/d(state at the start), n x n with n the size of the physical state; behind
  /// the projection of deviations onto those with which the motion can start (start_projection.h).
  Matrix by_state;
  /// d(state at the end)/d(key) at the fixed times and the fixed state at the start, n x keys, per
  /// SI unit of each key. Phases of sources at t = 0 stay. Where the end is a period T after the
  /// start, add `rates` times dT/dp.
  Matrix by_key;
  Vector rates; ///< dx/dt at the end, n
  /// Of the map from the projected start to the end: exp(int tr J dt) times those of the events.
  Determinant determinant;
  long events = 0;
  long without_derivative = 0; ///< events, see Variation::tangential_events()
};

/// Linearises motions of one trajectory, one after the other. What belongs to its linear phases is
/// made once, so that an analysis that asks often keeps one of these.
class Lineariser {
public:
  /// Keeps a reference. `accuracy`: scale and tolerance as for Variation.
  Lineariser(Trajectory &trajectory, VariationAccuracy accuracy)
      : trajectory_(trajectory), accuracy_(std::move(accuracy)) {}

  /// Starts the trajectory at `start` and advances it to `end` [s]. `also` may be an observer of
  /// the same motion; it costs little when it sees no steps.
  /// NumericalError when the motion or its variation fails, Interrupted when the run is to stop.
  LinearisedMotion operator()(const MotionState &start, double end,
                              const std::vector<KeyTangent *> &keys = {}, Observer *also = nullptr);

private:
  Trajectory &trajectory_;
  VariationAccuracy accuracy_;
  std::optional<Variation> variation_;
};

} // namespace vibroimpact::motion
