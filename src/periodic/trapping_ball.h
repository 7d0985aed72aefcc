// A ball around a stable fixed point that attracts all of its states, measured in the norm in which
// the map contracts.
//
// Linear maps contract by rho there (adapted_norm.h). How far the contraction of the map itself
// reaches is tested: the radius grows as long as the images of points on the sphere lie within
//
//   r (1 - 0.3 (1 - |mu|)) > rho r
//
// A ball like that decides which motion a state leads to long before the state is near it.
#pragma once

#include "periodic/adapted_norm.h"
#include "periodic/state_map.h"

namespace vibroimpact::periodic {

class TrappingBall {
public:
  /// `by_state`: J of the map at the fixed point. `largest`: beyond this distance in the scaled
  /// states no start is of interest. `points` on each sphere; 0: 64, or eight for each
  /// state when that is more. The radius is zero where even the smallest ball that can be told from
  /// rounding does not contract. std::logic_error for a fixed point that is not stable.
  TrappingBall(const StateMap &map, Vector fixed_point, const Matrix &by_state, double largest,
               Index points = 0);

  /// In the adapted norm; the least semi-axis in that of the states is radius() / sqrt(largest
  /// eigenvalue of S).
  double radius() const { return radius_; }
  double distance(const Vector &state) const { return norm_(state - fixed_point_); }
  /// Within this share of the radius?
  bool contains(const Vector &state, double share = 1) const {
    return distance(state) < share * radius_;
  }
  const Vector &fixed_point() const { return fixed_point_; }

private:
  bool contracts(const StateMap &map, const Matrix &directions, double radius) const;
  double reach(const StateMap &map, const Matrix &directions, double largest) const;

  Vector fixed_point_;
  AdaptedNorm norm_;
  double contraction_ = 0; ///< required of the sphere
  double radius_ = 0;
};

} // namespace vibroimpact::periodic
