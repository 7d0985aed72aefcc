#include "integration/trajectory.h"

#include "common/error.h"
#include "integration/unwatched_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact {

namespace {

// Contact changes in a row without any progress in time; more than the contacts' modes together
// could need means that none of them holds.
constexpr long maximum_events_at_once = 100;

const Guard &guard_of(const Equations &equations, std::size_t contact, std::size_t guard) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  return pair.law->modes()[static_cast<std::size_t>(equations.modes()[contact])].guards[guard];
}

std::size_t guard_count(const Equations &equations, std::size_t contact) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  return pair.law->modes()[static_cast<std::size_t>(equations.modes()[contact])].guards.size();
}

// |factor| for which form = factor * other; 0 when there is none.
double proportion(const AffineForm &form, const AffineForm &other) {
  const auto coefficients = [](const AffineForm &from, std::size_t n_internal) {
    std::vector<double> list = {from.constant, from.gap, from.gap_rate};
    list.insert(list.end(), from.internal.begin(), from.internal.end());
    list.resize(3 + n_internal, 0.0);
    return list;
  };
  const std::size_t n_internal = std::max(form.internal.size(), other.internal.size());
  const std::vector<double> a = coefficients(form, n_internal);
  const std::vector<double> b = coefficients(other, n_internal);
  double factor = 0;
  for (std::size_t i = 0; i < a.size() && factor == 0; ++i)
    factor = b[i] != 0 ? a[i] / b[i] : 0;
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - factor * b[i]) > rounding * std::abs(a[i]))
      return 0;
  return std::abs(factor);
}

} // namespace

Trajectory::Trajectory(const Model &model, const ContactSet &contacts,
                       const IntegrationSettings &settings)
    : settings_(settings), equations_(model, contacts), steppers_(equations_, settings) {
  if (steppers_.flight())
    flight_ = std::make_unique<UnwatchedFlight>(equations_, *steppers_.flight(),
                                                settings.event_tolerance);
}

Trajectory::~Trajectory() = default;

double Trajectory::time_tolerance() const {
  return std::max(settings_.event_tolerance, 8 * std::numeric_limits<double>::epsilon() *
                                                 std::abs(steppers_.present().time()));
}

void Trajectory::begin_phase(double time, const Vector &state) {
  equations_.set_source_break(equations_.model().next_break(time));
  steppers_.restart(time, state);
  flown_ = false;
  if (flight_)
    flight_->leave();
}

void Trajectory::refuse_penetration(double time, const Vector &state) const {
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const ContactPair &pair = equations_.contacts().pairs()[c];
    const LocalState local =
        equations_.local_state(c, time, ConstVectorView(state.data(), state.size()));
    if (local.gap < -settings_.absolute_tolerance && !pair.accept_initial_penetration)
      throw InputError(pair.origin + "\n  the motion starts with the two sides overlapping by " +
                       std::to_string(-local.gap * 1e3) +
                       " mm; change the initial condition or the clearance, or allow it with "
                       "Initial penetration = accept.");
  }
}

void Trajectory::choose_initial_modes(double time, const Vector &state) {
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const ConstVectorView x(state.data(), state.size());
    equations_.set_mode(
        c, equations_.contacts().pairs()[c].law->initial_mode(equations_.local_state(c, time, x)));
  }
}

// Contacts that are closed from the start take the internal states with which they would have been
// entered.
void Trajectory::enter_contacts(double time, Vector &state) const {
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const ContactPair &pair = equations_.contacts().pairs()[c];
    const LocalState local =
        equations_.local_state(c, time, ConstVectorView(state.data(), state.size()));
    const std::vector<double> entered = settle(*pair.law, local).internal;
    std::copy(entered.begin(), entered.end(),
              state.data() + layout().internal() + pair.internal_offset);
  }
}

void Trajectory::start(double time, const Vector &displacement, const Vector &velocity) {
  equations_.set_source_break(equations_.model().next_break(time));
  MotionState from{.time = time, .physical = Vector::Zero(layout().physical_size())};
  from.physical.head(layout().n) = displacement;
  from.physical.segment(layout().velocity(), layout().n) = velocity;
  from.physical.segment(layout().internal(), layout().n_internal) =
      equations_.contacts().initial_internal();
  from.physical.tail(layout().n_drive) = equations_.model().rotors().initial_drive();
  Vector state = Vector::Zero(layout().size());
  state.head(layout().physical_size()) = from.physical;
  refuse_penetration(time, state);
  enter_contacts(time, state);
  from.physical = state.head(layout().physical_size());
  start(from);
}

