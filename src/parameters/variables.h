// The key "Variables": named values for use in every number of the file.
#pragma once

#include "parameters/expression.h"
#include "parameters/origin.h"

#include <set>
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
VariableTable evaluate_variables(const std::vector<VariableDefinition> &definitions,
                                 bool dimensionless);
/// The same, where `known` holds the values of the definitions that are not `changed` and do not
/// use one that is, near or far. The names of all those that do are added to `changed`.
VariableTable evaluate_variables(const std::vector<VariableDefinition> &definitions,
                                 const VariableTable &known, std::set<std::string> &changed);

} // namespace vibroimpact::parameters
