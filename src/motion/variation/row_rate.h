// How fast a linear form of the state and the sources changes along a motion.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// Of row . [y, s, s', s''], with `rates` those of the state: physical_size() entries or more. Of
/// sources without an exponential form s''' counts as zero.
double rate_of_row(const Equations &equations, const RowVector &row, double time,
                   const Vector &rates);

} // namespace vibroimpact::motion
