// An analysis whose lines are one point each, without axes.
#pragma once

#include "analyses/analysis.h"

#include <functional>

namespace vibroimpact::analyses {

/// Stores the point that `compute` gives, or the reason of its NumericalError; nothing is computed
/// where an earlier run has it.
void run_single_point(LineContext &context, const std::function<PointResult()> &compute);

} // namespace vibroimpact::analyses
