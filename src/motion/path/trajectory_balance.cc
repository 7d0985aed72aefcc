// The energy balance of a motion, and what is reported of its accuracy.
#include "motion/path/trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

void Trajectory::begin_balance() {
  balance_.integrals = true;
  balance_.exact = true;
  balance_.initial_state = state();
  balance_.initial_energy = equations_.stored_energy(
      time(), ConstVectorView(balance_.initial_state.data(), balance_.initial_state.size()));
}

double Trajectory::energy_threshold() const {
  constexpr double of_exact_steps = 1e-10;
  return balance_.exact ? of_exact_steps
                        : std::max(of_exact_steps, 1000 * settings_.relative_tolerance);
}

Accuracy Trajectory::accuracy() const {
  const Vector &x = steppers_.present().state();
  const double energy = equations_.stored_energy(time(), ConstVectorView(x.data(), x.size()));
  const Vector since = x - balance_.initial_state;
  double unaccounted = energy - balance_.initial_energy - since[layout().input_work()] +
                       since[layout().damping_work()];
  for (Index c = 0; c < layout().n_contacts; ++c)
    unaccounted += since[layout().contact_work(c)];
  const double turnover = balance_.initial_energy + since[layout().absolute_input_work()];
  double energy_residual = turnover > 0 ? std::abs(unaccounted) / turnover : 0;
  if (!balance_.integrals)
    energy_residual = std::numeric_limits<double>::quiet_NaN();
  Accuracy result = counts_;
  result.rejected_steps += steppers_.rejected_steps();
  result.energy_residual = energy_residual;
  result.energy_threshold = energy_threshold();
  return result;
}

} // namespace vibroimpact::motion
