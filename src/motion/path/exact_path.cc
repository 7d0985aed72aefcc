#include "motion/path/exact_path.h"

#include "common/error.h"
#include "common/signals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace vibroimpact::motion {

ExactPath::ExactPath(Equations &equations, ExactPhases &phases, const Settings &settings,
                     StallBound &progress, Accuracy &counts)
    : equations_(equations), exact_phases_(phases), progress_(progress), counts_(counts),
      kernel_(kernel()), limits_{.event_tolerance = settings.event_tolerance,
                                 .tolerance = settings.relative_tolerance,
                                 .longest_step = settings.maximum_step > 0
                                                     ? settings.maximum_step
                                                     : std::numeric_limits<double>::infinity()},
      phases_(equations, phases, settings.relative_tolerance),
      observation_(equations, phases, settings.relative_tolerance, counts),
      last_event_(-std::numeric_limits<double>::infinity()) {}

void ExactPath::begin() {
  known_ = nullptr;
  running_ = false;
  march_.pieces = 0;
  last_event_ = -std::numeric_limits<double>::infinity();
  exact_phases_.forget();
}

void ExactPath::Buffers::resize(std::size_t largest) {
  for (AlignedArray *buffer : {&present, &turned, &next, &origin})
    buffer->resize(std::max(buffer->size(), 2 * largest));
  for (AlignedArray *buffer : {&magnitudes, &reach})
    buffer->resize(std::max(buffer->size(), largest));
}

void ExactPath::Buffers::take_next(MarchState &march) {
  double *const before = march.amplitudes;
  march.amplitudes = next.data();
  (before == present.data() ? present : turned).swap(next);
}

void ExactPath::Inputs::take(const Excitation &excitation, double time) {
  changes = 0;
  values.resize(static_cast<std::size_t>(excitation.size()));
  excitation.coordinates(time, values.data());
}

void ExactPath::Inputs::renew(const Excitation &excitation, const ExactPhase &phase, double time,
                              double *amplitudes) {
  constexpr int carried_changes = 32;
  if (++changes <= carried_changes)
    return;
  take(excitation, time);
  const auto first = static_cast<std::size_t>(phase.n_modes());
  for (std::size_t k = 0; k < values.size(); ++k)
    amplitudes[phase.places()[first + k]] = values[k];
}

double ExactPath::time_tolerance(double time) const {
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  return std::max(limits_.event_tolerance, rounding * std::abs(time));
}

// From march_.amplitudes on.
void ExactPath::start_walk(KnownPhase &known, double time) {
  std::copy_n(march_.amplitudes, known.phase().n_amplitudes(), buffers_.origin.begin());
  march_.origin = buffers_.origin.data();
  march_.noise = guards_.noise();
  march_.order = guards_.order().data();
  march_.time = 0;
  march_.pieces_of_phase = 0;
  origin_ = time;
  known_ = &known;
  exact_phases_.enter(known.linear);
}

// The amplitudes of the state, under the sources from `time` on.
KnownPhase &ExactPath::prepare_start(double time) {
  KnownPhase &known = *phases_.present();
  inputs_.take(exact_phases_.excitation(), time);
  const auto largest = static_cast<std::size_t>(equations_.layout().physical_size()) +
                       inputs_.values.size() + group_block;
  buffers_.resize(largest);
  guards_.begin(largest);
  buffers_.physical = state().head(known.phase().n_modes());
  known.phase().amplitudes(buffers_.physical, inputs_.values.data(), buffers_.first);
  std::copy(buffers_.first.begin(), buffers_.first.end(), buffers_.present.begin());
  march_.amplitudes = buffers_.present.data();
  march_.turned = buffers_.turned.data();
  march_.magnitudes = buffers_.magnitudes.data();
  march_.reach = buffers_.reach.data();
  return known;
}

// A guard that has just been passed is zero within what its location has left. False: it falls at
// once.
bool ExactPath::start_from(double time, std::span<const ZeroGuard> zero) {
  if (!phases_.known() || !exact_phases_.take_sources(time))
    return false;
  KnownPhase &known = prepare_start(time);
  const auto was_zero = [&](std::size_t g) {
    return std::any_of(zero.begin(), zero.end(), [&](const ZeroGuard &passed) {
      return passed.contact == known.guards()[g].contact && passed.guard == known.guards()[g].guard;
    });
  };
  const auto known_to = [&](std::size_t g, const double * /*f*/) {
    return was_zero(g) ? std::numeric_limits<double>::infinity()
                       : guards_.hidden(known.view(), g, march_.amplitudes);
  };
  const auto order = [&](std::size_t g, const double *f) {
    return rising_order(known, g, march_.amplitudes, f);
  };
  if (!guards_.enter(known, {}, march_.amplitudes, guards_.rounding(), std::ref(known_to),
                     std::ref(order)))
    return false;
  for (std::size_t g = 0; g < guards_.order().size(); ++g)
    if (guards_.order()[g] > 0 && !was_zero(g))
      return false;
  start_walk(known, time);
  return true;
}

