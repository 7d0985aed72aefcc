// Which nodes of two groups face each other: plain geometry.
#pragma once

#include "common/linear_algebra.h"

#include <array>
#include <limits>
#include <vector>

namespace vibroimpact::contact {

struct PairSearch {
  Vector3 direction = Vector3::UnitX(); ///< from the first side to the second, unit vector
  double radius = 0;                    ///< largest distance across the direction [m]
  double reach = std::numeric_limits<double>::infinity(); ///< and along it, either way [m]
  bool joining = false; ///< no direction: the radius bounds the distance itself
};

/// Positions in `first` and in `second`.
using NodePair = std::array<std::size_t, 2>;

/// Pairs of nodes [m] of which each is the nearest to the other among all within the search, so
/// that no node stands in two; in the order of `first`. Of nodes that are equally near (to 1e-9 of
/// the distance) the first counts.
std::vector<NodePair> facing_pairs(const std::vector<Vector3> &first,
                                   const std::vector<Vector3> &second, const PairSearch &search);

} // namespace vibroimpact::contact
