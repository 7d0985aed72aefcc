// Laws fitted to the impacts of one record.
#pragma once

#include "analyses/identify_formulas.h"

#include <vector>

namespace vibroimpact::analyses {

/// The constant mu that fits mu v_c = k d_c(e) best over all impacts with a solution (least
/// squares): k sum(v_c d_c) / sum(v_c^2). NaN when there is none.
double constant_damping_factor(const std::vector<Identified> &impacts);

/// e = coefficient (v_c / speed_unit)^exponent
struct PowerFit {
  double coefficient = 0;
  double exponent = 0;
  std::size_t impacts = 0; ///< that took part
};

/// Least squares in ln e over the impacts with e > 0. NaN unless two of them differ in speed.
PowerFit fit_power(const std::vector<Identified> &impacts, double speed_unit);

} // namespace vibroimpact::analyses
