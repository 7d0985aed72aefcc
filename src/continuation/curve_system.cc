#include "continuation/curve_system.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::continuation {

std::optional<Bound> bound_passed(const ScaledProblem &problem, const Settings &settings,
                                  const Vector &u) {
  const Range ranges[] = {settings.first_key, settings.second_key};
  for (Index unknown = problem.states(); unknown < problem.unknowns(); ++unknown) {
    const Range &range = ranges[unknown - problem.states()];
    const double scale = problem.scales()(unknown);
    if (u(unknown) < range.lower / scale)
      return Bound{unknown, range.lower / scale, false};
    if (u(unknown) > range.upper / scale)
      return Bound{unknown, range.upper / scale, true};
  }
  return std::nullopt;
}

double angle_between(const Vector &a, const Vector &b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

} // namespace vibroimpact::continuation
