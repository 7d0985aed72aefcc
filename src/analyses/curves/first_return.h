// About how long a motion without forcing takes to come back to where it was.
#pragma once

#include "periodic/forced_system.h"

namespace vibroimpact::analyses {

/// The time until the motion from `state` passes again, the same way and near that state, the plane
/// across it (periodic/free_period.h) [s]: near is a twentieth of its farthest way from there. It
/// is looked for within twenty of the system's period. `scale` makes states comparable.
/// NumericalError.
double first_return(periodic::ForcedSystem &system, const Vector &state, const Vector &scale);

} // namespace vibroimpact::analyses
