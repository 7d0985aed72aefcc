#include "motion/path/trajectory.h"

#include "common/error.h"
#include "common/signals.h"
#include "motion/event/mode_change.h"
#include "motion/moments/moment_path.h"
#include "motion/path/exact_path.h"
#include "motion/path/law_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::LocalState;

namespace {

// Slip rates along two directions that are about to stop: 3e-10 of the largest speeds and more,
// which steps can follow, while a direction that is kept from there on errs by less. It is the same
// as long as sides slip.
void note_slow_slips(const ContactScales &scales, bool begins, Equations &equations) {
  constexpr double errors = 30;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (begins || equations.mode(c).friction != contact::Friction::slip)
      equations.set_slow_slip(c, errors * scales.speed(c));
}

} // namespace

Trajectory::Trajectory(const model::Model &model, const contact::ContactSet &contacts,
                       const Settings &settings)
    : settings_(settings), equations_(model, contacts), scales_(equations_, settings_),
      collisions_(equations_, settings_, scales_), steppers_(equations_, settings),
      ts_(MotionTs::create(settings, equations_.layout().size())), costs_(equations_) {
  // Changes of friction along two directions are left to steps.
  if (steppers_.exact() && !contacts.has_planes())
    path_ = std::make_unique<ExactPath>(equations_, steppers_.exact()->phases(), settings,
                                        progress_, counts_);
  if (settings.method == "moments" && !MomentStep::holds(equations_))
    throw InputError("Method = moments needs a linear model and contacts with finite forces, none "
                     "of which has a circular gap or two directions of friction, holds its slip "
                     "(Coulomb) or has states that "
                     "relax by themselves.");
  if (path_ && MomentStep::holds(equations_))
    moments_ =
        std::make_unique<MomentPath>(equations_, steppers_.exact()->phases(), settings, counts_);
  if (moments_ && settings.method == "exact")
    steppers_.exact()->phases().allow_crowded();
}

Trajectory::~Trajectory() = default;

double Trajectory::time_tolerance() const {
  return std::max(settings_.event_tolerance, 8 * std::numeric_limits<double>::epsilon() *
                                                 std::abs(steppers_.present().time()));
}

// A contact can be shorter than the tolerance of events: its own steps say how short.
double Trajectory::location_tolerance() const {
  const Stepper &stepper = steppers_.present();
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * std::abs(stepper.time());
  const double length = stepper.time() - stepper.previous_time();
  return std::max(rounding,
                  std::min(settings_.event_tolerance, settings_.relative_tolerance * length));
}

void Trajectory::begin_phase(double time, const Vector &state) {
  equations_.set_source_break(equations_.model().next_break(time));
  list_guards();
  if (equations_.contacts().has_planes())
    note_slow_slips(scales_, false, equations_);
  steppers_.restart(time, state);
  steps_outdated_ = false;
  if (path_)
    path_->leave();
  if (moments_)
    moments_->leave();
}

void Trajectory::start(const MotionState &from) {
  equations_.set_source_break(equations_.model().next_break(from.time));
  Vector state = Vector::Zero(layout().size());
  state.head(layout().physical_size()) = from.physical;
  choose_initial_modes(from.time, state);
  scales_.begin(from.time, state);
  note_slow_slips(scales_, true, equations_);
  settle_friction(equations_, scales_, from.time, state);
  collisions_.settle(from.time, settings_.event_tolerance, state);
  if (path_)
    path_->begin();
  costs_.begin();
  if (moments_)
    moments_->begin();
  steppers_.forget(); // so that a case does not depend on what was integrated before it
  counts_ = {.rejected_steps = -steppers_.rejected_steps()};
  last_ = {};
  progress_.begin(equations_.contacts().size(), equations_.model().highest_frequency());
  zero_at_start_.clear();
  if (path_) { // a step, if one is needed at all, finds out the rest
    steppers_.place(from.time, state);
    steps_outdated_ = true;
  } else {
    begin_phase(from.time, state);
    note_zero_guards(state);
  }
  begin_balance();
}

MotionState Trajectory::motion_state() const {
  return {.time = time(), .physical = state().head(layout().physical_size())};
}

StepView Trajectory::view() const {
  return {equations_, steppers_.present().start_point(), steppers_.present().end_point()};
}

// A guard that was zero when its mode began counts from there, without the remainder that the
// location of that instant has left; otherwise a short first step would see the remainder as a
// change of its own. What the step's polynomial errs by counts too: bodies that begin to move
// together part in a high order of time.
Bernstein Trajectory::indicator(const StepView &view, std::size_t contact,
                                std::size_t guard) const {
  Bernstein curve = view.indicator(contact, guard_of(contact, guard).indicator);
  const auto zero = find_zero_guard(contact, guard);
  if (zero == zero_at_start_.end())
    return curve;
  curve += zero->remainder + zero->slack;
  const AffineForm &form = guard_of(contact, guard).indicator;
  if (zero->slack == 0)
    curve.clear_start(std::max(negligible(contact, form),
                               scales_.error_of_step(contact, form, view.end(), view.end_state())));
  return curve;
}

