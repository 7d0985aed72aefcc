// From which zeros the guards of a phase begin, and where a path goes through a change of a contact
// with friction.
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

// Guards of the contact that changed, or of all, may be zero in the phase to come and must rise
// then; what those of other contacts do, the kernel sees. False: one falls at once.
bool ExactPath::begin_guards(const KnownPhase &phase, std::optional<std::size_t> contact,
                             const Amplitudes &amplitudes, const AlignedArray &rounding,
                             const KnownTo &known_to) {
  const std::vector<PhaseGuard> &guards = phase.guards();
  noise_.resize(guards.size());
  order_.assign(guards.size(), 0);
  kernel_.guard_noise(phase.view(), rounding.data(), noise_.data());
  for (std::size_t g = 0; g < guards.size(); ++g) {
    if (contact && guards[g].contact != *contact)
      continue;
    double f[4];
    kernel_.derivatives(phase.view(), static_cast<int>(g), amplitudes.data(), f);
    const double noise = known_to(g, f);
    if (f[0] > noise)
      continue;
    const int order = f[0] < -noise ? 0 : rising_order(phase, g, amplitudes.data(), f);
    if (order == 0)
      return false;
    order_[g] = static_cast<unsigned char>(order);
  }
  return true;
}

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
bool ExactPath::change_friction(double time, std::size_t passed) {
  const std::vector<int> &modes = known_->linear.forms().contact_modes();
  const PhaseGuard &guard = known_->guards()[passed];
  set_modes(modes);
  Vector changed = Vector::Zero(equations_.layout().size());
  known_->phase().state(march_.turned, changed.data());
  motion::pass_guard(equations_, guard.contact, equations_.mode(guard.contact).guards[guard.guard],
                     time, changed);
  KnownPhase *const target = known_phase();
  bool rises = target != nullptr;
  if (rises) {
    exact_phases_.excitation().coordinates(time, inputs_.data());
    physical_ = changed.head(target->phase().n_modes());
    target->phase().amplitudes(physical_, inputs_.data(), first_);
    std::copy(first_.begin(), first_.end(), next_.begin());
    next_rounding_.assign(next_rounding_.size(), 0);
    const double uncertain =
        2 * std::max(time_tolerance(origin_), std::abs(march_.value / march_.slope));
    const auto known_to = [&](std::size_t g, const double *f) {
      return hidden(target->view(), g, next_.data()) + uncertain * std::abs(f[1]);
    };
    rises = begin_guards(*target, guard.contact, next_, next_rounding_, std::ref(known_to));
  }
  set_modes(modes);
  if (!rises) {
    kernel_.guard_noise(known_->view(), rounding_.data(), noise_.data());
    running_ = false;
    return false;
  }
  note_residual();
  enter(time, *target);
  return true;
}

} // namespace vibroimpact::motion
