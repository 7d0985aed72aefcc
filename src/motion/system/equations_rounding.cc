// How exactly forms of contacts are evaluated: the sizes of all terms that they are sums of.
#include "motion/system/equations.h"

#include <cmath>

namespace vibroimpact::motion {

using contact::ContactPair;
using model::TimeFunction;

namespace {

// sum += |A| |x|
void add_magnitudes(const model::LinearForm &form, const double *values, Vector &sum) {
  const auto x = ConstVectorView(values, sum.size()).cwiseAbs();
  sum += form.diagonal.cwiseAbs().cwiseProduct(x);
  if (form.coupling.size() > 0)
    sum.noalias() += form.coupling.cwiseAbs() * x;
}

} // namespace

// Sums of the absolute values of the terms of position and rate.
std::pair<double, double> Equations::magnitude_along(const Component &component, double time,
                                                     const Vector &x) const {
  const auto of_row = [&](Index first) {
    return component.along.projection->row.cwiseAbs().dot(x.segment(first, layout_.n).cwiseAbs());
  };
  double position = std::abs(component.along.offset) + of_row(0);
  double rate = std::abs(component.along.speed) + of_row(layout_.velocity());
  for (const BaseCoefficient &base : component.base_coefficients) {
    const TimeFunction &function = *model_.sources()[base.source].function;
    position += std::abs(base.factor * function.value(source_time(time)));
    rate += std::abs(base.factor * function.rate(source_time(time)));
  }
  return {position, rate};
}

double Equations::magnitude(std::size_t contact, const contact::AffineForm &form, double time,
                            const Vector &x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  double sum = std::abs(form.constant);
  if (pair.circle)
    sum += circular_magnitude(contact, form, time, x);
  for (int d = 0; d < pair.n_directions() && !pair.circle; ++d) {
    const contact::DirectionForm along = form.along(d);
    const auto [position, rate] = magnitude_along(component(contact, d), time, x);
    sum += std::abs(along.position) * position + std::abs(along.rate) * rate;
  }
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    sum += std::abs(form.internal[i] *
                    x[layout_.internal() + pair.internal_offset + static_cast<Index>(i)]);
  for (int d = 0; d < pair.n_directions(); ++d)
    if (const double factor = form.along(d).force; factor != 0 && mode(contact).holds(d))
      sum += std::abs(factor) * force_magnitude(contact, d, time, x);
  if (form.margin != 0)
    sum += std::abs(form.margin) *
           magnitude(contact, margin_gradient(contact, time, ConstVectorView(x.data(), x.size())),
                     time, x);
  return form.sees_normal_force() && !mode(contact).holds_gap
             ? sum + normal_force_magnitude(contact, form, time, x)
             : sum;
}

double Equations::rounding(std::size_t contact, const contact::AffineForm &form, double time,
                           const Vector &x) const {
  return rounding_factor * magnitude(contact, form, time, x);
}

double Equations::acceleration_rounding(std::size_t contact, double time, const Vector &x,
                                        int direction) const {
  const auto along = [&](int d) {
    const Component &component = this->component(contact, d);
    if (component.along.projection->row.isZero(0))
      return 0.0;
    double sum = acceleration_of_forces(component, time, x);
    for (const BaseCoefficient &base : component.base_coefficients)
      sum += std::abs(base.factor * source(base.source, 2, time));
    return sum;
  };
  if (!contacts_.pairs()[contact].circle)
    return rounding_factor * along(direction);
  return rounding_factor * (along(0) + along(1) + turning_acceleration(contact, time, x));
}

// |s w^2 / r| and |s g' w / r| <= |u'|^2 / r
double Equations::turning_acceleration(std::size_t contact, double time, const Vector &x) const {
  const contact::CircularFrame at = frame(contact, time, ConstVectorView(x.data(), x.size()));
  const double square = at.gap_rate * at.gap_rate + at.turning * at.turning;
  return at.distance > 0 ? square / at.distance : 0;
}

// Sum of the sizes of all that forces make of an acceleration.
double Equations::acceleration_of_forces(const Component &component, double time,
                                         const Vector &x) const {
  load(time);
  Vector &forces = elastic_;
  forces = load_.cwiseAbs();
  add_magnitudes(model_.stiffness(), x.data(), forces);
  add_magnitudes(model_.damping(), x.data() + layout_.velocity(), forces);
  const RowVector &row = component.along.projection->row;
  double sum = 0;
  for (Index j = 0; j < layout_.n; ++j)
    sum += std::abs(row[j]) * forces[j] / model_.mass()[j];
  return sum;
}

// Sum of the sizes of all that the force which holds a direction is made of.
double Equations::force_magnitude(std::size_t contact, int direction, double time,
                                  const Vector &x) const {
  if (!contacts_.pairs()[contact].circle)
    return acceleration_of_forces(component(contact, direction), time, x) *
           contacts_.effective_mass(contact, model_, direction);
  const RowVector row = row_along(contact, direction, time, ConstVectorView(x.data(), x.size()));
  const double acceleration = acceleration_of_forces(component(contact, 0), time, x) +
                              acceleration_of_forces(component(contact, 1), time, x) +
                              turning_acceleration(contact, time, x);
  return acceleration / row.cwiseQuotient(model_.mass().transpose()).dot(row);
}

} // namespace vibroimpact::motion
