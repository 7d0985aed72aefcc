// Laws that say themselves where they do not hold.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// NumericalError where a contact's law objects to the state, in the present modes.
void check_laws(const Equations &equations, double time, const Vector &state);

} // namespace vibroimpact::motion
