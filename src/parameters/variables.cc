#include "parameters/variables.h"

#include "parameters/text.h"

namespace vibroimpact::parameters {

std::vector<VariableDefinition> variable_definitions(const std::string &text,
                                                     const Origin &origin) {
  std::vector<VariableDefinition> definitions;
  for (const std::string &part : split_list(text)) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos)
      throw Refused("'" + part +
                    "' defines nothing; NAME = VALUE is expected, separated by commas");
    VariableDefinition definition{normalised(part.substr(0, equals)),
                                  normalised(part.substr(equals + 1)), origin};
    check_variable_name(definition.name);
    for (const VariableDefinition &earlier : definitions)
      if (earlier.name == definition.name)
        throw Refused("the variable '" + definition.name + "' is defined twice");
    definitions.push_back(std::move(definition));
  }
  return definitions;
}

std::string definitions_text(const std::vector<VariableDefinition> &definitions) {
  std::vector<std::string> parts;
  parts.reserve(definitions.size());
  for (const VariableDefinition &definition : definitions)
    parts.push_back(definition.name + " = " + definition.text);
  return join(parts, ", ");
}

namespace {

Number evaluated(const VariableDefinition &definition, const VariableTable &table) {
  try {
    return evaluate(definition.text, table);
  } catch (const Refused &refused) {
    const bool overridden = definition.origin.kind == Origin::Kind::override;
    const std::string value =
        overridden ? definition.text : definition.name + " = " + definition.text;
    refuse_value(definition.origin, {"Variables"}, value, refused.what());
  }
}

} // namespace

VariableTable evaluate_variables(const std::vector<VariableDefinition> &definitions,
                                 bool dimensionless) {
  VariableTable table;
  table.dimensionless = dimensionless;
  for (const VariableDefinition &definition : definitions)
    table[definition.name] = evaluated(definition, table);
  return table;
}

VariableTable evaluate_variables(const std::vector<VariableDefinition> &definitions,
                                 const VariableTable &known, std::set<std::string> &changed) {
  VariableTable table;
  table.dimensionless = known.dimensionless;
  for (const VariableDefinition &definition : definitions) {
    if (uses_any(definition.text, changed))
      changed.insert(definition.name);
    table[definition.name] = changed.contains(definition.name) ? evaluated(definition, table)
                                                               : known.at(definition.name);
  }
  return table;
}

} // namespace vibroimpact::parameters
