// The largest normal force of a contact within a step.
#pragma once

#include "motion/interval/step_view.h"

namespace vibroimpact::motion {

struct PeakForce {
  double force = 0; ///< [N]
  double tau = 0;   ///< in the step
};

/// From samples, refined around the largest one.
PeakForce sampled_peak_force(const StepView &view, std::size_t contact);

/// Likewise, but exact where the law is affine [N].
double peak_force(const StepView &view, std::size_t contact);

} // namespace vibroimpact::motion
