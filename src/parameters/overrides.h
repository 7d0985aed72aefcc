// Finds what an override means in a tree.
#pragma once

#include "parameters/tree.h"
#include "parameters/values.h"
#include "parameters/variables.h"

namespace vibroimpact::parameters {

/// Where messages say an override comes from: "--set Contact/heads/Clearance".
Origin override_origin(const Override &replacement);

/// Is it "Variables/NAME"?
bool is_variable_override(const Override &replacement);

/// Replaces one definition; returns its name. Throws InputError for a variable the file does not
/// define.
std::string override_variable(std::vector<VariableDefinition> &definitions,
                              const Override &replacement);

/// Replaces the text of the value the path names, and marks it and the sections around it as given.
/// The new text is not checked. Throws InputError for an unknown path.
Value &override_value(Node &root, const Override &replacement);

/// The text that an override replaces, of a variable or of a key that holds one quantity; else
/// empty. The path must lead to a key.
std::string replaced_text(Node root, std::vector<VariableDefinition> definitions,
                          const Override &replacement);

/// "--set Variables/gap = 1 has no unit and is taken as 1 m, but replaces 2 mm": where a number
/// without a unit replaces one with a unit; else empty. 0 needs no unit.
std::string missing_unit(const std::string &replaced, const Override &replacement,
                         const VariableTable &variables);

/// The one spelling of a path: "Contact heads/Clearance", "Variables/lambda". Works on copies.
/// Throws Refused for an unknown path.
std::string key_path(Node root, std::vector<VariableDefinition> definitions,
                     const std::string &path);

} // namespace vibroimpact::parameters
