#include "continuation/newton.h"

#include "common/decompositions.h"
#include "common/signals.h"

namespace vibroimpact::continuation {

namespace {

// With quadratic convergence |d_next| = c |d|^2 and |d| = c |d_before|^2; below a tenth of rounding
// of unknowns of size one it changes nothing.
bool next_is_rounding(double length, double before) {
  const double ratio = length / before;
  return length * ratio * ratio < 1e-17;
}

// Corrections that are only rounding, or the error of an evaluation that integrates, do not become
// smaller.
bool is_last(double length, double before, Until until, const Settings &settings) {
  constexpr double smaller = 0.5;
  const bool stalls = length <= settings.noise && length >= smaller * before;
  return length == 0 || stalls || (until == Until::tolerance && length <= settings.tolerance);
}

// Close behind a square-root graze convergence is quadratic within the depth of the touch only, so
// that what is expected is also looked at.
bool is_solved(const SquareSystem &at, const Settings &settings) {
  constexpr double evaluations = 10; // whose own error need not be corrected
  return solve_dense(at.slope, -at.residual).norm() <= evaluations * settings.tolerance;
}

} // namespace

Vector solve_dense(const Matrix &a, const Vector &b) {
  Vector x = LuFactors<Matrix>(a).solve(b);
  if (!x.allFinite())
    throw NumericalError("a matrix of the continuation is singular");
  return x;
}

Converged newton(const std::function<SquareSystem(const Vector &)> &system, Vector u,
                 double largest, const Settings &settings, Until until) {
  double before = std::numeric_limits<double>::infinity();
  const int most = settings.most_iterations + (until == Until::rounding ? 3 : 0);
  for (int iteration = 1; iteration <= most; ++iteration) {
    leave_if_stopped();
    const SquareSystem at = system(u);
    const Vector correction = solve_dense(at.slope, -at.residual);
    const double length = correction.norm();
    if (length > largest)
      throw NumericalError("Newton's method leaves the neighbourhood of its start");
    // What rounding leaves may double.
    if (length > 2 * before && length > 100 * settings.tolerance)
      throw NumericalError("Newton's method diverges");
    u += correction;
    if (is_last(length, before, until, settings))
      return {u, iteration};
    if (until == Until::tolerance && length <= settings.quadratic &&
        next_is_rounding(length, before) && is_solved(system(u), settings))
      return {u, iteration};
    before = length;
  }
  throw NumericalError("Newton's method does not converge within " + std::to_string(most) +
                       " iterations");
}

Corrected correct(const ScaledProblem &problem, const Vector &guess, double chart,
                  const Vector &normal, double largest, const Settings &settings, Until until) {
  Corrected result;
  const Index n = problem.states();
  const auto system = [&](const Vector &u) {
    result.at = problem.evaluate(u, chart);
    SquareSystem at{Vector(n + 1), Matrix(n + 1, n + 1)};
    at.residual << result.at.residual, normal.dot(u - guess);
    at.slope << result.at.slope, normal.transpose();
    return at;
  };
  const Converged converged = newton(system, guess, largest, settings, until);
  result.u = converged.u;
  result.iterations = converged.iterations;
  return result;
}

} // namespace vibroimpact::continuation
