// Which error in each state is as bad as the absolute tolerance in a displacement.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// One entry per state: coordinates so that no point moves by more than `tolerance` [m] with one of
/// them, velocities by the natural frequencies; the work integrals, which does not count, has a
/// huge one.
Vector absolute_tolerances(const Equations &equations, double tolerance);

} // namespace vibroimpact::motion
