#include "motion/variation/radau.h"

#include "common/decompositions.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

// Roots in (0, 1) of the Jacobi polynomial P^(1, 0), by its recurrence (Golub and Welsch 1969).
Vector jacobi_roots(Index degree) {
  Vector diagonal(degree);
  Vector beside(degree - 1);
  for (Index n = 0; n < degree; ++n) {
    const auto k = static_cast<double>(n);
    diagonal[n] = -1 / ((2 * k + 1) * (2 * k + 3));
    if (n > 0)
      beside[n - 1] = std::sqrt(k * (k + 1)) / (2 * k + 1);
  }
  return 0.5 * (tridiagonal_eigenvalues(diagonal, beside).array() + 1);
}

} // namespace

// The coefficients integrate polynomials of degree stages - 1 exactly.
RadauMethod::RadauMethod(Index stages) : nodes(stages) {
  nodes << jacobi_roots(stages - 1), 1.0;
  LongMatrix values(stages, stages);
  LongMatrix integrals(stages, stages);
  for (Index i = 0; i < stages; ++i)
    for (Index k = 0; k < stages; ++k) {
      const long double power = std::pow(static_cast<long double>(nodes[i]), k);
      values(i, k) = power;
      integrals(i, k) = power * nodes[i] / static_cast<long double>(k + 1);
    }
  coefficients = (integrals * extended::inverse(values)).cast<double>();
}

} // namespace vibroimpact::motion
