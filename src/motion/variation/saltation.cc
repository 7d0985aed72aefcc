#include "motion/variation/saltation.h"

#include "common/error.h"
#include "motion/interval/guard_forms.h"
#include "motion/variation/row_rate.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::ContactLaw;

namespace {

// A jump below this part of the rates themselves is their rounding.
constexpr double negligible_jump = 1e-11;

// The guard of a neighbouring law that corresponds to the one that was passed.
class SameGuard {
public:
  SameGuard(const ContactEvent &event, const ContactLaw &law)
      : mode_(static_cast<std::size_t>(event.from)) {
    for (const contact::Guard &guard : law.modes()[mode_].guards) {
      if (&guard == event.guard)
        return;
      ++index_;
    }
    throw std::logic_error("a contact has changed through a guard that its mode does not have");
  }
  const contact::Guard &operator()(const ContactLaw &law) const {
    return law.modes()[mode_].guards[index_];
  }

private:
  std::size_t mode_;
  std::size_t index_ = 0;
};

} // namespace

struct Saltations::Crossing {
  RowVector by_state; ///< g_x
  RowVector by_key;   ///< g_p
  double rate = 0;    ///< g'
};

struct Saltations::Reset {
  LowRankMap by_state; ///< R_x
  Matrix by_key;       ///< R_p
  Vector rates;        ///< R'
};

Vector Saltations::rates(double time, const Vector &state) const {
  Vector rates(state.size());
  equations_.rates(time, ConstVectorView(state.data(), state.size()),
                   VectorView(rates.data(), rates.size()));
  rates.conservativeResize(equations_.layout().physical_size());
  return rates;
}

// The gap is zero there. A force that begins with its fourth root would make 1e-4 of a rounding of
// 1e-16, and a jump of it.
Vector Saltations::rates_at_guard(const ContactEvent &event, const Vector &state) const {
  Vector rates = this->rates(event.time, state);
  const AffineForm &guard = event.guard->indicator;
  const bool is_gap = guard.constant == 0 && guard.margin == 0 && guard.gap_rate == 0 &&
                      guard.internal.empty() && !guard.sees_normal_force() &&
                      guard.tangential[0].zero() && guard.tangential[1].zero();
  if (!is_gap || equations_.mode(event.contact).holds_gap || equations_.inactive(event.contact))
    return rates;
  const ConstVectorView x(state.data(), state.size());
  contact::LocalState local = equations_.local_state(event.contact, event.time, x);
  const int mode = equations_.modes()[event.contact];
  const double force = equations_.force(event.contact, mode, local);
  local.gap = 0;
  const double at_zero = equations_.force(event.contact, mode, local);
  if (at_zero == force)
    return rates;
  const StateLayout &layout = equations_.layout();
  rates.segment(layout.velocity(), layout.n) +=
      (at_zero - force) *
      equations_.response_to(Matrix(equations_.row_along(event.contact, 0, event.time, x)),
                             event.time, x);
  return rates;
}

RowVector Saltations::gradient(const ContactEvent &event, const AffineForm &form) const {
  RowVector row = tangent_row(equations_, event.contact, form, event.time, *event.before).row;
  row.conservativeResize(equations_.layout().physical_size());
  return row;
}

// Forces that a form sees are rows of the state and the sources.
double Saltations::rate_along(const AffineForm &form, const ContactEvent &event,
                              const Vector &rates) const {
  if (form.margin != 0)
    return rate_along(without_margin(equations_, event.contact, form, event.time, *event.before),
                      event, rates);
  contact::LocalState change = equations_.local_rates(
      event.contact, event.time, ConstVectorView(event.before->data(), event.before->size()),
      ConstVectorView(rates.data(), rates.size()));
  change.gap = event.gap_rate;
  change.normal_force = 0;
  AffineForm slope = form;
  slope.constant = 0;
  AffineForm forces;
  forces.normal_force = std::exchange(slope.normal_force, 0);
  forces.normal_force_rate = std::exchange(slope.normal_force_rate, 0);
  for (std::size_t k = 0; k < contact::most_tangential; ++k)
    forces.tangential[k].force = form.tangential[k].force;
  return slope(change) + (form.sees_forces() ? rate_of_forces(forces, event, rates) : 0);
}