void Trajectory::start(const MotionState &from) {
  equations_.set_source_break(equations_.model().next_break(from.time));
  Vector state = Vector::Zero(layout().size());
  state.head(layout().physical_size()) = from.physical;
  choose_initial_modes(from.time, state);
  steps_ = events_ = events_at_once_ = 0;
  if (flight_)
    flight_->forget();
  steppers_.forget(); // so that a case does not depend on what was integrated before it
  rejected_before_ = steppers_.rejected_steps();
  event_residual_ = 0;
  last_event_time_ = -std::numeric_limits<double>::infinity();
  zero_at_start_.clear();
  begin_phase(from.time, state);
  begin_balance();
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c)
    note_zero_guards({.contact = c}, {}, state);
}

MotionState Trajectory::motion_state() const {
  return {.time = time(), .physical = state().head(layout().physical_size())};
}

StepView Trajectory::view() const {
  return {equations_, steppers_.present().start_point(), steppers_.present().end_point()};
}

// A guard that was zero when its mode began counts from there, without the remainder that the
// location of that instant has left; otherwise a short first step would see the remainder as a
// change of its own.
Bernstein Trajectory::indicator(const StepView &view, std::size_t contact,
                                std::size_t guard) const {
  Bernstein curve = view.indicator(contact, guard_of(equations_, contact, guard).indicator);
  for (const ZeroGuard &zero : zero_at_start_)
    if (zero.contact == contact && zero.guard == guard) {
      curve += zero.remainder;
      curve.clear_start(negligible(guard_of(equations_, contact, guard).indicator));
    }
  return curve;
}

// Error of an indicator that the absolute tolerance of the integration allows.
double Trajectory::negligible(const AffineForm &form) const {
  const double highest = std::max(1.0, equations_.model().highest_frequency());
  double sum = std::abs(form.gap) + std::abs(form.gap_rate) * highest;
  for (const double coefficient : form.internal)
    sum += std::abs(coefficient);
  return settings_.absolute_tolerance * sum;
}

void Trajectory::forget_grown_guards() {
  const StepView step = view();
  std::erase_if(zero_at_start_, [&](const ZeroGuard &zero) {
    const AffineForm &form = guard_of(equations_, zero.contact, zero.guard).indicator;
    return step.indicator(zero.contact, form).end() > negligible(form);
  });
}

bool Trajectory::find_crossing(const StepView &view, Crossing &crossing) const {
  bool found = false;
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c)
    for (std::size_t g = 0; g < guard_count(equations_, c); ++g) {
      const std::optional<double> tau = indicator(view, c, g).first_fall();
      if (tau && (!found || *tau < crossing.tau)) {
        crossing = {.tau = *tau, .contact = c, .guard = g};
        found = true;
      }
    }
  return found;
}

// How far the end of the step may be from the true instant: |indicator / its rate| there. Zero
// where the indicator is below the rounding of its own evaluation: near grazing no instant is
// closer. A guard that was zero when its mode began is taken without the remainder of that, as it
// was when the crossing was found.
double Trajectory::event_uncertainty(const StepView &view, Crossing &crossing) const {
  const AffineForm &form = guard_of(equations_, crossing.contact, crossing.guard).indicator;
  const Bernstein plain = view.indicator(crossing.contact, form);
  crossing.residual = std::abs(plain.end());
  crossing.rate = plain.derivative().end() / view.length();
  const double distance = std::abs(indicator(view, crossing.contact, crossing.guard).end());
  if (distance <= equations_.rounding(crossing.contact, form, view.end_state()))
    return 0;
  return std::abs(distance / crossing.rate);
}

