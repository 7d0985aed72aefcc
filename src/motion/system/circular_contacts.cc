// What the equations have of contacts in circular gaps: their forces are vectors across the axis.
#include "motion/system/equations.h"
#include "motion/system/friction_rates.h"

#include <cmath>
#include <tuple>

namespace vibroimpact::motion {

using contact::AcrossAxis;
using contact::AffineForm;
using contact::CircularFrame;
using contact::ContactPair;
using contact::RelativeMotion;

RelativeMotion Equations::relative_motion(std::size_t contact, double time,
                                          ConstVectorView x) const {
  RelativeMotion motion;
  for (int d = 0; d < 2; ++d) {
    const auto k = static_cast<std::size_t>(d);
    std::tie(motion.position[k], motion.rate[k]) = motion_along(component(contact, d), time, x);
  }
  return motion;
}

AcrossAxis Equations::relative_acceleration(std::size_t contact, double time,
                                            ConstVectorView acceleration) const {
  return {acceleration_along(component(contact, 0), time, acceleration),
          acceleration_along(component(contact, 1), time, acceleration)};
}

CircularFrame Equations::frame(std::size_t contact, double time, ConstVectorView x) const {
  return contacts_.pairs()[contact].circle->frame(relative_motion(contact, time, x));
}

RowVector Equations::row_along(std::size_t contact, int direction, double time,
                               ConstVectorView x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  if (!pair.circle)
    return pair.along(direction).projection->row;
  const CircularFrame at = frame(contact, time, x);
  const AcrossAxis &axis = direction == 0 ? at.normal : at.tangent;
  return axis[0] * pair.gap.row + axis[1] * pair.circle->second().row;
}

// The speed that moving bases and surfaces give to a direction.
double Equations::carried_along(std::size_t contact, int direction, double time,
                                ConstVectorView x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  if (!pair.circle)
    return base_rate(component(contact, direction), time);
  const CircularFrame at = frame(contact, time, x);
  const AcrossAxis &axis = direction == 0 ? at.normal : at.tangent;
  return axis[0] * base_rate(component(contact, 0), time) +
         axis[1] * base_rate(component(contact, 1), time) +
         (direction == 0 ? 0 : pair.circle->surface_speed());
}

// Before the division by the mass. A surface that moves puts in the power -F V.
double Equations::add_circular(const Acting &acting, double time, ConstVectorView x,
                               VectorView dxdt) const {
  const ContactPair &pair = *acting.pair;
  const auto contact = static_cast<Index>(acting.contact);
  const CircularFrame at = frame(acting.contact, time, x);
  pair.law->evaluate(modes_[acting.contact], local_motion(acting.contact, time, x), response_);
  const AcrossAxis force = pair.circle->force(at, response_);
  VectorView acceleration(dxdt.data() + layout_.velocity(), layout_.n);
  double power = -response_.tangential[0].force * pair.circle->surface_speed();
  for (int d = 0; d < 2; ++d) {
    const Component &component = this->component(acting.contact, d);
    const double along = force[static_cast<std::size_t>(d)];
    acceleration += along * component.along.projection->row.transpose();
    power -= along * base_rate(component, time);
  }
  for (int i = 0; i < pair.n_internal(); ++i)
    dxdt[layout_.internal() + pair.internal_offset + i] = response_.internal_rate[i];
  dxdt[layout_.impulse(contact)] = response_.force;
  dxdt[layout_.contact_work(contact)] = response_.dissipated_power;
  if (!pair.tangential.empty())
    write_friction(pair, dxdt);
  return power;
}

// row(place) = the gradient that these coefficients of u and u' are.
void Equations::write_row(std::size_t contact, const AffineForm &components, Index place,
                          Matrix &jacobian) const {
  jacobian.row(place).setZero();
  add_rows(contact, components, Vector::Unit(jacobian.rows(), place), jacobian);
}

// jacobian += into * the gradient
void Equations::add_rows(std::size_t contact, const AffineForm &components, const Vector &into,
                         Matrix &jacobian) const {
  const Index n = layout_.n;
  const ContactPair &pair = contacts_.pairs()[contact];
  for (int d = 0; d < 2; ++d) {
    const RowVector &row = pair.along(d).projection->row;
    jacobian.leftCols(n) += components.along(d).position * into * row;
    jacobian.middleCols(n, n) += components.along(d).rate * into * row;
  }
  for (std::size_t i = 0; i < components.internal.size(); ++i)
    jacobian.col(layout_.internal() + pair.internal_offset + static_cast<Index>(i)) +=
        components.internal[i] * into;
}

// Before the division by the mass, the law having been evaluated.
void Equations::add_circular(std::size_t c, double time, ConstVectorView x,
                             Matrix &jacobian) const {
  const ContactPair &pair = contacts_.pairs()[c];
  const CircularFrame at = frame(c, time, x);
  write_row(c, pair.circle->gradient(at, normal_force_gradient(response_)),
            layout_.impulse(static_cast<Index>(c)), jacobian);
  const std::array<AffineForm, 2> force = pair.circle->force_gradient(at, response_);
  for (int d = 0; d < 2; ++d) {
    Vector into = Vector::Zero(jacobian.rows());
    into.segment(layout_.velocity(), layout_.n) = pair.along(d).projection->row.transpose();
    add_rows(c, force[static_cast<std::size_t>(d)], into, jacobian);
  }
  write_circular_rates(c, time, x, jacobian);
}

// Of internal states, the law having been evaluated.
void Equations::write_circular_rates(std::size_t c, double time, ConstVectorView x,
                                     Matrix &jacobian) const {
  const ContactPair &pair = contacts_.pairs()[c];
  const CircularFrame at = frame(c, time, x);
  for (int i = 0; i < pair.n_internal(); ++i)
    write_row(c, pair.circle->gradient(at, internal_rate_gradient(response_, i, pair.n_internal())),
              layout_.internal() + pair.internal_offset + i, jacobian);
}

// The rows of the accelerations are complete.
RowVector Equations::gap_acceleration_row(std::size_t contact, double time, ConstVectorView x,
                                          const Matrix &jacobian) const {
  const auto accelerations = jacobian.middleRows(layout_.velocity(), layout_.n);
  RowVector row = row_along(contact, 0, time, x) * accelerations;
  const ContactPair &pair = contacts_.pairs()[contact];
  if (!pair.circle)
    return row;
  Vector rates(layout_.size());
  this->rates(time, x, VectorView(rates.data(), rates.size()));
  const AcrossAxis acceleration = relative_acceleration(
      contact, time, ConstVectorView(rates.data() + layout_.velocity(), layout_.n));
  Matrix by_frame = Matrix::Zero(1, jacobian.cols());
  add_rows(contact, pair.circle->acceleration_gradient(frame(contact, time, x), acceleration, 0),
           Vector::Ones(1), by_frame);
  return row + by_frame.row(0);
}

// |g| <= c + |u_1| + |u_2|, |g'| and |t . u'| <= |u_1'| + |u_2'|
double Equations::circular_magnitude(std::size_t contact, const AffineForm &form, double time,
                                     const Vector &x) const {
  const contact::CircularGap &circle = *contacts_.pairs()[contact].circle;
  double position = circle.clearance();
  double rate = 0;
  for (int d = 0; d < 2; ++d) {
    const auto [of_position, of_rate] = magnitude_along(component(contact, d), time, x);
    position += of_position;
    rate += of_rate;
  }
  const double slip_rate = rate + std::abs(circle.surface_speed());
  return std::abs(form.gap) * position + std::abs(form.gap_rate) * rate +
         std::abs(form.tangential[0].rate) * slip_rate;
}

// The partial derivatives by u, u' and internal states, times the rates of these.
void add_circular_rates(const Equations &equations, std::size_t contact,
                        contact::LawResponse &response, EndPoint &point) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  const ConstVectorView x(point.state.data(), point.state.size());
  pair.law->evaluate(equations.modes()[contact], equations.local_state(contact, point.time, x),
                     response);
  const CircularFrame at = equations.frame(contact, point.time, x);
  const contact::LocalState change = equations.relative_rates(
      contact, point.time, x, ConstVectorView(point.rates.data(), point.rates.size()));
  const std::array<AffineForm, 2> force = pair.circle->force_gradient(at, response);
  for (int d = 0; d < 2; ++d)
    point.higher.col(0).segment(layout.velocity(), layout.n) +=
        force[static_cast<std::size_t>(d)](change) * pair.along(d).projection->row.transpose();
  for (int i = 0; i < pair.n_internal(); ++i)
    point.higher(layout.internal() + pair.internal_offset + i, 0) =
        pair.circle->gradient(at, internal_rate_gradient(response, i, pair.n_internal()))(change);
}

contact::LocalState Equations::relative_rates(std::size_t contact, double time, ConstVectorView x,
                                              ConstVectorView rates) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  const RelativeMotion motion = relative_motion(contact, time, x);
  const AcrossAxis acceleration = relative_acceleration(
      contact, time, ConstVectorView(rates.data() + layout_.velocity(), layout_.n));
  contact::LocalState change{.gap = motion.rate[0],
                             .gap_rate = acceleration[0],
                             .internal = {rates.data() + layout_.internal() + pair.internal_offset,
                                          static_cast<std::size_t>(pair.n_internal())}};
  change.tangential[0] = {.slip = motion.rate[1], .slip_rate = acceleration[1]};
  return change;
}

} // namespace vibroimpact::motion
