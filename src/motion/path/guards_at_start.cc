#include "motion/path/guards_at_start.h"

#include <algorithm>

namespace vibroimpact::motion {

// The rounding changes places with that of the next phase, which may be larger.
void GuardsAtStart::begin(std::size_t largest) {
  next_rounding_.resize(std::max(next_rounding_.size(), largest));
  rounding_.assign(largest, 0);
}

bool GuardsAtStart::enter(const KnownPhase &phase, std::optional<std::size_t> contact,
                          const double *amplitudes, const AlignedArray &rounding,
                          const KnownTo &known_to, const Order &order) {
  const std::vector<PhaseGuard> &guards = phase.guards();
  noise_.resize(static_cast<std::size_t>(phase.view().n_forms));
  order_.assign(guards.size(), 0);
  kernel_.form_noise(phase.view(), rounding.data(), noise_.data());
  for (std::size_t g = 0; g < guards.size(); ++g) {
    if (contact && guards[g].contact != *contact)
      continue;
    double f[4];
    kernel_.derivatives(phase.view(), static_cast<int>(g), amplitudes, f);
    const double noise = known_to(g, f);
    if (f[0] > noise)
      continue;
    const int by_slope = f[1] > 0 ? 1 : 0;
    const int rises = f[0] < -noise ? 0 : order ? order(g, f) : by_slope;
    if (rises == 0)
      return false;
    order_[g] = static_cast<unsigned char>(rises);
  }
  return true;
}

void GuardsAtStart::stay(const KnownPhase &phase) {
  noise_.resize(static_cast<std::size_t>(phase.view().n_forms));
  order_.assign(phase.guards().size(), 0);
  kernel_.form_noise(phase.view(), rounding_.data(), noise_.data());
}

double GuardsAtStart::hidden(const PhaseView &view, std::size_t guard,
                             const double *amplitudes) const {
  return kernel_.guard_margin(view, static_cast<int>(guard), amplitudes, noise_.data());
}

} // namespace vibroimpact::motion
