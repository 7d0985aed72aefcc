// Internal states of contacts whose recovery is over.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// Sets lengths z of open contacts that decay by themselves, z' = -r z, to zero where they are lost
/// in the rounding of the gap to which they belong: as zero they stay what they are in a step of
/// any length, while stability would keep explicit steps below 6 / r for ever. True: one was set.
bool clear_decayed(const Equations &equations, double time, Vector &state);

} // namespace vibroimpact::motion
