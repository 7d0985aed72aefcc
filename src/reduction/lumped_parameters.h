// The masses of a lumped body in a parameter file, and the places that they carry.
#pragma once

#include "parameters/values.h"
#include "reduction/body_definition.h"

namespace vibroimpact::reduction {

/// InputError for keys that do not fit the axes, and for points without a mass.
void read_lumped_masses(const parameters::Values &body, BodyDefinition &definition);

} // namespace vibroimpact::reduction
