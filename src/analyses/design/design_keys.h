// Keys that a search changes between bounds, and the coordinates in which it does so.
#pragma once

#include "analyses/keys/swept_parameter.h"
#include "common/linear_algebra.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// One key. Its coordinate runs from 0 at the lower to 1 at the upper bound, evenly or, where the
/// key is `logarithmic`, in its logarithm. Without one of the bounds it is 0 at `start` and grows
/// by 1 over `length`.
struct DesignKey {
  std::string name;         ///< of its section, "Key NAME"
  SweptParameter parameter; ///< without values
  double lower = 0;         ///< [unit], infinite without a bound
  double upper = 0;         ///< [unit], infinite without a bound
  double start = 0;         ///< [unit]
  double length = 1;        ///< [unit]; of the natural logarithm where the key is logarithmic
  double step = 0.1;        ///< first step of a search, in the coordinate
  bool logarithmic = false;

  bool bounded() const;
  double coordinate(double value) const;
  /// Never beyond a bound.
  double value(double coordinate) const;
};

/// The sections Key.
void declare_design_keys(parameters::Section &section);

/// At least one, in the order of the file, none of them among `taken`, where they are put.
/// `repeated` is the analysis that is evaluated. InputError.
std::vector<DesignKey> read_design_keys(const parameters::Values &section,
                                        const std::string &repeated,
                                        std::vector<std::string> &taken);

/// In their units.
std::vector<double> values_at(const std::vector<DesignKey> &keys, const Vector &coordinates);
std::vector<parameters::Override> overrides_at(const std::vector<DesignKey> &keys,
                                               const Vector &coordinates);

/// The first one, number 0, is what the keys say; the others are drawn uniformly from the box
/// between the bounds, the same for equal `seed` and `number`.
Vector start_of_search(const std::vector<DesignKey> &keys, long seed, std::size_t number);

/// Has every key both bounds?
bool all_bounded(const std::vector<DesignKey> &keys);
/// InputError unless every key has both.
void require_bounds(const parameters::Values &section, const std::vector<DesignKey> &keys);
/// Those of the keys, then `more`.
std::vector<std::string> paths_of(const std::vector<DesignKey> &keys,
                                  const std::vector<std::string> &more);

/// Calls `check` at the start of the first search, and there with each bound by itself. An
/// InputError is given the values that it came from.
void check_at_bounds(const std::vector<DesignKey> &keys, const std::string &evaluated,
                     const std::function<void(const std::vector<parameters::Override> &)> &check);

/// InputError where the section selects excitations, contacts or initial conditions, since those of
/// the analysis that is evaluated count.
void refuse_selections(const parameters::Values &analysis, const std::string &evaluated);

/// The key Repeat, which must not name an analysis that evaluates others itself.
std::string read_evaluated(const parameters::Values &section);
/// The same where Repeat is given.
std::string evaluated_analysis(const parameters::Values &section);

} // namespace vibroimpact::analyses
