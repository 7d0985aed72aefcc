#include "motion/system/equations.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

using contact::ContactPair;
using contact::LocalState;
using model::RotorSet;
using model::TimeFunction;

namespace {

bool is_zero(const contact::AffineForm &form) {
  bool zero = form.constant == 0 && form.gap == 0 && form.gap_rate == 0 && form.normal_force == 0;
  for (const double c : form.internal)
    zero = zero && c == 0;
  return zero;
}

// sum += |A| |x|
void add_magnitudes(const model::LinearForm &form, const double *values, Vector &sum) {
  const auto x = ConstVectorView(values, sum.size()).cwiseAbs();
  sum += form.diagonal.cwiseAbs().cwiseProduct(x);
  if (form.coupling.size() > 0)
    sum.noalias() += form.coupling.cwiseAbs() * x;
}

} // namespace

Equations::Equations(const model::Model &model, const contact::ContactSet &contacts)
    : model_(model),
      contacts_(contacts), layout_{.n = model.size(),
                                   .n_internal = contacts.n_internal(),
                                   .n_drive = model.n_drive(),
                                   .n_contacts = static_cast<Index>(contacts.size())},
      modes_(contacts.size(), 0) {
  for (const ContactPair &pair : contacts.pairs()) {
    std::vector<char> inactive;
    for (const contact::Mode &mode : pair.law->modes())
      inactive.push_back(pair.n_internal() == 0 && !mode.in_contact && mode.affine &&
                         is_zero(mode.affine->force));
    inactive_.push_back(std::move(inactive));
    std::vector<BaseCoefficient> base_coefficients;
    for (std::size_t k = 0; k < pair.gap.base_coefficients.size(); ++k)
      if (pair.gap.base_coefficients[k] != 0)
        base_coefficients.push_back({.source = k, .factor = pair.gap.base_coefficients[k]});
    base_coefficients_.push_back(std::move(base_coefficients));
  }
  constraints_ = ActiveConstraints(model_, contacts_, modes_);
  list_acting();
}

void Equations::list_acting() {
  acting_.clear();
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (!inactive(c) && !mode(c).holds_gap)
      acting_.push_back({.contact = c, .pair = &contacts_.pairs()[c]});
}

const contact::Mode &Equations::mode(std::size_t contact) const {
  return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(modes_[contact])];
}

void Equations::set_mode(std::size_t contact, int mode) {
  const bool held = this->mode(contact).holds_gap;
  if (modes_[contact] == mode)
    return;
  modes_[contact] = mode;
  list_acting();
  if (held || this->mode(contact).holds_gap)
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
  const double instant = source_time(time);
  values.resize(model_.sources().size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const TimeFunction &function = *model_.sources()[k].function;
    values[k] = {function.value(instant), function.rate(instant), function.acceleration(instant)};
  }
}

LocalState Equations::local_state(std::size_t contact, double time, ConstVectorView x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  const double *row = pair.gap.row.data();
  const double *q = x.data();
  const double *velocity = q + layout_.velocity();
  LocalState state{.gap = pair.clearance,
                   .internal = {q + layout_.internal() + pair.internal_offset,
                                static_cast<std::size_t>(pair.n_internal())}};
  for (Index j = 0; j < layout_.n; ++j) {
    state.gap += row[j] * q[j];
    state.gap_rate += row[j] * velocity[j];
  }
  for (const BaseCoefficient &base_coefficients : base_coefficients_[contact]) {
    const TimeFunction &function = *model_.sources()[base_coefficients.source].function;
    state.gap += base_coefficients.factor * function.value(source_time(time));
    state.gap_rate += base_coefficients.factor * function.rate(source_time(time));
  }
  if (!constraints_.empty() && constraints_.holds(contact)) {
    held_rates_.resize(layout_.size());
    rates(time, x, VectorView(held_rates_.data(), held_rates_.size()));
    state.normal_force = held_rates_[layout_.impulse(static_cast<Index>(contact))];
  }
  return state;
}

double Equations::gap_acceleration(std::size_t contact, double time,
                                   ConstVectorView acceleration) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  double value = pair.gap.row.dot(acceleration);
  for (std::size_t k = 0; k < pair.gap.base_coefficients.size(); ++k)
    if (pair.gap.base_coefficients[k] != 0)
      value += pair.gap.base_coefficients[k] *
               model_.sources()[k].function->acceleration(source_time(time));
  return value;
}

