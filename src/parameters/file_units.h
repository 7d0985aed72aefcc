// The key "Units": whether the numbers of a file have units.
#pragma once

#include "parameters/scanned_file.h"
#include "parameters/units.h"

#include <string>

namespace vibroimpact::parameters {

inline constexpr const char *units_key = "Units";
inline constexpr const char *dimensionless_units = "dimensionless";

/// Does the file set Units = dimensionless? Files that it includes may say so again, which is left
/// out of `file`; throws InputError where two of them disagree.
bool is_dimensionless(ScannedEntry &file);

/// Throws Refused for a unit in `text`, a number of a file without units; % is a plain number.
void check_plain(const UnitFactor &unit, const std::string &text);

/// The numbers of a list by themselves, in SI: "0, 6.283185307179586" for "0 deg, 360 deg".
std::string plain_text(const std::string &numbers);

} // namespace vibroimpact::parameters
