// Many points as arrays with one dimension more, for results whose number is not known beforehand.
#pragma once

#include "common/result_sink.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// The fields of all points, by name: `dimension` comes first in each, then the field's own. What a
/// point does not have, or has shorter than others, is NaN. Names get the prefix.
std::vector<Field> stacked(const std::vector<PointResult> &points, const std::string &dimension,
                           const std::string &prefix = "");

} // namespace vibroimpact::analyses