double Equations::magnitude(std::size_t contact, const contact::AffineForm &form, double time,
                            const Vector &x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  const auto magnitude = [&](Index first) {
    return pair.gap.row.cwiseAbs().dot(x.segment(first, layout_.n).cwiseAbs());
  };
  double gap = std::abs(pair.clearance) + magnitude(0);
  double gap_rate = magnitude(layout_.velocity());
  for (const BaseCoefficient &base_coefficients : base_coefficients_[contact]) {
    const TimeFunction &function = *model_.sources()[base_coefficients.source].function;
    gap += std::abs(base_coefficients.factor * function.value(source_time(time)));
    gap_rate += std::abs(base_coefficients.factor * function.rate(source_time(time)));
  }
  double sum =
      std::abs(form.constant) + std::abs(form.gap) * gap + std::abs(form.gap_rate) * gap_rate;
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    sum += std::abs(form.internal[i] *
                    x[layout_.internal() + pair.internal_offset + static_cast<Index>(i)]);
  if (form.normal_force != 0 && constraints_.holds(contact))
    sum += std::abs(form.normal_force) * force_magnitude(contact, time, x);
  return sum;
}

double Equations::rounding(std::size_t contact, const contact::AffineForm &form, double time,
                           const Vector &x) const {
  return 64 * std::numeric_limits<double>::epsilon() * magnitude(contact, form, time, x);
}

double Equations::acceleration_rounding(std::size_t contact, double time, const Vector &x) const {
  const ContactPair &pair = contacts_.pairs()[contact];
  double sum = force_magnitude(contact, time, x) / contacts_.effective_mass(contact, model_);
  for (std::size_t k = 0; k < pair.gap.base_coefficients.size(); ++k)
    if (pair.gap.base_coefficients[k] != 0)
      sum += std::abs(pair.gap.base_coefficients[k] *
                      model_.sources()[k].function->acceleration(source_time(time)));
  return 64 * std::numeric_limits<double>::epsilon() * sum;
}

void Equations::rates(double time, ConstVectorView x, VectorView dxdt) const {
  const Index n = layout_.n;
  const ConstVectorView velocity(x.data() + layout_.velocity(), n);
  model_.load(source_time(time), load_);
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
  for (const Acting &acting : acting_)
    input_power += add_contact(acting, time, x, dxdt);
  if (!model_.linear())
    input_power += add_nonlinear_forces(time, x, dxdt);
  else
    for (Index j = 0; j < n; ++j)
      acceleration[j] /= model_.mass()[j];
  if (!constraints_.empty())
    input_power += hold(time, x, dxdt);
  dxdt[layout_.input_work()] = input_power;
  dxdt[layout_.absolute_input_work()] = std::abs(input_power);
  dxdt[layout_.damping_work()] = damping_power;
}

// Adds its force, before the division by the mass. Returns the power that moving bases put into it.
double Equations::add_contact(const Acting &acting, double time, ConstVectorView x,
                              VectorView dxdt) const {
  const ContactPair &pair = *acting.pair;
  const auto contact = static_cast<Index>(acting.contact);
  pair.law->evaluate(modes_[acting.contact], local_state(acting.contact, time, x), response_);
  double *acceleration = dxdt.data() + layout_.velocity();
  for (Index j = 0; j < layout_.n; ++j)
    acceleration[j] += response_.force * pair.gap.row[j];
  for (int i = 0; i < pair.n_internal(); ++i)
    dxdt[layout_.internal() + pair.internal_offset + i] = response_.internal_rate[i];
  dxdt[layout_.impulse(contact)] = response_.force;
  dxdt[layout_.contact_work(contact)] = response_.dissipated_power;
  double power = 0;
  for (const BaseCoefficient &base_coefficients : base_coefficients_[acting.contact])
    power -= response_.force * base_coefficients.factor *
             model_.sources()[base_coefficients.source].function->rate(source_time(time));
  return power;
}

