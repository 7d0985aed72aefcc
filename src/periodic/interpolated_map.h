// Interpolated cell mapping: the map of a plane, known at the nodes of a grid and interpolated
// between them (Tongue 1987; bicubic here).
//
// The interpolation error is of order h^4 where the map is smooth. Across lines where it is only
// continuous, such as that of grazing starts, it is of order h, on a part of the plane that
// is of order h as well. Maps that jump (rigid grazes are square roots, and touch lines of
// rigid contacts break the map) are none of its concern.
#pragma once

#include "periodic/state_map.h"

#include <array>
#include <optional>

namespace vibroimpact::periodic {

/// Of a rectangle of nodes along one axis.
struct NodeAxis {
  double first = 0, last = 0;
  Index count = 0; ///< at least 4

  double step() const { return (last - first) / static_cast<double>(count - 1); }
};

class InterpolatedMap {
public:
  /// Evaluates the map of two entries at every node. A node without a motion makes the cells
  /// around it unusable.
  InterpolatedMap(const StateMap &map, const std::array<NodeAxis, 2> &axes);

  /// Nothing outside of the nodes, and where one of the 16 that are needed has no image.
  std::optional<Eigen::Vector2d> operator()(const Vector &state) const;

private:
  struct Stencil {
    std::array<Index, 2> first;
    std::array<std::array<double, 4>, 2> weights;
  };
  bool place(const Vector &state, Stencil &stencil) const;
  Index node(Index i, Index j) const { return i * axes_[1].count + j; }

  std::array<NodeAxis, 2> axes_;
  Eigen::Matrix2Xd images_; ///< NaN where there is none
};

} // namespace vibroimpact::periodic
