// What the equations have of forces that hold gaps and slip rates (active_constraints.h).
#include "motion/system/equations.h"

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::ContactPair;
using contact::LocalState;

namespace {

// Along a direction: position and rate.
std::pair<double, double> seen_along(const LocalState &state, int direction) {
  if (direction == 0)
    return {state.gap, state.gap_rate};
  const contact::TangentialState &of = state.tangential[static_cast<std::size_t>(direction - 1)];
  return {of.slip, of.slip_rate};
}

} // namespace

// Rows that turn with the place, and responses that rotors change with it.
void Equations::place_constraints(double time, ConstVectorView x) const {
  if (!constraints_.turn() && model_.rotors().empty())
    return;
  for (Index k = 0; k < constraints_.size(); ++k) {
    const HeldDirection &held = constraints_.held(k);
    const ContactPair &pair = contacts_.pairs()[held.contact];
    if (!pair.circle)
      continue;
    const RowVector row = row_along(held.contact, held.direction, time, x);
    RowVector along = row;
    if (held.friction != 0) {
      const RowVector across = row_along(held.contact, 1, time, x);
      const RowVector mobility = row.cwiseQuotient(model_.mass().transpose());
      refuse_jamming(pair, held.friction, mobility.dot(row), mobility.dot(across));
      along += held.friction * across;
    }
    constraints_.set_rows(k, row, along);
  }
  constraints_.set_response(response_to(constraints_.along(), time, x));
}

// By impulses along what is held: v -= M^-1 W^T (W M^-1 W^T)^-1 slip_rate.
void Equations::stop_slip(double time, Vector &x) const {
  const ConstVectorView at(x.data(), x.size());
  place_constraints(time, at);
  Vector rates = Vector::Zero(constraints_.size());
  for (Index k = 0; k < rates.size(); ++k)
    if (const HeldDirection &held = constraints_.held(k); held.direction > 0)
      rates[k] = seen_along(local_motion(held.contact, time, at), held.direction).second;
  x.segment(layout_.velocity(), layout_.n) -= constraints_.response() * constraints_.forces(rates);
}

// Adds the forces that hold gaps and slip rates. Returns the power that moving bases and surfaces
// put into them.
double Equations::hold(double time, ConstVectorView x, VectorView dxdt) const {
  VectorView acceleration(dxdt.data() + layout_.velocity(), layout_.n);
  const ConstVectorView without(acceleration.data(), layout_.n);
  place_constraints(time, x);
  Vector missing(constraints_.size());
  Vector carried(constraints_.size());
  Vector rates(constraints_.size());
  for (Index k = 0; k < constraints_.size(); ++k) {
    const HeldDirection &held = constraints_.held(k);
    const auto [position, rate] = seen_along(local_motion(held.contact, time, x), held.direction);
    carried[k] = carried_along(held.contact, held.direction, time, x);
    rates[k] = rate;
    missing[k] = -gap_acceleration(held.contact, time, x, without, held.direction) -
                 constraints_.by_rate(k) * rate - constraints_.by_position(k) * position;
  }
  const Vector forces = constraints_.forces(missing);
  acceleration += constraints_.response() * forces;
  for (Index k = 0; k < constraints_.size(); ++k) {
    const auto contact = static_cast<Index>(constraints_.held(k).contact);
    if (constraints_.held(k).direction == 0)
      dxdt[layout_.impulse(contact)] = forces[k];
    dxdt[layout_.contact_work(contact)] += -forces[k] * rates[k];
  }
  held_forces_ = forces;
  double power = -forces.dot(carried);
  for (Index k = 0; k < constraints_.size(); ++k)
    if (const HeldDirection &held = constraints_.held(k);
        held.direction == 0 && mode(held.contact).friction == contact::Friction::slip)
      power += rub(held.contact, forces[k], time, x, dxdt);
  return power;
}

