// What the equations have of contacts: local states, and forces along each of their directions.
#include "motion/system/equations.h"
#include "motion/system/friction_rates.h"

#include <cmath>
#include <tuple>

namespace vibroimpact::motion {

using contact::ContactPair;
using contact::LocalState;

// Position and rate.
std::pair<double, double> Equations::motion_along(const Component &component, double time,
                                                  ConstVectorView x) const {
  const double *row = component.along.projection->row.data();
  const double *q = x.data();
  const double *velocity = q + layout_.velocity();
  double position = component.along.offset;
  double rate = component.along.speed;
  for (Index j = 0; j < layout_.n; ++j) {
    position += row[j] * q[j];
    rate += row[j] * velocity[j];
  }
  for (const BaseCoefficient &base : component.base_coefficients) {
    position += base.factor * source(base.source, 0, time);
    rate += base.factor * source(base.source, 1, time);
  }
  return {position, rate};
}

// Without the forces that hold it.
LocalState Equations::local_motion(std::size_t contact, double time, ConstVectorView x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  LocalState state{.internal = {x.data() + layout_.internal() + pair.internal_offset,
                                static_cast<std::size_t>(pair.n_internal())}};
  if (pair.circle) {
    pair.circle->see(frame(contact, time, x), state);
    return state;
  }
  std::tie(state.gap, state.gap_rate) = motion_along(component(contact, 0), time, x);
  for (int d = 1; d < pair.n_directions(); ++d) {
    contact::TangentialState &of = state.tangential[static_cast<std::size_t>(d - 1)];
    std::tie(of.slip, of.slip_rate) = motion_along(component(contact, d), time, x);
  }
  return state;
}

LocalState Equations::local_state(std::size_t contact, double time, ConstVectorView x) const {
  LocalState state = local_motion(contact, time, x);
  const bool held = !constraints_.empty() && constraints_.holds(contact);
  const bool seen = sees_normal_force(contact);
  if (held || (seen && mode(contact).sees_force_rate)) {
    held_rates_.resize(layout_.size());
    rates(time, x, VectorView(held_rates_.data(), held_rates_.size()));
  }
  if (seen)
    see_normal_force(contact, time, x, ConstVectorView(held_rates_.data(), held_rates_.size()),
                     state);
  for (Index k = 0; held && k < constraints_.size(); ++k) {
    const HeldDirection &held = constraints_.held(k);
    if (held.contact != contact)
      continue;
    (held.direction == 0 ? state.normal_force
                         : state.tangential[static_cast<std::size_t>(held.direction - 1)].force) =
        held_forces_[k];
  }
  if (mode(contact).sees_margin)
    see_margin(contact, state);
  return state;
}

// By the forces that the state has.
void Equations::see_margin(std::size_t contact, LocalState &state) const {
  state.slow_slip = slow_slip_[contact];
  if (const auto &limit = mode(contact).limit) {
    state.margin = (*limit)(state);
    return;
  }
  contacts_.pairs()[contact].law->evaluate(modes_[contact], state, response_);
  state.margin = response_.margin;
}

contact::AffineForm Equations::margin_gradient(std::size_t contact, double time,
                                               ConstVectorView x) const {
  const LocalState state = local_state(contact, time, x);
  if (const auto &limit = mode(contact).limit)
    return limit->gradient(state);
  contacts_.pairs()[contact].law->evaluate(modes_[contact], state, response_);
  return response_.margin_by;
}

double Equations::gap_acceleration(std::size_t contact, double time, ConstVectorView x,
                                   ConstVectorView acceleration, int direction) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  return pair.circle ? pair.circle->acceleration(frame(contact, time, x),
                                                 relative_acceleration(contact, time, acceleration),
                                                 direction)
                     : acceleration_along(component(contact, direction), time, acceleration);
}

double Equations::acceleration_along(const Component &component, double time,
                                     ConstVectorView acceleration) const {
  double value = component.along.projection->row.dot(acceleration);
  for (const BaseCoefficient &base : component.base_coefficients)
    value += base.factor * source(base.source, 2, time);
  return value;
}

