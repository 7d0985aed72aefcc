#include "derived/names.h"

#include <algorithm>

namespace vibroimpact::derived {

namespace {

bool holds_word(const std::vector<std::string> &list, const std::string &word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

} // namespace

AxisNames::AxisNames(const std::vector<Axis> &axes, const std::vector<analyses::GridKey> &keys)
    : axes_(axes), swept_(analyses::grid_paths(keys)) {
  std::vector<std::vector<std::string>> wanted(axes.size());
  for (std::size_t a = 0; a < axes.size(); ++a) {
    names_.push_back({axes[a].name});
    if (a < keys.size())
      wanted[a] = {keys[a].path.substr(keys[a].path.rfind('/') + 1), keys[a].name};
  }
  const auto unambiguous = [&](const std::string &name) {
    std::size_t owners = 0;
    for (std::size_t a = 0; a < axes.size(); ++a)
      owners += axes[a].name == name || holds_word(wanted[a], name) ? 1 : 0;
    return owners == 1;
  };
  for (std::size_t a = 0; a < axes.size(); ++a)
    for (const std::string &name : wanted[a])
      if (!name.empty() && unambiguous(name) && !holds_word(names_[a], name))
        names_[a].push_back(name);
}

const Axis *AxisNames::find(const std::string &name) const {
  for (std::size_t a = 0; a < axes_.size(); ++a)
    if (holds_word(names_[a], name))
      return &axes_[a];
  return nullptr;
}

std::string AxisNames::own_name(const std::string &name) const {
  const Axis *axis = find(name);
  return axis == nullptr ? name : axis->name;
}

bool AxisNames::changes(const std::string &variable) const {
  return holds_word(swept_, "Variables/" + variable) || find("Variables." + variable) != nullptr;
}

std::vector<std::string> AxisNames::all() const {
  std::vector<std::string> all;
  for (const auto &names : names_)
    all.insert(all.end(), names.begin(), names.end());
  return all;
}

} // namespace vibroimpact::derived