// What the friction of a contact takes that slides and is held along its normal. Returns the power
// that moving bases and surfaces put into it.
double Equations::rub(std::size_t contact, double normal_force, double time, ConstVectorView x,
                      VectorView dxdt) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  LocalState state = local_motion(contact, time, x);
  state.normal_force = normal_force;
  pair.law->evaluate(modes_[contact], state, response_);
  write_friction(pair, dxdt);
  dxdt[layout_.contact_work(static_cast<Index>(contact))] += response_.friction_power;
  double power = 0;
  for (std::size_t k = 0; k < pair.tangential.size(); ++k)
    power -=
        response_.tangential[k].force * carried_along(contact, 1 + static_cast<int>(k), time, x);
  return power;
}

// Adds the derivative of these forces, which is linear in that of the accelerations: along what is
// held, the derivatives of gap'' and slip'' at constant forces and of the terms of rates and
// positions are balanced by it.
void Equations::hold(double time, ConstVectorView x, Matrix &jacobian) const {
  auto accelerations = jacobian.middleRows(layout_.velocity(), layout_.n);
  Vector rates(layout_.size());
  if (constraints_.turn()) {
    this->rates(time, x, VectorView(rates.data(), rates.size()));
    turn_held_forces(time, x, jacobian);
  } else {
    place_constraints(time, x);
  }
  Matrix missing = -constraints_.rows() * accelerations;
  add_held_gradients(time, x, ConstVectorView(rates.data() + layout_.velocity(), layout_.n),
                     missing);
  accelerations += constraints_.response() * constraints_.forces(missing);
}

// Constant forces in circular gaps turn with the place; the accelerations have been evaluated.
void Equations::turn_held_forces(double time, ConstVectorView x, Matrix &jacobian) const {
  for (Index k = 0; k < constraints_.size(); ++k) {
    const HeldDirection &held = constraints_.held(k);
    const ContactPair &pair = contacts_.pairs()[held.contact];
    if (!pair.circle || held.direction > 0)
      continue;
    const Index beside = constraints_.place(held.contact, 1);
    contact::LawResponse forces{.force = held_forces_[k]};
    forces.tangential[0].force =
        beside < constraints_.size() ? held_forces_[beside] : held.friction * held_forces_[k];
    const std::array<AffineForm, 2> turned =
        pair.circle->force_gradient(frame(held.contact, time, x), forces);
    for (int d = 0; d < 2; ++d) {
      Vector into = Vector::Zero(jacobian.rows());
      into.segment(layout_.velocity(), layout_.n) =
          pair.along(d).projection->row.transpose().cwiseQuotient(model_.mass());
      add_rows(held.contact, turned[static_cast<std::size_t>(d)], into, jacobian);
    }
  }
}

void Equations::add_held_gradients(double time, ConstVectorView x, ConstVectorView acceleration,
                                   Matrix &missing) const {
  const Index n = layout_.n;
  for (Index k = 0; k < constraints_.size(); ++k) {
    const HeldDirection &held = constraints_.held(k);
    const contact::CircularGap *const circle = contacts_.pairs()[held.contact].circle.get();
    if (!circle) {
      missing.row(k).head(n) -= constraints_.by_position(k) * constraints_.rows().row(k);
      missing.row(k).segment(layout_.velocity(), n) -=
          constraints_.by_rate(k) * constraints_.rows().row(k);
      continue;
    }
    const contact::CircularFrame at = frame(held.contact, time, x);
    const AffineForm kept =
        constraints_.by_rate(k) * AffineForm::rate_along(held.direction) +
        constraints_.by_position(k) * AffineForm::position_along(held.direction);
    add_rows(held.contact,
             circle->acceleration_gradient(
                 at, relative_acceleration(held.contact, time, acceleration), held.direction) +
                 circle->gradient(at, kept),
             -Vector::Unit(missing.rows(), k), missing);
  }
}

} // namespace vibroimpact::motion
