// What a bilinear motion shows, under the names that recorders give it: extreme values, the history
// of one period, and the orders of the excitation.
#pragma once

#include "analyses/bilinear/bilinear_motion.h"
#include "analyses/results/field_writer.h"
#include "analyses/run/system.h"

namespace vibroimpact::analyses {

/// Adds the fields of a motion of `system`, of which `tied` was made. `samples` per period;
/// `orders`: highest multiple of the excitation frequency.
void add_bilinear_motion(const FieldWriter &result, const System &system, const TiedSystem &tied,
                         const BilinearMotion &motion, std::size_t samples, std::size_t orders);

} // namespace vibroimpact::analyses
