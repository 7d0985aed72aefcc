// What a law with friction gives at a local state: both forces, their derivatives, and the work.
#include "contact/friction/frictional_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::contact {

// The derivatives of a rate of the force by the state, beside those that its derivatives have: at
// constant rates of the state they are those of the derivatives of the force along it. By central
// differences over a part h of the penetration, whose error is of the size h^2 / 6 = 2e-9 for
// powers of it, and eps / h = 2e-12 by rounding; only derivatives of motions see it.
void FrictionalLaw::add_curvature(int mode, const LocalState &state, const LawResponse &normal,
                                  AffineForm &rate) const {
  constexpr double part = 1e-4; // of the penetration
  const auto n = static_cast<std::size_t>(normal_->n_internal());
  const double step = std::min(1.0, part * std::abs(state.gap / state.gap_rate));
  if (step == 0)
    return;
  LawResponse side;
  std::vector<double> internal(n);
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < n; ++i)
      internal[i] = state.internal[i] + sign * step * normal.internal_rate[i];
    normal_->evaluate(parts_[static_cast<std::size_t>(mode)].normal,
                      {.gap = state.gap + sign * step * state.gap_rate,
                       .gap_rate = state.gap_rate + sign * step * state.gap_acceleration,
                       .internal = internal},
                      side);
    const double weight = sign / (2 * step);
    rate.gap += weight * side.force_by_gap;
    rate.gap_rate += weight * side.force_by_gap_rate;
    for (std::size_t i = 0; i < n; ++i)
      rate.internal[i] += weight * side.force_by_internal[i];
  }
}

// N' = N_g g' + N_g' g'' + N_z z'
FrictionalLaw::NormalForce FrictionalLaw::normal_force(int mode, const LocalState &state,
                                                       const LawResponse &normal) const {
  const auto n = static_cast<std::size_t>(normal_->n_internal());
  NormalForce made;
  made.force = {.gap = normal.force_by_gap,
                .gap_rate = normal.force_by_gap_rate,
                .internal = {normal.force_by_internal.begin(), normal.force_by_internal.end()}};
  if (!modes()[static_cast<std::size_t>(mode)].sees_force_rate)
    return made;
  made.rate = {.gap_rate = normal.force_by_gap, .internal = std::vector<double>(n, 0.0)};
  made.by_gap_acceleration = normal.force_by_gap_rate;
  for (std::size_t k = 0; k < n; ++k) {
    const double by_internal = normal.force_by_internal[k];
    made.rate.gap += by_internal * normal.internal_rate_by_gap[k];
    made.rate.gap_rate += by_internal * normal.internal_rate_by_gap_rate[k];
    for (std::size_t j = 0; j < n; ++j)
      made.rate.internal[j] += by_internal * normal.internal_rate_by_internal[k * n + j];
  }
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  if (!normal_->modes()[static_cast<std::size_t>(part.normal)].affine)
    add_curvature(mode, state, normal, made.rate);
  return made;
}

// At a state that has the normal force.
TangentialValues FrictionalLaw::friction(int mode, const LocalState &state) const {
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  const AffineLaw &forms = forms_[static_cast<std::size_t>(mode)];
  TangentialValues values;
  if (part.evaluated) {
    tangential_->evaluate(part.tangential, state, n_normal, values);
    return values;
  }
  const auto of = [&](const AffineForm &form) {
    TangentialValue made{.value = form(state), .by = form};
    made.by.constant = 0;
    return made;
  };
  for (std::size_t k = 0; k < static_cast<std::size_t>(n_tangential()); ++k)
    values.force[k] = of(forms.tangential_force[k]);
  for (std::size_t i = n_normal; i < forms.internal_rate.size(); ++i)
    values.internal_rate.push_back(of(forms.internal_rate[i]));
  values.sliding_speed = forms.sliding_speed(state);
  return values;
}

