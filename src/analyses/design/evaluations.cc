#include "analyses/design/evaluations.h"

#include "analyses/fields.h"

namespace vibroimpact::analyses {

namespace {

void add_values(PointResult &point, const DesignValue &value, const Objective &objective) {
  const auto add = [&point](const std::string &name, double number, const std::string &unit,
                            const std::string &description) {
    point.fields.push_back(scalar_field(name, number, unit, description));
  };
  const std::string worst = objective.cases() > 1 ? ", the worst case" : "";
  const std::vector<Goal> &goals = objective.goals();
  for (std::size_t g = 0; g < goals.size(); ++g)
    add(goal_field(objective, g), g == 0 ? value.objective : value.others[g - 1],
        g == 0 ? value.unit : value.other_units[g - 1], goals[g].quantity.path + worst);
  if (objective.cases() > 1 && goals.size() == 1)
    point.fields.push_back(series_field("case_objective", "case", value.cases, value.unit,
                                        goals[0].quantity.path + " of each case, the last key of "
                                                                 "Worst over varying fastest"));
  for (std::size_t c = 0; c < value.excess.size(); ++c) {
    const std::string &name = objective.constraints()[c];
    add("constraint/" + name, value.constrained[c], value.constrained_units[c],
        "quantity of the constraint" + worst);
    add("excess/" + name, value.excess[c], "1",
        "by which part of its limit the constraint is not met; negative where it is");
  }
  add("unbalanced", value.unbalanced, "1",
      "points of the evaluation whose energy balance does not close");
  add("unsettled_points", value.unsettled, "1",
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
  value.unbalanced = stored_value(point, "unbalanced");
  value.unsettled = stored_value(point, "unsettled_points");
  const auto add = [&point](const std::string &name, std::vector<double> &values,
                            std::vector<std::string> &units) {
    for (const Field &field : point.fields)
      if (field.name() == name) {
        values.push_back(field.values.at(0));
        units.push_back(field.unit());
      }
  };
  for (std::size_t g = 0; g < objective.goals().size(); ++g)
    add(goal_field(objective, g), value.others, value.other_units);
  value.objective = value.others.at(0);
  value.unit = value.other_units.at(0);
  value.others.erase(value.others.begin());
  value.other_units.erase(value.other_units.begin());
  for (const Field &field : point.fields)
    if (field.name() == "case_objective")
      value.cases = field.values;
  for (const std::string &name : objective.constraints()) {
    value.excess.push_back(stored_value(point, "excess/" + name));
    add("constraint/" + name, value.constrained, value.constrained_units);
  }
  return value;
}

} // namespace vibroimpact::analyses
