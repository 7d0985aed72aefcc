#include "motion/path/exact_path.h"

#include "common/error.h"
#include "common/memory.h"
#include "common/signals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace vibroimpact::motion {

namespace {

constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

// Value of a guard of the next phase for each value of the guard passed, where the two are
// proportional (up to the sign); 0 where they are not.
double proportion(const LinearRow &form, const LinearRow &passed) {
  const double constant = form.constant * form.constant;
  const double square = passed.row.squaredNorm() + passed.constant * passed.constant;
  const double product = form.row.dot(passed.row) + form.constant * passed.constant;
  const double size = form.row.squaredNorm() + constant;
  const bool parallel = product * product >= (1 - 64 * rounding_unit) * size * square;
  return parallel && square > 0 ? std::abs(product) / square : 0;
}

const contact::AffineForm &indicator(const Equations &equations, const PhaseGuard &guard) {
  const contact::ContactLaw &law = *equations.contacts().pairs()[guard.contact].law;
  const auto mode = static_cast<std::size_t>(equations.modes()[guard.contact]);
  return law.modes()[mode].guards[guard.guard].indicator;
}

} // namespace

ExactPath::ExactPath(Equations &equations, ExactPhases &phases, const Settings &settings,
                     StallBound &progress, Accuracy &counts)
    : equations_(equations), exact_phases_(phases), progress_(progress), counts_(counts),
      kernel_(kernel()), event_tolerance_(settings.event_tolerance),
      tolerance_(settings.relative_tolerance),
      longest_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()),
      contact_steps_(equations, settings.relative_tolerance),
      last_event_(-std::numeric_limits<double>::infinity()) {}

void ExactPath::begin() {
  known_ = nullptr;
  running_ = false;
  march_.pieces = 0;
  last_event_ = -std::numeric_limits<double>::infinity();
  exact_phases_.forget();
}

std::size_t ExactPath::Transition::bytes() const {
  std::size_t sum = bytes_of(proportion) + (change ? change->bytes() : 0);
  for (const auto &[mode, transition] : behind)
    sum += transition->bytes();
  return sum + (contact ? contact->bytes() : 0);
}

std::size_t ExactPath::KnownPhase::bytes() const {
  std::size_t sum = bytes_of(transitions);
  for (const auto &transition : transitions)
    sum += transition ? transition->bytes() : 0;
  for (const auto *part : {&monitored, &monitored_before})
    sum +=
        *part && (*part)->outputs ? bytes_of((*part)->forms.rows) + (*part)->outputs->bytes() : 0;
  return sum;
}

void ExactPath::KnownPhase::forget(const LinearPhase &other) {
  const auto leads_there = [&](const std::unique_ptr<Transition> &transition) {
    return transition && transition->target && &transition->target->linear == &other;
  };
  for (std::unique_ptr<Transition> &transition : transitions)
    if (leads_there(transition))
      transition.reset();
    else if (transition)
      std::erase_if(transition->behind, [&](const auto &at) { return leads_there(at.second); });
}

double ExactPath::time_tolerance(double time) const {
  return std::max(event_tolerance_, 8 * rounding_unit * std::abs(time));
}

void ExactPath::set_modes(const std::vector<int> &modes) {
  for (std::size_t c = 0; c < modes.size(); ++c)
    equations_.set_mode(c, modes[c]);
}

// Of the present modes of the equations, under the present excitation.
ExactPath::KnownPhase *ExactPath::known_phase() {
  LinearPhase *const linear = exact_phases_.present();
  return linear ? &linear->part<KnownPhase>() : nullptr;
}

// Under the present excitation.
void ExactPath::renew(Transition &transition, const std::vector<PhaseForms::Reset> &resets) {
  const long excitation = exact_phases_.excitation().generation();
  if (transition.excitation == excitation)
    return;
  transition.excitation = excitation;
  transition.target->phase().take(exact_phases_.excitation());
  if (transition.change)
    transition.change->renew();
  else
    transition.change =
        std::make_unique<ExactChange>(known_->phase(), resets, transition.target->phase());
}

// To the phase beyond a guard of the present one. None where it is left to others: impacts and rest
// are for several contacts together.
ExactPath::Transition *ExactPath::transition(std::size_t guard) {
  std::unique_ptr<Transition> &known = known_->transitions[guard];
  if (!known)
    known = std::make_unique<Transition>(find_transition(known_->guards()[guard]));
  if (!known->target)
    return nullptr;
  renew(*known, known_->linear.forms().resets(guard));
  return known.get();
}

