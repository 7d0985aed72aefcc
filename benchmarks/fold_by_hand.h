// The folds of the isolator over frequency and stiffness as one would write them with Boost.odeint:
// the equations of half a period with those of their variation, the jumps of the variation where
// contact begins and ends, and Newton's method on the map, a bordered matrix and the arclength.
#pragma once

#include "common/linear_algebra.h"

#include <vector>

namespace vibroimpact::benchmarks {

struct FoldPoint {
  Eigen::Vector2d state; ///< at phase 0
  double frequency = 0, stiffness = 0;
};

/// From a fold to smaller stiffnesses: `count` points at equal distances in (state, lambda, mu).
/// `tolerance` of odeint, relative and absolute. NumericalError.
std::vector<FoldPoint> folds_by_hand(const FoldPoint &start, int count, double distance,
                                     double tolerance);

} // namespace vibroimpact::benchmarks
