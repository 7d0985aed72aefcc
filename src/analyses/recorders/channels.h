// The quantities a motion is observed by: displacement, velocity and acceleration of every named
// point along the axes it can move, rotation of every mass that turns.
//
// Displacements and velocities are relative to the base the body stands on, accelerations are
// absolute, as is usual for shaken structures.
#pragma once

#include "model/model.h"

#include <algorithm>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct Channel {
  std::string point; ///< "body.point"
  char axis = 'x';
  model::Projection relative; ///< displacement relative to the base, or rotation
  model::Projection absolute; ///< displacement in space, or rotation
  bool rotation = false;      ///< about the axis

  /// Does a moving base carry the point along this axis?
  bool carried() const {
    return std::any_of(absolute.base_coefficients.begin(), absolute.base_coefficients.end(),
                       [](double base_coefficients) { return base_coefficients != 0; });
  }
};

/// All points of the model but those of interfaces, whose contacts are observed, along all axes on
/// which some coordinate moves them by more than 1e-12 of the point's largest value; and the
/// rotations that are coordinates of lumped bodies.
std::vector<Channel> observed_channels(const model::Model &model);

} // namespace vibroimpact::analyses
