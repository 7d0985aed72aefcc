#include "modes/normal_modes.h"

#include "modes/mode_search.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vibroimpact::modes {

namespace {

// Rayleigh quotients of rigid-body modes, by deformations, stay below this fraction of the largest
// eigenvalue.
constexpr double rigid_fraction = 1e-25;
// Of a Rayleigh quotient and of the dense eigenvalues, relative: the bounds know exact ones only.
constexpr double rounding = 1e-14;

NormalModes normal_modes_of(const EigenProblem &problem, const ModeSearch &search,
                            const CompletePairs &found) {
  NormalModes modes;
  modes.eigenvalues = found.pairs.values;
  const Vector noise = rounding_of_quotients(problem, found.pairs.vectors);
  for (Index j = 0; j < modes.eigenvalues.size(); ++j)
    if (std::abs(modes.eigenvalues[j]) <=
        std::max(rigid_fraction * search.largest(), rounding_deviations * noise[j]))
      modes.eigenvalues[j] = 0;
  modes.shapes = gather(Layout(problem.mass), found.pairs.vectors);
  modes.error_bounds = found.error_bounds;
  for (Index j = 0; j < modes.eigenvalues.size(); ++j)
    if (const double value = modes.eigenvalues[j]; value > 0)
      modes.error_bounds[j] = modes.error_bounds[j] * (value - search.shift()) / value + rounding;
  modes.orthogonality_residual = orthogonality_residual(problem, found.pairs.vectors);
  return modes;
}

// A mode on the edge of the band belongs to it, whatever the last digit of its frequency.
constexpr double band_tolerance = 1e-9;

void select_band(NormalModes &modes, const std::array<double, 2> &band) {
  const Vector omega = modes.eigenvalues.array().max(0.0).sqrt();
  const double lower = band[0] * (1 - band_tolerance);
  const double upper = band[1] * (1 + band_tolerance);
  modes.first = (omega.array() < lower).count();
  modes.number = (omega.array() <= upper).count() - modes.first;
}

} // namespace

TooManyModes::TooManyModes(int available_modes)
    : std::runtime_error("there are only " + std::to_string(available_modes) + " modes"),
      available(available_modes) {}

NormalModes normal_modes(const EigenProblem &problem, const Selection &selection) {
  if (!selection.band && selection.number > problem.mass_rank)
    throw TooManyModes(problem.mass_rank);
  ModeSearch search(problem);
  int count = selection.number;
  if (selection.band) {
    const double upper = (*selection.band)[1] * (1 + 10 * band_tolerance);
    count = std::max(1, search.count_below(upper * upper));
  }
  NormalModes modes = normal_modes_of(problem, search, search.lowest(count));
  modes.number = std::min<Index>(count, modes.eigenvalues.size());
  if (selection.band)
    select_band(modes, *selection.band);
  return modes;
}

} // namespace vibroimpact::modes
