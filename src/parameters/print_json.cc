#include "common/json_text.h"
#include "parameters/print_formats.h"
#include "parameters/text.h"

#include <functional>

namespace vibroimpact::parameters {

namespace {

const char *kind_name(KeyKind kind) {
  switch (kind) {
  case KeyKind::quantity:
    return "quantity";
  case KeyKind::quantities:
    return "quantities";
  case KeyKind::integer:
    return "integer";
  case KeyKind::boolean:
    return "boolean";
  case KeyKind::choice:
    return "choice";
  case KeyKind::names:
    return "names";
  case KeyKind::variables:
    return "variables";
  case KeyKind::text:
    break;
  }
  return "text";
}

std::string list(const std::vector<std::string> &items, int depth) {
  if (items.empty())
    return "[]";
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  return "[\n" + indent + "  " + join(items, ",\n" + indent + "  ") + "\n" + indent + "]";
}

std::string quoted_list(const std::vector<std::string> &words) {
  std::vector<std::string> items;
  items.reserve(words.size());
  for (const std::string &word : words)
    items.push_back(json_string(word));
  return "[" + join(items, ", ") + "]";
}

std::string key_object(const Key &key) {
  const bool has_unit = key.kind == KeyKind::quantity || key.kind == KeyKind::quantities;
  return "{\"name\": " + json_string(key.name) + ", \"kind\": " + json_string(kind_name(key.kind)) +
         ", \"default\": " + json_string(key.default_value) +
         ", \"required\": " + (key.required ? "true" : "false") +
         ", \"required when\": " + json_string(key.required_when) +
         ", \"unit\": " + json_string(has_unit ? si_unit(key.dimension) : "") +
         ", \"range\": " + json_string(limits(key)) + ", \"options\": " + quoted_list(key.options) +
         ", \"symbol\": " + json_string(key.symbol) +
         ", \"sentence\": " + json_string(key.sentence) + "}";
}

std::string section_object(const Section &section, int depth) {
  std::vector<std::string> keys;
  keys.reserve(section.keys().size());
  for (const Key &key : section.keys())
    keys.push_back(key_object(key));
  const auto objects = [&](const std::vector<std::unique_ptr<Section>> &sections) {
    std::vector<std::string> items;
    for (const auto &item : sections)
      items.push_back(section_object(*item, depth + 2));
    return list(items, depth + 1);
  };
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  return "{\n" + indent + "  \"name\": " + json_string(section.name()) + ",\n" + indent +
         "  \"sentence\": " + json_string(section.sentence()) + ",\n" + indent +
         "  \"keys\": " + list(keys, depth + 1) + ",\n" + indent +
         "  \"subsections\": " + objects(section.subsections()) + ",\n" + indent +
         "  \"named subsections\": " + objects(section.named_subsections()) + "\n" + indent + "}";
}

} // namespace

std::string print_json(const Section &declarations) {
  return section_object(declarations, 0) + "\n";
}

} // namespace vibroimpact::parameters
