// The names by which a parameter file may call the axes of an analysis.
#pragma once

#include "analyses/run/grid.h"
#include "common/result_sink.h"

#include <string>
#include <vector>

namespace vibroimpact::derived {

/// Of one analysis: for each outer axis its own name first, then what else it goes by.
class AxisNames {
public:
  AxisNames() = default;
  /// The axes of `keys` come first. A swept key also goes by the last part of its path and by the
  /// name of its section, as long as only one axis goes by that name.
  AxisNames(const std::vector<Axis> &axes, const std::vector<analyses::GridKey> &keys);

  /// The axis' own name; `name` itself when no outer axis is called so.
  std::string own_name(const std::string &name) const;
  /// The outer axis, nullptr when no one is called so.
  const Axis *find(const std::string &name) const;
  /// Does this variable of the file change from point to point?
  bool changes(const std::string &variable) const;
  /// All names, for messages.
  std::vector<std::string> all() const;

private:
  std::vector<Axis> axes_;
  std::vector<std::vector<std::string>> names_;
  std::vector<std::string> swept_; ///< paths of keys, followers included
};

} // namespace vibroimpact::derived
