// What is made as small or as large as possible, and under which conditions: quantities of another
// analysis, the worst of them over values of further keys.
#pragma once

#include "analyses/grid.h"
#include "analyses/outcomes.h"

#include <limits>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// Of one set of values of the keys.
struct DesignValue {
  std::string failure{}; ///< why there are no values; else empty
  double objective = std::numeric_limits<double>::quiet_NaN(); ///< the worst case [unit]
  std::string unit{};
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

class Objective {
public:
  static void declare(parameters::Section &section);
  /// `taken`: keys that are changed already. InputError.
  Objective(const parameters::Values &section, const std::string &repeated,
            std::vector<std::string> &taken);

  bool maximise() const { return maximise_; }
  /// `objective` or its negative, so that less is better.
  double to_minimise(double objective) const { return maximise_ ? -objective : objective; }
  const std::vector<std::string> &constraints() const { return constraint_names_; }
  const std::string &quantity() const { return quantities_.front(); }
  /// Paths of the keys of Worst over.
  std::vector<std::string> worst_keys() const { return grid_paths(worst_over_); }
  std::size_t cases() const { return grid_size(worst_over_); }

  /// InputError, see Outcomes::check(), in any case of Worst over.
  void check(const Outcomes &outcomes, const std::vector<parameters::Override> &overrides) const;
  /// A NumericalError becomes the value's failure. InputError when a quantity is not there, is no
  /// single number, or is limited by a value of another dimension; `progress` may throw.
  DesignValue evaluate(const Outcomes &outcomes, const std::vector<parameters::Override> &overrides,
                       const std::function<void(double share)> &progress) const;

private:
  std::vector<parameters::Override> case_overrides(std::size_t number,
                                                   std::vector<parameters::Override> first) const;
  void add_case(const Evaluated &evaluated, DesignValue &value) const;
  double excess_of(std::size_t constraint, const Outcome &outcome) const;

  bool maximise_;
  std::string analysis_;                ///< that is evaluated
  std::vector<std::string> quantities_; ///< the objective, then those of the constraints
  std::vector<std::string> constraint_names_;
  std::vector<GridKey> worst_over_;
  parameters::Values section_;
};

} // namespace vibroimpact::analyses
