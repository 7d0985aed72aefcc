// The largest normal force of a contact within a step.
#pragma once

#include "motion/interval/step_view.h"

#include <functional>

namespace vibroimpact::motion {

struct PeakForce {
  double force = 0; ///< [N]
  double tau = 0;   ///< in the step
};

/// From samples at tau in [0, 1], refined around the largest one.
PeakForce sampled_peak(const std::function<double(double tau)> &force);
PeakForce sampled_peak_force(const StepView &view, std::size_t contact);

/// Likewise, but exact where the law is affine [N].
double peak_force(const StepView &view, std::size_t contact);

} // namespace vibroimpact::motion
