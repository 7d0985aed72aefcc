// Derivatives of functions by Ridders' extrapolation of central differences: independent values for
// the variation of motions.
#pragma once

#include "common/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace vibroimpact::testing {

struct NumericalDerivative {
  Vector value;
  /// Of the largest entry, relative to the largest of the value: by how much the last
  /// extrapolations differ, or what the rounding of f makes of the difference when that is more;
  /// infinite where no difference could be taken.
  double error = std::numeric_limits<double>::infinity();
};

/// Extrapolated differences of one step length: with every further one an error of order h^2 less.
struct DifferenceRow {
  double step = 0;
  std::vector<Vector> columns;
};

/// Size of the rounding of f: what single extrapolations of the shortest steps, whose errors of
/// order h^4 have died out, still differ by, times the step. The median of four.
inline double rounding_of(const std::vector<DifferenceRow> &rows) {
  std::vector<double> sizes;
  for (std::size_t i = rows.size(); i-- > 2 && sizes.size() < 4;)
    sizes.push_back(rows[i].step *
                    (rows[i].columns[1] - rows[i - 1].columns[1]).cwiseAbs().maxCoeff());
  std::sort(sizes.begin(), sizes.end());
  return sizes.empty() ? 0 : sizes[sizes.size() / 2];
}

/// Of f at 0. `f` gives nothing where it is not to be compared (another sequence of events): the
/// differences begin where it is, after `tries` halvings at most. Errors of order h^2, h^4 ... are
/// taken out one by one (Ridders 1982); the step is halved `steps` times.
inline NumericalDerivative
numerical_derivative(const std::function<std::optional<Vector>(double)> &f, double step,
                     int steps = 12, int tries = 16) {
  std::vector<DifferenceRow> rows;
  for (int taken = 0, tried = 0; taken < steps && tried < steps + tries; ++tried, step /= 2) {
    const std::optional<Vector> up = f(step);
    const std::optional<Vector> down = up ? f(-step) : std::nullopt;
    if (!up || !down) {
      rows.clear();
      continue;
    }
    ++taken;
    DifferenceRow row{.step = step, .columns = {(*up - *down) / (2 * step)}};
    for (std::size_t k = 0; !rows.empty() && k < rows.back().columns.size(); ++k)
      row.columns.push_back(row.columns[k] + (row.columns[k] - rows.back().columns[k]) /
                                                 (std::pow(4.0, static_cast<double>(k + 1)) - 1));
    rows.push_back(std::move(row));
  }
  const double rounding = rounding_of(rows);
  NumericalDerivative best;
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (std::size_t k = 1; k < rows[i].columns.size(); ++k) {
      const Vector &value = rows[i].columns[k];
      const double apart = std::max({(value - rows[i].columns[k - 1]).cwiseAbs().maxCoeff(),
                                     (value - rows[i - 1].columns[k - 1]).cwiseAbs().maxCoeff(),
                                     rounding / rows[i].step});
      const double size = value.cwiseAbs().maxCoeff();
      if (apart <= best.error * size || (size == 0 && apart == 0)) {
        best.value = value;
        best.error = size > 0 ? apart / size : 0;
      }
    }
  return best;
}

} // namespace vibroimpact::testing