// Adds the forces that hold gaps. Returns the power that moving bases put into them.
double Equations::hold(double time, ConstVectorView x, VectorView dxdt) const {
  VectorView acceleration(dxdt.data() + layout_.velocity(), layout_.n);
  if (!model_.rotors().empty())
    constraints_.set_response(response_to(constraints_.rows(), time, x));
  Vector missing(constraints_.size());
  Vector carried(constraints_.size());
  Vector gap_rate(constraints_.size());
  for (Index k = 0; k < constraints_.size(); ++k) {
    const ContactPair &pair = contacts_.pairs()[constraints_.contact(k)];
    double gap = pair.clearance + pair.gap.row.dot(x.head(layout_.n));
    carried[k] = 0;
    for (std::size_t s = 0; s < pair.gap.base_coefficients.size(); ++s)
      if (pair.gap.base_coefficients[s] != 0) {
        const TimeFunction &function = *model_.sources()[s].function;
        gap += pair.gap.base_coefficients[s] * function.value(source_time(time));
        carried[k] += pair.gap.base_coefficients[s] * function.rate(source_time(time));
      }
    gap_rate[k] = pair.gap.row.dot(x.segment(layout_.velocity(), layout_.n)) + carried[k];
    missing[k] = -gap_acceleration(constraints_.contact(k), time,
                                   ConstVectorView(acceleration.data(), layout_.n)) -
                 constraints_.by_gap_rate(k) * gap_rate[k] - constraints_.by_gap(k) * gap;
  }
  const Vector forces = constraints_.forces(missing);
  acceleration += constraints_.response() * forces;
  for (Index k = 0; k < constraints_.size(); ++k) {
    const auto contact = static_cast<Index>(constraints_.contact(k));
    dxdt[layout_.impulse(contact)] = forces[k];
    dxdt[layout_.contact_work(contact)] = -forces[k] * gap_rate[k];
  }
  return -forces.dot(carried);
}

// Adds the derivative of the forces that hold gaps, which is linear in that of the accelerations.
void Equations::hold(Matrix &jacobian) const {
  const Index n = layout_.n;
  auto accelerations = jacobian.middleRows(layout_.velocity(), n);
  Matrix missing = -constraints_.rows() * accelerations;
  for (Index k = 0; k < constraints_.size(); ++k) {
    missing.row(k).head(n) -= constraints_.by_gap(k) * constraints_.rows().row(k);
    missing.row(k).segment(layout_.velocity(), n) -=
        constraints_.by_gap_rate(k) * constraints_.rows().row(k);
  }
  accelerations += constraints_.response() * constraints_.forces(missing);
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
  const Vector frame = model_.rotor_frame(source_time(time));
  Vector unloaded = Vector::Zero(n);
  rotors.couple(model_.mass(), q, velocity, frame, VectorView(unloaded.data(), n));
  for (Index k = 0; k < response.cols(); ++k)
    rotors.couple(model_.mass(), q, velocity, frame, VectorView(response.col(k).data(), n));
  return response.colwise() - unloaded;
}

// Sum of the sizes of all that the force which holds a contact is made of.
double Equations::force_magnitude(std::size_t contact, double time, const Vector &x) const {
  const Index n = layout_.n;
  model_.load(source_time(time), load_);
  Vector &forces = elastic_;
  forces = load_.cwiseAbs();
  add_magnitudes(model_.stiffness(), x.data(), forces);
  add_magnitudes(model_.damping(), x.data() + layout_.velocity(), forces);
  const RowVector &row = contacts_.pairs()[contact].gap.row;
  double sum = 0;
  for (Index j = 0; j < n; ++j)
    sum += std::abs(row[j]) * forces[j] / model_.mass()[j];
  return sum * contacts_.effective_mass(contact, model_);
}

// Cubic springs and rotors; divides by the mass. Returns the power they take in.
double Equations::add_nonlinear_forces(double time, ConstVectorView x, VectorView dxdt) const {
  const Index n = layout_.n;
  const ConstVectorView q(x.data(), n);
  const ConstVectorView velocity(x.data() + layout_.velocity(), n);
  const ConstVectorView drive(x.data() + layout_.drive(), layout_.n_drive);
  VectorView acceleration(dxdt.data() + layout_.velocity(), n);
  double power = model_.add_cubic_forces(source_time(time), q, acceleration);
  const RotorSet &rotors = model_.rotors();
  if (rotors.empty()) {
    acceleration.array() /= model_.mass().array();
    return power;
  }
  const Vector frame = model_.rotor_frame(source_time(time));
  rotors.add_torques(drive, acceleration);
  acceleration.array() /= model_.mass().array();
  rotors.couple(model_.mass(), q, velocity, frame, acceleration);
  rotors.drive_rates(velocity, drive, VectorView(dxdt.data() + layout_.drive(), layout_.n_drive));
  return power + rotors.input_power(q, velocity, drive, frame);
}