void ExactPath::begin_part(double time) {
  observation_.enter(*known_);
  if (!observation_.observed())
    return;
  const bool at_origin = !(march_.time > 0);
  observation_.begin_part(*known_, {.time = time,
                                    .amplitudes = at_origin ? march_.origin : march_.amplitudes,
                                    .stays = at_origin,
                                    .enters_phase = time == origin_});
}

// Another part of the same phase.
void ExactPath::part_the_phase(double time) {
  observation_.end_part(time, march_.amplitudes);
  begin_part(time);
}

// To the phase beyond the guard that is passed. False: one of its guards falls at once.
bool ExactPath::enter_phase(const Transition &next, std::size_t contact, double time) {
  double *const amplitudes = buffers_.next.data();
  kernel_.change(next.change->view(), march_.turned, amplitudes, guards_.next_rounding().data());
  inputs_.renew(exact_phases_.excitation(), next.target->phase(), time, amplitudes);
  note_residual();
  const double uncertain =
      2 * std::max(time_tolerance(origin_), std::abs(march_.value / march_.slope));
  const auto known_to = [&](std::size_t g, const double *f) {
    return std::max({guards_.hidden(next.target->view(), g, amplitudes), uncertain * std::abs(f[1]),
                     next.proportion.empty() ? 0 : next.proportion[g] * std::abs(march_.value)});
  };
  const auto order = [&](std::size_t g, const double *f) {
    return rising_order(*next.target, g, amplitudes, f);
  };
  return guards_.enter(*next.target, contact, amplitudes, guards_.next_rounding(),
                       std::ref(known_to), std::ref(order));
}

// The contact has changed and the motion stands in another phase, at the amplitudes `next`.
void ExactPath::enter(double time, KnownPhase &target, const FrictionRoutes::Route *route) {
  progress_.note(passed_guard().contact, time, known_->view().fastest, time_tolerance(time));
  if (observation_.observed() && route)
    observation_.report_friction(time, passed_guard(), march_.turned, *route, target.phase(),
                                 buffers_.next.data());
  else if (observation_.observed())
    observation_.report_change(time, passed_guard(), march_.turned);
  else
    ++counts_.events;
  last_event_ = time;
  guards_.take_next_rounding();
  buffers_.take_next(march_);
  start_walk(target, time);
  begin_part(time);
}

// False: the change is left to others; the motion stands before it.
bool ExactPath::change_phase(double limit, long &most_events) {
  const double time = origin_ + march_.time + march_.to_guard;
  const auto passed = static_cast<std::size_t>(march_.guard);
  if (time - last_event_ <= time_tolerance(time) || progress_.slow() || exact_phases_.crowded())
    return false;
  const FrictionRoutes::Route *route = nullptr;
  Transition *const next =
      has_plane_friction(passed_guard().contact) && !is_rigid(passed_guard().contact)
          ? phases_.friction_transition(*known_, passed, march_.turned, guards_.rounding().data(),
                                        route)
          : phases_.transition(*known_, passed);
  if (!next && !route) {
    const std::optional<StepReason> left =
        most_events > 0 ? pass_contact(time, passed, limit) : StepReason::interrupted;
    if (left)
      note_pending(*left);
    else
      --most_events;
    return !left;
  }
  if (!next || !enter_phase(*next, passed_guard().contact, time)) {
    guards_.stay(*known_);
    running_ = false;
    return false;
  }
  enter(time, *next->target, route);
  return true;
}

void ExactPath::note_pending(StepReason reason) {
  pending_ = {.contact = passed_guard().contact,
              .guard = passed_guard().guard,
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
          guards_.hidden(known_->view(), static_cast<std::size_t>(march_.guard), march_.turned))
    counts_.event_residual = residual;
}

// Where nobody observes, the equations need the modes of the last phase only.
void ExactPath::stand(double time, const double *amplitudes) {
  if (!observation_.observed())
    phases_.set_modes_of(*known_);
  observation_.end_part(time, amplitudes);
  if (!state().allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(time) + " s");
}

bool ExactPath::advance(double &time, const Vector &state, double limit, long most_events,
                        std::span<const ZeroGuard> zero, const PathObservers *observers) {
  observation_.begin(observers, state);
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
    const double until = std::min(limit, observation_.part_limit());
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
