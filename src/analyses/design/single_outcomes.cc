#include "analyses/design/single_outcomes.h"

#include "common/error.h"

#include <cmath>

namespace vibroimpact::analyses {

namespace {

constexpr double longest_trial = 5; // of processor time [s]

void require_single_number(const Outcome &outcome, const std::string &path) {
  if (outcome.values.size() == 1)
    return;
  std::string axes;
  for (const Axis &axis : outcome.axes)
    axes += (axes.empty() ? "" : ", ") + axis.name;
  throw InputError("'" + path + "' must be a single number, but goes over " + axes +
                   ". A section Derived with an Operation such as maximum, mean or select along "
                   "these axes makes one of it.");
}

} // namespace

double single_number(const Outcome &outcome, const std::string &path) {
  require_single_number(outcome, path);
  if (!std::isfinite(outcome.values[0]))
    throw NumericalError(path + " is no finite number");
  return outcome.values[0];
}

std::optional<std::vector<Outcome>>
try_quantities(const Outcomes &outcomes, const std::string &analysis,
               const std::vector<parameters::Override> &overrides,
               const std::vector<WantedQuantity> &quantities,
               const std::function<void(std::size_t, const Outcome &)> &check) {
  std::vector<std::string> paths;
  for (const WantedQuantity &quantity : quantities)
    paths.push_back(quantity.path);
  try {
    const auto tried = outcomes.try_first_point(analysis, overrides, paths, longest_trial);
    if (!tried)
      return std::nullopt;
    for (std::size_t i = 0; i < paths.size(); ++i)
      check(i, tried->outcomes[i]);
    return tried->outcomes;
  } catch (const InputError &error) {
    const std::string message = error.what();
    for (const WantedQuantity &quantity : quantities)
      if (message.starts_with("'" + quantity.path + "'"))
        throw InputError(quantity.place + ": " + message);
    throw;
  }
}

std::optional<std::vector<Outcome>>
try_single_numbers(const Outcomes &outcomes, const std::string &analysis,
                   const std::vector<parameters::Override> &overrides,
                   const std::vector<WantedQuantity> &quantities) {
  return try_quantities(outcomes, analysis, overrides, quantities,
                        [&](std::size_t i, const Outcome &outcome) {
                          require_single_number(outcome, quantities[i].path);
                        });
}

} // namespace vibroimpact::analyses
