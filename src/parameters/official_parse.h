// deal.II's ParameterHandler has the last word on what a parameter file says.
#pragma once

#include "parameters/tree.h"

namespace vibroimpact::parameters {

/// Declares every key of the tree, its named subsections included, parses the scanned file and
/// puts the values found into the tree. Throws InputError.
void parse_with_dealii(const ScannedEntry &file, Node &root);

} // namespace vibroimpact::parameters
