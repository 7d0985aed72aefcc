// State and deviations through a part of a step that is stiff, where an explicit method would take
// steps by stability instead of accuracy.
//
//   X_i = X_0 + h sum_j a_ij F(X_j),   (1 - h A (x) J_j) D = D_0 + h A r
//
// The columns meet the same matrix as the last Newton iteration for the stages, so that they are
// the derivative of the step itself. Seven stages (order 13) go on; five (order 9) say what the
// error is.
#pragma once

#include "motion/variation/joint_rates.h"

namespace vibroimpact::motion {

/// How fast deviations change, at both known instants of an interval the slower [1/s].
struct RateScales {
  double radius = 0; ///< of the eigenvalues
  double decay = 0;  ///< of the fastest decay
};
RateScales rate_scales(const JointInterval &interval, const Equations &equations,
                       const Vector &scale);

/// Takes packed columns from s = 0 to 1; returns the integral of the divergence. `tolerance`: error
/// of a step relative to the units of the rates. NumericalError where no step is short enough.
double integrate_implicitly(JointRates &rates, double tolerance, Matrix &columns);

} // namespace vibroimpact::motion
