#include "common/log.h"
#include "parameters/check_value.h"
#include "parameters/echo.h"
#include "parameters/file_units.h"
#include "parameters/like.h"
#include "parameters/overrides.h"
#include "parameters/parameter_data.h"
#include "parameters/text.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>

namespace vibroimpact::parameters {

namespace {

struct Pending {
  Value *value;
  const Node *node;
};

/// A default that fails its own check is a mistake in the program, not of the user.
void check_default(Value value, const Section &section) {
  try {
    check_value(value, {});
  } catch (const Refused &refused) {
    throw std::logic_error("default of '" + section.name() + " / " + value.key->name +
                           "': " + refused.what());
  }
}

void check_defaults(const Section &section) {
  for (const Key &key : section.keys())
    check_default({.key = &key, .text = normalised(key.default_value)}, section);
  for (const auto &subsection : section.subsections())
    check_defaults(*subsection);
  for (const auto &kind : section.named_subsections())
    check_defaults(*kind);
}

std::vector<std::string> path_of(const Pending &pending) {
  std::vector<std::string> path = pending.node->path;
  path.push_back(pending.value->key->name);
  return path;
}

void check(const Pending &pending, const VariableTable &variables) {
  const std::vector<std::string> path = path_of(pending);
  try {
    check_value(*pending.value, variables);
  } catch (const Refused &refused) {
    refuse_value(pending.value->origin, path, pending.value->text, refused.what());
  }
}

std::vector<Pending> values_where(Node &root, const std::function<bool(const Value &)> &wanted) {
  std::vector<Pending> found;
  for_each_node_with(root, wanted, [&](Node &node) {
    for (Value &value : node.values)
      if (wanted(value))
        found.push_back({&value, &node});
  });
  return found;
}

/// In file order, so that the first error of the file is the one reported; overrides come last.
void check_in_order(std::vector<Pending> pending, const VariableTable &variables) {
  const auto rank = [](const Pending &item) {
    const Origin &origin = item.value->origin;
    return std::pair(origin.kind == Origin::Kind::override, origin.order);
  };
  std::stable_sort(pending.begin(), pending.end(),
                   [&](const Pending &a, const Pending &b) { return rank(a) < rank(b); });
  for (const Pending &item : pending)
    check(item, variables);
}

/// What overrides have changed in a tree.
struct Changes {
  std::vector<const Value *> values;
  std::set<std::string> variables; ///< by name
  bool all_variables = false;
};

/// Changed itself, or by a variable in it.
bool outdated(const Value &value, const Changes &changes) {
  const bool expression = std::any_of(value.numbers.begin(), value.numbers.end(),
                                      [](const Number &number) { return !number.literal; });
  return (expression && (changes.all_variables || uses_any(value.text, changes.variables))) ||
         std::find(changes.values.begin(), changes.values.end(), &value) != changes.values.end();
}

/// The definitions as the value of the key "Variables" now has them.
std::vector<VariableDefinition> read_definitions(const Value &value) {
  try {
    return variable_definitions(value.text, value.origin);
  } catch (const Refused &refused) {
    refuse_value(value.origin, {value.key->name}, value.text, refused.what());
  }
}

/// Replaces texts only.
Changes replace_texts(Node &root, std::vector<VariableDefinition> &definitions,
                      const std::vector<Override> &overrides) {
  Changes changes;
  for (const Override &replacement : overrides) {
    if (is_variable_override(replacement)) {
      changes.variables.insert(override_variable(definitions, replacement));
      root.find_value("Variables")->text = definitions_text(definitions);
      root.find_value("Variables")->given = true;
      continue;
    }
    const Value &value = override_value(root, replacement);
    if (&value == std::as_const(root).find_value(units_key))
      refuse_value(override_origin(replacement), {}, replacement.value,
                   "Units must be set in the file itself");
    changes.values.push_back(&value);
    if (value.key->kind == KeyKind::variables) {
      definitions = read_definitions(value);
      changes.all_variables = true;
    }
  }
  return changes;
}

/// Of an override by hand; those of grids and searches have the units of their keys.
void warn_of_missing_units(const Node &file, const std::vector<VariableDefinition> &definitions,
                           const std::vector<Override> &overrides, const VariableTable &variables) {
  for (const Override &replacement : overrides)
    if (const std::string warning =
            missing_unit(replaced_text(file, definitions, replacement), replacement, variables);
        !warning.empty())
      log::warning(warning);
}

bool is_json(const std::string &file) {
  const std::string suffix = std::filesystem::path(file).extension().string();
  if (suffix != ".prm" && suffix != ".json")
    refuse_place({.source = file}, {}, "the name of a parameter file must end in .prm or .json");
  return suffix == ".json";
}

} // namespace

ParameterSet::ParameterSet(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

std::shared_ptr<const ParameterSet> ParameterSet::read(std::shared_ptr<const Section> declarations,
                                                       const std::string &file,
                                                       const std::vector<Override> &overrides) {
  const bool json = is_json(file);
  return parse(std::move(declarations), file_content(file, {.source = file}), file, json,
               overrides);
}

std::shared_ptr<const ParameterSet> ParameterSet::parse(std::shared_ptr<const Section> declarations,
                                                        const std::string &text,
                                                        const std::string &name, bool json,
                                                        const std::vector<Override> &overrides) {
  check_defaults(*declarations);
  ScannedEntry scanned = json ? scan_json(text, name) : scan_prm(text, name);
  auto data = std::make_shared<Data>();
  data->variables.dimensionless = is_dimensionless(scanned);
  if (data->variables.dimensionless)
    declarations = declarations->without_units();
  take_over_entries(scanned, *declarations);
  data->file = name;
  data->root = build_tree(*declarations, scanned);
  data->declarations = std::move(declarations);
  if (const Value *variables = std::as_const(data->root).find_value("Variables"))
    data->definitions = read_definitions(*variables);
  const Node file = data->root;
  const std::vector<VariableDefinition> file_definitions = data->definitions;
  replace_texts(data->root, data->definitions, overrides);
  data->variables = evaluate_variables(data->definitions, data->variables.dimensionless);
  check_in_order(values_where(data->root, [](const Value &) { return true; }), data->variables);
  warn_of_missing_units(file, file_definitions, overrides, data->variables);
  return std::make_shared<const ParameterSet>(std::move(data));
}

std::shared_ptr<const ParameterSet> ParameterSet::with(const std::vector<Override> &more) const {
  auto data = std::make_shared<Data>(*data_);
  Changes changes = replace_texts(data->root, data->definitions, more);
  if (changes.all_variables)
    data->variables = evaluate_variables(data->definitions, data_->variables.dimensionless);
  else if (!changes.variables.empty())
    data->variables = evaluate_variables(data->definitions, data_->variables, changes.variables);
  const auto is_outdated = [&](const Value &value) { return outdated(value, changes); };
  check_in_order(values_where(data->root, is_outdated), data->variables);
  return std::make_shared<const ParameterSet>(std::move(data));
}

std::optional<SiNumber> ParameterSet::number_at(const std::string &path) const {
  const Override probe{.path = path, .value = "0", .origin = "parameter grid"};
  if (is_variable_override(probe)) {
    const auto found = data_->variables.find(path.substr(path.find('/') + 1));
    if (found == data_->variables.end())
      return std::nullopt;
    return SiNumber{.value = found->second.value, .unit = si_unit(found->second.dimension)};
  }
  Node tree = data_->root; // the walk to a value is that of an override, on a copy
  const Value &value = override_value(tree, probe);
  const bool number = value.key->kind == KeyKind::quantity || value.key->kind == KeyKind::integer;
  if (!number || value.numbers.size() != 1)
    return std::nullopt;
  const Dimension dimension =
      value.key->dimension.any ? value.numbers.front().dimension : value.key->dimension;
  return SiNumber{.value = value.numbers.front().value, .unit = si_unit(dimension)};
}

std::string ParameterSet::key_path(const std::string &path) const try {
  return parameters::key_path(data_->root, data_->definitions, path);
} catch (const Refused &refused) {
  throw InputError(path + ": " + refused.what() + ".");
}

Values ParameterSet::root() const { return {shared_from_this(), data_->root}; }

const VariableTable &ParameterSet::variables() const { return data_->variables; }

bool ParameterSet::dimensionless() const { return data_->variables.dimensionless; }

std::string ParameterSet::folder() const {
  const std::filesystem::path folder = std::filesystem::path(data_->file).parent_path();
  return folder.empty() ? "." : folder.string();
}

std::string ParameterSet::echo() const { return echo_text(data_->root); }

} // namespace vibroimpact::parameters
