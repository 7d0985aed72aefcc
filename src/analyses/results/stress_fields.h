// The largest stress of the bodies' elements over recorded instants, as fields of a result.
#pragma once

#include "analyses/results/field_writer.h"
#include "model/model.h"

namespace vibroimpact::analyses {

/// Of each body whose elements have a known stress: maximum, instant and place, as fields and
/// summary lines.
void add_largest_stresses(const FieldWriter &result, const model::Model &model,
                          const Motion &motion);

/// Has a body of the model elements of known stress?
bool has_known_stress(const model::Model &model);

} // namespace vibroimpact::analyses
