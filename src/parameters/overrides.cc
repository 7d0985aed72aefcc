#include "parameters/overrides.h"

#include "parameters/text.h"

#include <sstream>

namespace vibroimpact::parameters {

namespace {

const std::string variables_prefix = "Variables/";

/// Parts of the path of a key, "Contact/heads/Clearance"; normalised.
std::vector<std::string> path_parts(const std::string &path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '/');)
    parts.push_back(normalised(part));
  return parts;
}

/// Follows a path from the root, noting every section it enters.
class PathWalker {
public:
  PathWalker(Node &root, const std::string &path) : parts_(path_parts(path)), entered_{&root} {}

  Value &walk() {
    if (parts_.empty())
      refuse("a path is missing; write SECTION/KEY");
    while (position_ + 1 < parts_.size())
      enter_next();
    if (position_ == parts_.size())
      refuse("the name of a key is missing after '" + parts_.back() + "'");
    return key();
  }
  const std::vector<Node *> &entered() const { return entered_; }

private:
  Node &here() { return *entered_.back(); }

  [[noreturn]] static void refuse(const std::string &problem) { throw Refused(problem); }

  /// "Geometry", "Body left" or, over two parts, "Body" and "left".
  void enter_next() {
    const std::string &part = parts_[position_];
    if (Node *fixed = here().find_subsection(part)) {
      enter(*fixed, 1);
      return;
    }
    const Section *kind = kind_of(*here().declared, part);
    if (kind == nullptr)
      refuse(unknown_subsection(*here().declared, part));
    const bool over_two_parts = kind->name() == part;
    const std::string name =
        over_two_parts ? parts_[position_ + 1] : part.substr(kind->name().size() + 1);
    enter_instance(*kind, name, over_two_parts ? 2 : 1);
  }

  void enter_instance(const Section &kind, const std::string &name, std::size_t parts) {
    Node *instance = here().find_instance(kind.name(), name);
    if (instance == nullptr)
      refuse("there is no '" + kind.name() + " " + name + "'; " + instances_of(kind));
    enter(*instance, parts);
  }

  void enter(Node &node, std::size_t parts) {
    entered_.push_back(&node);
    position_ += parts;
  }

  std::string instances_of(const Section &kind) {
    std::vector<std::string> names;
    for (const std::vector<Shared<Node>> &of_kind : here().instances)
      for (const Node &node : of_kind)
        if (node.declared == &kind)
          names.push_back(node.path.back());
    return names.empty() ? "the file has no subsection '" + kind.name() + " NAME'"
                         : "the file has: " + join(names, ", ");
  }

  Value &key() {
    const std::string &name = parts_[position_];
    if (Value *value = here().find_value(name))
      return *value;
    if (here().find_subsection(name) != nullptr || kind_of(*here().declared, name) != nullptr)
      refuse("'" + name + "' is a subsection; the name of a key is missing after it");
    refuse(unknown_key(*here().declared, name));
  }

  std::vector<std::string> parts_;
  std::size_t position_ = 0;
  std::vector<Node *> entered_;
};

} // namespace

Origin override_origin(const Override &replacement) {
  return {.kind = Origin::Kind::override, .source = replacement.origin + " " + replacement.path};
}

bool is_variable_override(const Override &replacement) {
  return replacement.path.starts_with(variables_prefix);
}

namespace {

std::string variable_name(const std::string &path) {
  return normalised(path.substr(variables_prefix.size()));
}

/// Throws Refused for a variable that is not among them.
VariableDefinition &find_definition(std::vector<VariableDefinition> &definitions,
                                    const std::string &name) {
  std::vector<std::string> known;
  for (VariableDefinition &definition : definitions) {
    known.push_back(definition.name);
    if (definition.name == name)
      return definition;
  }
  std::string problem = "there is no variable '" + name + "'";
  if (nearest(name, known).empty())
    problem += known.empty() ? "; the file defines none" : "; defined are: " + join(known, ", ");
  throw Refused(problem + suggestion(name, known));
}

} // namespace

std::string override_variable(std::vector<VariableDefinition> &definitions,
                              const Override &replacement) try {
  const std::string name = variable_name(replacement.path);
  VariableDefinition &definition = find_definition(definitions, name);
  definition.text = normalised(replacement.value);
  definition.origin = override_origin(replacement);
  return name;
} catch (const Refused &refused) {
  refuse_value(override_origin(replacement), {}, replacement.value, refused.what());
}

Value &override_value(Node &root, const Override &replacement) try {
  PathWalker walker(root, replacement.path);
  Value &value = walker.walk();
  value.text = normalised(replacement.value);
  if (!is_plain_text(replacement.value))
    throw Refused("a value may not hold control characters or text that is no UTF-8");
  if (replacement.value.find_first_of("#\n\r") != std::string::npos || value.text.ends_with('\\'))
    throw Refused("a value may not hold '#' or a line break, nor end in '\\'");
  value.origin = override_origin(replacement);
  value.given = true;
  for (Node *node : walker.entered())
    node->given = true;
  return value;
} catch (const Refused &refused) {
  refuse_value(override_origin(replacement), {}, replacement.value, refused.what());
}

std::string replaced_text(Node root, std::vector<VariableDefinition> definitions,
                          const Override &replacement) {
  if (is_variable_override(replacement))
    return find_definition(definitions, variable_name(replacement.path)).text;
  const Value &value = PathWalker(root, replacement.path).walk();
  return value.key->kind == KeyKind::quantity ? value.text : "";
}

std::string missing_unit(const std::string &replaced, const Override &replacement,
                         const VariableTable &variables) try {
  if (replaced.empty())
    return "";
  const Number before = evaluate(replaced, variables);
  const Number now = evaluate(replacement.value, variables);
  if (before.bare || !now.bare || now.value == 0)
    return "";
  const std::string unit = si_unit(before.dimension);
  return replacement.origin + " " + replacement.path + " = " + normalised(replacement.value) +
         " has no unit and is taken as " + number_text(now.value) +
         (unit == "1" ? "" : " " + unit) + ", but replaces " + replaced;
} catch (const Refused &) { // said where the value is checked
  return "";
}

std::string key_path(Node root, std::vector<VariableDefinition> definitions,
                     const std::string &path) {
  if (path.starts_with(variables_prefix))
    return variables_prefix + find_definition(definitions, variable_name(path)).name;
  PathWalker walker(root, path);
  const std::string key = walker.walk().key->name;
  std::vector<std::string> parts = walker.entered().back()->path;
  parts.push_back(key);
  return join(parts, "/");
}

Override split_override(const std::string &text, const std::string &origin) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || normalised(text.substr(0, equals)).empty())
    refuse_place({.kind = Origin::Kind::override, .source = origin + " " + text}, {},
                 "PATH=VALUE is expected, for example \"Contact/stop/Clearance=0.7 mm\"");
  return {normalised(text.substr(0, equals)), normalised(text.substr(equals + 1)), origin};
}

} // namespace vibroimpact::parameters
