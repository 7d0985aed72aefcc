// Bounded nonlinear least squares by the method of Levenberg and Marquardt.
//
// In the box that the bounds leave around an iterate, the step p makes |J p + r|^2 + w |p|^2 least.
// The damping w grows where a step fails or does not decrease the sum of squares, which shortens
// the step and turns it towards the gradient, and falls where the linear model has held. What the
// residuals do not depend on is not changed by the errors of the derivatives, as it is by a
// Gauss-Newton step.
#pragma once

#include "analyses/design/nlopt_search.h"
#include "common/linear_algebra.h"

#include <functional>

namespace vibroimpact::analyses {

struct LeastSquaresProblem {
  Vector lower, upper; ///< infinite without a bound
  Vector start;
  /// Always as many; NumericalError where there are none, which a shorter step avoids.
  std::function<Vector(const Vector &)> residuals;
  std::function<Matrix(const Vector &)> jacobian; ///< one column for each coordinate; may throw
  double tolerance = 0;                           ///< of the coordinates
  int most_steps = 0;                             ///< accepted or not
};

/// SearchEnd::other where steps of every length fail. Throws what the functions throw, at the
/// start NumericalError of the residuals too.
SearchEnd least_squares(const LeastSquaresProblem &problem);

} // namespace vibroimpact::analyses
