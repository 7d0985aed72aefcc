// What a ParameterSet holds.
#pragma once

#include "parameters/tree.h"
#include "parameters/values.h"
#include "parameters/variables.h"

namespace vibroimpact::parameters {

struct ParameterSet::Data {
  std::shared_ptr<const Section> declarations; ///< the tree points into it
  std::string file;
  Node root;
  std::vector<VariableDefinition> definitions;
  VariableTable variables;
};

} // namespace vibroimpact::parameters
