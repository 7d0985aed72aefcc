// One section and all below it as text that is equal when the physics is.
#pragma once

#include "parameters/tree.h"

namespace vibroimpact::parameters {

/// "path = value in SI" lines with 17 digits; paths begin below the section.
std::string fingerprint_text(const Node &section, const VariableTable &variables);

} // namespace vibroimpact::parameters
