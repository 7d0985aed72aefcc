// Reads the text of an expression.
#pragma once

#include "parameters/expression_program.h"

#include <string>
#include <vector>

namespace vibroimpact::parameters {

/// The steps that compute `text`; `arguments` hide variables of the same names. Throws Refused.
std::vector<Step> read_steps(const std::string &text, const VariableTable &variables,
                             const std::vector<std::string> &arguments);

} // namespace vibroimpact::parameters
