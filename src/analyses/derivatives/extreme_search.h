// Where the extreme values of a motion lie, and between which instants it is smooth.
//
// Extreme values lie inside steps, where the quantity is flat, or at events, where it has a kink or
// a jump: of these the side counts.
#pragma once

#include "analyses/recorders/observables.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"

#include <cmath>
#include <limits>
#include <vector>

namespace vibroimpact::analyses {

/// The largest value seen of something. Nothing seen: the value is -infinity.
struct Extreme {
  enum class Place { inside, after_event, before_event };

  double value = -std::numeric_limits<double>::infinity();
  double time = 0;   ///< [s]
  double beside = 0; ///< another instant, close by in the same step [s]
  Place place = Place::inside;

  bool seen() const { return std::isfinite(value); }
};

/// Of one impact of one contact.
struct ImpactExtremes {
  Extreme force, overlap;
};

/// From one event to the next.
struct SmoothInterval {
  double start = 0, end = 0; ///< [s]
  std::vector<int> modes{};  ///< of all contacts
  bool from_break = false;   ///< of the sources, without an event
  long steps = 0;
};

class ExtremeSearch : public motion::Observer {
public:
  /// Keeps references.
  ExtremeSearch(const System &system, const std::vector<Observable> &quantities);

  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override;
  bool wants_integrals() const override { return true; }
  /// The motion ends here.
  void end(const motion::Trajectory &trajectory);

  /// Of each quantity. Of the smallest values the signs are reversed.
  std::vector<Extreme> largest, smallest;
  std::vector<Extreme> forces;                      ///< per contact
  std::vector<std::vector<ImpactExtremes>> impacts; ///< per contact, as those of the log
  std::vector<std::vector<double>> approach_speeds; ///< per contact, of all onsets [m/s]
  std::vector<double> events;                       ///< their instants, in their order [s]
  std::vector<SmoothInterval> intervals;            ///< between events and breaks of the sources
  bool breaks = false;                              ///< of the sources were passed
  motion::ImpactLog log;

private:
  void note(const std::vector<Extreme *> &extremes, const motion::StepView &view,
            const motion::Bernstein &curve) const;
  void note_contact(const motion::StepView &view, std::size_t contact);
  void settle_places();
  void take_interval(const motion::StepView &view);

  const System &system_;
  const std::vector<Observable> &quantities_;
  std::vector<ImpactExtremes> present_; ///< of the impact that lasts, per contact
  std::vector<char> complete_;          ///< its beginning was seen
  double next_break_ = 0;               ///< of the sources, in the present interval [s]
};

} // namespace vibroimpact::analyses
