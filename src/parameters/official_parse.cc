#include "parameters/official_parse.h"

#include "parameters/text.h"

#include <deal.II/base/parameter_handler.h>

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

void parse(const ScannedFile &file, dealii::ParameterHandler &handler) {
  const std::string &name = file.root.origin.source;
  try {
    if (file.root.origin.kind == Origin::Kind::json) {
      std::istringstream stream(file.text);
      handler.parse_input_from_json(stream);
    } else {
      handler.parse_input_from_string(file.text);
    }
  } catch (const dealii::ExceptionBase &error) {
    refuse_place({.source = name}, {}, message_of(error));
  }
}

} // namespace

void parse_with_dealii(const ScannedFile &file, Node &root) {
  dealii::ParameterHandler handler;
  declare(root, handler);
  parse(file, handler);
  for_each_node(root, [&](Node &node) {
    for (Value &value : node.values)
      value.text = normalised(handler.get(node.path, value.key->name));
  });
}

} // namespace vibroimpact::parameters
