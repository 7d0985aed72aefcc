// What the equations have of normal forces that friction sees by value, and of their rates, which
// follow from the accelerations.
#include "motion/system/equations.h"
#include "motion/system/friction_rates.h"

#include <cmath>
#include <limits>

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::ContactPair;
using contact::LawResponse;
using contact::LocalState;

double rate_of_force(const LawResponse &response, const LocalState &change) {
  double rate = response.force_by_gap * change.gap + response.force_by_gap_rate * change.gap_rate;
  for (std::size_t i = 0; i < response.force_by_internal.size(); ++i)
    rate += response.force_by_internal[i] * change.internal[i];
  return rate;
}

bool Equations::sees_normal_force(std::size_t contact) const {
  return !contacts_.pairs()[contact].tangential.empty() && !mode(contact).holds_gap &&
         (!mode(contact).affine || mode(contact).sees_force_rate);
}

// `rates`: dx/dt, where the mode sees the rate of the force.
void Equations::see_normal_force(std::size_t contact, double time, ConstVectorView x,
                                 ConstVectorView rates, LocalState &state) const {
  const contact::ContactLaw &law = *contacts_.pairs()[contact].law;
  law.evaluate(modes_[contact], state, response_);
  state.normal_force = response_.force;
  if (!mode(contact).sees_force_rate)
    return;
  state.gap_acceleration = gap_acceleration(
      contact, time, x, ConstVectorView(rates.data() + layout_.velocity(), layout_.n));
  state.normal_force_rate = rate_of_force(response_, {.gap = state.gap_rate,
                                                      .gap_rate = state.gap_acceleration,
                                                      .internal = response_.internal_rate});
}

// Once the accelerations are known; forces do not depend on these rates.
void Equations::follow_force_rates(double time, ConstVectorView x, VectorView dxdt) const {
  for (const std::size_t c : following_) {
    const ContactPair &pair = contacts_.pairs()[c];
    LocalState state = local_motion(c, time, x);
    see_normal_force(c, time, x, ConstVectorView(dxdt.data(), dxdt.size()), state);
    pair.law->evaluate(modes_[c], state, response_);
    for (int i = 0; i < pair.n_internal(); ++i)
      dxdt[layout_.internal() + pair.internal_offset + i] = response_.internal_rate[i];
    dxdt[layout_.contact_work(static_cast<Index>(c))] = response_.dissipated_power;
    write_friction(pair, dxdt);
  }
}

// The rows of the accelerations are complete.
void Equations::follow_force_rates(double time, ConstVectorView x, Matrix &jacobian) const {
  for (const std::size_t c : following_) {
    const ContactPair &pair = contacts_.pairs()[c];
    const LocalState local = local_state(c, time, x);
    const RowVector by_state = gap_acceleration_row(c, time, x, jacobian);
    pair.law->evaluate(modes_[c], local, response_);
    if (pair.circle)
      write_circular_rates(c, time, x, jacobian);
    else
      write_internal_rates(c, jacobian);
    const std::vector<double> &by_acceleration = response_.internal_rate_by_gap_acceleration;
    for (std::size_t i = 0; i < by_acceleration.size(); ++i)
      jacobian.row(layout_.internal() + pair.internal_offset + static_cast<Index>(i)) +=
          by_acceleration[i] * by_state;
  }
}

// Of what a form has of the normal force and its rate, by the terms of gap and gap rate.
double Equations::normal_force_magnitude(std::size_t contact, const AffineForm &form, double time,
                                         const Vector &x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  const ConstVectorView at(x.data(), x.size());
  pair.law->evaluate(modes_[contact], local_state(contact, time, at), response_);
  const double by_gap = std::abs(response_.force_by_gap);
  const double by_rate = std::abs(response_.force_by_gap_rate);
  const double force = std::abs(response_.force);
  const double gap = magnitude(contact, AffineForm::position_along(0), time, x);
  const double gap_rate = magnitude(contact, AffineForm::rate_along(0), time, x);
  double sum = std::abs(form.normal_force) * (force + by_gap * gap + by_rate * gap_rate);
  if (form.normal_force_rate != 0) {
    const double acceleration = acceleration_rounding(contact, time, x) / rounding_factor +
                                force / contacts_.effective_mass(contact, model_);
    sum += std::abs(form.normal_force_rate) * (by_gap * gap_rate + by_rate * acceleration);
  }
  return sum;
}

} // namespace vibroimpact::motion
