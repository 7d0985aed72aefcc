// Derivatives of functions by Ridders' extrapolation of central differences: independent values for
// the variation of motions.
#pragma once

#include "common/linear_algebra.h"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace vibroimpact::testing {

struct NumericalDerivative {
  Vector value;
  /// Largest entry, relative to the largest of the value, by which the last extrapolations differ;
  /// infinite where no difference could be taken.
  double error = std::numeric_limits<double>::infinity();
};

/// Of f at 0. `f` gives nothing where it is not to be compared (another sequence of events): the
/// differences begin where it is, after `tries` halvings at most. Errors of order h^2, h^4 ... are
/// taken out one by one (Ridders 1982); the step is halved while that helps, `steps` times.
inline NumericalDerivative
numerical_derivative(const std::function<std::optional<Vector>(double)> &f, double step,
                     int steps = 12, int tries = 16) {
  NumericalDerivative best;
  std::vector<Vector> before;
  for (int taken = 0, tried = 0; taken < steps && tried < steps + tries; ++tried, step /= 2) {
    const std::optional<Vector> up = f(step);
    const std::optional<Vector> down = up ? f(-step) : std::nullopt;
    if (!up || !down) {
      before.clear();
      continue;
    }
    ++taken;
    std::vector<Vector> row = {(*up - *down) / (2 * step)};
    double factor = 4;
    for (const Vector &coarse : before) {
      row.push_back(row.back() + (row.back() - coarse) / (factor - 1));
      factor *= 4;
      const std::size_t k = row.size() - 1;
      const double apart = std::max((row[k] - row[k - 1]).cwiseAbs().maxCoeff(),
                                    (row[k] - before[k - 1]).cwiseAbs().maxCoeff());
      const double size = row[k].cwiseAbs().maxCoeff();
      if (apart <= best.error * size || (size == 0 && apart == 0)) {
        best.value = row[k];
        best.error = size > 0 ? apart / size : 0;
      }
    }
    before = row;
  }
  return best;
}

} // namespace vibroimpact::testing
