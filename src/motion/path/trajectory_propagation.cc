// What a motion does without steps, and how steps take over.
#include "motion/moments/moment_path.h"
#include "motion/path/exact_path.h"
#include "motion/path/trajectory.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::motion {

// Goes on in closed form as far as that is clear. False: a step is next.
bool Trajectory::propagate(double limit, const Observers &observers) {
  if (!path_ || !equations_.model().linear() || keeps_modes())
    return false;
  if (moments_ &&
      (settings_.method == "moments" || steppers_.exact()->phases().crowded() || costs_.crowded()))
    return propagate_by_moments(limit, observers);
  double instant = time();
  const Accuracy before = counts_;
  const PathObservers path_observers{
      .observers = observers,
      .integrals = balance_.integrals,
      .change = [&](double when, std::size_t contact, std::size_t guard, Vector &changed) {
        change_mode(when, contact, guard, changed, observers);
      }};
  const long most_events = settings_.maximum_events > 0 ? settings_.maximum_events - before.events
                                                        : std::numeric_limits<long>::max();
  const bool moved = path_->advance(instant, state(), limit, most_events, zero_at_start_,
                                    observers.empty() ? nullptr : &path_observers);
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
                 observers);
  return path_->clear();
}

// Through contact changes of any number. False: a step is next.
bool Trajectory::propagate_by_moments(double limit, const Observers &observers) {
  const MomentPath::Report report{
      .observers = observers.list(),
      .show = [&](const StepView &step) { show(step); },
      .integrals = balance_.integrals,
      .change = [&](double when, std::size_t contact, std::size_t guard,
                    Vector &changed) { change_mode(when, contact, guard, changed, observers); }};
  double instant = time();
  const bool moved =
      moments_->advance(instant, state(), limit, observers.empty() ? nullptr : &report);
  balance_.exact = false;
  if (!moved)
    return false;
  steppers_.place(instant, moments_->state());
  steps_outdated_ = true;
  zero_at_start_.clear();
  path_->leave();
  return instant == limit;
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
