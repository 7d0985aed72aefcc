// What an analysis that evaluates others is given: quantities of them at other values of some keys.
// derived/repeated_analysis.h computes them.
#pragma once

#include "common/result_sink.h"
#include "parameters/expression.h"
#include "parameters/values.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// A field or derived quantity.
struct Outcome {
  std::string unit;       ///< as results have it, "1" when dimensionless
  parameters::Number one; ///< what one unit is in SI
  std::string description;
  std::vector<Axis> axes;                    ///< of its dimensions; none for a single number
  std::vector<parameters::Number> axis_ones; ///< what one unit of each of them is in SI
  std::vector<double> values;                ///< row-major over the axes [unit]
};

/// All that one evaluation gives.
struct Evaluated {
  std::vector<Outcome> outcomes; ///< one for each name that was asked for
  std::size_t unbalanced = 0;    ///< points whose energy balance does not close
  std::size_t unsettled = 0;     ///< points that were recorded before they were steady
};

class Outcomes {
public:
  virtual ~Outcomes() = default;

  /// InputError when the analysis cannot be built at these values of keys, or when it, or a
  /// parameter grid around it, changes one of them itself.
  virtual void check(const std::string &analysis,
                     const std::vector<parameters::Override> &overrides) const = 0;

  /// Runs the whole analysis on this rank and evaluates the quantities `names`, each of them the
  /// path of a field or the name of a Derived. `progress` is called with the share that is done and
  /// may throw. NumericalError when a point failed or the model cannot be built at these values;
  /// InputError when there is no such quantity.
  virtual Evaluated evaluate(const std::string &analysis,
                             const std::vector<parameters::Override> &overrides,
                             const std::vector<std::string> &names,
                             const std::function<void(double share)> &progress) const = 0;

  /// The same as far as the first point of the analysis shows: units and axes are right, values may
  /// be NaN. None where that cannot be known within `seconds` of processor time, or where the point
  /// fails. InputError as evaluate().
  virtual std::optional<Evaluated>
  try_first_point(const std::string & /*analysis*/,
                  const std::vector<parameters::Override> & /*overrides*/,
                  const std::vector<std::string> & /*names*/, double /*seconds*/) const {
    return std::nullopt;
  }
};

} // namespace vibroimpact::analyses
