// Quantities of another analysis that must be single numbers.
#pragma once

#include "analyses/run/outcomes.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct WantedQuantity {
  std::string path;  ///< of a field, or name of a Derived
  std::string place; ///< where the file asks for it, for messages
};

/// Texts in a note are cut off: a unit, and a failure that stands instead of units.
inline constexpr std::size_t longest_unit = 32;
constexpr std::size_t longest_failure(std::size_t units) { return 256 + longest_unit * units; }

/// InputError when the outcome is no single number, NumericalError when it is not finite.
double single_number(const Outcome &outcome, const std::string &path);

/// Are the quantities there? InputError with their place when they are not, or when `check`, which
/// is called with the number and the outcome of each, throws one; none when some seconds do not
/// suffice to know.
std::optional<std::vector<Outcome>>
try_quantities(const Outcomes &outcomes, const std::string &analysis,
               const std::vector<parameters::Override> &overrides,
               const std::vector<WantedQuantity> &quantities,
               const std::function<void(std::size_t, const Outcome &)> &check);

/// Are the quantities there, and single numbers? InputError when they are not; none when some
/// seconds do not suffice to know.
std::optional<std::vector<Outcome>>
try_single_numbers(const Outcomes &outcomes, const std::string &analysis,
                   const std::vector<parameters::Override> &overrides,
                   const std::vector<WantedQuantity> &quantities);

} // namespace vibroimpact::analyses
