// Implicit collocation at the Radau points (Radau IIA; Hairer and Wanner, Solving Ordinary
// Differential Equations II, IV.5): stiffly accurate, order 2 s - 1 with s stages.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::motion {

/// x(c_i h) = x(0) + h sum over j of coefficients(i, j) f(x(c_j h)); the last node is 1.
struct RadauMethod {
  /// stages > 1
  explicit RadauMethod(Index stages);

  Vector nodes;        ///< c
  Matrix coefficients; ///< stages squared; the last row are the weights
};

} // namespace vibroimpact::motion
