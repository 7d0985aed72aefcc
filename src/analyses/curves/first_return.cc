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
  const auto returns = [](const periodic::Passage &passage) {
    return passage.away <= near * passage.farthest;
  };
  // No farther: a motion beside an unstable one leaves it.
  const std::vector<periodic::Passage> found = periodic::passages(
      plane, scale, 0, most, looks * periods_looked,
      [&](double time) -> Vector {
        trajectory.advance(time);
        return trajectory.motion_state().physical;
      },
      returns);
  if (!found.empty() && returns(found.back()))
    return found.back().time;
  throw NumericalError("the motion does not come back to where it was within " +
                       std::to_string(most) +
                       " s; a longer settling or another Period may help. The period is looked for "
                       "because no active excitation changes with time");
}

} // namespace vibroimpact::analyses