// Shortens the step until it ends at the first crossing. False: the crossing was an artefact of the
// longer step's polynomial, and the step as it now stands is free of changes.
bool Trajectory::locate(Crossing &crossing) {
  constexpr int maximum_corrections = 60;
  const double limit = steppers_.present().time(); // up to here the step is good
  int extensions = 0;
  for (int i = 0; i < maximum_corrections; ++i) {
    const double start = steppers_.present().previous_time();
    const double instant = start + crossing.tau * (steppers_.present().time() - start);
    if (instant - start <= time_tolerance()) {
      const Bernstein indicator = view().indicator(
          crossing.contact, guard_of(equations_, crossing.contact, crossing.guard).indicator);
      crossing.residual = std::abs(indicator.start());
      crossing.rate =
          std::abs(indicator.derivative().start() / (steppers_.present().time() - start));
      steppers_.present().undo();
      return true;
    }
    if (instant != steppers_.present().time())
      steppers_.present().shorten(instant);
    const StepView shorter = view();
    Crossing earlier = crossing;
    const bool inside = find_crossing(shorter, earlier);
    Crossing &candidate = inside ? earlier : crossing;
    const double uncertainty = event_uncertainty(shorter, candidate);
    const bool at_end = !inside || (1 - earlier.tau) * shorter.length() <= time_tolerance();
    if (at_end && uncertainty <= time_tolerance()) {
      event_residual_ = std::max(event_residual_, uncertainty);
      crossing = candidate;
      return true;
    }
    const double ahead = steppers_.present().time() + uncertainty;
    if (!inside && (++extensions > 2 || !(candidate.rate < 0 && ahead <= limit)))
      return false; // not there yet: the next step will meet it
    crossing = candidate;
    if (!inside)
      crossing.tau = 1 + uncertainty / shorter.length();
  }
  throw NumericalError("a contact change near t = " + std::to_string(steppers_.present().time()) +
                       " s could not be located to the event tolerance");
}

void Trajectory::change_mode(std::size_t contact, std::size_t guard, Vector &state,
                             Observer &observer) {
  const Guard &passed = guard_of(equations_, contact, guard);
  const ContactPair &pair = equations_.contacts().pairs()[contact];
  const LocalState local =
      equations_.local_state(contact, time(), ConstVectorView(state.data(), state.size()));
  const Vector before = state;
  ContactEvent event{.time = time(),
                     .contact = contact,
                     .from = equations_.modes()[contact],
                     .to = passed.target,
                     .gap = local.gap,
                     .gap_rate = local.gap_rate,
                     .state = &state,
                     .before = &before,
                     .guard = &passed,
                     .layout = &layout()};
  const double held = equations_.contact_energy(contact, event.from, local);
  std::vector<double> fresh;
  for (const AffineForm &form : passed.reset)
    fresh.push_back(form(local));
  for (std::size_t i = 0; i < fresh.size(); ++i)
    state[layout().internal() + pair.internal_offset + static_cast<Index>(i)] = fresh[i];
  equations_.set_mode(contact, passed.target);
  // What the new mode holds no more is lost at this instant; `local` sees the new internal states.
  state[layout().contact_work(static_cast<Index>(contact))] +=
      held - equations_.contact_energy(contact, event.to, local);
  observer.event(event);
  ++events_;
}

// Several contacts may change at the same instant; each guard that is zero there starts the new
// phase from an exact zero, so that rounding cannot fire it again.
void Trajectory::change_modes(const Crossing &first, Observer &observer) {
  const bool stuck = time() - last_event_time_ <= time_tolerance();
  events_at_once_ = stuck ? events_at_once_ + 1 : 0;
  if (events_at_once_ > maximum_events_at_once)
    throw NumericalError("contact changes follow each other without progress at t = " +
                         std::to_string(time()) + " s");
  if (settings_.maximum_events > 0 && events_ >= settings_.maximum_events)
    throw NumericalError("more than " + std::to_string(settings_.maximum_events) +
                         " contact changes (Maximum events)");
  last_event_time_ = time();
  Vector state = steppers_.present().state();
  // A copy: the mode it belongs to is about to be left.
  const AffineForm passed = guard_of(equations_, first.contact, first.guard).indicator;
  change_mode(first.contact, first.guard, state, observer);
  begin_phase(time(), state);
  std::erase_if(zero_at_start_,
                [&](const ZeroGuard &zero) { return zero.contact == first.contact; });
  note_zero_guards(first, passed, state);
}

// What was left of the guard that was passed is left of the guard back as well, and must not be
// seen as a change of its own. The guard back often is its negative. Where it is another
// expression, in other units, the time that the remainder stands for is the same.
void Trajectory::note_zero_guards(const Crossing &crossing, const AffineForm &passed,
                                  const Vector &state) {
  const std::size_t contact = crossing.contact;
  Vector rates_at_start(state.size());
  equations_.rates(time(), ConstVectorView(state.data(), state.size()),
                   VectorView(rates_at_start.data(), rates_at_start.size()));
  const double delay = crossing.rate != 0 ? crossing.residual / std::abs(crossing.rate) : 0;
  const LocalState local =
      equations_.local_state(contact, time(), ConstVectorView(state.data(), state.size()));
  // The rate of an affine form is the form of the rates.
  const LocalState rates{
      .gap = local.gap_rate,
      .gap_rate = equations_.gap_acceleration(
          contact, time(),
          ConstVectorView(rates_at_start.data() + layout().velocity(), layout().n)),
      .internal = {rates_at_start.data() + layout().internal() +
                       equations_.contacts().pairs()[contact].internal_offset,
                   local.internal.size()}};
  for (std::size_t g = 0; g < guard_count(equations_, contact); ++g) {
    const AffineForm &form = guard_of(equations_, contact, g).indicator;
    const double rate = form(rates) - form.constant;
    const double noise = std::max({2 * std::max(time_tolerance(), delay) * std::abs(rate),
                                   proportion(form, passed) * crossing.residual,
                                   equations_.rounding(contact, form, state)});
    if (std::abs(form(local)) <= noise)
      zero_at_start_.push_back(
          {.contact = contact, .guard = g, .remainder = std::max(0.0, -form(local))});
  }
}

