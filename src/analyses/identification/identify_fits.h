// Laws fitted to the impacts of one record.
#pragma once

#include "analyses/identification/identify_formulas.h"

#include <vector>

namespace vibroimpact::analyses {

/// The constant mu that fits mu v_c = k d_c(e) best over all impacts with a solution (least
/// squares): k sum(v_c d_c) / sum(v_c^2). NaN when there is none.
double constant_damping_factor(const std::vector<Identified> &impacts);

/// e = coefficient (v_c / speed_unit)^exponent
struct PowerFit {
  double coefficient = 0;
  double exponent = 0;
  Interval coefficient_interval{}; ///< of 95 %; NaN with less than three impacts
  Interval exponent_interval{};
  std::size_t impacts = 0; ///< that took part
};

/// Least squares in ln e over the impacts with e > 0. NaN unless two of them differ in speed. With
/// N impacts, the factors X = [1, ln(v_c / speed_unit)] and s^2 = sum of squares / (N - 2) the
/// covariance of (ln a, b) is s^2 (X'X)^-1, the intervals those of Student's distribution.
PowerFit fit_power(const std::vector<Identified> &impacts, double speed_unit);

} // namespace vibroimpact::analyses
