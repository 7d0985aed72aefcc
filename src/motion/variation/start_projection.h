// Which deviations a motion can start with.
//
// A contact at rest holds its gap: deviations of the coordinates and velocities must not change it.
// They are projected along M^-1 W^T, W the gap rows of the contacts at rest,
//
//   d_q <- d_q - M^-1 W^T (W M^-1 W^T)^-1 (W d_q + d gap/dp),   d_v likewise with the gap rates
//
// An internal state that follows the gap in the mode at the start, z = R(gap) with z' = dR/dt (the
// compression of a Kelvin-Voigt bumper in contact), has no deviation of its own: d_z = R_x d +
// dR/dp. Without that the map of a period would have a false multiplier 1.
#pragma once

#include "motion/variation/key_tangent.h"

namespace vibroimpact::motion {

/// d+ = by_state d- of deviations, and by_state d- + by_key of the derivatives by keys.
struct LinearMap {
  Matrix by_state; ///< physical_size() squared
  Matrix by_key;   ///< physical_size() x keys
};

/// In the present modes of the equations, at a state with its work integrals.
LinearMap start_projection(const Equations &equations, const std::vector<KeyTangent *> &keys,
                           double time, const Vector &state);

} // namespace vibroimpact::motion
