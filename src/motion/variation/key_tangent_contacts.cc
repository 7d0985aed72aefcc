// How what contacts see of the motion, and the forces of their laws, change with a key at fixed
// coordinates and velocities.
#include "common/error.h"
#include "motion/variation/key_tangent.h"

namespace vibroimpact::motion {

using contact::AcrossAxis;
using contact::AffineForm;
using contact::CircularFrame;
using contact::ContactPair;
using contact::LawResponse;
using contact::LocalState;

namespace {

ConstVectorView seen(const Vector &vector) { return {vector.data(), vector.size()}; }

double along(const AcrossAxis &a, const AcrossAxis &b) { return a[0] * b[0] + a[1] * b[1]; }

} // namespace

double KeyTangent::position(std::size_t contact, double time, const Vector &state,
                            int direction) const {
  const DirectionTangent &tangent = data_->along(contact, direction);
  return tangent.offset + tangent.projection.row.dot(state.head(model_.size())) +
         gap_by_sources(contact, time, 0, direction);
}

double KeyTangent::rate(std::size_t contact, double time, const Vector &state,
                        int direction) const {
  const DirectionTangent &tangent = data_->along(contact, direction);
  return tangent.projection.row.dot(state.segment(model_.size(), model_.size())) + tangent.speed +
         gap_by_sources(contact, time, 1, direction);
}

// Of its derivative by time of the given order, through moving bases.
double KeyTangent::gap_by_sources(std::size_t contact, double time, std::size_t order,
                                  int direction) const {
  const std::vector<double> &own =
      contacts_.pairs()[contact].along(direction).projection->base_coefficients;
  const std::vector<double> &tangent =
      data_->along(contact, direction).projection.base_coefficients;
  double change = 0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (own[k] != 0)
      change += own[k] * sources_->at(k, time)[order];
    if (tangent[k] != 0)
      change += tangent[k] * sources_->value(k, time)[order];
  }
  return change;
}

// u and u' of a circular gap.
contact::RelativeMotion KeyTangent::relative_motion(std::size_t contact, double time,
                                                    const Vector &state) const {
  const Index n = model_.size();
  contact::RelativeMotion motion;
  for (int d = 0; d < 2; ++d) {
    const contact::Direction of = contacts_.pairs()[contact].along(d);
    const auto place = static_cast<std::size_t>(d);
    motion.position[place] = of.offset + of.projection->row.dot(state.head(n));
    motion.rate[place] = of.speed + of.projection->row.dot(state.segment(n, n));
    for (std::size_t k = 0; k < of.projection->base_coefficients.size(); ++k)
      if (const double factor = of.projection->base_coefficients[k]; factor != 0) {
        motion.position[place] += factor * sources_->value(k, time)[0];
        motion.rate[place] += factor * sources_->value(k, time)[1];
      }
  }
  return motion;
}

// What u and u' change by.
contact::RelativeMotion KeyTangent::moved(std::size_t contact, double time,
                                          const Vector &state) const {
  return {.position = {position(contact, time, state, 0), position(contact, time, state, 1)},
          .rate = {rate(contact, time, state, 0), rate(contact, time, state, 1)}};
}

// With g = s (c - r), beside what u and u' make of them, dg = s dc and dv = dV.
LocalState KeyTangent::moved_local_state(std::size_t contact, double time,
                                         const Vector &state) const {
  const contact::CircularGap &circle = *contacts_.pairs()[contact].circle;
  const CircularFrame frame = circle.frame(relative_motion(contact, time, state));
  const contact::RelativeMotion by = moved(contact, time, state);
  LocalState change{.gap = by.position[0], .gap_rate = by.rate[0]};
  change.tangential[0] = {.slip = by.position[1], .slip_rate = by.rate[1]};
  const auto of = [&](const AffineForm &form) { return circle.gradient(frame, form)(change); };
  LocalState local{.gap = of(AffineForm::position_along(0)) +
                          circle.sense() * data_->circle(contact).clearance,
                   .gap_rate = of(AffineForm::rate_along(0))};
  local.tangential[0].slip_rate =
      of(AffineForm::rate_along(1)) + data_->circle(contact).surface_speed;
  return local;
}

double KeyTangent::gap(std::size_t contact, double time, const Vector &state, int direction) const {
  if (!contacts_.pairs()[contact].circle)
    return position(contact, time, state, direction);
  return direction == 0 ? moved_local_state(contact, time, state).gap : 0;
}

double KeyTangent::gap_rate(std::size_t contact, double time, const Vector &state,
                            int direction) const {
  if (!contacts_.pairs()[contact].circle)
    return rate(contact, time, state, direction);
  const LocalState local = moved_local_state(contact, time, state);
  return direction == 0 ? local.gap_rate : local.tangential[0].slip_rate;
}