ExactPath::Transition ExactPath::find_transition(const PhaseGuard &passed) {
  if (equations_.contacts().pairs()[passed.contact].law->rigid())
    return {};
  set_modes(known_->linear.forms().contact_modes());
  const LinearRow form = linear_row(equations_, passed.contact, indicator(equations_, passed));
  equations_.set_mode(passed.contact, passed.target);
  Transition transition{.target = known_phase(), .proportion = {}};
  if (transition.target)
    for (const PhaseGuard &other : transition.target->guards())
      transition.proportion.push_back(
          proportion(linear_row(equations_, other.contact, indicator(equations_, other)), form));
  set_modes(known_->linear.forms().contact_modes());
  return transition;
}

// What rounding may hide of a guard.
double ExactPath::hidden(const PhaseView &view, std::size_t guard, const double *amplitudes) const {
  return guard_rounding * kernel_.guard_size(view, static_cast<int>(guard), amplitudes) +
         noise_[guard];
}

// From march_.amplitudes on, in the phase known_.
void ExactPath::start_walk(KnownPhase &known) {
  std::copy_n(march_.amplitudes, known.phase().n_amplitudes(), start_.begin());
  march_.origin = start_.data();
  march_.noise = noise_.data();
  march_.order = order_.data();
  march_.time = 0;
  march_.pieces_of_phase = 0;
  known_ = &known;
  exact_phases_.enter(known.linear);
}

// A guard that has just been passed is zero within what its location has left. False: it falls at
// once.
bool ExactPath::start_from(double time, std::span<const ZeroGuard> zero) {
  if (!exact_phases_.linear() || !exact_phases_.take_sources(time))
    return false;
  KnownPhase &known = *known_phase();
  inputs_.resize(static_cast<std::size_t>(exact_phases_.excitation().size()));
  exact_phases_.excitation().coordinates(time, inputs_.data());
  const auto largest =
      static_cast<std::size_t>(equations_.layout().physical_size()) + inputs_.size() + group_block;
  for (AlignedArray *buffer :
       {&amplitudes_, &turned_, &next_, &part_copy_, &step_start_, &step_end_, &start_})
    buffer->resize(std::max(buffer->size(), 2 * largest));
  for (AlignedArray *buffer : {&magnitudes_, &reach_, &next_rounding_})
    buffer->resize(std::max(buffer->size(), largest));
  physical_ = state_.head(known.phase().n_modes());
  known.phase().amplitudes(physical_, inputs_.data(), first_);
  rounding_.assign(largest,
                   0); // it changes places with that of the next phase, which may be larger
  std::copy(first_.begin(), first_.end(), amplitudes_.begin());
  march_.amplitudes = amplitudes_.data();
  march_.turned = turned_.data();
  march_.magnitudes = magnitudes_.data();
  march_.reach = reach_.data();
  const auto was_zero = [&](std::size_t g) {
    return std::any_of(zero.begin(), zero.end(), [&](const ZeroGuard &passed) {
      return passed.contact == known.guards()[g].contact && passed.guard == known.guards()[g].guard;
    });
  };
  const auto known_to = [&](std::size_t g, const double * /*f*/) {
    return was_zero(g) ? std::numeric_limits<double>::infinity()
                       : hidden(known.view(), g, amplitudes_.data());
  };
  if (!begin_guards(known, {}, amplitudes_, rounding_, std::ref(known_to)))
    return false;
  for (std::size_t g = 0; g < order_.size(); ++g)
    if (order_[g] > 0 && !was_zero(g))
      return false;
  changes_ = 0;
  origin_ = time;
  start_walk(known);
  return true;
}

