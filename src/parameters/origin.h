// Where a value or section was set, and how a message names that place.
#pragma once

#include <string>
#include <vector>

namespace vibroimpact::parameters {

struct Origin {
  enum class Kind { prm, json, override } kind = Kind::prm;
  std::string source; ///< file as the user gave it; of an override: "--set Contact/heads/Clearance"
  int line = 0;       ///< of a .prm file, from 1; 0 where there is none
  int order = -1;     ///< position among all entries of the file; -1 if not given in it
};

/// "beams.prm:23: Contact heads / Clearance", "beams.json: "Contact heads"/"Clearance"",
/// "--set Contact/heads/Clearance".
std::string place(const Origin &origin, const std::vector<std::string> &path);

/// Throws the InputError "PLACE = VALUE", or "PLACE=VALUE" for overrides, and the problem below.
[[noreturn]] void refuse_value(const Origin &origin, const std::vector<std::string> &path,
                               const std::string &value, const std::string &problem);

/// The same for a section or a whole file.
[[noreturn]] void refuse_place(const Origin &origin, const std::vector<std::string> &path,
                               const std::string &problem);

} // namespace vibroimpact::parameters
