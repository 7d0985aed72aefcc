#include "reduction/known_flexibility.h"

#include <limits>

namespace vibroimpact::reduction {

bool has_modes(const ReducedBody &body) { return body.modal() || body.type == "modes"; }

double flexibility_along(const BodyPoint &point, const Vector3 &direction) {
  if (point.flexibility.size() == 0)
    return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (direction[i] != 0 && direction[j] != 0) // nothing need be known of the other axes
        sum += direction[i] * point.flexibility(i, j) * direction[j];
  return sum;
}

double kept_flexibility(const ReducedBody &body, const RowVector &row) {
  double sum = 0;
  for (Index j = 0; j < body.size(); ++j)
    if (body.stiffness[j] > 0)
      sum += row[j] * row[j] / body.stiffness[j];
  return sum;
}

} // namespace vibroimpact::reduction
