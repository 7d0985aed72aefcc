// Fields of periodic motions that several analyses share.
#pragma once

#include "common/result_sink.h"
#include "periodic/orbit.h"

namespace vibroimpact::analyses {

/// Multipliers, stability, residual, multiple, symmetry and section of an orbit, and its state at
/// phase 0.
void add_orbit(PointResult &result, const periodic::StroboscopicMap &map,
               const periodic::Orbit &orbit, const Vector &state_at_zero);

} // namespace vibroimpact::analyses