// Of the work integrals, whose integrals do not act back, only the work of loads and the impulses:
// an implicit method solves for them as exactly as for the motion.
void Equations::jacobian(double time, ConstVectorView x, Matrix &jacobian) const {
  const Index n = layout_.n;
  jacobian.setZero(layout_.size(), layout_.size());
  jacobian.block(0, n, n, n).setIdentity();
  jacobian.block(n, 0, n, n) = -model_.stiffness().dense();
  if (!model_.linear())
    add_cubic_stiffness(time, x, jacobian);
  jacobian.block(n, n, n, n) = -model_.damping().dense();
  model_.load(source_time(time), load_);
  jacobian.row(layout_.input_work()).segment(n, n) = load_.transpose();
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    if (inactive(c) || mode(c).holds_gap)
      continue;
    const ContactPair &pair = contacts_.pairs()[c];
    pair.law->evaluate(modes_[c], local_state(c, time, x), response_);
    const RowVector &row = pair.gap.row;
    const Index impulse = layout_.impulse(static_cast<Index>(c));
    jacobian.row(impulse).head(n) = response_.force_by_gap * row;
    jacobian.row(impulse).segment(n, n) = response_.force_by_gap_rate * row;
    jacobian.block(n, 0, n, n) += response_.force_by_gap * row.transpose() * row;
    jacobian.block(n, n, n, n) += response_.force_by_gap_rate * row.transpose() * row;
    const Index first = layout_.internal() + pair.internal_offset;
    for (int i = 0; i < pair.n_internal(); ++i) {
      jacobian.col(first + i).segment(n, n) += response_.force_by_internal[i] * row.transpose();
      jacobian.row(first + i).head(n) = response_.internal_rate_by_gap[i] * row;
      jacobian.row(first + i).segment(n, n) = response_.internal_rate_by_gap_rate[i] * row;
      for (int j = 0; j < pair.n_internal(); ++j)
        jacobian(first + i, first + j) =
            response_.internal_rate_by_internal[i * pair.n_internal() + j];
    }
  }
  jacobian.middleRows(n, n).array().colwise() /= model_.mass().array();
  if (!model_.rotors().empty())
    couple_rotors(time, x, jacobian);
  if (!constraints_.empty())
    hold(jacobian);
}

void Equations::add_cubic_stiffness(double time, ConstVectorView x, Matrix &jacobian) const {
  const Index n = layout_.n;
  Matrix stiffness = Matrix::Zero(n, n);
  model_.add_cubic_stiffness(source_time(time), ConstVectorView(x.data(), n), stiffness);
  jacobian.block(n, 0, n, n) -= stiffness;
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
  const Vector frame = model_.rotor_frame(source_time(time));
  rotors.couple_jacobian(model_.mass(), q, velocity, frame, uncoupled_acceleration(time, x),
                         jacobian.middleRows(n, n));
}

// D^-1 F: accelerations as if the rotors had no mass.
Vector Equations::uncoupled_acceleration(double time, ConstVectorView x) const {
  const Index n = layout_.n;
  const ConstVectorView q(x.data(), n);
  model_.load(source_time(time), load_);
  model_.stiffness().apply(q, elastic_);
  model_.damping().apply(ConstVectorView(x.data() + layout_.velocity(), n), damping_);
  Vector force = load_ - elastic_ - damping_;
  const VectorView view(force.data(), n);
  model_.add_cubic_forces(source_time(time), q, view);
  model_.rotors().add_torques(ConstVectorView(x.data() + layout_.drive(), layout_.n_drive), view);
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (!inactive(c))
      force += this->force(c, modes_[c], local_state(c, time, x)) *
               contacts_.pairs()[c].gap.row.transpose();
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
