// What a motion does without steps, and how steps take over.
#include "integration/exact/exact_path.h"
#include "integration/trajectory.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::integration {

// Goes on without steps as far as that is clear, and as all who watch can do without them. False: a
// step is next, from where the flight has led.
bool Trajectory::fly(double limit, Observer &observer) {
  if (!flight_ || keeps_modes() || (watched_ && !observer.flight_watcher()))
    return false;
  double instant = time();
  Vector state = steppers_.present().state();
  const long events_before = events_;
  const PathObserver path_observer{
      .watcher = observer.flight_watcher(),
      .change = [&](double when, std::size_t contact, std::size_t guard, Vector &changed) {
        change_mode(when, contact, guard, changed, observer);
      }};
  const long most_events = settings_.maximum_events > 0 ? settings_.maximum_events - events_
                                                        : std::numeric_limits<long>::max();
  const bool moved = flight_->advance(instant, state, limit, most_events, zero_at_start_,
                                      watched_ ? &path_observer : nullptr);
  const ExactPath::Tally tally = flight_->take_tally();
  steps_ += tally.pieces;
  events_ = events_before + tally.events;
  event_residual_ = std::max(event_residual_, tally.event_residual);
  undecided_ += tally.undecided;
  last_event_time_ = std::max(last_event_time_, flight_->last_event());
  if (!moved)
    return false;
  steppers_.place(instant, state);
  flown_ = true;
  zero_at_start_.clear();
  if (const std::optional<ExactPath::PendingChange> &pending = flight_->pending())
    change_modes({.tau = 1,
                  .contact = pending->contact,
                  .guard = pending->guard,
                  .residual = pending->residual,
                  .rate = pending->rate},
                 observer);
  return flight_->clear();
}

// A step begins where the flight has ended.
void Trajectory::take_over() {
  const Vector state = steppers_.present().state();
  begin_phase(time(), state);
  note_zero_guards(state);
}

} // namespace vibroimpact::integration
