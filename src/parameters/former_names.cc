#include "parameters/former_names.h"

#include "common/log.h"
#include "parameters/overrides.h"
#include "parameters/text.h"

namespace vibroimpact::parameters {

namespace {

// A name that a key, a section or an option had in the version before.
struct FormerName {
  const char *key; ///< whose option it was; empty for a key or section
  const char *former;
  const char *present;
};

constexpr FormerName former_names[] = {
    {"Law", "relaxing stop", "kelvin-voigt bumper"},
    {"", "Relaxing stop", "Kelvin-Voigt bumper"},
    {"Law", "piecewise stop", "bilinear stop"},
    {"", "Piecewise stop", "Bilinear stop"},
    {"", "Follows", "Tied to"},
    {"Type", "response", "steady state"},
    {"", "Response", "Steady state"},
    {"Record", "excursions", "extreme values"},
    {"", "Excursions", "Extreme values"},
    {"", "Stretch", "Interval"},
    {"Method", "flight", "exact"},
};

} // namespace

std::string FormerNames::present_name(const std::string &name, const std::string &key,
                                      const std::string &place) {
  for (const FormerName &known : former_names) {
    if (known.former != name || known.key != key)
      continue;
    if (warned_.insert(key + "/" + name).second)
      log::warning(place + ": '" + name + "' is now called '" + known.present +
                   "'; the next version no longer reads the former name.");
    return known.present;
  }
  return name;
}

bool FormerNames::is_path(const std::string &text) const {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    return false;
  const std::string first = normalised(text.substr(0, slash));
  return declarations_.find_subsection(first) != nullptr ||
         kind_of(declarations_, first) != nullptr;
}

std::string FormerNames::present_path(const std::string &path, const std::string &place) {
  if (!is_path(path))
    return path;
  std::vector<std::string> parts = path_parts(path);
  for (std::string &part : parts)
    part = present_name(part, "", place);
  return join(parts, "/");
}

void FormerNames::rename_below(ScannedEntry &section, std::vector<std::string> &path) {
  for (ScannedEntry &entry : section.entries) {
    path.push_back(entry.name);
    const std::string where = parameters::place(entry.origin, path);
    entry.name = present_name(entry.name, "", where);
    path.back() = entry.name;
    entry.value = present_path(entry.value, where);
    rename_below(entry, path);
    path.pop_back();
  }
}

void FormerNames::rename(ScannedEntry &file) {
  std::vector<std::string> path;
  rename_below(file, path);
}

void FormerNames::rename_options(Value &value, const std::vector<std::string> &path) {
  const Key &key = *value.key;
  const std::string where = parameters::place(value.origin, path);
  if (key.kind == KeyKind::choice)
    value.text = present_name(value.text, key.name, where);
  if (key.kind != KeyKind::names || value.text.empty())
    return;
  const std::vector<std::string> former = split_list(value.text);
  std::vector<std::string> names;
  for (const std::string &name : former)
    names.push_back(present_name(name, key.name, where));
  if (names != former)
    value.text = join(names, ", ");
}

} // namespace vibroimpact::parameters
