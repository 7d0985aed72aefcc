// Where a path goes through a contact as a whole.
#include "motion/path/exact_path.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// Shorter contacts than so many times the tolerance of an instant are events at once.
constexpr double shortest = 16;

} // namespace

std::size_t ExactPath::ContactEpisodePart::bytes() const {
  std::size_t sum = contact->bytes() + (work ? work->bytes() : 0);
  for (const auto *part : {&observed, &observed_before})
    sum += *part && (*part)->outputs ? (*part)->outputs->bytes() : 0;
  return sum;
}

// What a contact that begins at a guard of the present phase is solved by; nullptr: it is left to
// others.
ExactPath::ContactEpisodePart *ExactPath::contact_beyond(std::size_t guard) {
  Transition &known = *known_->transitions[guard];
  if (!known.contact_known) {
    known.contact_known = true;
    set_modes(known_->linear.forms().contact_modes());
    std::shared_ptr<TaughtContact> &taught = known_->linear.taught(guard);
    if (!taught)
      taught = std::make_shared<TaughtContact>();
    if (auto contact = PhaseEpisode::create(equations_, known_->linear, guard, tolerance_, taught))
      known.contact =
          std::make_unique<ContactEpisodePart>(ContactEpisodePart{.contact = std::move(contact)});
  }
  return known.contact.get();
}

// Where the law cuts its force off while the sides still overlap, the phase behind the contact is
// another one than that before. nullptr: the same.
ExactPath::Transition *ExactPath::phase_behind(std::size_t passed, const PhaseEpisode &contact) {
  std::vector<int> modes = known_->linear.forms().contact_modes();
  if (contact.mode_after() == modes[contact.contact()])
    return nullptr;
  std::unique_ptr<Transition> &behind = known_->transitions[passed]->behind[contact.mode_after()];
  if (!behind) {
    modes[contact.contact()] = contact.mode_after();
    const std::vector<int> present = equations_.modes();
    set_modes(modes);
    behind = std::make_unique<Transition>(Transition{.target = known_phase(), .proportion = {}});
    set_modes(present);
  }
  static const std::vector<PhaseForms::Reset> none;
  renew(*behind, none);
  return behind.get();
}

// To the amplitudes behind the contact. False: it does not end there. One of its guards is zero
// within the error of the instant, and rises; the others are positive.
bool ExactPath::enter_behind(Transition *behind, const PhaseEpisode &contact) {
  next_rounding_.assign(next_rounding_.size(), 0);
  contact.add_rounding(next_rounding_.data());
  if (behind)
    kernel_.change(behind->change->view(), contact.after().data(), next_.data(),
                   next_rounding_.data());
  else
    std::copy(contact.after().begin(), contact.after().end(), next_.begin());
  const KnownPhase &phase = behind ? *behind->target : *known_;
  const double instant = std::max(time_tolerance(origin_), tolerance_ * contact.duration());
  bool rises = false;
  const auto known_to = [&](std::size_t g, const double *f) {
    const double noise = hidden(phase.view(), g, next_.data()) + 2 * instant * std::abs(f[1]);
    if (std::abs(f[0]) <= noise && f[1] > 0) {
      rises = true;
      counts_.event_residual = std::max(counts_.event_residual, std::abs(f[0]) / f[1]);
    }
    return noise;
  };
  return begin_guards(phase, contact.contact(), next_, next_rounding_, std::ref(known_to)) && rises;
}

// In the modes of the contact.
ExactPath::ObservedContact &ExactPath::observation_of(ContactEpisodePart &part) {
  const Observers &observers = observer_->observers;
  if (!part.observed || part.observed->observers != observers.identity())
    std::swap(part.observed, part.observed_before);
  if (!part.observed || part.observed->observers != observers.identity()) {
    Audience all{.list = observers.list()};
    all.ask(equations_);
    const bool in_steps = !observers.in_steps(equations_).list.empty();
    part.observed = std::make_unique<ObservedContact>(ObservedContact{
        .observers = observers.identity(), .all = std::move(all), .in_steps = in_steps});
  }
  return *part.observed;
}

// As one part of the motion.
void ExactPath::show_whole(ContactEpisodePart &part, ObservedContact &observed, double time) {
  const PhaseEpisode &contact = *part.contact;
  part_state_ = state_;
  if (observer_->integrals)
    part.work->add(time, state_);
  const ConstVectorView after(contact.after().data(), contact.state_rows().cols());
  state_.head(contact.state_rows().rows()).noalias() = contact.state_rows() * after;
  if (!observed.outputs) {
    observed.forms = LinearOutputs(observed.all.outputs, equations_);
    observed.outputs = std::make_unique<ContactOutputs>(observed.forms, contact, tolerance_);
  }
  observed.outputs->include();
  observed.all.show(Interval(equations_, time, part_state_, time + contact.duration(), state_));
}

void ExactPath::report_contact(ContactEpisodePart &part, double time) {
  const PhaseEpisode &contact = *part.contact;
  if (observer_->integrals && !part.work)
    part.work = std::make_unique<ContactWork>(known_->linear.powers(equations_), contact,
                                              equations_, tolerance_);
  report_change(time);
  ObservedContact &observed = observation_of(part);
  if (observed.in_steps || !ContactOutputs::possible(contact))
    counts_.steps += contact_steps_.show(
        contact, time, observer_->integrals ? part.work.get() : nullptr, state_, observed.all);
  else
    show_whole(part, observed, time);
  observer_->change(time + contact.duration(), contact.contact(), contact.release(), state_);
}

// From the touch to the end of the force, in the present phase, and into that behind. A reason: it
// is left to others; nothing has changed.
std::optional<StepReason> ExactPath::pass_contact(double time, std::size_t passed, double limit) {
  ContactEpisodePart *const part = contact_beyond(passed);
  if (!part)
    return StepReason::law;
  PhaseEpisode *const contact = part->contact.get();
  Transition *behind = nullptr;
  std::optional<StepReason> left =
      contact->pass(march_.turned, std::min(limit - time, longest_step_));
  if (!left) {
    behind = phase_behind(passed, *contact);
    if (contact->duration() <= shortest * time_tolerance(time) || !enter_behind(behind, *contact))
      left = StepReason::shallow;
  }
  if (left) {
    noise_.resize(known_->guards().size());
    order_.assign(known_->guards().size(), 0);
    kernel_.guard_noise(known_->view(), rounding_.data(), noise_.data());
    return left;
  }
  const double end = time + contact->duration();
  note_residual();
  progress_.note(contact->contact(), end, 0, time_tolerance(end));
  if (observer_)
    report_contact(*part, time);
  else
    counts_.events += 2;
  ++counts_.steps;
  ++counts_.contact_episodes;
  last_event_ = origin_ = end;
  std::swap(rounding_, next_rounding_);
  KnownPhase &next = behind ? *behind->target : *known_;
  std::copy_n(next_.begin(), next.phase().n_amplitudes(), march_.amplitudes);
  renew_inputs(next.phase(), end, march_.amplitudes);
  start_walk(next);
  begin_part(end);
  return {};
}

} // namespace vibroimpact::motion
