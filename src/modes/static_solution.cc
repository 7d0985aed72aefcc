#include "modes/static_solution.h"

#include <cmath>

namespace vibroimpact::modes {

namespace {

constexpr double accuracy = 1e-12; // of the error in the energy norm, relative
constexpr int most_improvements = 10;

} // namespace

Vector static_solution(const EigenProblem &problem, const Vector &load) {
  if (load.isZero(0))
    return load;
  const Layout layout(problem.stiffness);
  const Factorisation factorised(problem.stiffness, problem.mass, 0);
  const Block force = own_rows(layout, load);
  Block solution = Block::Zero(layout.own, 1);
  for (int step = 0; step <= most_improvements; ++step) {
    const Block residual = force - multiply(problem.accurate_stiffness, solution);
    const Block correction = factorised.solve(residual);
    const double error = std::abs(inner_products(layout, residual, correction)(0, 0));
    const double work = std::abs(inner_products(layout, force, solution)(0, 0));
    if (step > 0 && error <= accuracy * accuracy * work)
      return gather(layout, solution).col(0);
    solution += correction;
  }
  throw NumericalError("The static solution is lost in the round-off of the stiffness matrix");
}

} // namespace vibroimpact::modes