// Makes what it takes to observe a phase, the modes of the equations being its.
void ExactPath::prepare_monitoring(KnownPhase &known) {
  if (!observer_->monitor)
    return;
  const long monitor = observer_->monitor->identity();
  if (!known.monitored || known.monitored->monitor != monitor)
    std::swap(known.monitored, known.monitored_before);
  const long excitation = exact_phases_.excitation().generation();
  if (!known.monitored || known.monitored->monitor != monitor) {
    std::vector<MonitoredForm> forms;
    observer_->monitor->add_forms(equations_, forms);
    known.monitored = std::make_unique<MonitoredOutputs>(
        MonitoredOutputs{.monitor = monitor, .forms = MonitoredForms(forms)});
    if (!known.monitored->forms.ranges.empty())
      known.monitored->outputs =
          std::make_unique<ExactOutputs>(known.monitored->forms, known.phase());
  } else if (known.monitored->outputs && known.monitored->excitation != excitation) {
    known.monitored->outputs->renew();
  }
  known.monitored->excitation = excitation;
}

// A part of a phase is reported as a whole, and is not longer than its work integrals stay exact.
void ExactPath::begin_part(double time) {
  part_limit_ = std::numeric_limits<double>::infinity();
  if (!observer_)
    return;
  prepare_monitoring(*known_);
  if (observer_->integrals)
    part_limit_ = time + known_->linear.work(equations_).longest();
  part_ = start_.data();
  if (march_.time > 0) {
    std::copy_n(march_.amplitudes, known_->phase().n_amplitudes(), part_copy_.begin());
    part_ = part_copy_.data();
  }
  part_start_ = time;
  if (observer_->monitor)
    observer_->monitor->part_begins(equations_, time, state_);
}

// The modes of the equations are those of the part. Leaves its state at the end.
void ExactPath::end_part(double time, const double *amplitudes) {
  const bool part = observer_ && time > part_start_;
  if (part && observer_->steps)
    show_steps(time, amplitudes);
  else if (part && observer_->integrals)
    known_->linear.work(equations_).add(part_, amplitudes, time - part_start_, state_);
  known_->phase().state(amplitudes, state_.data());
  if (!part || !observer_->monitor)
    return;
  if (known_->monitored->outputs)
    known_->monitored->outputs->include(part_, amplitudes, time - part_start_);
  observer_->monitor->part_done(equations_, part_start_, time, state_);
}

// The part from part_start_ on as steps whose polynomials keep the tolerance, all of them from the
// amplitudes at its start. Two halves rather than a step and a sliver.
void ExactPath::show_steps(double time, const double *amplitudes) {
  ExactSegment &segment = known_->linear.segment(equations_);
  WorkIntegrals &work = known_->linear.work(equations_);
  std::copy_n(part_, known_->phase().n_amplitudes(), step_start_.begin());
  start_point_.state = state_;
  segment.fill(part_start_, step_start_.data(), start_point_);
  segment.begin(step_start_.data(), part_start_ == origin_);
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
      std::copy_n(amplitudes, known_->phase().n_amplitudes(), step_end_.begin());
    else
      kernel_.turn(known_->view(), part_, to - part_start_, step_end_.data());
    end_point_.state = start_point_.state;
    work.add(step_start_.data(), step_end_.data(), to - from, end_point_.state);
    segment.fill(to, step_end_.data(), end_point_);
    observer_->steps->step(StepView(equations_, start_point_, end_point_));
    ++counts_.steps;
    std::swap(start_point_, end_point_);
    step_start_.swap(step_end_);
  }
  state_ = start_point_.state;
}

// Another part of the same phase.
void ExactPath::part_the_phase(double time) {
  end_part(time, march_.amplitudes);
  begin_part(time);
}

// Reports a contact change, which takes the equations to the modes after it.
void ExactPath::report_change(double time) {
  const PhaseGuard &passed = known_->guards()[static_cast<std::size_t>(march_.guard)];
  end_part(time, march_.turned);
  observer_->change(time, passed.contact, passed.guard, state_);
}

// Rounding turns the inputs that are carried along from phase to phase, so that they are taken from
// their closed form again and again.
void ExactPath::renew_inputs(const ExactPhase &phase, double time, double *amplitudes) {
  constexpr int carried_changes = 32;
  if (++changes_ <= carried_changes)
    return;
  changes_ = 0;
  exact_phases_.excitation().coordinates(time, inputs_.data());
  const auto first = static_cast<std::size_t>(phase.n_modes());
  for (std::size_t k = 0; k < inputs_.size(); ++k)
    amplitudes[phase.places()[first + k]] = inputs_[k];
}