// Error of an indicator.
double Trajectory::negligible(std::size_t contact, const AffineForm &form) const {
  return scales_.error(contact, form);
}

std::vector<ZeroGuard>::const_iterator Trajectory::find_zero_guard(std::size_t contact,
                                                                   std::size_t guard) const {
  return std::find_if(zero_at_start_.begin(), zero_at_start_.end(), [&](const ZeroGuard &zero) {
    return zero.contact == contact && zero.guard == guard;
  });
}

bool Trajectory::keeps_modes() const {
  return std::any_of(zero_at_start_.begin(), zero_at_start_.end(),
                     [](const ZeroGuard &zero) { return zero.slack > 0; });
}

void Trajectory::forget_grown_guards() {
  const StepView step = view();
  std::erase_if(zero_at_start_, [&](const ZeroGuard &zero) {
    const AffineForm &form = guard_of(zero.contact, zero.guard).indicator;
    return step.indicator(zero.contact, form).end() > negligible(zero.contact, form);
  });
}

// Of guards that fall at the same instant those come first by which a contact ends, which an impact
// would close again; then impacts, which decide with which velocities other contacts are entered.
void Trajectory::list_guards() {
  guards_.clear();
  Index place = 0;
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c)
    for (std::size_t g = 0; g < equations_.mode(c).guards.size(); ++g)
      guards_.push_back({.contact = c, .guard = g, .place = place++});
  const auto rank = [&](const PresentGuard &at) {
    const contact::Guard &guard = guard_of(at.contact, at.guard);
    const auto &modes = equations_.contacts().pairs()[at.contact].law->modes();
    if (guard.action == contact::GuardAction::impact)
      return 1;
    const bool ends = equations_.mode(at.contact).in_contact &&
                      !modes[static_cast<std::size_t>(guard.target)].in_contact;
    return ends ? 0 : 2;
  };
  std::stable_sort(guards_.begin(), guards_.end(),
                   [&](const PresentGuard &a, const PresentGuard &b) { return rank(a) < rank(b); });
}

