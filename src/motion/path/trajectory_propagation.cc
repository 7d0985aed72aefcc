// What a motion does without steps, and how steps take over.
#include "motion/moments/moment_path.h"
#include "motion/path/exact_path.h"
#include "motion/path/trajectory.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::motion {

// Goes on in closed form as far as that is clear. False: a step is next.
bool Trajectory::propagate_by_moments(double limit, const PathObserver *observer) {
  double instant = time();
  const bool moved = moments_->advance(instant, state(), limit, observer);
  balance_.exact = false;
  if (!moved)
    return false;
  steppers_.place(instant, moments_->state());
  steps_outdated_ = true;
  zero_at_start_.clear();
  path_->leave();
  return instant == limit;
}

bool Trajectory::propagate(double limit, Observer &observer) {
  if (!path_ || keeps_modes())
    return false;
  double instant = time();
  const Accuracy before = counts_;
  const PathObserver path_observer{
      .monitor = observer.output_monitor(),
      .steps = observer.step_observer(),
      .everyone = &observer,
      .integrals = balance_.integrals,
      .change = [&](double when, std::size_t contact, std::size_t guard, Vector &changed) {
        change_mode(when, contact, guard, changed, observer);
      }};
  const bool observed = path_observer.monitor || path_observer.steps;
  if (moments_ && (settings_.method == "moments" || steppers_.exact()->phases().crowded()))
    return propagate_by_moments(limit, observed ? &path_observer : nullptr);
  const long most_events = settings_.maximum_events > 0 ? settings_.maximum_events - before.events
                                                        : std::numeric_limits<long>::max();
  const bool moved = path_->advance(instant, state(), limit, most_events, zero_at_start_,
                                    observed ? &path_observer : nullptr);
  balance_.exact = balance_.exact && counts_.contact_episodes == before.contact_episodes;
  if (counts_.events > before.events)
    note_path_events();
  if (!moved)
    return false;
  steppers_.place(instant, path_->state());
  steps_outdated_ = true;
  zero_at_start_.clear();
  if (const std::optional<ExactPath::PendingChange> &pending = path_->pending())
    change_modes({.tau = 1,
                  .contact = pending->contact,
                  .guard = pending->guard,
                  .residual = pending->residual,
                  .rate = pending->rate,
                  .reason = pending->reason},
                 observer);
  return path_->clear();
}

// What is known of an earlier instant says nothing of this one.
void Trajectory::note_path_events() {
  if (path_->last_event() - last_.time > time_tolerance())
    last_ = {};
  last_.time = path_->last_event();
}

// A step begins where the closed form has led.
void Trajectory::take_over() {
  const Vector state = steppers_.present().state();
  scales_.note(time(), state, true);
  begin_phase(time(), state);
  note_zero_guards(state);
}

} // namespace vibroimpact::motion
