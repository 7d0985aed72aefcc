#include "analyses/curves/first_return.h"

#include "common/error.h"

#include <string>

namespace vibroimpact::analyses {

namespace {

constexpr int looks = 100;         // within a period of the system
constexpr int periods_looked = 20; // of the system
constexpr double near = 0.05;      // of the farthest way from the start

} // namespace

double first_return(periodic::ForcedSystem &system, const Vector &state, const Vector &scale) {
  motion::Trajectory &trajectory = system.trajectory();
  trajectory.start({.time = 0, .physical = state});
  const Vector full = trajectory.state();
  Vector rates(full.size());
  system.equations().rates(0, ConstVectorView(full.data(), full.size()),
                           VectorView(rates.data(), rates.size()));
  const periodic::Plane plane = periodic::plane_across(state, rates.head(state.size()), scale);
  const double most = periods_looked * system.period();
  for (const periodic::Passage &passage : periodic::passages(
           plane, scale, 0, most, looks * periods_looked, [&](double time) -> Vector {
             trajectory.advance(time);
             return trajectory.motion_state().physical;
           }))
    if (passage.away <= near * passage.farthest)
      return passage.time;
  throw NumericalError("the motion does not come back to where it was within " +
                       std::to_string(most) +
                       " s; a longer settling or another Period may help. The period is looked for "
                       "because no active excitation changes with time");
}

} // namespace vibroimpact::analyses
