#include "motion/system/equations.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace vibroimpact::motion {

using contact::ContactPair;
using contact::LocalState;
using model::RotorSet;

Equations::Equations(const model::Model &model, const contact::ContactSet &contacts)
    : model_(model), contacts_(contacts), layout_{.n = model.size(),
                                                  .n_internal = contacts.n_internal(),
                                                  .n_drive = model.n_drive(),
                                                  .n_contacts = static_cast<Index>(contacts.size()),
                                                  .n_sliding = contacts.n_sliding()},
      modes_(contacts.size(), 0), slow_slip_(contacts.size(), 0.0), sources_(model) {
  for (const ContactPair &pair : contacts.pairs()) {
    std::vector<char> inactive;
    for (const contact::Mode &mode : pair.law->modes())
      inactive.push_back(pair.n_internal() == 0 && !mode.in_contact && mode.affine &&
                         mode.affine->force.zero());
    inactive_.push_back(std::move(inactive));
    first_component_.push_back(components_.size());
    for (int d = 0; d < pair.n_directions(); ++d) {
      Component component{.along = pair.along(d), .base_coefficients = {}};
      const std::vector<double> &factors = component.along.projection->base_coefficients;
      for (std::size_t k = 0; k < factors.size(); ++k)
        if (factors[k] != 0)
          component.base_coefficients.push_back({.source = k, .factor = factors[k]});
      components_.push_back(std::move(component));
    }
  }
  constraints_ = ActiveConstraints(model_, contacts_, modes_);
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    list(c);
}

// In the present mode of the contact; both lists ascend.
void Equations::list(std::size_t contact) {
  const auto keep = [&](auto &list, auto key, const auto &entry, bool wanted) {
    const auto place = std::ranges::lower_bound(list, contact, {}, key);
    const bool listed = place != list.end() && std::invoke(key, *place) == contact;
    if (wanted && !listed)
      list.insert(place, entry);
    else if (listed && !wanted)
      list.erase(place);
  };
  keep(acting_, &Acting::contact, Acting{.contact = contact, .pair = &contacts_.pairs()[contact]},
       !inactive(contact) && !mode(contact).holds_gap);
  keep(following_, std::identity{}, contact, mode(contact).sees_force_rate);
}

void Equations::set_mode(std::size_t contact, int mode) {
  if (modes_[contact] == mode)
    return;
  const ContactPair &pair = contacts_.pairs()[contact];
  const contact::Mode &next = pair.law->modes()[static_cast<std::size_t>(mode)];
  if (pair.circle && next.holds_slip && !next.holds_gap)
    throw NumericalError("contact " + pair.name +
                         " comes to stick in its circular gap, where sides that a finite force "
                         "parts slip only; a spring-slider sticks by a spring");
  if (!pair.tangential.empty() && !pair.circle)
    refuse_jamming(model_, pair, mode);
  const bool held = this->mode(contact).holds();
  modes_[contact] = mode;
  list(contact);
  if (held || this->mode(contact).holds())
    constraints_ = ActiveConstraints(model_, contacts_, modes_);
}

bool Equations::inactive(std::size_t contact) const {
  return inactive_[contact][static_cast<std::size_t>(modes_[contact])] != 0;
}

void Equations::set_source_break(double instant) {
  source_break_ = instant;
  last_source_time_ = std::isinf(instant)
                          ? instant
                          : std::nextafter(instant, -std::numeric_limits<double>::infinity());
}

void Equations::source_values(double time, std::vector<SourceValues> &values) const {
  values.resize(model_.sources().size());
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = {source(k, 0, time), source(k, 1, time), source(k, 2, time)};
}

void Equations::load(double time) const {
  model_.load([&](std::size_t k, std::size_t derivative) { return source(k, derivative, time); },
              load_);
}

