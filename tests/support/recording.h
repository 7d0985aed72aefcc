// Recorders on motions made by hand: settle for some periods, then watch some.
#pragma once

#include "analyses/recorders/recorder.h"

#include <string>

namespace vibroimpact::testing {

class Nobody : public motion::Observer {};

/// Lets the motion settle, records `cycles` periods, and gives the state at the end.
inline motion::MotionState record(const analyses::System &system, analyses::Recorder &recorder,
                                  double period, long settling, long cycles) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  Nobody nobody;
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  trajectory.advance(static_cast<double>(settling) * period, nobody);
  recorder.begin({.start = trajectory.time(),
                  .end = static_cast<double>(settling + cycles) * period,
                  .period = period,
                  .cycles = cycles},
                 trajectory);
  for (long cycle = 1; cycle <= cycles; ++cycle) {
    trajectory.advance(static_cast<double>(settling + cycle) * period, recorder);
    recorder.period_end(cycle, trajectory);
  }
  return trajectory.motion_state();
}

/// The field of that name; std::logic_error when there is none.
inline const Field &field(const PointResult &result, const std::string &name) {
  for (const Field &field : result.fields)
    if (field.name() == name)
      return field;
  throw std::logic_error("no field " + name);
}

inline double value(const PointResult &result, const std::string &name) {
  return field(result, name).values.at(0);
}

} // namespace vibroimpact::testing