bool Trajectory::find_crossing(const StepView &view, Crossing &crossing) const {
  bool found = false;
  for (const PresentGuard &at : guards_) {
    const std::optional<double> tau = indicator(view, at.contact, at.guard).first_down_crossing();
    if (tau && (!found || *tau < crossing.tau)) {
      crossing = {.tau = *tau, .contact = at.contact, .guard = at.guard};
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
  const AffineForm &form = guard_of(crossing.contact, crossing.guard).indicator;
  const Bernstein plain = view.indicator(crossing.contact, form);
  crossing.residual = std::abs(plain.end());
  crossing.rate = plain.derivative().end() / view.length();
  const double distance = std::abs(indicator(view, crossing.contact, crossing.guard).end());
  const double rounding = equations_.rounding(crossing.contact, form, view.end(), view.end_state());
  crossing.hidden = distance <= rounding ? rounding / std::abs(crossing.rate) : 0;
  return distance <= rounding ? 0 : std::abs(distance / crossing.rate);
}

GuardStart Trajectory::guard_start(std::size_t contact, std::size_t guard) const {
  const auto zero = find_zero_guard(contact, guard);
  if (zero != zero_at_start_.end())
    return {.zero = true, .shift = zero->remainder + zero->slack, .until = 8 * time_tolerance()};
  return {};
}

// The earliest fall in the step, for certain; counts the touches before it that stay undecided.
bool Trajectory::find_fall(const GuardCurves &curves, Crossing &crossing) {
  const double length = steppers_.present().time() - steppers_.present().previous_time();
  double end = length;
  bool found = false;
  std::vector<double> touches; // instants after the start of the step
  for (const PresentGuard &at : guards_) {
    const FirstDownCrossing fall =
        first_down_crossing(curves, at.place, end, guard_start(at.contact, at.guard));
    if (fall.touch)
      touches.push_back(*fall.touch);
    if (fall.time && (!found || *fall.time < end)) {
      crossing = {.tau = *fall.time / length, .contact = at.contact, .guard = at.guard};
      found = true;
      end = *fall.time;
    }
  }
  counts_.undecided_events += std::count_if(
      touches.begin(), touches.end(), [&](double instant) { return !found || instant < end; });
  return found;
}

// The contact changes at the start of the step. A guard that a jump has taken below zero was never
// zero: it leaves no remainder, and its negative is no zero of the mode to come.
void Trajectory::end_at_start(Crossing &crossing) {
  const Bernstein indicator =
      view().indicator(crossing.contact, guard_of(crossing.contact, crossing.guard).indicator);
  const double length = steppers_.present().time() - steppers_.present().previous_time();
  const bool jumped = indicator.start() < 0 &&
                      find_zero_guard(crossing.contact, crossing.guard) == zero_at_start_.end();
  crossing.residual = jumped ? 0 : std::abs(indicator.start());
  crossing.rate = std::abs(indicator.derivative().start() / length);
  steppers_.present().undo();
}

// Shortens the step to a fall that is known for certain.
void Trajectory::end_at_fall(Crossing &crossing) {
  const double start = steppers_.present().previous_time();
  const double instant = start + crossing.tau * (steppers_.present().time() - start);
  if (instant - start <= time_tolerance()) {
    end_at_start(crossing);
    return;
  }
  if (instant != steppers_.present().time())
    steppers_.present().shorten(instant);
  counts_.event_residual = std::max(counts_.event_residual, event_uncertainty(view(), crossing));
}

// Shortens the step to its first change of a contact.
bool Trajectory::changes_in_step(Crossing &crossing) {
  if (const GuardCurves *curves = steppers_.present().guard_curves()) {
    const bool falls = find_fall(*curves, crossing);
    if (falls)
      end_at_fall(crossing);
    return falls;
  }
  return find_crossing(view(), crossing) && locate(crossing);
}

// Shortens the step until it ends at the first crossing. False: the crossing was an artefact of the
// longer step's polynomial, and the step as it now stands is free of changes.
bool Trajectory::locate(Crossing &crossing) {
  constexpr int maximum_corrections = 60;
  const double limit = steppers_.present().time(); // up to here the step is good
  const double own = location_tolerance();
  int extensions = 0;
  for (int i = 0; i < maximum_corrections; ++i) {
    // Where rounding keeps the tolerance of the step's own length out of reach, that of events
    // does; at the end of the step, too, what rounding makes of the instant.
    const double tolerance = i < maximum_corrections / 2 ? own : time_tolerance();
    const double start = steppers_.present().previous_time();
    const double instant = start + crossing.tau * (steppers_.present().time() - start);
    if (instant - start <= tolerance) {
      end_at_start(crossing);
      return true;
    }
    if (instant != steppers_.present().time())
      steppers_.present().shorten(instant);
    const StepView shorter = view();
    Crossing earlier = crossing;
    const bool inside = find_crossing(shorter, earlier);
    Crossing &candidate = inside ? earlier : crossing;
    const double uncertainty = event_uncertainty(shorter, candidate);
    const double same = i < maximum_corrections / 2 ? own : std::max(tolerance, candidate.hidden);
    const bool at_end = !inside || (1 - earlier.tau) * shorter.length() <= same;
    if (at_end && uncertainty <= tolerance) {
      counts_.event_residual = std::max(counts_.event_residual, uncertainty);
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

// Of a contact that begins in a step.
StepReason Trajectory::reason_for_steps() const {
  if (!path_)
    return StepReason::method;
  return steppers_.present().exact() ? StepReason::undecided : StepReason::system;
}

void Trajectory::advance(double end, const Observers &observers) {
  const bool wanted = observers.want_integrals();
  if (wanted && !balance_.integrals)
    begin_balance();
  balance_.integrals = wanted;
  audience_.list = observers.list();
  audience_modes_.reset();
  integrate(end, observers);
}

void Trajectory::advance(double end) { advance(end, Observers({})); }

void Trajectory::integrate(double end, const Observers &observers) {
  if (!ts_) {
    move(end, observers);
    return;
  }
  ts_->step(time(), state(), end, [&]() -> const Vector & {
    move(end, observers);
    return state();
  });
}

void Trajectory::show(const StepView &step) {
  if (audience_modes_ != equations_.modes()) {
    audience_modes_ = equations_.modes();
    audience_.ask(equations_);
  }
  audience_.show(step);
}

void Trajectory::move(double end, const Observers &observers) {
  while (steppers_.present().time() < end) {
    leave_if_stopped();
    progress_.pass(time(), time_tolerance());
    if (progress_.stalled())
      throw NumericalError(stall_reason("the motion hardly advances"));
    if (at_source_break()) {
      pass_source_break();
      continue;
    }
    if (settings_.maximum_steps > 0 && counts_.steps >= settings_.maximum_steps)
      throw NumericalError("more than " + std::to_string(settings_.maximum_steps) +
                           " steps (Maximum steps)");
    const double limit = std::min(end, equations_.source_break());
    if (!progress_.slow() && propagate(limit, observers))
      continue;
    if (steps_outdated_)
      take_over();
    ++counts_.steps;
    const long rejected = steppers_.rejected_steps();
    steppers_.step(limit);
    Crossing crossing;
    const bool changes = changes_in_step(crossing);
    if (moments_ && !steppers_.present().exact())
      costs_.note_step(1 + steppers_.rejected_steps() - rejected, changes);
    steppers_.present().accept(balance_.integrals);
    balance_.exact = balance_.exact && steppers_.present().exact();
    if (steppers_.present().time() > steppers_.present().previous_time())
      show(view());
    scales_.note(time(), state());
    check_laws(equations_, time(), state());
    if (changes) {
      crossing.reason = reason_for_steps();
      change_modes(crossing, observers);
      continue;
    }
    if (!zero_at_start_.empty())
      forget_grown_guards();
  }
}

} // namespace vibroimpact::motion
