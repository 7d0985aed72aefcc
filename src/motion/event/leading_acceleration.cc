#include "motion/event/leading_acceleration.h"

#include <cmath>

namespace vibroimpact::motion {

double present_acceleration(const Equations &equations, std::size_t contact, double time,
                            const Vector &state, int direction) {
  const StateLayout &layout = equations.layout();
  Vector rates(state.size());
  equations.rates(time, ConstVectorView(state.data(), state.size()),
                  VectorView(rates.data(), rates.size()));
  return equations.gap_acceleration(contact, time, ConstVectorView(state.data(), state.size()),
                                    ConstVectorView(rates.data() + layout.velocity(), layout.n),
                                    direction);
}

double leading_acceleration(const Equations &equations, std::size_t contact, double time,
                            const Vector &state, int direction) {
  const double now = present_acceleration(equations, contact, time, state, direction);
  if (std::abs(now) > equations.acceleration_rounding(contact, time, state, direction))
    return now;
  constexpr double part_of_time_scale = 1e-3;
  // Where nothing oscillates, a second is as good as any scale.
  const double highest = equations.model().highest_frequency();
  const double step = part_of_time_scale / (highest > 0 ? highest : 1);
  const auto rates = [&](double after, const Vector &x) {
    Vector dxdt(x.size());
    equations.rates(time + after, ConstVectorView(x.data(), x.size()),
                    VectorView(dxdt.data(), dxdt.size()));
    return dxdt;
  };
  const Vector k1 = rates(0, state);
  const Vector k2 = rates(step / 2, state + step / 2 * k1);
  const Vector k3 = rates(step / 2, state + step / 2 * k2);
  const Vector k4 = rates(step, state + step * k3);
  const Vector later = state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  const double then = present_acceleration(equations, contact, time + step, later, direction);
  const double rounding = equations.acceleration_rounding(contact, time + step, later, direction);
  return std::abs(then) > rounding ? then : 0;
}

} // namespace vibroimpact::motion
