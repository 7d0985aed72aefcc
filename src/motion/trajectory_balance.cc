// The energy balance of a motion, and what is reported of its accuracy.
#include "motion/trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

void Trajectory::begin_balance() {
  integrals_ = true;
  exact_ = true;
  initial_state_ = state();
  initial_energy_ = equations_.stored_energy(
      time(), ConstVectorView(initial_state_.data(), initial_state_.size()));
}

double Trajectory::energy_threshold() const {
  constexpr double of_exact_steps = 1e-10;
  return exact_ ? of_exact_steps : std::max(of_exact_steps, 1000 * settings_.relative_tolerance);
}

Accuracy Trajectory::accuracy() const {
  const Vector &x = steppers_.present().state();
  const double energy = equations_.stored_energy(time(), ConstVectorView(x.data(), x.size()));
  const Vector since = x - initial_state_;
  double unaccounted =
      energy - initial_energy_ - since[layout().input_work()] + since[layout().damping_work()];
  for (Index c = 0; c < layout().n_contacts; ++c)
    unaccounted += since[layout().contact_work(c)];
  const double turnover = initial_energy_ + since[layout().absolute_input_work()];
  double energy_residual = turnover > 0 ? std::abs(unaccounted) / turnover : 0;
  if (!integrals_)
    energy_residual = std::numeric_limits<double>::quiet_NaN();
  return {.steps = steps_,
          .rejected_steps = steppers_.rejected_steps() - rejected_before_,
          .events = events_,
          .energy_residual = energy_residual,
          .energy_threshold = energy_threshold(),
          .event_residual = event_residual_,
          .undecided_events = undecided_,
          .chatters = chatters_,
          .whole_contacts = whole_contacts_,
          .step_reasons = step_reasons_};
}

} // namespace vibroimpact::motion
