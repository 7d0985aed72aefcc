// A part of a random motion, and motions beside it with the same events.
#pragma once

#include "analyses/run/system.h"
#include "motion/interval/observer.h"
#include "motion/path/trajectory.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vibroimpact::testing {

/// The contact changes of a motion; sees no steps where it is known in closed form.
class EventSequence : public motion::Observer {
public:
  struct Event {
    double time = 0;
    std::size_t contact = 0;
    int from = 0, to = 0;
  };

  explicit EventSequence(const std::vector<contact::ContactPair> &pairs) : pairs_(pairs) {}
  bool sees_steps(const motion::Equations & /*equations*/) const override { return false; }
  void event(const motion::ContactEvent &event) override;

  std::vector<Event> list;
  std::set<std::string> laws, kinds;

private:
  const std::vector<contact::ContactPair> &pairs_;
};

/// Do contacts change in the same way? Events nearer to each other than `at_once` [s] count as one,
/// by what each contact was before and is behind. Where two contacts change at one place, as
/// opposite stops without clearance do, rounding says which is the first, and whether one does so
/// once more.
bool same_events(const std::vector<EventSequence::Event> &a,
                 const std::vector<EventSequence::Event> &b, double at_once);

/// As exact as the tolerance of the system and the method allow.
motion::Settings tight(const analyses::System &system);

/// A motion from a state on, and what its neighbours must be like.
struct MotionWindow {
  motion::MotionState start;
  double end = 0;     ///< [s]
  double at_once = 0; ///< as for same_events() [s]
  std::vector<EventSequence::Event> events{};
};

/// The physical state at the end of the window; nothing where the motion fails or has other events
/// than the window. `maximum_step` [s], 0: none.
std::optional<Vector> end_of_motion(const analyses::System &system, const MotionWindow &window,
                                    const motion::MotionState &start, double maximum_step);

/// Which part of a motion.
struct WindowChoice {
  double place = 0.25;      ///< of the first event in it, among the instants of events
  std::size_t instants = 6; ///< of events, at most
  double margin = 1;        ///< part of the way to the next event before the first and behind the
                            ///< last one, or of the whole where there are none
};
/// Away from events at both ends.
MotionWindow find_window(const analyses::System &system, double duration,
                         const WindowChoice &choice);

/// Factors that make the entries of the state comparable.
Vector scale_of(const analyses::System &system);

} // namespace vibroimpact::testing