double Saltations::rate_of_forces(const AffineForm &forces, const ContactEvent &event,
                                  const Vector &rates) const {
  const LinearRow form = tangent_row(equations_, event.contact, forces, event.time, *event.before);
  return rate_of_row(equations_, form.row, event.time, rates);
}

Saltations::Crossing Saltations::crossing(const ContactEvent &event, const Vector &before) const {
  const AffineForm &guard = event.guard->indicator;
  Crossing crossing{.by_state = gradient(event, guard),
                    .by_key = RowVector::Zero(static_cast<Index>(keys_.size())),
                    .rate = rate_along(guard, event, before)};
  if (keys_.empty())
    return crossing;
  if (event.guard->action == contact::GuardAction::impact) { // it is the gap itself
    for (std::size_t k = 0; k < keys_.size(); ++k)
      crossing.by_key[static_cast<Index>(k)] =
          guard.gap * keys_[k]->gap(event.contact, event.time, *event.before);
    return crossing;
  }
  const SameGuard same(event, *equations_.contacts().pairs()[event.contact].law);
  for (std::size_t k = 0; k < keys_.size(); ++k)
    crossing.by_key[static_cast<Index>(k)] = keys_[k]->form(
        equations_, event.contact,
        [&](const ContactLaw &law) -> const AffineForm & { return same(law).indicator; },
        event.time, *event.before);
  return crossing;
}

Saltations::Reset Saltations::no_reset(const Vector &before) const {
  return {.by_state = {},
          .by_key = Matrix::Zero(before.size(), static_cast<Index>(keys_.size())),
          .rates = before};
}

// Only internal states of the contact itself are reset.
Saltations::Reset Saltations::internal_reset(const ContactEvent &event,
                                             const Vector &before) const {
  Reset reset = no_reset(before);
  const contact::ContactPair &pair = equations_.contacts().pairs()[event.contact];
  const Index first = equations_.layout().internal() + pair.internal_offset;
  const SameGuard same(event, *pair.law);
  for (std::size_t i = 0; i < event.guard->reset.size(); ++i) {
    const AffineForm &form = event.guard->reset[i];
    const Index row = first + static_cast<Index>(i);
    const Vector unit = Vector::Unit(before.size(), row);
    reset.by_state.add(unit, gradient(event, form) - unit.transpose());
    reset.rates[row] = rate_along(form, event, before);
    for (std::size_t k = 0; k < keys_.size(); ++k)
      reset.by_key(row, static_cast<Index>(k)) = keys_[k]->form(
          equations_, event.contact,
          [&](const ContactLaw &law) -> const AffineForm & { return same(law).reset[i]; },
          event.time, *event.before);
  }
  return reset;
}

// The velocities alone jump, by all contacts that take an impulse.
Saltations::Reset Saltations::impact(const ContactEvent &event, const Vector &before) const {
  Reset reset = no_reset(before);
  const Collision &collision = *event.collision;
  if (collision.contacts.empty())
    return reset;
  const StateLayout &layout = equations_.layout();
  const Matrix impulses = collision.response * collision.impulse_by_rate;
  reset.by_state = {.left = Matrix::Zero(before.size(), impulses.cols()),
                    .right = Matrix::Zero(impulses.cols(), before.size())};
  reset.by_state.left.middleRows(layout.velocity(), layout.n) = impulses;
  reset.by_state.right.middleCols(layout.velocity(), layout.n) = collision.rows;
  Vector accelerations(static_cast<Index>(collision.contacts.size()));
  for (Index k = 0; k < accelerations.size(); ++k)
    accelerations[k] =
        equations_.gap_acceleration(collision.contacts[static_cast<std::size_t>(k)], event.time,
                                    ConstVectorView(event.before->data(), event.before->size()),
                                    ConstVectorView(before.data() + layout.velocity(), layout.n),
                                    collision.directions[static_cast<std::size_t>(k)]);
  reset.rates.segment(layout.velocity(), layout.n) += impulses * accelerations;
  for (std::size_t k = 0; k < keys_.size(); ++k)
    reset.by_key.col(static_cast<Index>(k)).segment(layout.velocity(), layout.n) =
        keys_[k]->jump(equations_, collision, event.time, *event.before);
  return reset;
}

