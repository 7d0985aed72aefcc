// What a search from one start has found, as the point that stands before its evaluations.
#pragma once

#include "analyses/design/evaluations.h"
#include "analyses/design/nlopt_search.h"

namespace vibroimpact::analyses {

/// The best of the evaluations whose constraints are met within `constraint_tolerance`, the first
/// of equal ones; nullptr when there is none.
const Evaluation *best_evaluation(const std::deque<Evaluation> &evaluations,
                                  const Objective &objective, double constraint_tolerance);

/// Why none of them meets the constraints.
std::string why_nothing_is_good(const std::deque<Evaluation> &evaluations,
                                const Objective &objective);
/// The fields search/evaluations and search/failed.
void add_counts(PointResult &result, const std::deque<Evaluation> &evaluations);
/// Summary lines of all fields search/...
void add_search_summary(PointResult &result);
/// The point with index (line, 0): the best evaluation again, with why the search ended and which
/// bounds and constraints are active, within `tolerance` of the coordinates; failed when no
/// evaluation is good.
PointResult result_of_search(std::size_t line, const std::deque<Evaluation> &evaluations,
                             const std::vector<DesignKey> &keys, const Objective &objective,
                             double tolerance, double constraint_tolerance, SearchEnd end);

} // namespace vibroimpact::analyses
