// Where a path goes through a contact as a whole.
#include "motion/exact/exact_path.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// Shorter contacts than so many times the tolerance of an instant are events at once.
constexpr double shortest = 16;

} // namespace

// What a contact that begins at a guard of the present phase is solved by; nullptr: it is left to
// others.
PhaseContact *ExactPath::contact_beyond(std::size_t guard) {
  Transition &known = *known_->transitions[guard];
  if (!known.contact_known) {
    known.contact_known = true;
    const std::vector<int> &modes = known_->linear->forms().contact_modes();
    for (std::size_t c = 0; c < modes.size(); ++c)
      equations_.set_mode(c, modes[c]);
    known.contact = PhaseContact::create(equations_, *known_->linear, guard, tolerance_);
  }
  return known.contact.get();
}

// At a release the gap is zero within the error of the instant, and rises.
bool ExactPath::parts(const PhaseContact &contact) {
  const PhaseView &view = known_->view();
  const std::vector<PhaseGuard> &guards = known_->guards();
  next_rounding_.assign(next_rounding_.size(), 0);
  contact.add_rounding(next_rounding_.data());
  kernel_.guard_noise(view, next_rounding_.data(), noise_.data());
  order_.assign(guards.size(), 0);
  const double instant = std::max(time_tolerance(origin_), tolerance_ * contact.duration());
  bool part = true;
  for (std::size_t g = 0; g < guards.size(); ++g) {
    if (guards[g].contact != contact.contact())
      continue;
    double f[4];
    kernel_.derivatives(view, static_cast<int>(g), contact.after().data(), f);
    const double noise = hidden(view, g, contact.after().data()) + 2 * instant * std::abs(f[1]);
    part = part && std::abs(f[0]) <= noise && f[1] > 0;
    tally_.event_residual = std::max(tally_.event_residual, f[1] > 0 ? std::abs(f[0]) / f[1] : 0);
    order_[g] = 1;
  }
  return part;
}

void ExactPath::report_contact(const PhaseContact &contact, double time) {
  report_change(time);
  tally_.steps_shown += contact_steps_.show(contact, time, state_, *observer_->everyone);
  observer_->change(time + contact.duration(), contact.contact(), contact.release(), state_);
}

// From touch to release in the present phase, whose guards are then those before. False: it is left
// to others; nothing has changed.
bool ExactPath::pass_contact(double time, std::size_t passed, double limit) {
  PhaseContact *const contact = contact_beyond(passed);
  if (!contact)
    return false;
  const bool solved = contact->pass(walk_.turned, std::min(limit - time, longest_step_)) &&
                      contact->duration() > shortest * time_tolerance(time) && parts(*contact);
  if (!solved) {
    kernel_.guard_noise(known_->view(), rounding_.data(), noise_.data());
    return false;
  }
  const double end = time + contact->duration();
  note_residual();
  if (observer_)
    report_contact(*contact, time);
  ++tally_.pieces;
  tally_.events += 2;
  ++tally_.whole_contacts;
  last_event_ = origin_ = end;
  std::swap(rounding_, next_rounding_);
  std::copy(contact->after().begin(), contact->after().end(), walk_.amplitudes);
  renew_inputs(known_->phase(), end, walk_.amplitudes);
  start_walk(*known_);
  begin_part(end);
  return true;
}

} // namespace vibroimpact::motion
