// A curve as its points, the special points between them, and how it ends.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::continuation {

enum class End {
  lower_bound, ///< of the key of a branch
  upper_bound,
  bounds, ///< of one of the keys of a locus
  closed,
  far,            ///< the state grows beyond Settings::largest_state
  shorter_return, ///< on solutions of a lower multiple of the map
  graze, ///< that a branch returns to again and again; of a locus, see LocusSpecial::ends_at_graze
  one_sided, ///< of a branch, at a graze that has no solutions close by on its other side
  real_pair, ///< a Neimark-Sacker pair becomes real: strong resonance 1:1 or 1:2
  least_step,
  most_points
};

template <class Point_, class Special_> struct Curve {
  using Point = Point_;
  using Special = Special_;
  std::vector<Point> points;
  std::vector<Special> special; ///< by arclength
  End end = End::most_points;
  std::string reason; ///< the end in words
};

/// Called for every point and special point as it is found. May throw to end the run.
template <class Curve> struct CurveListener {
  std::function<void(const typename Curve::Point &)> point;
  std::function<void(const typename Curve::Special &)> special;
};

} // namespace vibroimpact::continuation