// Nearer than this no step is possible.
bool Trajectory::at_source_break() const {
  const double instant = equations_.source_break();
  constexpr double nothing = 8 * std::numeric_limits<double>::epsilon();
  return time() >= instant || instant - time() <= nothing * std::abs(time());
}

void Trajectory::pass_source_break() {
  const double instant = equations_.source_break();
  const Vector state = steppers_.present().state();
  begin_phase(instant, state);
}

void Trajectory::begin_balance() {
  watched_ = true;
  initial_state_ = state();
  initial_energy_ = equations_.stored_energy(
      time(), ConstVectorView(initial_state_.data(), initial_state_.size()));
}

void Trajectory::advance(double end, Observer &observer) {
  if (!watched_)
    begin_balance();
  integrate(end, observer);
}

void Trajectory::advance(double end) {
  watched_ = false;
  Observers nobody({});
  integrate(end, nobody);
}

// Goes on unwatched as far as that is clear. A guard that has just been zero is left to a step.
bool Trajectory::fly(double limit) {
  if (watched_ || !flight_ || !zero_at_start_.empty())
    return false;
  double instant = time();
  Vector state = steppers_.present().state();
  const bool moved = flight_->fly(instant, state, limit);
  const UnwatchedFlight::Tally tally = flight_->take_tally();
  steps_ += tally.pieces;
  events_ += tally.events;
  event_residual_ = std::max(event_residual_, tally.event_residual);
  last_event_time_ = std::max(last_event_time_, flight_->last_event());
  if (!moved)
    return false;
  steppers_.place(instant, state);
  flown_ = true;
  return true;
}

// A step begins where the flight has ended.
void Trajectory::take_over() {
  const Vector state = steppers_.present().state();
  begin_phase(time(), state);
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c)
    note_zero_guards({.contact = c}, {}, state);
}

void Trajectory::integrate(double end, Observer &observer) {
  while (steppers_.present().time() < end) {
    if (at_source_break()) {
      pass_source_break();
      continue;
    }
    if (settings_.maximum_steps > 0 && steps_ >= settings_.maximum_steps)
      throw NumericalError("more than " + std::to_string(settings_.maximum_steps) +
                           " steps (Maximum steps)");
    const double limit = std::min(end, equations_.source_break());
    if (fly(limit))
      continue;
    if (flown_)
      take_over();
    ++steps_;
    steppers_.present().step(limit);
    Crossing crossing;
    const bool changes = find_crossing(view(), crossing) && locate(crossing);
    steppers_.present().accept(watched_);
    if (steppers_.present().time() > steppers_.present().previous_time())
      observer.step(view());
    if (changes) {
      change_modes(crossing, observer);
      continue;
    }
    if (!zero_at_start_.empty())
      forget_grown_guards();
  }
}

Accuracy Trajectory::accuracy() const {
  const Vector &x = steppers_.present().state();
  const double energy = equations_.stored_energy(time(), ConstVectorView(x.data(), x.size()));
  const Vector since = x - initial_state_;
  double unaccounted =
      energy - initial_energy_ - since[layout().input_work()] + since[layout().damping_work()];
  for (Index c = 0; c < layout().n_contacts; ++c)
    unaccounted += since[layout().contact_work(c)];
  const double turnover = initial_energy_ + since[layout().absolute_input_work()];
  double energy_residual = turnover > 0 ? std::abs(unaccounted) / turnover : 0;
  if (!watched_)
    energy_residual = std::numeric_limits<double>::quiet_NaN();
  return {.steps = steps_,
          .rejected_steps = steppers_.rejected_steps() - rejected_before_,
          .events = events_,
          .energy_residual = energy_residual,
          .event_residual = event_residual_};
}

} // namespace vibroimpact
