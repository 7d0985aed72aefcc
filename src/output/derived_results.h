// Derived quantities in the summary.
#pragma once

#include "derived/derived_quantities.h"
#include "output/summary_list.h"

#include <vector>

namespace vibroimpact::output {

/// `analysis.NAME.derived.QUANTITY = value [unit]`; an array has the index of its value, counted
/// from 1, behind the name. Arrays of more than 100 values, contours and bands are left out.
SummaryList derived_summary(const AnalysisHeader &header,
                            const std::vector<derived::DerivedArray> &quantities);

} // namespace vibroimpact::output
