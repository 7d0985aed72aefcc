#include "analyses/design/objective.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using parameters::Override;
using parameters::Values;

namespace {

constexpr const char *worst_kind = "Worst over";

double single_number(const Outcome &outcome, const std::string &name) {
  if (outcome.values.size() != 1) {
    std::string axes;
    for (const Axis &axis : outcome.axes)
      axes += (axes.empty() ? "" : ", ") + axis.name;
    throw InputError("'" + name + "' is no single number but goes over " + axes +
                     ". A section Derived with an Operation such as maximum, mean or select along "
                     "these axes makes one of it.");
  }
  if (!std::isfinite(outcome.values[0]))
    throw NumericalError(name + " is no finite number");
  return outcome.values[0];
}

} // namespace

double DesignValue::largest_excess() const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double one : excess)
    largest = std::max(largest, one);
  return largest;
}

void Objective::declare(parameters::Section &section) {
  using namespace parameters;
  section
      .text("Objective", "",
            "What is made smallest or largest: the path of a field of the repeated analysis or the "
            "name of a Derived of it; one number.")
      .choice("Sense", "minimise", {"minimise", "maximise"}, "Which of the two.");
  section
      .named_subsection("Constraint",
                        "A quantity that must stay within limits; for some methods only.")
      .text("Quantity", "", "Field or Derived of the repeated analysis; one number.")
      .quantity("Lower", "", dimension::any, range::any, "", "Least value allowed.")
      .quantity("Upper", "", dimension::any, range::any, "", "Largest value allowed.");
  declare_grid_keys(section, worst_kind,
                    "A key whose values make several cases of every evaluation; objective and "
                    "constraints are those of the worst case.");
}

Objective::Objective(const Values &section, const std::string &repeated,
                     std::vector<std::string> &taken)
    : maximise_(section.choice("Sense") == "maximise"), analysis_(repeated),
      worst_over_(read_grid_keys(section, worst_kind, repeated, "analysis", taken)),
      section_(section) {
  section.require("Objective");
  quantities_.push_back(section.text("Objective"));
  constraint_names_ = section.instances("Constraint");
  for (const std::string &name : constraint_names_) {
    const Values constraint = section.instance("Constraint", name);
    constraint.require("Quantity");
    if (!constraint.has("Lower"))
      constraint.require("Upper");
    quantities_.push_back(constraint.text("Quantity"));
  }
}

std::vector<Override> Objective::case_overrides(std::size_t number,
                                                std::vector<Override> first) const {
  for (Override &more : grid_overrides(worst_over_, number))
    first.push_back(std::move(more));
  return first;
}

void Objective::check(const Outcomes &outcomes, const std::vector<Override> &overrides) const {
  for (const std::size_t number : grid_probes(worst_over_))
    outcomes.check(analysis_, case_overrides(number, overrides));
}

// q <= u as (q - u) / |u|, without a unit; a limit of zero counts in the quantity's own unit.
double Objective::excess_of(std::size_t constraint, const Outcome &outcome) const {
  const Values section = section_.instance("Constraint", constraint_names_[constraint]);
  double excess = -std::numeric_limits<double>::infinity();
  const auto limit = [&](const char *key, double sign) {
    if (!section.has(key))
      return;
    const double bound = section.quantity_of(key, outcome.one.dimension) / outcome.one.value;
    const double scale = bound == 0 ? 1 : std::abs(bound);
    excess = std::max(excess, sign * (outcome.values[0] - bound) / scale);
  };
  limit("Lower", -1);
  limit("Upper", 1);
  return excess;
}

void Objective::add_case(const Evaluated &evaluated, DesignValue &value) const {
  const bool first = value.cases.empty();
  const double objective = single_number(evaluated.outcomes[0], quantities_[0]);
  value.cases.push_back(objective);
  value.unit = evaluated.outcomes[0].unit;
  if (first || to_minimise(objective) > to_minimise(value.objective))
    value.objective = objective;
  value.constrained.resize(constraint_names_.size());
  value.constrained_units.resize(constraint_names_.size());
  value.excess.resize(constraint_names_.size());
  for (std::size_t c = 0; c < constraint_names_.size(); ++c) {
    const Outcome &outcome = evaluated.outcomes[c + 1];
    const double quantity = single_number(outcome, quantities_[c + 1]);
    const double excess = excess_of(c, outcome);
    if (!first && excess <= value.excess[c])
      continue;
    value.excess[c] = excess;
    value.constrained[c] = quantity;
    value.constrained_units[c] = outcome.unit;
  }
  value.unbalanced += static_cast<double>(evaluated.unbalanced);
  value.unsettled += static_cast<double>(evaluated.unsettled);
}

DesignValue Objective::evaluate(const Outcomes &outcomes, const std::vector<Override> &overrides,
                                const std::function<void(double share)> &progress) const {
  DesignValue value;
  const auto total = static_cast<double>(cases());
  for (std::size_t number = 0; number < cases(); ++number)
    try {
      add_case(outcomes.evaluate(
                   analysis_, case_overrides(number, overrides), quantities_,
                   [&](double share) { progress((static_cast<double>(number) + share) / total); }),
               value);
    } catch (const NumericalError &error) {
      return {.failure = worst_over_.empty()
                             ? error.what()
                             : grid_case(worst_over_, number) + ": " + error.what()};
    }
  return value;
}

} // namespace vibroimpact::analyses
