// Numbers in the units that results carry. Inside, frequencies are in rad/s; results have Hz.
#pragma once

#include "parameters/expression.h"

#include <string>

namespace vibroimpact::derived {

/// What one `unit` is in SI; the plain number 1 for "1". A unit may be a fraction, "1/s".
parameters::Number one(const std::string &unit);

} // namespace vibroimpact::derived
