#include "parameters/values.h"

#include "parameters/check_value.h"
#include "parameters/fingerprint.h"
#include "parameters/overrides.h"
#include "parameters/parameter_data.h"
#include "parameters/text.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vibroimpact::parameters {

namespace {

std::vector<std::string> path_of(const Node &node, const std::string &key) {
  std::vector<std::string> path = node.path;
  path.push_back(key);
  return path;
}

std::string shown_value(const Value &value) {
  return value.given ? value.text : value.text + " (default)";
}

std::logic_error undeclared(const std::string &what, const std::string &name, const Node &node) {
  return std::logic_error(what + " '" + name + "' is not declared in section '" +
                          join(node.path, "/") + "'");
}

} // namespace

Values::Values(std::shared_ptr<const ParameterSet> set, const Node &node)
    : set_(std::move(set)), node_(&node) {}

const Value &Values::value(const std::string &key) const {
  const Value *value = node_->find_value(key);
  if (value == nullptr)
    throw undeclared("key", key, *node_);
  return *value;
}

const Value &Values::value(const std::string &key, const std::vector<KeyKind> &kinds) const {
  const Value &found = value(key);
  if (std::find(kinds.begin(), kinds.end(), found.key->kind) == kinds.end())
    throw std::logic_error("key '" + key + "' was asked for as another kind than declared");
  return found;
}

double Values::quantity(const std::string &key) const {
  const Value &found = value(key, {KeyKind::quantity});
  require_value(key);
  return found.numbers.front().value;
}

double Values::quantity_of(const std::string &key, const Dimension &expected) const {
  require_value(key);
  require_dimension(key, expected);
  return quantity(key);
}

std::vector<double> Values::quantities(const std::string &key) const {
  std::vector<double> numbers;
  for (const Number &number : value(key, {KeyKind::quantities}).numbers)
    numbers.push_back(number.value);
  return numbers;
}

long Values::integer(const std::string &key) const {
  const Value &found = value(key, {KeyKind::integer});
  require_value(key);
  return static_cast<long>(found.numbers.front().value);
}

bool Values::boolean(const std::string &key) const {
  const Value &found = value(key, {KeyKind::boolean});
  require_value(key);
  return boolean_value(found.text);
}

std::string Values::choice(const std::string &key) const {
  const Value &found = value(key, {KeyKind::choice});
  require_value(key);
  return found.text;
}

std::string Values::text(const std::string &key) const {
  return value(key, {KeyKind::text, KeyKind::variables}).text;
}

std::vector<std::string> Values::names(const std::string &key) const {
  return split_list(value(key, {KeyKind::names}).text);
}

std::optional<Dimension> Values::dimension(const std::string &key) const {
  const Value &found = value(key, {KeyKind::quantity, KeyKind::quantities});
  if (found.numbers.empty() || found.numbers.front().bare)
    return std::nullopt;
  return found.numbers.front().dimension;
}

void Values::require_dimension(const std::string &key, const Dimension &expected) const {
  const Value &found = value(key, {KeyKind::quantity, KeyKind::quantities});
  if (set_->dimensionless())
    return; // reading has refused all units
  for (const Number &number : found.numbers)
    if (!fits(number, expected))
      reject(key, wrong_dimension(found.text, number, expected, found.key->range, ""));
}

double Values::part(const std::string &key, const std::string &part, const Dimension &expected,
                    const Range &range) const {
  value(key, {KeyKind::text, KeyKind::names});
  try {
    return checked_number(part, set_->dimensionless() ? dimension::none : expected, range, "",
                          set_->data_->variables)
        .value;
  } catch (const Refused &refused) {
    reject(key, refused.what());
  }
}

bool Values::has(const std::string &key) const { return !value(key).text.empty(); }

bool Values::given(const std::string &key) const { return value(key).given; }

void Values::require(const std::string &key) const {
  if (!value(key).key->required)
    throw std::logic_error("key '" + key + "' of section '" + path() + "' is not marked required");
  require_value(key);
}

void Values::require_value(const std::string &key) const {
  if (has(key))
    return;
  const Value &found = value(key);
  const std::string &when = found.key->required_when;
  const std::string problem = "a value must be given" + (when.empty() ? when : " when " + when) +
                              "; " + expectation(*found.key);
  if (found.given)
    refuse_value(found.origin, path_of(*node_, key), "", problem);
  refuse_place(found.origin, path_of(*node_, key), problem);
}

Values Values::subsection(const std::string &name) const {
  const Node *found = node_->find_subsection(name);
  if (found == nullptr)
    throw undeclared("subsection", name, *node_);
  return {set_, *found};
}

bool Values::subsection_given(const std::string &name) const {
  return subsection(name).node_->given;
}

std::vector<std::string> Values::instances(const std::string &kind) const {
  if (node_->declared->find_named(kind) == nullptr)
    throw undeclared("named subsection", kind, *node_);
  std::vector<std::string> names;
  for (const std::vector<Shared<Node>> &of_kind : node_->instances)
    for (const Node &instance : of_kind)
      if (instance.declared->name() == kind)
        names.push_back(instance.instance);
  return names;
}

Values Values::instance(const std::string &kind, const std::string &name) const {
  const Node *found = node_->find_instance(kind, name);
  if (found == nullptr)
    throw undeclared(kind, name, *node_);
  return {set_, *found};
}

void Values::reject(const std::string &key, const std::string &problem) const {
  const Value &found = value(key);
  const std::string subject = problem.starts_with("must ") ? key + " " : "";
  refuse_value(found.origin, path_of(*node_, key), shown_value(found), subject + problem);
}

void Values::reject_section(const std::string &problem) const {
  refuse_place(node_->origin, node_->path, problem);
}

void Values::require_known(const std::string &key, const std::string &name,
                           const std::vector<std::string> &known) const {
  if (std::find(known.begin(), known.end(), name) != known.end())
    return;
  const std::string all =
      known.empty() ? "; there is none" : "; possible are: " + join(known, ", ");
  const std::string near = suggestion(name, known);
  reject(key, "there is no '" + name + "'" + (near.empty() ? all : near));
}

std::string Values::key_path(const std::string &key) const {
  try {
    return parameters::key_path(set_->data_->root, set_->data_->definitions, text(key));
  } catch (const Refused &refused) {
    reject(key, refused.what());
  }
}

std::string Values::locate(const std::string &key) const {
  return place(key) + " = " + shown_value(value(key));
}

std::string Values::place(const std::string &key) const {
  return parameters::place(value(key).origin, path_of(*node_, key));
}

std::string Values::path() const { return join(node_->path, "/"); }

std::string Values::fingerprint() const { return fingerprint_text(*node_, set_->data_->variables); }

} // namespace vibroimpact::parameters
