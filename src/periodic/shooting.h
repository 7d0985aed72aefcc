// A periodic motion at a fixed key: Newton's method for x = P(x).
//
//   (I - P_x) d = P(x) - x,   x <- x + lambda d
//
// lambda is halved until the residual has become smaller in proportion. Where an eighth of the step
// does not do that, the motion itself goes on for some periods, x <- P(x), and Newton's method
// begins again. The sequence ends where the step is below 1e-12 of the motion, or where it stops
// becoming smaller below 1e-7 of it: that is as exact as the motion is.
#pragma once

#include "periodic/stroboscopic_map.h"

namespace vibroimpact::periodic {

/// A fixed point of the map.
struct FixedPoint {
  Vector state;
  Flow image;
  double residual = 0; ///< largest scaled entry of P(x) - x over that of x
  long iterations = 0;
};

/// NumericalError when Newton's method does not come to an end.
FixedPoint find_fixed_point(const StroboscopicMap &map, const Section &section,
                            const Vector &start);

} // namespace vibroimpact::periodic
