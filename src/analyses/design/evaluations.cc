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
  add("objective", value.objective, value.unit, objective.quantity() + worst);
  if (objective.cases() > 1)
    point.fields.push_back(series_field("case_objective", "case", value.cases, value.unit,
                                        objective.quantity() + " of each case, the last key of "
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
  if (point.status == Status::failed)
    return {.failure = stored_failure(point)};
  DesignValue value;
  value.objective = stored_value(point, "objective");
  value.unbalanced = stored_value(point, "unbalanced");
  value.unsettled = stored_value(point, "unsettled_points");
  for (const Field &field : point.fields) {
    if (field.name() == "objective")
      value.unit = field.unit();
    if (field.name() == "case_objective")
      value.cases = field.values;
  }
  for (const std::string &name : objective_.constraints()) {
    value.excess.push_back(stored_value(point, "excess/" + name));
    for (const Field &field : point.fields)
      if (field.name() == "constraint/" + name) {
        value.constrained.push_back(field.values.at(0));
        value.constrained_units.push_back(field.unit());
      }
  }
  return value;
}

} // namespace vibroimpact::analyses