KeyTangent::ContactTangent KeyTangent::contact(const Equations &equations, std::size_t contact,
                                               double time, const Vector &state,
                                               LawResponse &own) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  const int mode = equations.modes()[contact];
  const LocalState local = equations.local_state(contact, time, seen(state));
  pair.law->evaluate(mode, local, own);
  ContactTangent tangent{.gap = gap(contact, time, state),
                         .gap_rate = gap_rate(contact, time, state),
                         .internal_rates = Vector::Zero(pair.n_internal())};
  const bool slides = pair.law->n_tangential() > 0;
  const double slip = slides ? gap(contact, time, state, 1) : 0;
  tangent.slip_rate = slides ? gap_rate(contact, time, state, 1) : 0;
  tangent.force = own.force_by_gap * tangent.gap + own.force_by_gap_rate * tangent.gap_rate;
  const AffineForm &by = own.tangential[0].by;
  tangent.tangential_force = by.gap * tangent.gap + by.gap_rate * tangent.gap_rate +
                             by.tangential[0].position * slip +
                             by.tangential[0].rate * tangent.slip_rate;
  const std::vector<double> &by_slip_rate = own.tangential[0].internal_rate_by_slip_rate;
  for (Index i = 0; i < pair.n_internal(); ++i) {
    const auto place = static_cast<std::size_t>(i);
    tangent.internal_rates[i] = own.internal_rate_by_gap[place] * tangent.gap +
                                own.internal_rate_by_gap_rate[place] * tangent.gap_rate +
                                (slides ? by_slip_rate[place] * tangent.slip_rate : 0);
  }
  for (const Near &near : near_) {
    LawResponse other;
    near.data.contacts->pairs()[contact].law->evaluate(mode, local, other);
    tangent.force += near.weight * (other.force - own.force);
    tangent.tangential_force += near.weight * (other.tangential[0].force - own.tangential[0].force);
    for (Index i = 0; i < pair.n_internal(); ++i) {
      const auto place = static_cast<std::size_t>(i);
      tangent.internal_rates[i] +=
          near.weight * (other.internal_rate[place] - own.internal_rate[place]);
    }
  }
  return tangent;
}

// d(f row^T) with df = dN n + dF t + (F n - N t) s (t . du) / r along both directions of u
Vector KeyTangent::circular_force(const Equations &equations, std::size_t contact, double time,
                                  const Vector &state, const ContactTangent &tangent,
                                  const LawResponse &own) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  const CircularFrame frame = equations.frame(contact, time, seen(state));
  const AcrossAxis force = pair.circle->force(frame, own);
  const double moved_along = along(frame.tangent, moved(contact, time, state).position);
  const double turned =
      frame.distance > 0 ? pair.circle->sense() / frame.distance * moved_along : 0;
  const double friction = own.tangential[0].force;
  Vector change = Vector::Zero(model_.size());
  for (int d = 0; d < 2; ++d) {
    const auto k = static_cast<std::size_t>(d);
    const double by_key = tangent.force * frame.normal[k] +
                          tangent.tangential_force * frame.tangent[k] +
                          (friction * frame.normal[k] - own.force * frame.tangent[k]) * turned;
    change += by_key * pair.along(d).projection->row.transpose() +
              force[k] * data_->along(contact, d).projection.row.transpose();
  }
  return change;
}

// dF/dp, and into `change` that of the rates of internal states.
KeyTangent::Forces KeyTangent::forces(const Equations &equations, double time, const Vector &state,
                                      const Vector &rates, Vector &change) const {
  const StateLayout &layout = equations.layout();
  Forces forces{.present = rates.segment(layout.impulse(0), layout.n_contacts),
                .change = Vector::Zero(layout.n)};
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    if (equations.inactive(c) || equations.mode(c).holds_gap)
      continue;
    const ContactPair &pair = contacts_.pairs()[c];
    LawResponse own;
    const ContactTangent tangent = contact(equations, c, time, state, own);
    change.segment(layout.internal() + pair.internal_offset, pair.n_internal()) +=
        tangent.internal_rates;
    if (pair.circle) {
      forces.present[static_cast<Index>(c)] = 0; // all of it is in the change
      forces.change += circular_force(equations, c, time, state, tangent, own);
      continue;
    }
    forces.change += tangent.force * pair.gap.row.transpose();
    if (!pair.tangential.empty())
      forces.change += tangent.tangential_force * pair.along(1).projection->row.transpose() +
                       own.tangential[0].force * data_->along(c, 1).projection.row.transpose();
  }
  return forces;
}

double KeyTangent::normal_force(const Equations &equations, std::size_t contact, double time,
                                const Vector &state) const {
  LawResponse own;
  return this->contact(equations, contact, time, state, own).force;
}

// What holds the slip, and the rate of the normal force, follow from accelerations.
void KeyTangent::refuse_friction(const Equations &equations) const {
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (equations.mode(c).holds_slip || equations.mode(c).sees_force_rate)
      throw NumericalError("contact " + contacts_.pairs()[c].name +
                           ": in a phase that is not linear sides that stick, and spring-sliders "
                           "without a dashpot, have no known derivative by keys");
}

} // namespace vibroimpact::motion