void Equations::rates(double time, ConstVectorView x, VectorView dxdt) const {
  const Index n = layout_.n;
  const ConstVectorView velocity(x.data() + layout_.velocity(), n);
  load(time);
  model_.stiffness().apply(ConstVectorView(x.data(), n), elastic_);
  model_.damping().apply(velocity, damping_);

  double *acceleration = dxdt.data() + layout_.velocity();
  double input_power = 0;
  double damping_power = 0;
  for (Index j = 0; j < n; ++j) {
    dxdt[j] = velocity[j];
    acceleration[j] = load_[j] - elastic_[j] - damping_[j];
    input_power += load_[j] * velocity[j];
    damping_power += damping_[j] * velocity[j];
  }
  std::fill_n(&dxdt[layout_.integrals()], layout_.size() - layout_.integrals(), 0.0);
  if (model_.circulatory().size() > 0)
    input_power += model_.circulatory_power(ConstVectorView(x.data(), n), velocity);
  for (const Acting &acting : acting_)
    input_power += add_contact(acting, time, x, dxdt);
  if (!model_.linear())
    input_power += add_nonlinear_forces(time, x, dxdt);
  else
    for (Index j = 0; j < n; ++j)
      acceleration[j] /= model_.mass()[j];
  if (!constraints_.empty())
    input_power += hold(time, x, dxdt);
  if (!following_.empty())
    follow_force_rates(time, x, dxdt);
  dxdt[layout_.input_work()] = input_power;
  dxdt[layout_.absolute_input_work()] = std::abs(input_power);
  dxdt[layout_.damping_work()] = damping_power;
}

// Rotors add to the inertia of their points.
Matrix Equations::response_to(const Matrix &rows, double time, ConstVectorView x) const {
  Matrix response = model_.mass().cwiseInverse().asDiagonal() * rows.transpose();
  const RotorSet &rotors = model_.rotors();
  if (rotors.empty())
    return response;
  const Index n = layout_.n;
  const ConstVectorView q(x.data(), n);
  const ConstVectorView velocity(x.data() + layout_.velocity(), n);
  model_.rotor_frame(source_time(time), frame_);
  Vector unloaded = Vector::Zero(n);
  rotors.couple(model_.mass(), q, velocity, frame_, VectorView(unloaded.data(), n));
  for (Index k = 0; k < response.cols(); ++k)
    rotors.couple(model_.mass(), q, velocity, frame_, VectorView(response.col(k).data(), n));
  return response.colwise() - unloaded;
}

// Cubic springs, run-ups and rotors; divides by the mass. Returns the power they take in.
double Equations::add_nonlinear_forces(double time, ConstVectorView x, VectorView dxdt) const {
  const Index n = layout_.n;
  const ConstVectorView q(x.data(), n);
  const ConstVectorView velocity(x.data() + layout_.velocity(), n);
  const ConstVectorView drive(x.data() + layout_.drive(), layout_.n_drive);
  VectorView acceleration(dxdt.data() + layout_.velocity(), n);
  double power = model_.add_cubic_forces(source_time(time), q, acceleration);
  power += model_.add_run_up_forces(source_time(time), q, velocity, acceleration);
  const RotorSet &rotors = model_.rotors();
  if (rotors.empty()) {
    acceleration.array() /= model_.mass().array();
    return power;
  }
  model_.rotor_frame(source_time(time), frame_);
  rotors.add_torques(drive, acceleration);
  acceleration.array() /= model_.mass().array();
  rotors.couple(model_.mass(), q, velocity, frame_, acceleration);
  rotors.drive_rates(velocity, drive, VectorView(dxdt.data() + layout_.drive(), layout_.n_drive));
  return power + rotors.input_power(q, velocity, drive, frame_);
}

