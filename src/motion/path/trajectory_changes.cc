// What a trajectory does where a contact changes its mode, and what it knows of the guards there.
//
// At such an instant guards are zero for certain that evaluate to a remainder: the one that was
// passed; every guard that is proportional to it; and, while the motion stays at that instant,
// those that were zero before. A guard that is zero fires when it falls from there, not because of
// its remainder.
//
// Contacts may change one after the other at one instant. Positions stay, and without an impulse so
// do the velocities: modes of all contacts that come up a second time would come up for ever. Then
// the guards that send them round are zero within the error of the integration, and which of the
// modes holds is indeterminate. The present ones are kept until a guard is below zero by more than
// that error, so that the forces of the motion differ by no more than this from those of either.
#include "motion/path/trajectory.h"

#include "common/error.h"
#include "motion/event/lasting_contacts.h"
#include "motion/event/mode_change.h"
#include "motion/path/change_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::LocalState;

namespace {

// Contact changes in a row without any progress in time; more than the contacts' modes together
// could need means that none of them holds.
constexpr long maximum_events_at_once = 100;

// |factor| for which form = factor * other; 0 when there is none. Margins of two modes are two
// quantities.
double proportion(const AffineForm &form, const AffineForm &other) {
  if (form.margin != 0 || other.margin != 0)
    return 0;
  const auto coefficients = [](const AffineForm &from, std::size_t n_internal) {
    std::vector<double> list = {from.constant, from.normal_force_rate};
    for (int d = 0; d <= static_cast<int>(contact::most_tangential); ++d) {
      const contact::DirectionForm along = from.along(d);
      list.insert(list.end(), {along.position, along.rate, along.force});
    }
    const std::size_t size = list.size() + n_internal;
    list.insert(list.end(), from.internal.begin(), from.internal.end());
    list.resize(size, 0.0);
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

// The guard of a mode that has led to the present one; the first one where none does.
std::size_t guard_towards(const Equations &equations, std::size_t contact, int from) {
  const contact::ContactLaw &law = *equations.contacts().pairs()[contact].law;
  const std::vector<contact::Guard> &guards = law.modes()[static_cast<std::size_t>(from)].guards;
  const auto found = std::ranges::find(guards, equations.modes()[contact], &contact::Guard::target);
  return found == guards.end() ? 0 : static_cast<std::size_t>(found - guards.begin());
}

} // namespace

// Where rigid contacts last side by side, what one of them does may change others.
void Trajectory::change_mode(double instant, std::size_t contact, std::size_t guard, Vector &state,
                             const Observers &observers) {
  before_ = state;
  const std::vector<int> modes = equations_.modes();
  const ConstVectorView x(before_.data(), before_.size());
  const LocalState local = equations_.local_state(contact, instant, x);
  if (lasts_beside_others(equations_, contact))
    pass_together(equations_, scales_, contact, guard_of(contact, guard), instant, state);
  if (equations_.modes() == modes)
    motion::pass_guard(equations_, contact, guard_of(contact, guard), instant, local, state);
  const auto report = [&](std::size_t c, std::size_t passed, const LocalState &seen) {
    report_change(equations_,
                  {.time = instant,
                   .contact = c,
                   .from = modes[c],
                   .guard = passed,
                   .local = seen,
                   .before = before_},
                  balance_.integrals, state, observers);
    ++counts_.events;
  };
  report(contact, guard, local);
  for (std::size_t c = 0; c < modes.size(); ++c)
    if (c != contact && equations_.modes()[c] != modes[c])
      report(c, guard_towards(equations_, c, modes[c]), equations_.local_state(c, instant, x));
}

// What is zero at this instant, with the values that rounding and the location have left.
std::vector<Trajectory::KnownZero> Trajectory::known_zeros(const Crossing &first,
                                                           bool stuck) const {
  const std::size_t contact = first.contact;
  const contact::Guard &passed = guard_of(contact, first.guard);
  const Vector &x = steppers_.present().state();
  const LocalState local =
      equations_.local_state(contact, time(), ConstVectorView(x.data(), x.size()));
  std::vector<KnownZero> zeros;
  const auto add = [&](const AffineForm &form) {
    zeros.push_back({.form = form, .size = std::abs(form(local))});
  };
  // The segment that located it and the state round differently.
  const double left = std::abs(passed.indicator(local));
  const bool rounded = left <= negligible(contact, passed.indicator);
  zeros.push_back({.form = passed.indicator,
                   .size = rounded ? std::max(first.residual, left) : first.residual});
  // A gap that was held is zero, whatever error of the integration it has, and so is a slip rate.
  if (equations_.mode(contact).holds_gap)
    add({.gap = 1});
  if (equations_.mode(contact).holds_slip)
    for (int d = 1; d < equations_.contacts().pairs()[contact].n_directions(); ++d)
      add(AffineForm::rate_along(d));
  if (stuck)
    for (const ZeroGuard &zero : zero_at_start_)
      if (zero.contact == contact)
        add(guard_of(contact, zero.guard).indicator);
  return zeros;
}

void Trajectory::pass_guard(const Crossing &first, bool stuck, const Observers &observers) {
  progress_.note(first.contact, time(), steppers_.present().fastest(), time_tolerance());
  const std::vector<KnownZero> zeros = known_zeros(first, stuck);
  Vector state = steppers_.present().state();
  const std::vector<int> modes = equations_.modes();
  const bool apart = !equations_.mode(first.contact).in_contact;
  change_mode(time(), first.contact, first.guard, state, observers);
  const contact::Mode &mode = equations_.mode(first.contact);
  if (apart && mode.in_contact && !mode.affine && !mode.holds_gap)
    ++counts_.step_reasons[static_cast<std::size_t>(first.reason)];
  begin_phase(time(), state);
  std::erase_if(zero_at_start_, [&](const ZeroGuard &zero) {
    return zero.contact == first.contact || equations_.modes()[zero.contact] != modes[zero.contact];
  });
  renew_zero_guards(state);
  const double delay = first.rate != 0 ? first.residual / std::abs(first.rate) : 0;
  note_zero_guards(first.contact, zeros, delay, state);
  note_zero_guards(state);
}

// Several contacts may change at the same instant; each guard that is zero there starts the new
// phase from an exact zero, so that rounding cannot fire it again.
void Trajectory::change_modes(const Crossing &first, const Observers &observers) {
  const bool stuck = time() - last_.time <= time_tolerance();
  last_.events = stuck ? last_.events + 1 : 0;
  note_change(first.contact, stuck);
  scales_.note(time(), state(), true);
  if (last_.events > maximum_events_at_once)
    throw NumericalError(stall_reason("contact changes follow each other without progress"));
  if (settings_.maximum_events > 0 && counts_.events >= settings_.maximum_events)
    throw NumericalError("more than " + std::to_string(settings_.maximum_events) +
                         " contact changes (Maximum events)");
  last_.time = time();
  if (!stuck)
    last_.tried = {equations_.modes()};
  if (guard_of(first.contact, first.guard).action == contact::GuardAction::impact)
    collide(first.contact, observers);
  else
    pass_guard(first, stuck, observers);
  if (std::find(last_.tried.begin(), last_.tried.end(), equations_.modes()) != last_.tried.end())
    keep_modes();
  else
    last_.tried.push_back(equations_.modes());
}

// The guards of the contacts that have changed at this instant, as far as they are zero within the
// error of the integration, fire only when they have fallen by twice that error.
void Trajectory::keep_modes() {
  const Vector &x = steppers_.present().state();
  bool kept = false;
  for (const std::size_t c : last_.changed) {
    const LocalState local = equations_.local_state(c, time(), ConstVectorView(x.data(), x.size()));
    for (std::size_t g = 0; g < equations_.mode(c).guards.size(); ++g) {
      const AffineForm &form = guard_of(c, g).indicator;
      const double remainder = std::max(0.0, -form(local));
      const double error = std::max(negligible(c, form), equations_.rounding(c, form, time(), x));
      const auto known = find_zero_guard(c, g);
      if (known == zero_at_start_.end() && std::abs(form(local)) > error)
        continue;
      if (known != zero_at_start_.end())
        zero_at_start_.erase(known);
      zero_at_start_.push_back(
          {.contact = c, .guard = g, .remainder = remainder, .slack = 2 * error});
      kept = true;
    }
  }
  counts_.undecided_events += kept ? 1 : 0;
}

// Of the guards that were zero at the start of an earlier phase: a jump of velocities or of forces
// may have taken one off its zero. One that is below zero now has fallen, and its contact changes
// at once.
void Trajectory::renew_zero_guards(const Vector &state) {
  std::erase_if(zero_at_start_, [&](const ZeroGuard &zero) {
    const AffineForm &form = guard_of(zero.contact, zero.guard).indicator;
    const double value = form(
        equations_.local_state(zero.contact, time(), ConstVectorView(state.data(), state.size())));
    return std::abs(value) >
           std::max(2 * (zero.remainder + zero.slack), negligible(zero.contact, form));
  });
}

// Guards of other contacts that are zero within the uncertainty of this instant pass or leave zero
// at this instant too: what they do in the new phase decides.
void Trajectory::note_zero_guards(const Vector &state) {
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c)
    note_zero_guards(c, {}, 0, state);
}

// What was left of the guard that was passed is left of the guard back as well, and must not be
// seen as a change of its own. The guard back often is its negative. Where it is another
// expression, in other units, the time that the remainder stands for is the same.
void Trajectory::note_zero_guards(std::size_t contact, const std::vector<KnownZero> &known,
                                  double delay, const Vector &state) {
  Vector rates_at_start(state.size());
  equations_.rates(time(), ConstVectorView(state.data(), state.size()),
                   VectorView(rates_at_start.data(), rates_at_start.size()));
  const LocalState local =
      equations_.local_state(contact, time(), ConstVectorView(state.data(), state.size()));
  // The rate of an affine form is the form of the rates.
  const LocalState rates =
      equations_.local_rates(contact, time(), ConstVectorView(state.data(), state.size()),
                             ConstVectorView(rates_at_start.data(), rates_at_start.size()));
  for (std::size_t g = 0; g < equations_.mode(contact).guards.size(); ++g) {
    if (find_zero_guard(contact, g) != zero_at_start_.end())
      continue;
    const AffineForm &form = guard_of(contact, g).indicator;
    const double rate = form(rates) - form.constant;
    double noise = std::max({2 * std::max(time_tolerance(), delay) * std::abs(rate),
                             equations_.rounding(contact, form, time(), state)});
    for (const KnownZero &zero : known)
      noise = std::max(noise, proportion(form, zero.form) * zero.size);
    // Gaps are held, and forces hold them, with the error of the integration.
    if (form.sees_forces() || guard_of(contact, g).action == contact::GuardAction::impact)
      noise = std::max(noise, negligible(contact, form));
    if (std::abs(form(local)) <= noise)
      zero_at_start_.push_back(
          {.contact = contact, .guard = g, .remainder = std::max(0.0, -form(local))});
  }
}

} // namespace vibroimpact::motion
