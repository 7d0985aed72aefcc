// What is made as small or as large as possible, and under which conditions: quantities of another
// analysis, the worst of them over values of further keys.
#pragma once

#include "analyses/design/single_outcomes.h"
#include "analyses/run/grid.h"
#include "common/bytes.h"

#include <limits>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// Of one set of values of the keys.
struct DesignValue {
  std::string failure{}; ///< why there are no values; else empty
  double objective = std::numeric_limits<double>::quiet_NaN(); ///< the worst case [unit]
  std::string unit{};
  std::vector<double> others{}; ///< of the objectives after the first, each the worst case
  std::vector<std::string> other_units{};
  std::vector<double> cases{};       ///< objective of each case of the sections Worst over [unit]
  std::vector<double> constrained{}; ///< quantity of each constraint, the worst case
  std::vector<std::string> constrained_units{};
  /// By which part of the limit each constraint is not met; negative where it is.
  std::vector<double> excess{};
  double unbalanced = 0; ///< points whose energy balance does not close
  double unsettled = 0;  ///< points that were recorded before they were steady

  bool failed() const { return !failure.empty(); }
  double largest_excess() const;
};
void members(auto &visit, As<DesignValue> auto &value) {
  visit(value.failure, value.objective, value.unit, value.others, value.other_units, value.cases,
        value.constrained, value.constrained_units, value.excess, value.unbalanced,
        value.unsettled);
}

/// A quantity that is to be small or large.
struct Goal {
  std::string name{}; ///< of its section; empty for a single one
  WantedQuantity quantity;
  bool maximise = false;
  /// `value` or its negative, so that less is better.
  double to_minimise(double value) const { return maximise ? -value : value; }
};

class Objective {
public:
  /// Keys of a single goal.
  static void declare_goal(parameters::Section &section);
  static Goal read_goal(const parameters::Values &section, const std::string &key);
  /// Constraints and the sections Worst over.
  static void declare_limits(parameters::Section &section);
  /// `taken`: keys that are changed already. InputError.
  Objective(std::vector<Goal> goals, const parameters::Values &section, const std::string &repeated,
            std::vector<std::string> &taken);

  const std::vector<Goal> &goals() const { return goals_; }
  double to_minimise(double objective) const { return goals_.front().to_minimise(objective); }
  /// Every objective so that less is better.
  std::vector<double> all_to_minimise(const DesignValue &value) const;
  const std::vector<std::string> &constraints() const { return constraint_names_; }
  /// Paths of the keys of Worst over.
  std::vector<std::string> worst_keys() const { return grid_paths(worst_over_); }
  std::size_t cases() const { return grid_size(worst_over_); }

  /// InputError, see Outcomes::check(), in any case of Worst over.
  void check(const Outcomes &outcomes, const std::vector<parameters::Override> &overrides) const;
  /// InputError when quantities are not there, are no single numbers, or are limited by values of
  /// another dimension, as far as Outcomes::try_first_point() shows.
  void try_out(const Outcomes &outcomes, const std::vector<parameters::Override> &overrides) const;
  /// A NumericalError becomes the value's failure. InputError when a quantity is not there, is no
  /// single number, or is limited by a value of another dimension; `progress` may throw.
  DesignValue evaluate(const Outcomes &outcomes, const std::vector<parameters::Override> &overrides,
                       const std::function<void(double share)> &progress) const;

  /// What an evaluation leaves for the lines after its own.
  std::string note(DesignValue value) const;
  std::size_t message_size() const;

private:
  std::vector<parameters::Override> case_overrides(std::size_t number,
                                                   std::vector<parameters::Override> first) const;
  void add_goals(const Evaluated &evaluated, DesignValue &value) const;
  void add_case(const Evaluated &evaluated, DesignValue &value) const;
  double excess_of(std::size_t constraint, const Outcome &outcome) const;

  std::vector<Goal> goals_;
  std::string analysis_;               ///< that is evaluated
  std::vector<WantedQuantity> wanted_; ///< of the goals, then of the constraints
  std::vector<std::string> paths_;     ///< of these
  std::vector<std::string> constraint_names_;
  std::vector<GridKey> worst_over_;
  parameters::Values section_;
};

} // namespace vibroimpact::analyses
