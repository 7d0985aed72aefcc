#include "random_models/windowed_motion.h"

#include "analyses/sweeps/steadiness.h"
#include "common/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace vibroimpact::testing {

using analyses::System;
using motion::MotionState;

namespace {

using Event = EventSequence::Event;

// A motion that takes more steps in its window is stiff and followed by an implicit method of low
// order, whose error cannot be made as small as differences need.
constexpr long most_steps = 4000;
// Of the motion: events that are nearer to each other are at one instant.
constexpr double shortest_interval = 1e-10;

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

// Events at one instant.
struct Instant {
  double first = 0, last = 0;                          ///< [s]
  std::map<std::size_t, std::array<int, 3>> changes{}; ///< of each contact: from, to, impacts
};

std::vector<Instant> instants_of(const std::vector<Event> &events, double at_once) {
  std::vector<Instant> instants;
  for (const Event &event : events) {
    if (instants.empty() || event.time - instants.back().last > at_once)
      instants.push_back({.first = event.time});
    instants.back().last = event.time;
    auto &change = instants.back()
                       .changes.try_emplace(event.contact, std::array{event.from, 0, 0})
                       .first->second;
    change[1] = event.to;
    change[2] += event.from == event.to ? 1 : 0;
  }
  for (Instant &instant : instants)
    std::erase_if(instant.changes, [](const auto &entry) {
      const auto &[from, to, impacts] = entry.second;
      return from == to && impacts == 0;
    });
  return instants;
}

} // namespace

void EventSequence::event(const motion::ContactEvent &event) {
  list.push_back({event.time, event.contact, event.from, event.to});
  const contact::ContactLaw &law = *pairs_[event.contact].law;
  laws.insert(law.name());
  kinds.insert(kind_of(event, law));
}

bool same_events(const std::vector<Event> &a, const std::vector<Event> &b, double at_once) {
  const std::vector<Instant> one = instants_of(a, at_once);
  const std::vector<Instant> other = instants_of(b, at_once);
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const Instant &x, const Instant &y) { return x.changes == y.changes; });
}

motion::Settings tight(const System &system) {
  motion::Settings settings = system.integration;
  settings.absolute_tolerance = 1e-17;
  settings.event_tolerance = 1e-15;
  settings.maximum_steps = most_steps;
  return settings;
}

std::optional<Vector> end_of_motion(const System &system, const MotionWindow &window,
                                    const MotionState &start, double maximum_step) {
  motion::Settings settings = tight(system);
  settings.maximum_step = maximum_step;
  if (maximum_step > 0)
    settings.maximum_steps += 2 * std::lround((window.end - start.time) / maximum_step);
  try {
    motion::Trajectory trajectory(system.model, system.contacts, settings);
    trajectory.start(start);
    EventSequence sequence(system.contacts.pairs());
    trajectory.advance(window.end, sequence);
    if (!same_events(sequence.list, window.events, window.at_once))
      return std::nullopt;
    return trajectory.motion_state().physical;
  } catch (const InputError &) {
    return std::nullopt;
  } catch (const NumericalError &) {
    return std::nullopt;
  }
}

MotionWindow find_window(const System &system, double duration, const WindowChoice &choice) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  EventSequence sequence(system.contacts.pairs());
  trajectory.advance(duration, sequence);
  const double at_once = shortest_interval * duration;
  const std::vector<Instant> instants = instants_of(sequence.list, at_once);
  double from = (0.06 + choice.place) * duration;
  double to = from + 0.42 * choice.margin * duration;
  if (instants.size() > 2) {
    const auto first =
        static_cast<std::size_t>(choice.place * static_cast<double>(instants.size()));
    const std::size_t last = std::min(first + choice.instants, instants.size()) - 1;
    const double before = first > 0 ? instants[first - 1].last : 0;
    const double behind = last + 1 < instants.size() ? instants[last + 1].first : duration;
    const double to_next = last + 1 < instants.size() ? 0.5 : 1;
    from = instants[first].first - 0.5 * choice.margin * (instants[first].first - before);
    to = instants[last].last + to_next * choice.margin * (behind - instants[last].last);
  }
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  EventSequence unused(system.contacts.pairs());
  trajectory.advance(from, unused);
  return {.start = trajectory.motion_state(), .end = to, .at_once = at_once};
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
