// Newton's method for square systems, with the checks that keep it on the branch it began at.
#pragma once

#include "continuation/scaled_problem.h"
#include "continuation/settings.h"

#include <functional>

namespace vibroimpact::continuation {

struct SquareSystem {
  Vector residual;
  Matrix slope;
};

struct Converged {
  Vector u;
  int iterations = 0;
};

/// x of A x = b. NumericalError where A is singular.
Vector solve_dense(const Matrix &a, const Vector &b);

/// When Newton's method is done. To rounding where derivatives change within a short distance, as
/// behind grazes, or are tested for zeros.
enum class Until { tolerance, rounding };

/// The last call of `system` is at the result, or as close to it as the last correction.
/// NumericalError when it needs more than settings.most_iterations, a correction exceeds `largest`
/// or is twice the one before.
Converged newton(const std::function<SquareSystem(const Vector &)> &system, Vector u,
                 double largest, const Settings &settings, Until until = Until::tolerance);

/// A solution of F on a hyperplane.
struct Corrected {
  Vector u;
  Linearisation at;
  int iterations = 0;
};

/// The solution on the hyperplane through `guess` with this normal.
Corrected correct(const ScaledProblem &problem, const Vector &guess, double chart,
                  const Vector &normal, double largest, const Settings &settings,
                  Until until = Until::tolerance);

} // namespace vibroimpact::continuation
