// Reads the expression of a force over a length and its rate.
#pragma once

#include "parameters/formula.h"
#include "parameters/values.h"

namespace vibroimpact::contact {

/// The text `key` of a section as an expression of x [m] and v [m/s]; a force [N] where its numbers
/// have units. Throws InputError.
parameters::Formula read_formula(const parameters::Values &section, const std::string &key);

} // namespace vibroimpact::contact
