// The key "Variables": named values for use in every number of the file.
#pragma once

#include "parameters/expression.h"
#include "parameters/origin.h"

#include <string>
#include <vector>

namespace vibroimpact::parameters {

struct VariableDefinition {
  std::string name;
  std::string text;
  Origin origin{};
};

/// "lambda = 2, L = 0.3 m". Throws Refused.
std::vector<VariableDefinition> variable_definitions(const std::string &text, const Origin &origin);

std::string definitions_text(const std::vector<VariableDefinition> &definitions);

/// Evaluates the definitions in turn; throws the InputError at the one that fails.
VariableTable evaluate_variables(const std::vector<VariableDefinition> &definitions);

} // namespace vibroimpact::parameters
