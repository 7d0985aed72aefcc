#include "analyses/design/objective.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using parameters::Override;
using parameters::Values;

namespace {

constexpr const char *worst_kind = "Worst over";

} // namespace

double DesignValue::largest_excess() const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double one : excess)
    largest = std::max(largest, one);
  return largest;
}

std::string Objective::note(DesignValue value) const {
  value.failure.resize(std::min(value.failure.size(), longest_failure(wanted_.size())));
  value.unit.resize(std::min(value.unit.size(), longest_unit));
  for (auto *units : {&value.other_units, &value.constrained_units})
    for (std::string &unit : *units)
      unit.resize(std::min(unit.size(), longest_unit));
  return packed(value);
}

std::size_t Objective::message_size() const {
  const std::vector<std::string> units(wanted_.size());
  const std::vector<double> numbers(wanted_.size());
  return packed(DesignValue{.failure = std::string(longest_failure(wanted_.size()), ' '),
                            .others = numbers,
                            .other_units = units,
                            .cases = std::vector<double>(cases()),
                            .constrained = numbers,
                            .constrained_units = units,
                            .excess = numbers})
      .size();
}

void Objective::declare_goal(parameters::Section &section) {
  section
      .text("Objective", "",
            "What is made smallest or largest: the path of a field of the repeated analysis or the "
            "name of a Derived of it; one number.")
      .required()
      .choice("Sense", "minimise", {"minimise", "maximise"}, "Which of the two.");
}

Goal Objective::read_goal(const Values &section, const std::string &key) {
  section.require(key);
  return {.name = {},
          .quantity = {.path = section.text(key), .place = section.place(key)},
          .maximise = section.choice("Sense") == "maximise"};
}

void Objective::declare_limits(parameters::Section &section) {
  using namespace parameters;
  section
      .named_subsection("Constraint",
                        "A quantity that must stay within limits; for some methods only.")
      .text("Quantity", "", "Field or Derived of the repeated analysis; one number.")
      .required()
      .quantity("Lower", "", dimension::any, range::any, "", "Least value allowed.")
      .quantity("Upper", "", dimension::any, range::any, "", "Largest value allowed.")
      .required("Lower is not given");
  declare_grid_keys(section, worst_kind,
                    "A key whose values make several cases of every evaluation; objective and "
                    "constraints are those of the worst case.");
}

Objective::Objective(std::vector<Goal> goals, const Values &section, const std::string &repeated,
                     std::vector<std::string> &taken)
    : goals_(std::move(goals)), analysis_(repeated),
      worst_over_(read_grid_keys(section, worst_kind, repeated, "analysis", taken)),
      section_(section) {
  for (const Goal &goal : goals_)
    wanted_.push_back(goal.quantity);
  constraint_names_ = section.instances("Constraint");
  for (const std::string &name : constraint_names_) {
    const Values constraint = section.instance("Constraint", name);
    constraint.require("Quantity");
    if (!constraint.has("Lower"))
      constraint.require("Upper");
    wanted_.push_back({constraint.text("Quantity"), constraint.place("Quantity")});
  }
  for (const WantedQuantity &quantity : wanted_)
    paths_.push_back(quantity.path);
}

std::vector<double> Objective::all_to_minimise(const DesignValue &value) const {
  std::vector<double> all{goals_[0].to_minimise(value.objective)};
  for (std::size_t g = 1; g < goals_.size(); ++g)
    all.push_back(goals_[g].to_minimise(value.others.at(g - 1)));
  return all;
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

void Objective::try_out(const Outcomes &outcomes, const std::vector<Override> &overrides) const {
  const auto tried = try_single_numbers(outcomes, analysis_, case_overrides(0, overrides), wanted_);
  for (std::size_t c = 0; tried && c < constraint_names_.size(); ++c)
    excess_of(c, (*tried)[goals_.size() + c]);
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

void Objective::add_goals(const Evaluated &evaluated, DesignValue &value) const {
  const bool first = value.cases.empty();
  value.others.resize(goals_.size() - 1);
  value.other_units.resize(goals_.size() - 1);
  for (std::size_t g = 0; g < goals_.size(); ++g) {
    const double number = single_number(evaluated.outcomes[g], paths_[g]);
    double &worst = g == 0 ? value.objective : value.others[g - 1];
    if (first || goals_[g].to_minimise(number) > goals_[g].to_minimise(worst))
      worst = number;
    (g == 0 ? value.unit : value.other_units[g - 1]) = evaluated.outcomes[g].unit;
  }
  value.cases.push_back(evaluated.outcomes[0].values[0]);
}

void Objective::add_case(const Evaluated &evaluated, DesignValue &value) const {
  const bool first = value.cases.empty();
  add_goals(evaluated, value);
  value.constrained.resize(constraint_names_.size());
  value.constrained_units.resize(constraint_names_.size());
  value.excess.resize(constraint_names_.size());
  for (std::size_t c = 0; c < constraint_names_.size(); ++c) {
    const std::size_t i = goals_.size() + c;
    const Outcome &outcome = evaluated.outcomes[i];
    const double quantity = single_number(outcome, paths_[i]);
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
                   analysis_, case_overrides(number, overrides), paths_,
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