// The contact has changed and the motion stands in another phase, at the amplitudes next_.
void ExactPath::enter(double time, KnownPhase &target) {
  const auto passed = static_cast<std::size_t>(march_.guard);
  progress_.note(known_->guards()[passed].contact, time, known_->view().fastest,
                 time_tolerance(time));
  if (observer_)
    report_change(time);
  else
    ++counts_.events;
  last_event_ = origin_ = time;
  std::swap(rounding_, next_rounding_);
  double *const before = march_.amplitudes;
  march_.amplitudes = next_.data();
  (before == amplitudes_.data() ? amplitudes_ : turned_).swap(next_);
  start_walk(target);
  begin_part(time);
}

// False: the change is left to others; the motion stands before it.
bool ExactPath::change_phase(double limit, long &most_events) {
  const double time = origin_ + march_.time + march_.to_guard;
  const auto passed = static_cast<std::size_t>(march_.guard);
  if (time - last_event_ <= time_tolerance(time) || progress_.slow())
    return false;
  if (!equations_.contacts().pairs()[known_->guards()[passed].contact].tangential.empty())
    return change_friction(time, passed);
  Transition *next = transition(passed);
  if (!next) {
    const std::optional<StepReason> left =
        most_events > 0 ? pass_contact(time, passed, limit) : StepReason::interrupted;
    if (left)
      note_pending(*left);
    else
      --most_events;
    return !left;
  }
  kernel_.change(next->change->view(), march_.turned, next_.data(), next_rounding_.data());
  renew_inputs(next->target->phase(), time, next_.data());
  note_residual();
  const double uncertain =
      2 * std::max(time_tolerance(origin_), std::abs(march_.value / march_.slope));
  const auto known_to = [&](std::size_t g, const double *f) {
    return std::max({hidden(next->target->view(), g, next_.data()), uncertain * std::abs(f[1]),
                     next->proportion[g] * std::abs(march_.value)});
  };
  if (!begin_guards(*next->target, known_->guards()[passed].contact, next_, next_rounding_,
                    std::ref(known_to))) {
    kernel_.guard_noise(known_->view(), rounding_.data(), noise_.data());
    running_ = false;
    return false;
  }
  enter(time, *next->target);
  return true;
}

void ExactPath::note_pending(StepReason reason) {
  const PhaseGuard &guard = known_->guards()[static_cast<std::size_t>(march_.guard)];
  pending_ = {.contact = guard.contact,
              .guard = guard.guard,
              .residual = std::abs(march_.value),
              .rate = march_.slope,
              .reason = reason};
  note_residual();
}

// Zero where the guard is below the rounding of its own evaluation: no instant is closer.
void ExactPath::note_residual() {
  const double residual = std::abs(march_.value / march_.slope);
  if (residual > counts_.event_residual &&
      std::abs(march_.value) >
          hidden(known_->view(), static_cast<std::size_t>(march_.guard), march_.turned))
    counts_.event_residual = residual;
}

// Where nobody observes, the equations need the modes of the last phase only.
void ExactPath::stand(double time, const double *amplitudes) {
  if (!observer_)
    set_modes(known_->linear.forms().contact_modes());
  end_part(time, amplitudes);
  if (!state_.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(time) + " s");
}

bool ExactPath::advance(double &time, const Vector &state, double limit, long most_events,
                        std::span<const ZeroGuard> zero, const PathObserver *observer) {
  observer_ = observer;
  state_ = state;
  pending_.reset();
  if (!running_ && !start_from(time, zero))
    return false;
  begin_part(time);
  const double from = time;
  MarchEnd end = MarchEnd::paused;
  bool moving = true;
  while (moving) {
    const long before = march_.pieces;
    const long undecided = march_.undecided;
    const double until = std::min(limit, part_limit_);
    end = kernel_.advance(known_->view(), march_, until - origin_);
    counts_.steps += march_.pieces - before;
    counts_.undecided_events += march_.undecided - undecided;
    leave_if_stopped();
    if (end == MarchEnd::limit && until < limit)
      part_the_phase(until);
    else
      moving = end == MarchEnd::paused ||
               (end == MarchEnd::guard && most_events-- > 0 && change_phase(limit, most_events));
  }
  running_ = end == MarchEnd::limit;
  time = running_ ? limit : origin_ + march_.time + (pending_ ? march_.to_guard : 0);
  stand(time, pending_ ? march_.turned : march_.amplitudes);
  return time > from;
}

} // namespace vibroimpact::motion