LocalState Equations::local_rates(std::size_t contact, double time, ConstVectorView x,
                                  ConstVectorView rates) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  const LocalState local = local_motion(contact, time, x);
  const ConstVectorView acceleration(rates.data() + layout_.velocity(), layout_.n);
  LocalState change{.gap = local.gap_rate,
                    .gap_rate = gap_acceleration(contact, time, x, acceleration),
                    .internal = {rates.data() + layout_.internal() + pair.internal_offset,
                                 local.internal.size()}};
  if (sees_normal_force(contact)) {
    pair.law->evaluate(modes_[contact], local, response_);
    change.normal_force = rate_of_force(response_, change);
  }
  for (int d = 1; d < pair.n_directions(); ++d) {
    const auto k = static_cast<std::size_t>(d - 1);
    change.tangential[k] = {.slip = local.tangential[k].slip_rate - pair.along(d).speed,
                            .slip_rate = gap_acceleration(contact, time, x, acceleration, d)};
  }
  if (mode(contact).sees_margin)
    change.margin = margin_gradient(contact, time, x)(change);
  return change;
}

// Adds its force, before the division by the mass. Returns the power that moving bases put into it.
double Equations::add_contact(const Acting &acting, double time, ConstVectorView x,
                              VectorView dxdt) const {
  const ContactPair &pair = *acting.pair;
  if (pair.circle)
    return add_circular(acting, time, x, dxdt);
  const auto contact = static_cast<Index>(acting.contact);
  pair.law->evaluate(modes_[acting.contact], local_motion(acting.contact, time, x), response_);
  double *acceleration = dxdt.data() + layout_.velocity();
  for (Index j = 0; j < layout_.n; ++j)
    acceleration[j] += response_.force * pair.gap.row[j];
  for (int i = 0; i < pair.n_internal(); ++i)
    dxdt[layout_.internal() + pair.internal_offset + i] = response_.internal_rate[i];
  dxdt[layout_.impulse(contact)] = response_.force;
  dxdt[layout_.contact_work(contact)] = response_.dissipated_power;
  double power = 0;
  for (const BaseCoefficient &base : component(acting.contact, 0).base_coefficients)
    power -= response_.force * base.factor * source(base.source, 1, time);
  return pair.tangential.empty() ? power : power + add_friction(acting.contact, time, dxdt);
}

// The speed that a direction has by moving bases and surfaces.
double Equations::base_rate(const Component &component, double time) const {
  double rate = component.along.speed;
  for (const BaseCoefficient &base : component.base_coefficients)
    rate += base.factor * source(base.source, 1, time);
  return rate;
}

// Likewise, the law having been evaluated.
double Equations::add_friction(std::size_t contact, double time, VectorView dxdt) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  VectorView acceleration(dxdt.data() + layout_.velocity(), layout_.n);
  double power = 0;
  for (int d = 1; d < pair.n_directions(); ++d) {
    const double force = response_.tangential[static_cast<std::size_t>(d - 1)].force;
    const Component &component = this->component(contact, d);
    acceleration += force * component.along.projection->row.transpose();
    power -= force * base_rate(component, time);
  }
  write_friction(pair, dxdt);
  return power;
}

// What friction takes, the law having been evaluated.
void Equations::write_friction(const ContactPair &pair, VectorView dxdt) const {
  dxdt[layout_.friction_work(pair.sliding_place)] = response_.friction_power;
  dxdt[layout_.wear_work(pair.sliding_place)] = response_.force * response_.sliding_speed;
  dxdt[layout_.sliding_way(pair.sliding_place)] = response_.sliding_speed;
}

// Before the division by the mass.
void Equations::add_contact(std::size_t c, double time, ConstVectorView x, Matrix &jacobian) const {
  const Index n = layout_.n;
  const ContactPair &pair = contacts_.pairs()[c];
  pair.law->evaluate(modes_[c], local_motion(c, time, x), response_);
  if (pair.circle)
    return add_circular(c, time, x, jacobian);
  const RowVector &row = pair.gap.row;
  const Index impulse = layout_.impulse(static_cast<Index>(c));
  jacobian.row(impulse).head(n) = response_.force_by_gap * row;
  jacobian.row(impulse).segment(n, n) = response_.force_by_gap_rate * row;
  jacobian.block(n, 0, n, n) += response_.force_by_gap * row.transpose() * row;
  jacobian.block(n, n, n, n) += response_.force_by_gap_rate * row.transpose() * row;
  const Index first = layout_.internal() + pair.internal_offset;
  for (int i = 0; i < pair.n_internal(); ++i)
    jacobian.col(first + i).segment(n, n) += response_.force_by_internal[i] * row.transpose();
  write_internal_rates(c, jacobian);
  if (!pair.tangential.empty())
    add_friction(c, jacobian);
}

