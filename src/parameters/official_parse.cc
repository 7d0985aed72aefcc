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

const Node *section_below(const Node &node, const std::string &name) {
  if (const Node *fixed = node.find_subsection(name))
    return fixed;
  const Section *kind = kind_of(*node.declared, name);
  return kind == nullptr || name == kind->name()
             ? nullptr
             : node.find_instance(kind->name(), name.substr(kind->name().size() + 1));
}

/// In deal.II's language, without comments and continued lines. What may be either in JSON, an
/// empty entry, is what the tree took it for.
std::string prm_text(const ScannedEntry &section, const Node &node) {
  std::string text;
  for (const ScannedEntry &entry : section.entries)
    if (const Node *below = section_below(node, entry.name))
      text += "subsection " + entry.name + "\n" + prm_text(entry, *below) + "end\n";
    else
      text += "set " + entry.name + " = " + entry.value + "\n";
  return text;
}

} // namespace

void parse_with_dealii(const ScannedEntry &file, Node &root) {
  dealii::ParameterHandler handler;
  declare(root, handler);
  try {
    handler.parse_input_from_string(prm_text(file, root));
  } catch (const dealii::ExceptionBase &error) {
    refuse_place({.source = file.origin.source}, {}, message_of(error));
  }
  for_each_node(root, [&](Node &node) {
    for (Value &value : node.values)
      value.text = normalised(handler.get(node.path, value.key->name));
  });
}

} // namespace vibroimpact::parameters
