// The sections "Figure NAME" of a parameter file: figures with chosen axes. They are read again,
// from the parameters that the results carry, by who draws them.
#pragma once

#include "parameters/values.h"

namespace vibroimpact::output {

/// Declares the kind "Figure".
void declare_figures(parameters::Section &root);

/// InputError for a figure of an analysis that the file does not have, for one without a quantity
/// along an axis, and for divisors and ranges that cannot be.
void check_figures(const parameters::Values &root);

} // namespace vibroimpact::output
