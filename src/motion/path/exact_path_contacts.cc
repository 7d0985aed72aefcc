// Where a path goes through a contact as a whole.
#include "motion/path/exact_path.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// Shorter contacts than so many times the tolerance of an instant are events at once.
constexpr double shortest = 16;

} // namespace

// To the amplitudes behind the contact. False: it does not end there. One of its guards is zero
// within the error of the instant, and rises; the others are positive.
bool ExactPath::enter_behind(Transition *behind, const PhaseEpisode &contact) {
  AlignedArray &rounding = guards_.next_rounding();
  double *const amplitudes = buffers_.next.data();
  rounding.assign(rounding.size(), 0);
  contact.add_rounding(rounding.data());
  if (behind)
    kernel_.change(behind->change->view(), contact.after().data(), amplitudes, rounding.data());
  else
    std::copy(contact.after().begin(), contact.after().end(), amplitudes);
  const KnownPhase &phase = behind ? *behind->target : *known_;
  const double instant = std::max(time_tolerance(origin_), limits_.tolerance * contact.duration());
  bool rises = false;
  const auto known_to = [&](std::size_t g, const double *f) {
    const double noise = guards_.hidden(phase.view(), g, amplitudes) + 2 * instant * std::abs(f[1]);
    if (std::abs(f[0]) <= noise && f[1] > 0) {
      rises = true;
      counts_.event_residual = std::max(counts_.event_residual, std::abs(f[0]) / f[1]);
    }
    return noise;
  };
  return guards_.enter(phase, contact.contact(), amplitudes, rounding, std::ref(known_to)) && rises;
}

// From the touch to the end of the force, in the present phase, and into that behind. A reason: it
// is left to others; nothing has changed.
std::optional<StepReason> ExactPath::pass_contact(double time, std::size_t passed, double limit) {
  ContactPart *const part = phases_.contact_beyond(*known_, passed, time, march_.turned);
  if (!part)
    return StepReason::law;
  PhaseEpisode *const contact = part->contact.get();
  Transition *behind = nullptr;
  std::optional<StepReason> left =
      contact->pass(march_.turned, std::min(limit - time, limits_.longest_step));
  if (!left) {
    behind = phases_.behind(*known_, passed, *contact);
    if (contact->duration() <= shortest * time_tolerance(time) || !enter_behind(behind, *contact))
      left = StepReason::shallow;
  }
  if (left) {
    guards_.stay(*known_);
    return left;
  }
  const double end = time + contact->duration();
  note_residual();
  progress_.note(contact->contact(), end, 0, time_tolerance(end));
  if (observation_.observed())
    observation_.report_contact(*part, time, passed_guard(), march_.turned);
  else
    counts_.events += 2;
  ++counts_.steps;
  ++counts_.contact_episodes;
  last_event_ = end;
  guards_.take_next_rounding();
  KnownPhase &next = behind ? *behind->target : *known_;
  std::copy_n(buffers_.next.begin(), next.phase().n_amplitudes(), march_.amplitudes);
  inputs_.renew(exact_phases_.excitation(), next.phase(), end, march_.amplitudes);
  start_walk(next, end);
  begin_part(end);
  return {};
}

} // namespace vibroimpact::motion
