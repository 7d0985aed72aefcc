// Bounded nonlinear least squares by PETSc's Gauss-Newton method with regularisation (TAO, `brgn`).
//
// Of the libraries at hand it alone came to the minimum where bounds are active: NLopt has no
// method for least squares, and the projected steps of Ceres stall at a bound.
#pragma once

#include "analyses/design/nlopt_search.h"
#include "common/linear_algebra.h"

#include <functional>

namespace vibroimpact::analyses {

struct LeastSquaresProblem {
  Vector lower, upper; ///< infinite without a bound
  Vector start;
  std::function<Vector(const Vector &)> residuals; ///< always as many; may throw
  std::function<Matrix(const Vector &)> jacobian;  ///< one column for each coordinate; may throw
  Index size = 0;                                  ///< number of residuals
  double tolerance = 0;                            ///< of the coordinates
  int most_iterations = 0;
};

/// Runs until it ends, or until a function throws, which this does then.
SearchEnd least_squares(const LeastSquaresProblem &problem);

} // namespace vibroimpact::analyses
