// After how many forcing periods a motion repeats, from states taken once per period.
#pragma once

#include "common/linear_algebra.h"

#include <vector>

namespace vibroimpact::analyses {

/// States at the ends of consecutive forcing periods, made comparable.
class StroboscopicPoints {
public:
  /// `scale`: s_j > 0, the size that counts as one for each component. `angles`: components [rad]
  /// that repeat after a turn.
  StroboscopicPoints(const std::vector<Vector> &states, const Vector &scale,
                     const std::vector<Index> &angles);

  std::size_t size() const { return points_.size(); }
  /// max_j |P(n + k) - P(n)|_j / s_j
  double difference(std::size_t n, std::size_t k) const;
  /// The largest of these over first <= n <= last - k.
  double largest_difference(std::size_t k, std::size_t first, std::size_t last) const;

private:
  std::vector<Vector> points_; ///< divided by the scale
  Vector turn_;                ///< 2 pi / scale for angles, 0 for other components
};

struct Repetition {
  long multiple = 0;     ///< k: the motion repeats after k periods; 0 when it does not
  double difference = 0; ///< largest difference at k, or the smallest such of all k searched
  long searched = 0;     ///< largest k that was looked at
};

/// The smallest k <= longest with max_n max_j |P(n + k) - P(n)|_j / s_j < tolerance. Only k that
/// fit twice into the points are searched.
Repetition find_repetition(const StroboscopicPoints &points, long longest, double tolerance);

/// A motion that is still on its way to one that repeats.
struct Approach {
  long multiple = 0;    ///< k of the motion approached; 0 when none is recognised
  double rate = 0;      ///< factor by which the distance shrinks per forcing period
  double remaining = 0; ///< distance left at the end, as a geometric series
};

/// Is what find_repetition() took for a repetition after k > 1 periods a slow spiral towards a
/// motion that repeats sooner? Of one that does repeat after k and no sooner, the differences at j
/// < k repeat as well; here those of a j < k shrink, from the first k of the points to the last k,
/// by more than a twentieth.
Approach find_spiral(const StroboscopicPoints &points, long k);

/// The smallest k <= longest for which the largest difference shrinks by more than a tenth from
/// third to third of the points, the second time by at least half (logarithmically) of the first.
Approach find_approach(const StroboscopicPoints &points, long longest);

} // namespace vibroimpact::analyses
