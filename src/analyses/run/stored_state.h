// A state of an earlier run, read from its result file.
#pragma once

#include "parameters/values.h"

#include <vector>

namespace vibroimpact::analyses {

/// Keys that name run, analysis and point.
void declare_stored_state(parameters::Section &section);

/// The array `state` of that point in SI; empty when no run is named. InputError when there is no
/// such run, analysis or point, or no state in it.
std::vector<double> read_stored_state(const parameters::Values &section);

} // namespace vibroimpact::analyses
