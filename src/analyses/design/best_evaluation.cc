#include "analyses/design/best_evaluation.h"

#include "analyses/results/fields.h"
#include "parameters/text.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

using EvaluationList = std::deque<Evaluation>;

std::size_t failures(const EvaluationList &evaluations) {
  return static_cast<std::size_t>(
      std::count_if(evaluations.begin(), evaluations.end(),
                    [](const Evaluation &evaluation) { return evaluation.value.failed(); }));
}

// In the summary as well.
FieldWriter of_search(const FieldWriter &result) { return result.below("search/").listed(); }

void add_active(const FieldWriter &search, const Evaluation &best,
                const std::vector<DesignKey> &keys, const Objective &objective, double tolerance,
                double constraint_tolerance) {
  for (std::size_t k = 0; k < keys.size(); ++k)
    search.number(
        "bound/" + keys[k].name,
        bound_at(keys[k], keys[k].value(best.coordinates[static_cast<Index>(k)]), tolerance), "1",
        "-1 where the best value is at the lower bound, 1 at the upper one, else 0");
  for (std::size_t c = 0; c < best.value.excess.size(); ++c)
    search.number("active/" + objective.constraints()[c],
                  best.value.excess[c] >= -std::max(tolerance, constraint_tolerance) ? 1 : 0, "1",
                  "1 where the constraint is at its limit");
}

void add_summary(const FieldWriter &result, const Evaluation &best,
                 const std::vector<DesignKey> &keys, const Objective &objective) {
  result.line("objective", best.value.objective, best.value.unit);
  for (std::size_t k = 0; k < keys.size(); ++k)
    result.line("key." + keys[k].name, keys[k].value(best.coordinates[static_cast<Index>(k)]),
                keys[k].parameter.unit);
  for (std::size_t c = 0; c < best.value.excess.size(); ++c)
    result.line("constraint." + objective.constraints()[c], best.value.constrained[c],
                best.value.constrained_units[c]);
}

} // namespace

std::string why_nothing_is_good(const std::deque<Evaluation> &evaluations,
                                const Objective &objective) {
  if (evaluations.empty())
    return "no evaluation was done";
  const std::size_t failed = failures(evaluations);
  if (failed == evaluations.size())
    return "all " + std::to_string(failed) +
           " evaluations failed, the first one: " + evaluations.front().value.failure;
  const Evaluation *nearest = nullptr;
  for (const Evaluation &evaluation : evaluations)
    if (!evaluation.value.failed() &&
        (nearest == nullptr || evaluation.value.largest_excess() < nearest->value.largest_excess()))
      nearest = &evaluation;
  const std::vector<double> &excess = nearest->value.excess;
  const auto worst = std::max_element(excess.begin(), excess.end());
  return "no evaluation meets the constraints; the nearest, number " +
         std::to_string(nearest->number) + ", misses '" +
         objective.constraints()[static_cast<std::size_t>(worst - excess.begin())] + "' by " +
         parameters::number_text(*worst) + " of its limit";
}

void add_counts(const FieldWriter &result, const std::deque<Evaluation> &evaluations) {
  const FieldWriter search = of_search(result);
  search.number("evaluations", static_cast<double>(evaluations.size()), "1",
                "evaluations of the search");
  search.number("failed", static_cast<double>(failures(evaluations)), "1",
                "of these, those that failed");
}

const Evaluation *best_evaluation(const std::deque<Evaluation> &evaluations,
                                  const Objective &objective, double constraint_tolerance) {
  const Evaluation *best = nullptr;
  for (const Evaluation &evaluation : evaluations) {
    const DesignValue &value = evaluation.value;
    if (value.failed() || value.largest_excess() > constraint_tolerance)
      continue;
    if (best == nullptr ||
        objective.to_minimise(value.objective) < objective.to_minimise(best->value.objective))
      best = &evaluation;
  }
  return best;
}

PointResult result_of_search(std::size_t line, const std::deque<Evaluation> &evaluations,
                             const std::vector<DesignKey> &keys, const Objective &objective,
                             double tolerance, double constraint_tolerance, SearchEnd end) {
  const std::vector<std::size_t> index{line, 0};
  const Evaluation *best = best_evaluation(evaluations, objective, constraint_tolerance);
  if (best == nullptr)
    return {.index = index,
            .status = Status::failed,
            .reason = why_nothing_is_good(evaluations, objective)};
  PointResult result = evaluation_point(index, *best, keys, objective);
  add_summary(result, *best, keys, objective);
  const FieldWriter search = of_search(result);
  search.number("best", static_cast<double>(best->number), "1", "number of the best evaluation");
  add_counts(result, evaluations);
  search.number(
      "end", static_cast<double>(end), "1",
      "why the search ended: 1 the keys change by less than Tolerance, 2 the objective by less "
      "than "
      "Objective tolerance, 3 Most evaluations, 4 rounding, 0 the method's own end");
  add_active(search, *best, keys, objective, tolerance, constraint_tolerance);
  return result;
}

} // namespace vibroimpact::analyses
