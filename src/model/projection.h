// Linear observations of the motion.
#pragma once

#include "common/linear_algebra.h"

#include <vector>

namespace vibroimpact::model {

/// A linear observation of the motion: row . q + sum over sources carrier_k s_k(t). With
/// base_coefficients it is absolute, without it relative to the base.
struct Projection {
  RowVector row;                         ///< n
  std::vector<double> base_coefficients; ///< one entry per source
};

} // namespace vibroimpact::model
