// From which zeros the guards of contacts with friction rise.
#include "motion/path/exact_path.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// What the slope of a guard is summed up from.
double slope_size(const PhaseView &view, std::size_t guard, const double *amplitudes) {
  const auto n = static_cast<std::size_t>(view.n_padded);
  const double *rows = view.rows + (4 * guard + 1) * 2 * n;
  double sum = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double size = std::abs(amplitudes[j]) + std::abs(amplitudes[n + j]);
    const double exponent =
        std::sqrt(view.rate[j] * view.rate[j] + view.frequency[j] * view.frequency[j]);
    sum += std::max(std::abs(rows[j] * amplitudes[j]) + std::abs(rows[n + j] * amplitudes[n + j]),
                    view.sizes[guard * n + j] * exponent * size);
  }
  return sum;
}

} // namespace

// Of the zero from which a guard rises; 0: it falls. The slip rate of sides that begin to slip
// where the force has just reached its limit leaves zero with no slope, and so does the limit of a
// spring that has just come to stick: there the first derivative decides that is not zero to
// rounding.
int ExactPath::rising_order(const KnownPhase &phase, std::size_t guard, const double *amplitudes,
                            const double *derivatives) const {
  if (has_plane_friction(phase.guards()[guard].contact)) {
    const double noise = guard_rounding * slope_size(phase.view(), guard, amplitudes) +
                         2 * time_tolerance(origin_) * std::abs(derivatives[2]);
    if (std::abs(derivatives[1]) <= noise)
      return derivatives[2] > 0 ? 2 : 0;
  }
  return derivatives[1] > 0 ? 1 : 0;
}

} // namespace vibroimpact::motion
