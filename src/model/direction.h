// Directions in a parameter file: "x", "-z", or three numbers.
#pragma once

#include "common/linear_algebra.h"
#include "parameters/values.h"

#include <optional>
#include <string>

namespace vibroimpact::model {

/// Unit vector; nothing when the text is no direction or has length zero.
std::optional<Vector3> parse_direction(const std::string &text);

/// Unit vector of a text key; InputError otherwise.
Vector3 read_direction(const parameters::Values &values, const std::string &key);

} // namespace vibroimpact::model
