// What a motion does without steps, and how steps take over.
#include "motion/moments/moment_path.h"
#include "motion/path/change_report.h"
#include "motion/path/exact_path.h"
#include "motion/path/trajectory.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::motion {

namespace {

// Takes state and equations to what is behind. The local state before is that of motion alone, the
// same in the modes before and behind; in those that hold nothing it asks for no force.
PassedChange take_known_change(Equations &equations, const KnownChange &change,
                               const Vector &before, Vector &state) {
  const ConstVectorView seen(before.data(), before.size());
  PassedChange passed{.time = change.time,
                      .contact = change.contact,
                      .from = equations.modes()[change.contact],
                      .guard = change.guard,
                      .local = {},
                      .before = before};
  const bool held = equations.mode(change.contact).holds();
  if (!held)
    passed.local = equations.local_state(change.contact, change.time, seen);
  for (const PhaseForms::Reset &reset : change.route.resets)
    state[reset.entry] = change.behind[reset.entry];
  equations.set_mode(change.contact, change.route.mode);
  if (held)
    passed.local = equations.local_state(change.contact, change.time, seen);
  return passed;
}

} // namespace

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
      .change = [&](double when, std::size_t contact, std::size_t guard,
                    Vector &changed) { change_mode(when, contact, guard, changed, observers); },
      .known_change =
          [&](const KnownChange &change, Vector &changed) {
            before_ = changed;
            report_change(equations_, take_known_change(equations_, change, before_, changed),
                          balance_.integrals, changed, observers);
            ++counts_.events;
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