// The internal states of the normal law stand before those of the tangential one. A force that
// holds the gap is no function of the state: derivatives by it stay.
void FrictionalLaw::add_friction(int mode, const NormalForce &normal,
                                 const TangentialValues &friction, LawResponse &response) const {
  const bool held = modes()[static_cast<std::size_t>(mode)].holds_gap;
  const auto by_state = [&](AffineForm by) {
    if (held)
      return by;
    const double force = std::exchange(by.normal_force, 0);
    const double rate = std::exchange(by.normal_force_rate, 0);
    if (force != 0)
      by += force * normal.force;
    if (rate != 0)
      by += rate * normal.rate;
    return by;
  };
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  const auto n = static_cast<std::size_t>(n_internal());
  const auto directions = static_cast<std::size_t>(n_tangential());
  for (std::size_t k = 0; k < directions; ++k) {
    TangentialResponse &tangential = response.tangential[k];
    tangential.force = friction.force[k].value;
    tangential.by = by_state(friction.force[k].by);
    tangential.internal_rate_by_slip_rate.assign(n, 0);
  }
  if (directions > 1) {
    response.margin = friction.margin.value;
    response.margin_by = friction.margin.by;
  }
  for (std::vector<double> *list :
       {&response.force_by_internal, &response.internal_rate, &response.internal_rate_by_gap,
        &response.internal_rate_by_gap_rate})
    list->resize(n, 0);
  response.internal_rate_by_gap_acceleration.assign(n, 0);
  std::vector<double> by_internal(n * n, 0.0);
  for (std::size_t i = 0; i < n_normal; ++i)
    std::copy_n(response.internal_rate_by_internal.data() + i * n_normal, n_normal,
                by_internal.data() + i * n);
  for (std::size_t i = n_normal; i < n; ++i) {
    const TangentialValue &rate = friction.internal_rate[i - n_normal];
    const AffineForm by = by_state(rate.by);
    response.force_by_internal[i] = 0;
    response.internal_rate[i] = rate.value;
    response.internal_rate_by_gap[i] = by.gap;
    response.internal_rate_by_gap_rate[i] = by.gap_rate;
    response.internal_rate_by_gap_acceleration[i] =
        rate.by.normal_force_rate * normal.by_gap_acceleration;
    std::copy(by.internal.begin(), by.internal.end(), by_internal.data() + i * n);
    for (std::size_t k = 0; k < directions; ++k)
      response.tangential[k].internal_rate_by_slip_rate[i] = by.tangential[k].rate;
  }
  response.internal_rate_by_internal = std::move(by_internal);
}

namespace {

double power_taken(const TangentialValues &friction, const LocalState &state, int directions) {
  double power = -friction.force[0].value * state.tangential[0].slip_rate;
  for (std::size_t k = 1; k < static_cast<std::size_t>(directions); ++k)
    power -= friction.force[k].value * state.tangential[k].slip_rate;
  return power;
}

} // namespace

// What goes in, less what deforms stores; where all of it deforms, what the dashpots take. Terms
// that cancel would hide the others.
void FrictionalLaw::add_work(int mode, const LocalState &state, const TangentialValues &friction,
                             LawResponse &response) const {
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  const bool sticks = modes()[static_cast<std::size_t>(mode)].friction == Friction::stick;
  response.sliding_speed = friction.sliding_speed;
  response.friction_power = sticks ? 0 : power_taken(friction, state, n_tangential());
  for (std::size_t i = 0; i < friction.internal_rate.size(); ++i) {
    const double deformation = state.internal[n_normal + i];
    const double rate = friction.internal_rate[i].value;
    const double pull = tangential_->stiffness() * deformation;
    response.stored_energy += 0.5 * pull * deformation;
    response.friction_power += (sticks ? tangential_->damping_constant() * rate : -pull) * rate;
  }
  response.dissipated_power += response.friction_power;
}

void FrictionalLaw::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  normal_->evaluate(parts_[static_cast<std::size_t>(mode)].normal, of_normal(state), response);
  LocalState seen = state;
  seen.normal_force = response.force;
  const TangentialValues values = friction(mode, seen);
  const NormalForce normal = normal_force(mode, state, response);
  add_friction(mode, normal, values, response);
  add_work(mode, state, values, response);
}

} // namespace vibroimpact::contact
