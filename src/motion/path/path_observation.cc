#include "motion/path/path_observation.h"

#include "common/error.h"
#include "common/signals.h"

#include <algorithm>
#include <limits>
#include <string>

namespace vibroimpact::motion {

PathObservation::PathObservation(const Equations &equations, const ExactPhases &phases,
                                 double tolerance, Accuracy &counts)
    : equations_(equations), phases_(phases), tolerance_(tolerance), counts_(counts),
      contact_steps_(equations, tolerance) {}

void PathObservation::begin(const PathObservers *observers, const Vector &state) {
  observers_ = observers;
  state_ = state;
}

// Made for the present modes of the equations, which are those of the phase.
ObservedPhase &PathObservation::observation_of(KnownPhase &phase) const {
  const Observers &observers = observers_->observers;
  const long excitation = phases_.excitation().generation();
  ObservedPhase *known = phase.observed.find(observers);
  if (!known) {
    phase.observed.present =
        std::make_unique<ObservedPhase>(ObservedPhase{.observers = observers.identity(),
                                                      .in_steps = observers.in_steps(equations_),
                                                      .as_whole = observers.as_whole(equations_)});
    known = phase.observed.present.get();
    known->forms = LinearOutputs(known->as_whole.outputs, equations_);
    if (!known->forms.ranges.empty())
      known->outputs = std::make_unique<ExactOutputs>(known->forms, phase.phase());
  } else if (known->outputs && known->excitation != excitation) {
    known->outputs->renew();
  }
  known->excitation = excitation;
  return *known;
}

// A part of a phase is reported as a whole, and is not longer than its work integrals stay exact.
void PathObservation::begin_part(KnownPhase &phase, const Start &start) {
  part_limit_ = std::numeric_limits<double>::infinity();
  observed_ = &observation_of(phase);
  if (observers_->integrals)
    part_limit_ = start.time + phase.linear.work(equations_).longest();
  start_ = start;
  start_state_ = state_;
  if (start.stays)
    return;
  start_copy_.assign(start.amplitudes, start.amplitudes + phase.phase().n_amplitudes());
  start_.amplitudes = start_copy_.data();
}

void PathObservation::end_part(double time, const double *amplitudes) {
  const bool part = observers_ && time > start_.time;
  if (part && !observed_->in_steps.list.empty())
    show_steps(time, amplitudes);
  else if (part && observers_->integrals)
    phase_->linear.work(equations_).add(start_.amplitudes, amplitudes, time - start_.time, state_);
  phase_->phase().state(amplitudes, state_.data());
  if (!part)
    return;
  if (observed_->outputs)
    observed_->outputs->include(start_.amplitudes, amplitudes, time - start_.time);
  observed_->as_whole.show(Interval(equations_, start_.time, start_state_, time, state_));
}

// The part as steps whose polynomials keep the tolerance, all of them from the amplitudes at its
// start. Two halves rather than a step and a sliver.
void PathObservation::show_steps(double time, const double *amplitudes) {
  ExactSegment &segment = phase_->linear.segment(equations_);
  WorkIntegrals &work = phase_->linear.work(equations_);
  const std::size_t size = phase_->phase().n_amplitudes();
  step_start_.assign(start_.amplitudes, start_.amplitudes + size);
  step_end_.resize(step_start_.size());
  start_point_.state = state_;
  segment.fill(start_.time, step_start_.data(), start_point_);
  segment.begin(step_start_.data(), start_.enters_phase);
  while (start_point_.time < time) {
    leave_if_stopped();
    const double from = start_point_.time;
    const double wanted = segment.step(step_start_.data());
    const double rest = time - from;
    if (!(from + wanted > from))
      throw NumericalError("the motion is too fast for any step, at t = " + std::to_string(from) +
                           " s");
    const bool last = rest <= wanted * (1 + 1e-9);
    const double to = last ? time : from + (rest < 2 * wanted ? 0.5 * rest : wanted);
    if (last)
      std::copy_n(amplitudes, size, step_end_.begin());
    else
      kernel().turn(phase_->view(), start_.amplitudes, to - start_.time, step_end_.data());
    end_point_.state = start_point_.state;
    work.add(step_start_.data(), step_end_.data(), to - from, end_point_.state);
    segment.fill(to, step_end_.data(), end_point_);
    observed_->in_steps.show(StepView(equations_, start_point_, end_point_));
    ++counts_.steps;
    std::swap(start_point_, end_point_);
    step_start_.swap(step_end_);
  }
  state_ = start_point_.state;
}

void PathObservation::report_change(double time, const PhaseGuard &passed,
                                    const double *amplitudes) {
  end_part(time, amplitudes);
  observers_->change(time, passed.contact, passed.guard, state_);
}

void PathObservation::report_friction(double time, const PhaseGuard &passed,
                                      const double *amplitudes, const FrictionRoutes::Route &route,
                                      const ExactPhase &next, const double *behind) {
  end_part(time, amplitudes);
  behind_.resize(next.n_modes());
  if (!route.resets.empty())
    next.state(behind, behind_.data());
  observers_->known_change({.time = time,
                            .contact = passed.contact,
                            .guard = passed.guard,
                            .route = route,
                            .behind = behind_},
                           state_);
}

// In the modes of the contact.
ObservedContact &PathObservation::observation_of(ContactPart &part) const {
  const Observers &observers = observers_->observers;
  if (ObservedContact *const known = part.observed.find(observers))
    return *known;
  Audience all{.list = observers.list()};
  all.ask(equations_);
  const bool in_steps = !observers.in_steps(equations_).list.empty();
  part.observed.present = std::make_unique<ObservedContact>(ObservedContact{
      .observers = observers.identity(), .all = std::move(all), .in_steps = in_steps});
  return *part.observed.present;
}

// As one part of the motion.
void PathObservation::show_whole(ContactPart &part, ObservedContact &observed, double time) {
  const PhaseEpisode &contact = *part.contact;
  start_state_ = state_;
  if (observers_->integrals)
    part.work->add(time, state_);
  const ConstVectorView after(contact.after().data(), contact.state_rows().cols());
  state_.head(contact.state_rows().rows()).noalias() = contact.state_rows() * after;
  if (!observed.outputs) {
    observed.forms = LinearOutputs(observed.all.outputs, equations_);
    observed.outputs = std::make_unique<ContactOutputs>(observed.forms, contact, tolerance_);
  }
  observed.outputs->include();
  observed.all.show(Interval(equations_, time, start_state_, time + contact.duration(), state_));
}

void PathObservation::report_contact(ContactPart &part, double time, const PhaseGuard &passed,
                                     const double *amplitudes) {
  const PhaseEpisode &contact = *part.contact;
  if (observers_->integrals && !part.work)
    part.work = std::make_unique<ContactWork>(phase_->linear.powers(equations_), contact,
                                              equations_, tolerance_);
  report_change(time, passed, amplitudes);
  ObservedContact &observed = observation_of(part);
  if (observed.in_steps || !ContactOutputs::possible(contact))
    counts_.steps += contact_steps_.show(
        contact, time, observers_->integrals ? part.work.get() : nullptr, state_, observed.all);
  else
    show_whole(part, observed, time);
  observers_->change(time + contact.duration(), contact.contact(), contact.release(), state_);
}

} // namespace vibroimpact::motion
