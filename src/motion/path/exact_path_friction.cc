// From which zeros the guards of contacts with friction rise, and where a path goes through a
// change of one.
#include "motion/event/mode_change.h"
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
    const double exponent = std::hypot(view.rate[j], view.frequency[j]);
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
  const std::vector<contact::ContactPair> &pairs = equations_.contacts().pairs();
  if (!pairs[phase.guards()[guard].contact].tangential.empty()) {
    const double noise = guard_rounding * slope_size(phase.view(), guard, amplitudes) +
                         2 * time_tolerance(origin_) * std::abs(derivatives[2]);
    if (std::abs(derivatives[1]) <= noise)
      return derivatives[2] > 0 ? 2 : 0;
  }
  return derivatives[1] > 0 ? 1 : 0;
}

// Of a contact with friction: its next mode depends on more than the guard (mode_change.h), so that
// the way leads over the state. False: it is left to others.
bool ExactPath::change_friction(double time) {
  Vector changed = Vector::Zero(equations_.layout().size());
  known_->phase().state(march_.turned, changed.data());
  KnownPhase *const target = phases_.behind_friction(*known_, passed_guard(), time, changed);
  if (!target || !begin_behind(*target, time, changed)) {
    guards_.stay(*known_);
    running_ = false;
    return false;
  }
  note_residual();
  enter(time, *target);
  return true;
}

// False: one of its guards falls at once.
bool ExactPath::begin_behind(KnownPhase &target, double time, const Vector &state) {
  inputs_.take(exact_phases_.excitation(), time);
  buffers_.physical = state.head(target.phase().n_modes());
  target.phase().amplitudes(buffers_.physical, inputs_.values.data(), buffers_.first);
  std::copy(buffers_.first.begin(), buffers_.first.end(), buffers_.next.begin());
  AlignedArray &rounding = guards_.next_rounding();
  rounding.assign(rounding.size(), 0);
  const double uncertain =
      2 * std::max(time_tolerance(origin_), std::abs(march_.value / march_.slope));
  const auto known_to = [&](std::size_t g, const double *f) {
    return guards_.hidden(target.view(), g, buffers_.next.data()) + uncertain * std::abs(f[1]);
  };
  const auto order = [&](std::size_t g, const double *f) {
    return rising_order(target, g, buffers_.next.data(), f);
  };
  return guards_.enter(target, passed_guard().contact, buffers_.next.data(), rounding,
                       std::ref(known_to), std::ref(order));
}

} // namespace vibroimpact::motion
