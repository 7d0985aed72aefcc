#include "modes/static_solution.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::modes {

namespace {

// Of the error in the energy norm, relative: what is aimed at, and what round-off may leave.
constexpr double wanted = 1e-11;
constexpr double accepted = 1e-8;
constexpr int most_improvements = 10;

/// Largest sqrt(error / work) of the columns with a load.
double relative(const Vector &error, const Vector &work) {
  double largest = 0;
  for (Index j = 0; j < error.size(); ++j)
    if (!(error[j] == 0 && work[j] == 0))
      largest = std::max(largest, std::sqrt(error[j] / work[j]));
  return largest;
}

} // namespace

Matrix static_solution(const EigenProblem &problem, const Matrix &loads) {
  const Layout layout(problem.stiffness);
  const Factorisation &factorised = problem.factorised_at(0);
  const Block force = own_rows(layout, loads);
  Block solution = factorised.solve(force);
  double previous = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_improvements; ++step) {
    const Block residual = force - multiply(problem.accurate_stiffness, solution);
    const Block correction = factorised.solve(residual);
    const Vector error = column_products(layout, residual, correction).cwiseAbs();
    const Vector work = column_products(layout, force, solution).cwiseAbs();
    solution += correction;
    const double largest = relative(error, work);
    if (largest <= wanted || (largest <= accepted && largest > previous / 2))
      return gather(layout, solution);
    if (!(largest < previous))
      break;
    previous = largest;
  }
  throw NumericalError("The static solution is lost in the round-off of the stiffness matrix");
}

} // namespace vibroimpact::modes
