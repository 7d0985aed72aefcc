#include "parameters/official_parse.h"

#include "parameters/text.h"

// Without this Boost 1.74 prints a message about its own use of the placeholders.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <deal.II/base/parameter_handler.h>

#include <iterator>
#include <sstream>

namespace vibroimpact::parameters {

namespace {

void declare(const Node &root, dealii::ParameterHandler &handler) {
  for_each_node(root, [&](const Node &node) {
    for (const std::string &name : node.path)
      handler.enter_subsection(name);
    for (const Value &value : node.values)
      handler.declare_entry(value.key->name, value.key->default_value, dealii::Patterns::Anything(),
                            value.key->sentence);
    for (std::size_t i = 0; i < node.path.size(); ++i)
      handler.leave_subsection();
  });
}

/// The message alone: what() of deal.II's exceptions carries a stack trace.
std::string message_of(const dealii::ExceptionBase &error) {
  std::ostringstream text;
  error.print_info(text);
  return normalised(text.str());
}

using JsonTree = boost::property_tree::ptree;

bool is_section(const Node &node, const std::string &name) {
  if (node.find_subsection(name) != nullptr)
    return true;
  const Section *kind = kind_of(*node.declared, name);
  return kind != nullptr && node.find_value(name) == nullptr;
}

const Node &section_below(const Node &node, const std::string &name) {
  if (const Node *fixed = node.find_subsection(name))
    return *fixed;
  const std::string &kind = kind_of(*node.declared, name)->name();
  return *node.find_instance(kind, name.substr(kind.size() + 1));
}

/// deal.II takes an empty object for a key.
void remove_empty_sections(JsonTree &object, const Node &node) {
  for (auto child = object.begin(); child != object.end();) {
    if (is_section(node, child->first))
      remove_empty_sections(child->second, section_below(node, child->first));
    const bool is_empty = child->second.empty() && is_section(node, child->first);
    child = is_empty ? object.erase(child) : std::next(child);
  }
}

void parse_json(const std::string &text, const Node &root, dealii::ParameterHandler &handler) {
  JsonTree tree;
  std::istringstream stream(text);
  boost::property_tree::read_json(stream, tree);
  remove_empty_sections(tree, root);
  std::stringstream without_empty_sections;
  boost::property_tree::write_json(without_empty_sections, tree);
  handler.parse_input_from_json(without_empty_sections);
}

void parse(const ScannedFile &file, const Node &root, dealii::ParameterHandler &handler) {
  const std::string &name = file.root.origin.source;
  try {
    if (file.root.origin.kind == Origin::Kind::json)
      parse_json(file.text, root, handler);
    else
      handler.parse_input_from_string(file.text);
  } catch (const dealii::ExceptionBase &error) {
    refuse_place({.source = name}, {}, message_of(error));
  }
}

} // namespace

void parse_with_dealii(const ScannedFile &file, Node &root) {
  dealii::ParameterHandler handler;
  declare(root, handler);
  parse(file, root, handler);
  for_each_node(root, [&](Node &node) {
    for (Value &value : node.values)
      value.text = normalised(handler.get(node.path, value.key->name));
  });
}

} // namespace vibroimpact::parameters
