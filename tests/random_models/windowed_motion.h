// A part of a random motion, and motions beside it with the same sequence of events.
#pragma once

#include "analyses/system.h"
#include "motion/observer.h"
#include "motion/trajectory.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vibroimpact::testing {

struct EventSequence : motion::Observer {
  struct Event {
    std::size_t contact = 0;
    int from = 0, to = 0;
    bool operator==(const Event &) const = default;
  };
  void step(const motion::StepView & /*view*/) override {}
  void event(const motion::ContactEvent &event) override;

  const std::vector<contact::ContactPair> *contacts = nullptr;
  std::vector<Event> list;
  std::vector<double> times;
  std::set<std::string> laws, kinds;
};

/// As exact as the tolerance of the system and the method allow.
motion::Settings tight(const analyses::System &system);

/// The physical state at `end`; nothing where the motion fails or has other events.
/// `maximum_step` [s], 0: none.
std::optional<Vector> end_of_motion(const analyses::System &system,
                                    const motion::MotionState &start, double end,
                                    const std::vector<EventSequence::Event> &events,
                                    double maximum_step);

/// An interval of the motion with up to five events, away from them at both ends.
struct MotionWindow {
  motion::MotionState start;
  double end = 0;
};
MotionWindow find_window(const analyses::System &system, double duration);

/// Factors that make the entries of the state comparable.
Vector scale_of(const analyses::System &system);

} // namespace vibroimpact::testing