// The law having been evaluated.
void Equations::write_internal_rates(std::size_t c, Matrix &jacobian) const {
  const Index n = layout_.n;
  const ContactPair &pair = contacts_.pairs()[c];
  const RowVector &row = pair.gap.row;
  const Index first = layout_.internal() + pair.internal_offset;
  for (int i = 0; i < pair.n_internal(); ++i) {
    jacobian.row(first + i).head(n) = response_.internal_rate_by_gap[i] * row;
    jacobian.row(first + i).segment(n, n) = response_.internal_rate_by_gap_rate[i] * row;
    for (int j = 0; j < pair.n_internal(); ++j)
      jacobian(first + i, first + j) =
          response_.internal_rate_by_internal[i * pair.n_internal() + j];
    for (int d = 1; d < pair.n_directions(); ++d) {
      const std::vector<double> &by_slip_rate =
          response_.tangential[static_cast<std::size_t>(d - 1)].internal_rate_by_slip_rate;
      if (!by_slip_rate.empty())
        jacobian.row(first + i).segment(n, n) +=
            by_slip_rate[static_cast<std::size_t>(i)] * pair.along(d).projection->row;
    }
  }
}

// The law having been evaluated.
void Equations::add_friction(std::size_t c, Matrix &jacobian) const {
  const Index n = layout_.n;
  const ContactPair &pair = contacts_.pairs()[c];
  const Index first = layout_.internal() + pair.internal_offset;
  for (int d = 1; d < pair.n_directions(); ++d) {
    const contact::TangentialResponse &response =
        response_.tangential[static_cast<std::size_t>(d - 1)];
    const RowVector &row = pair.along(d).projection->row;
    for (int by = 0; by < pair.n_directions(); ++by) {
      const RowVector &seen = pair.along(by).projection->row;
      jacobian.block(n, 0, n, n) += response.by.along(by).position * row.transpose() * seen;
      jacobian.block(n, n, n, n) += response.by.along(by).rate * row.transpose() * seen;
    }
    for (std::size_t i = 0; i < response.by.internal.size(); ++i)
      jacobian.col(first + static_cast<Index>(i)).segment(n, n) +=
          response.by.internal[i] * row.transpose();
  }
}

namespace {

// The rates of the tangential forces are their partial derivatives times the rates of the local
// state.
void add_friction_rates(const Equations &equations, std::size_t contact,
                        const contact::LawResponse &response, EndPoint &point) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  if (pair.tangential.empty())
    return;
  const StateLayout &layout = equations.layout();
  const LocalState change = equations.local_rates(
      contact, point.time, ConstVectorView(point.state.data(), point.state.size()),
      ConstVectorView(point.rates.data(), point.rates.size()));
  for (int d = 1; d < pair.n_directions(); ++d) {
    const auto k = static_cast<std::size_t>(d - 1);
    const contact::TangentialResponse &of = response.tangential[k];
    point.higher.col(0).segment(layout.velocity(), layout.n) +=
        of.by(change) * pair.along(d).projection->row.transpose();
    for (std::size_t i = 0; i < of.internal_rate_by_slip_rate.size(); ++i)
      point.higher(layout.internal() + pair.internal_offset + static_cast<Index>(i), 0) +=
          of.internal_rate_by_slip_rate[i] * change.tangential[k].slip_rate;
  }
}

} // namespace

void add_contact_rates(const Equations &equations, std::size_t contact,
                       contact::LawResponse &response, EndPoint &point) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  if (pair.circle)
    return add_circular_rates(equations, contact, response, point);
  const StateLayout &layout = equations.layout();
  const ConstVectorView x(point.state.data(), point.state.size());
  const LocalState local = equations.local_state(contact, point.time, x);
  const double gap_acceleration = equations.gap_acceleration(
      contact, point.time, x, ConstVectorView(point.rates.data() + layout.n, layout.n));
  pair.law->evaluate(equations.modes()[contact], local, response);
  double force =
      response.force_by_gap * local.gap_rate + response.force_by_gap_rate * gap_acceleration;
  const int count = pair.n_internal();
  const Index first = layout.internal() + pair.internal_offset;
  for (int i = 0; i < count; ++i) {
    force += response.force_by_internal[i] * point.rates[first + i];
    double second = response.internal_rate_by_gap[i] * local.gap_rate +
                    response.internal_rate_by_gap_rate[i] * gap_acceleration;
    for (int j = 0; j < count; ++j)
      second += response.internal_rate_by_internal[i * count + j] * point.rates[first + j];
    point.higher(first + i, 0) = second;
  }
  point.higher.col(0).segment(layout.velocity(), layout.n) += force * pair.gap.row.transpose();
  add_friction_rates(equations, contact, response, point);
}

} // namespace vibroimpact::motion
