// Names of the version before in a parameter file become the present ones.
#pragma once

#include "parameters/scanned_file.h"
#include "parameters/tree.h"

#include <set>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

/// Warns of each former name once, at the first place it is found at.
class FormerNames {
public:
  /// The declarations are referred to.
  explicit FormerNames(const Section &declarations) : declarations_(declarations) {}

  /// Keys and sections of the file, and paths of keys among its values.
  void rename(ScannedEntry &file);
  /// The path of an override; other text is returned as it is.
  std::string present_path(const std::string &path, const std::string &place);
  /// An option, or the entries of a list of names.
  void rename_options(Value &value, const std::vector<std::string> &path);

private:
  void rename_below(ScannedEntry &section, std::vector<std::string> &path);
  bool is_path(const std::string &text) const;
  /// `name` itself where it is no former one; `key` is that of an option.
  std::string present_name(const std::string &name, const std::string &key,
                           const std::string &place);

  const Section &declarations_;
  std::set<std::string> warned_;
};

} // namespace vibroimpact::parameters
