#include "random_models/windowed_motion.h"

#include "analyses/steadiness.h"
#include "common/error.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::testing {

using analyses::System;
using motion::MotionState;

namespace {

// A motion that takes more steps in its window is stiff and followed by an implicit method of low
// order, whose error cannot be made as small as differences need.
constexpr long most_steps = 4000;

std::string kind_of(const motion::ContactEvent &event, const contact::ContactLaw &law) {
  const auto holds = [&](int mode) {
    return law.modes()[static_cast<std::size_t>(mode)].holds_gap;
  };
  if (event.chatter_duration > 0)
    return "chatter";
  if (event.guard->action == contact::GuardAction::impact)
    return holds(event.to)                                           ? "begin of rest"
           : event.collision && event.collision->contacts.size() > 1 ? "impact of several"
                                                                     : "impact";
  if (holds(event.from))
    return "end of rest";
  return event.guard->reset.empty() ? "change of mode" : "reset";
}

} // namespace

void EventSequence::event(const motion::ContactEvent &event) {
  list.push_back({event.contact, event.from, event.to});
  times.push_back(event.time);
  const contact::ContactPair *pair = &(*contacts)[event.contact];
  laws.insert(pair->law->name());
  kinds.insert(kind_of(event, *pair->law));
}

motion::Settings tight(const System &system) {
  motion::Settings settings = system.integration;
  settings.absolute_tolerance = 1e-17;
  settings.event_tolerance = 1e-15;
  settings.maximum_steps = most_steps;
  return settings;
}

std::optional<Vector> end_of_motion(const System &system, const MotionState &start, double end,
                                    const std::vector<EventSequence::Event> &events,
                                    double maximum_step) {
  motion::Settings settings = tight(system);
  settings.maximum_step = maximum_step;
  if (maximum_step > 0)
    settings.maximum_steps += 2 * std::lround((end - start.time) / maximum_step);
  try {
    motion::Trajectory trajectory(system.model, system.contacts, settings);
    trajectory.start(start);
    EventSequence sequence;
    sequence.contacts = &system.contacts.pairs();
    trajectory.advance(end, sequence);
    if (sequence.list != events)
      return std::nullopt;
    return trajectory.motion_state().physical;
  } catch (const InputError &) {
    return std::nullopt;
  } catch (const NumericalError &) {
    return std::nullopt;
  }
}

MotionWindow find_window(const System &system, double duration) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  EventSequence sequence;
  sequence.contacts = &system.contacts.pairs();
  trajectory.advance(duration, sequence);
  double from = 0.31 * duration;
  double to = 0.73 * duration;
  std::vector<double> times = sequence.times;
  times.erase(std::unique(times.begin(), times.end()), times.end());
  if (times.size() > 2) {
    const std::size_t first = times.size() / 4;
    const std::size_t last = std::min(first + 5, times.size() - 1);
    from = 0.5 * ((first > 0 ? times[first - 1] : 0) + times[first]);
    to = last + 1 < times.size() ? 0.5 * (times[last] + times[last + 1]) : duration;
  }
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  EventSequence nothing;
  nothing.contacts = &system.contacts.pairs();
  trajectory.advance(from, nothing);
  return {.start = trajectory.motion_state(), .end = to};
}

// A mode with a node at every point of its body moves these by rounding alone.
Vector scale_of(const System &system) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  Vector scale = analyses::state_scale(trajectory.equations(), 10);
  const Index n = trajectory.layout().n;
  for (const Index first : {Index{0}, n})
    scale.segment(first, n) =
        scale.segment(first, n).cwiseMax(1e-3 * scale.segment(first, n).maxCoeff());
  return scale;
}

} // namespace vibroimpact::testing