// Of the work integrals, whose integrals do not act back, only the work of loads and the impulses:
// an implicit method solves for them as exactly as for the motion.
void Equations::jacobian(double time, ConstVectorView x, Matrix &jacobian) const {
  const Index n = layout_.n;
  jacobian.setZero(layout_.size(), layout_.size());
  jacobian.block(0, n, n, n).setIdentity();
  jacobian.block(n, 0, n, n) = -model_.stiffness().dense();
  jacobian.block(n, n, n, n) = -model_.damping().dense();
  if (!model_.linear())
    add_nonlinear_forces(time, x, jacobian);
  load(time);
  jacobian.row(layout_.input_work()).segment(n, n) = load_.transpose();
  if (const Matrix &circulatory = model_.circulatory(); circulatory.size() > 0) {
    jacobian.row(layout_.input_work()).head(n) = -(x.segment(n, n).transpose() * circulatory);
    jacobian.row(layout_.input_work()).segment(n, n) -= (circulatory * x.head(n)).transpose();
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (!inactive(c) && !mode(c).holds_gap)
      add_contact(c, time, x, jacobian);
  jacobian.middleRows(n, n).array().colwise() /= model_.mass().array();
  if (!model_.rotors().empty())
    couple_rotors(time, x, jacobian);
  if (!constraints_.empty())
    hold(time, x, jacobian);
  if (!following_.empty())
    follow_force_rates(time, x, jacobian);
}

void Equations::add_nonlinear_forces(double time, ConstVectorView x, Matrix &jacobian) const {
  const Index n = layout_.n;
  Matrix stiffness = Matrix::Zero(n, n);
  model_.add_cubic_stiffness(source_time(time), ConstVectorView(x.data(), n), stiffness);
  model_.add_run_up_stiffness(source_time(time), stiffness);
  jacobian.block(n, 0, n, n) -= stiffness;
  Matrix damping = Matrix::Zero(n, n);
  model_.add_run_up_damping(source_time(time), damping);
  jacobian.block(n, n, n, n) -= damping;
}

void Equations::couple_rotors(double time, ConstVectorView x, Matrix &jacobian) const {
  const Index n = layout_.n;
  const RotorSet &rotors = model_.rotors();
  for (const model::Rotor &rotor : rotors.list())
    if (rotor.motor) {
      const Index torque = layout_.drive() + rotor.motor->drive;
      jacobian(n + rotor.angle, torque) += 1 / model_.mass()[rotor.angle];
      jacobian(torque, torque) = -1 / rotor.motor->time_constant;
      jacobian(torque, n + rotor.angle) = -rotor.motor->slope / rotor.motor->time_constant;
    }
  const ConstVectorView q(x.data(), n);
  const ConstVectorView velocity(x.data() + layout_.velocity(), n);
  model_.rotor_frame(source_time(time), frame_);
  rotors.couple_jacobian(model_.mass(), q, velocity, frame_, uncoupled_acceleration(time, x),
                         jacobian.middleRows(n, n));
}

// D^-1 F: accelerations as if the rotors had no mass.
Vector Equations::uncoupled_acceleration(double time, ConstVectorView x) const {
  const Index n = layout_.n;
  const ConstVectorView q(x.data(), n);
  load(time);
  model_.stiffness().apply(q, elastic_);
  model_.damping().apply(ConstVectorView(x.data() + layout_.velocity(), n), damping_);
  Vector force = load_ - elastic_ - damping_;
  const VectorView view(force.data(), n);
  model_.add_cubic_forces(source_time(time), q, view);
  model_.add_run_up_forces(source_time(time), q, ConstVectorView(x.data() + layout_.velocity(), n),
                           view);
  model_.rotors().add_torques(ConstVectorView(x.data() + layout_.drive(), layout_.n_drive), view);
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (!inactive(c))
      force +=
          this->force(c, modes_[c], local_state(c, time, x)) * row_along(c, 0, time, x).transpose();
  return force.cwiseQuotient(model_.mass());
}

double Equations::stored_energy(double time, ConstVectorView x) const {
  const Index n = layout_.n;
  const auto velocity = x.segment(layout_.velocity(), n);
  Vector elastic;
  model_.stiffness().apply(ConstVectorView(x.data(), n), elastic);
  double energy = 0.5 * velocity.cwiseAbs2().dot(model_.mass()) + 0.5 * elastic.dot(x.head(n));
  if (!model_.linear()) {
    const ConstVectorView q(x.data(), n);
    energy += model_.cubic_energy(source_time(time), q);
    if (!model_.rotors().empty())
      energy +=
          model_.rotors().kinetic_energy(q, ConstVectorView(x.data() + layout_.velocity(), n));
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    contacts_.pairs()[c].law->evaluate(modes_[c], local_state(c, time, x), response_);
    energy += response_.stored_energy;
  }
  return energy;
}

double Equations::force(std::size_t contact, int mode, const LocalState &state) const {
  contacts_.pairs()[contact].law->evaluate(mode, state, response_);
  return response_.force;
}

double Equations::contact_energy(std::size_t contact, int mode, const LocalState &state) const {
  contacts_.pairs()[contact].law->evaluate(mode, state, response_);
  return response_.stored_energy;
}

} // namespace vibroimpact::motion
