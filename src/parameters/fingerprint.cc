#include "parameters/fingerprint.h"

#include "parameters/check_value.h"
#include "parameters/text.h"

#include <array>
#include <cstdio>

namespace vibroimpact::parameters {

namespace {

std::string digits17(double value) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
  return buffer.data();
}

std::string numbers_text(const std::vector<Number> &numbers) {
  std::vector<std::string> texts;
  texts.reserve(numbers.size());
  for (const Number &number : numbers)
    texts.push_back(digits17(number.value));
  return join(texts, ", ");
}

/// A text may hold expressions that its reader evaluates: the variables named in it belong to it.
std::string text_with_variables(const std::string &text, const VariableTable &variables) {
  std::string result = text;
  for (const std::string &name : used_variables(text, variables))
    result += "; " + name + " = " + digits17(variables.at(name).value);
  return result;
}

std::string si_text(const Value &value, const VariableTable &variables) {
  switch (value.key->kind) {
  case KeyKind::quantity:
  case KeyKind::quantities:
  case KeyKind::integer:
    return numbers_text(value.numbers);
  case KeyKind::boolean:
    return value.text.empty() ? "" : boolean_value(value.text) ? "true" : "false";
  case KeyKind::names:
    return join(split_list(value.text), ", ");
  case KeyKind::text:
    return text_with_variables(value.text, variables);
  case KeyKind::choice:
  case KeyKind::variables:
    break;
  }
  return value.text;
}

} // namespace

std::string fingerprint_text(const Node &section, const VariableTable &variables) {
  std::string text;
  for_each_node(section, [&](const Node &node) {
    std::string path;
    for (std::size_t i = section.path.size(); i < node.path.size(); ++i)
      path += node.path[i] + "/";
    for (const Value &value : node.values)
      if (value.key->kind != KeyKind::variables)
        text += path + value.key->name + " = " + si_text(value, variables) + "\n";
  });
  return text;
}

} // namespace vibroimpact::parameters
