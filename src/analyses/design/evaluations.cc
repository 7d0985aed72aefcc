#include "analyses/design/evaluations.h"

#include "analyses/results/fields.h"

namespace vibroimpact::analyses {

namespace {

void add_values(const FieldWriter &point, const DesignValue &value, const Objective &objective) {
  const std::string worst = objective.cases() > 1 ? ", the worst case" : "";
  const std::vector<Goal> &goals = objective.goals();
  for (std::size_t g = 0; g < goals.size(); ++g)
    point.number(goal_field(objective, g), g == 0 ? value.objective : value.others[g - 1],
                 g == 0 ? value.unit : value.other_units[g - 1], goals[g].quantity.path + worst);
  if (objective.cases() > 1 && goals.size() == 1)
    point.series("case_objective", "case", value.cases, value.unit,
                 goals[0].quantity.path + " of each case, the last key of "
                                          "Worst over varying fastest");
  for (std::size_t c = 0; c < value.excess.size(); ++c) {
    const std::string &name = objective.constraints()[c];
    point.number("constraint/" + name, value.constrained[c], value.constrained_units[c],
                 "quantity of the constraint" + worst);
    point.number("excess/" + name, value.excess[c], "1",
                 "by which part of its limit the constraint is not met; negative where it is");
  }
  point.number("unbalanced", value.unbalanced, "1",
               "points of the evaluation whose energy balance does not close");
  point.number("unsettled_points", value.unsettled, "1",
               "points of the evaluation that were recorded before they were steady");
}

} // namespace

PointResult evaluation_point(const std::vector<std::size_t> &index, const Evaluation &evaluation,
                             const std::vector<DesignKey> &keys, const Objective &objective) {
  PointResult point{.index = index};
  add_keys(point, keys, evaluation.coordinates);
  if (!evaluation.value.failed())
    add_values(point, evaluation.value, objective);
  else {
    point.status = Status::failed;
    point.reason = evaluation.value.failure;
  }
  return point;
}

DesignValue Evaluations::compute(const std::vector<parameters::Override> &overrides) const {
  return objective_.evaluate(context().outcomes(), overrides,
                             [this](double share) { context().note_progress(share); });
}

PointResult Evaluations::point(const std::vector<std::size_t> &index,
                               const Evaluation &evaluation) const {
  return evaluation_point(index, evaluation, search_keys_, objective_);
}

DesignValue Evaluations::read(const PointResult &point) const {
  return stored_design_value(point, objective_);
}

std::string goal_field(const Objective &objective, std::size_t goal) {
  const std::string &name = objective.goals()[goal].name;
  return name.empty() ? "objective" : "objective/" + name;
}

DesignValue stored_design_value(const PointResult &point, const Objective &objective) {
  if (point.status == Status::failed)
    return {.failure = stored_failure(point)};
  DesignValue value;
  value.unbalanced = number_of(point, "unbalanced", nan);
  value.unsettled = number_of(point, "unsettled_points", nan);
  for (std::size_t g = 0; g < objective.goals().size(); ++g) {
    const Field &field = field_of(point, goal_field(objective, g));
    (g == 0 ? value.objective : value.others.emplace_back()) = field.values.at(0);
    (g == 0 ? value.unit : value.other_units.emplace_back()) = field.unit();
  }
  if (const Field *field = find(point, "case_objective"))
    value.cases = field->values;
  for (const std::string &name : objective.constraints()) {
    value.excess.push_back(number_of(point, "excess/" + name, nan));
    const Field &field = field_of(point, "constraint/" + name);
    value.constrained.push_back(field.values.at(0));
    value.constrained_units.push_back(field.unit());
  }
  return value;
}

} // namespace vibroimpact::analyses