Saltation Saltations::join(Crossing crossing, Reset reset, const Vector &after) const {
  const Vector jump = after - reset.rates;
  const double size = scale_.cwiseProduct(after.cwiseAbs() + reset.rates.cwiseAbs()).maxCoeff();
  const bool shifts = scale_.cwiseProduct(jump).cwiseAbs().maxCoeff() > negligible_jump * size;
  Saltation saltation{.by_state = std::move(reset.by_state),
                      .by_key = std::move(reset.by_key),
                      .delay = std::move(crossing.by_state)};
  saltation.jumps = shifts || !saltation.by_state.right.isZero(0);
  if (crossing.rate == 0) {
    saltation.delay.setZero();
    saltation.differentiable = !shifts;
    return saltation;
  }
  saltation.delay /= -crossing.rate;
  if (jump.isZero(0))
    return saltation;
  saltation.by_state.add(jump, -saltation.delay);
  if (!keys_.empty())
    saltation.by_key += jump * (crossing.by_key / crossing.rate);
  return saltation;
}

// Of its guard, by more than rounding and the location of an event leave.
bool Saltations::below_zero(const ContactEvent &event) const {
  const Vector &state = *event.before;
  const AffineForm &guard = event.guard->indicator;
  const double value = guard(equations_.local_state(event.contact, event.time,
                                                    ConstVectorView(state.data(), state.size())));
  return value < -16 * equations_.rounding(event.contact, guard, event.time, state);
}

// A guard that a jump of forces has taken below zero is passed when the change before happens,
// whatever it is itself. The delay of that one is a row of positions, which no change moves.
Saltation Saltations::change(const ContactEvent &event, bool at_start) {
  equations_.set_mode(event.contact, event.from);
  const Vector before = rates_at_guard(event, *event.before);
  Crossing crossing = this->crossing(event, before);
  if (at_start && below_zero(event)) { // no deviation moves the instant
    crossing.by_state.setZero();
    crossing.by_key.setZero();
    crossing.rate = 1;
  } else if (last_.time == event.time && below_zero(event)) {
    crossing = {.by_state = -last_.delay, .by_key = -last_.delay_by_key, .rate = 1};
  }
  Reset reset = internal_reset(event, before);
  equations_.set_mode(event.contact, event.to);
  const RowVector by_key = crossing.by_key * (crossing.rate != 0 ? -1 / crossing.rate : 0);
  Saltation saltation =
      join(std::move(crossing), std::move(reset), rates_at_guard(event, *event.state));
  last_ = {.time = event.time, .delay = saltation.delay, .delay_by_key = by_key};
  return saltation;
}

Saltation Saltations::collide(const ContactEvent &event) {
  if (!equations_.model().rotors().empty())
    throw NumericalError("rigid impacts have no known derivative in models with "
                         "rotors, whose inertia changes with the position");
  const Collision &collision = *event.collision;
  for (std::size_t c = 0; c < collision.modes_before.size(); ++c)
    equations_.set_mode(c, collision.modes_before[c]);
  const Vector before = rates(event.time, *event.before);
  Crossing crossing = this->crossing(event, before);
  Reset reset = impact(event, before);
  for (std::size_t c = 0; c < collision.modes_after.size(); ++c)
    equations_.set_mode(c, collision.modes_after[c]);
  Saltation saltation =
      join(std::move(crossing), std::move(reset), rates(event.time, *event.state));
  saltation.differentiable = saltation.differentiable && collision.unique;
  return saltation;
}

std::optional<Saltation> Saltations::of(const ContactEvent &event, double start) {
  if (event.guard->action == contact::GuardAction::impact) {
    if (!event.collision)
      return std::nullopt;
    return collide(event);
  }
  const ContactLaw &law = *equations_.contacts().pairs()[event.contact].law;
  if (law.modes()[static_cast<std::size_t>(event.from)].holds_gap &&
      !law.modes()[static_cast<std::size_t>(event.to)].holds_gap) { // let go without force
    equations_.set_mode(event.contact, event.to);
    return std::nullopt;
  }
  return change(event, event.time == start);
}

Matrix Saltations::at_break(const Vector &state, double next) {
  const double instant = equations_.source_break();
  const Vector before = rates(instant, state);
  equations_.set_source_break(next);
  const Vector after = rates(instant, state);
  Matrix added(before.size(), static_cast<Index>(keys_.size()));
  for (std::size_t k = 0; k < keys_.size(); ++k)
    added.col(static_cast<Index>(k)) = (before - after) * keys_[k]->sources().break_rate();
  return added;
}

} // namespace vibroimpact::motion
