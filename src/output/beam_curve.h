// The deformed axis of an Euler-Bernoulli beam element between its nodes.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::output {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Displacement and rotation at `position` (0 at the first node, 1 at the second) of a straight
/// element between the places `first` and `second` [m], from those of its nodes (three
/// displacements [m], three rotations [rad]): linear along the axis and in torsion, cubic Hermite
/// across, with the rotation equal to the slope. This is the exact shape of an unloaded element.
Vector6 beam_curve(const Vector3 &first, const Vector3 &second, const Vector6 &motion_first,
                   const Vector6 &motion_second, double position);

} // namespace vibroimpact::output
