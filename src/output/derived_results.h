// The way of an analysis' arrays to its derived quantities, and of these to the files.
#pragma once

#include "derived/derived_quantities.h"
#include "output/analysis_arrays.h"

#include <string>
#include <vector>

namespace vibroimpact::output {

/// Looks at the values in `arrays`, which must outlive it.
derived::Source derivation_source(const AnalysisHeader &header, const AnalysisArrays &arrays);

/// `analysis.NAME.derived.QUANTITY = value [unit]`; an array has the index of its value, counted
/// from 1, behind the name. Arrays of more than 100 values, contours and bands are left out.
std::string derived_summary(const AnalysisHeader &header,
                            const std::vector<derived::DerivedArray> &quantities);

} // namespace vibroimpact::output
