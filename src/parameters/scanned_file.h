// What stands in a parameter file and where, before it is compared with the declarations.
#pragma once

#include "parameters/origin.h"

#include <string>
#include <vector>

namespace vibroimpact::parameters {

/// A key or subsection as written. In JSON an empty entry may be meant as either.
struct ScannedEntry {
  enum class Kind { key, section, empty, array } kind = Kind::section;
  std::string name;
  std::string value{}; ///< of a key, normalised
  Origin origin{};
  bool marked_as_default = false;      ///< by the comment "# default", as the echo does
  std::vector<ScannedEntry> entries{}; ///< of a section, in file order
};

/// The whole file as one section, in deal.II's language; an included file is looked for beside the
/// one that includes it. `name` stands for the file in messages. Throws InputError.
ScannedEntry scan_prm(const std::string &text, const std::string &name);

/// The same from nested objects; every value is a string, number or boolean. Throws InputError.
ScannedEntry scan_json(const std::string &text, const std::string &name);

/// The content of a file; throws InputError at `origin` if it cannot be read.
std::string file_content(const std::string &file, const Origin &origin);

} // namespace vibroimpact::parameters
