// What data say of keys near the best fit: standard errors, correlations, and which combinations of
// keys they determine or leave free.
#pragma once

#include "common/linear_algebra.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct FitStatistics {
  double residual_variance = 0; ///< sum of squares over degrees of freedom
  Vector standard_error; ///< in the keys' units; infinite where the data leave a key free, NaN
                         ///< where it is fixed by a bound
  Vector half_width;     ///< of the interval of 95 %
  Matrix correlation;    ///< NaN where one of the two is fixed by a bound
  /// Of the Jacobian by relative changes of all keys, the largest first.
  Vector singular_value;
  Matrix direction; ///< row k: the combination of relative changes of singular value k
  /// Standard error of each combination, relative; at most `free_error` where it is determined.
  Vector direction_error;
};

/// A combination whose relative error is beyond this is free.
constexpr double free_error = 1;

/// `jacobian`: of the residuals by the keys in their units; `sizes`: of the keys, for relative
/// changes; `fixed`: keys that are at a bound; `known_variance`: whether residuals are counted in
/// the standard deviations of the data, so that theirs is one.
FitStatistics fit_statistics(const Vector &residuals, const Matrix &jacobian, const Vector &sizes,
                             const std::vector<bool> &fixed, bool known_variance);

/// "determined to 0.1 %: k; to 4 %: m, c as 1 : -0.3. Free: ..." in the names of the keys.
std::string combinations_in_words(const FitStatistics &statistics,
                                  const std::vector<std::string> &names);

} // namespace vibroimpact::analyses
