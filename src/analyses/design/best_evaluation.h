// What a search from one start has found, as the point that stands before its evaluations.
#pragma once

#include "analyses/design/evaluations.h"
#include "analyses/design/nlopt_search.h"
#include "analyses/results/field_writer.h"

namespace vibroimpact::analyses {

/// The best of the evaluations whose constraints are met within `constraint_tolerance`, the first
/// of equal ones; nullptr when there is none.
const Evaluation *best_evaluation(const std::deque<Evaluation> &evaluations,
                                  const Objective &objective, double constraint_tolerance);

/// Why none of them meets the constraints.
std::string why_nothing_is_good(const std::deque<Evaluation> &evaluations,
                                const Objective &objective);
/// The fields search/evaluations and search/failed, in the summary as well.
void add_counts(const FieldWriter &result, const std::deque<Evaluation> &evaluations);
/// The point with index (line, 0): the best evaluation again, with why the search ended and which
/// bounds and constraints are active, within `tolerance` of the coordinates; failed when no
/// evaluation is good.
PointResult result_of_search(std::size_t line, const std::deque<Evaluation> &evaluations,
                             const std::vector<DesignKey> &keys, const Objective &objective,
                             double tolerance, double constraint_tolerance, SearchEnd end);

} // namespace vibroimpact::analyses
