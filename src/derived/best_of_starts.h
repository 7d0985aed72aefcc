// Of an analysis that searches from several starts: which of them has found the best, and what.
#pragma once

#include "analyses/analysis.h"
#include "derived/labelled_array.h"

#include <vector>

namespace vibroimpact::derived {

/// `best_OBJECTIVE`, where `objective` is the field that is made small or large, `best_KEY` and, of
/// a fit, `standard_error_KEY` of every key and, of several starts, `best_start` (from 1), over the
/// axes before start and evaluation; NaN where no start has found anything. Nothing before the
/// first result.
std::vector<DerivedArray> best_of_starts(const Source &source, const analyses::BestOf &by);

} // namespace vibroimpact::derived
