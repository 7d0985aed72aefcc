#include "motion/variation/key_tangent.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "motion/interval/observer.h"
#include "motion/variation/key_stencil.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace vibroimpact::motion {

using contact::ContactPair;
using contact::LawResponse;
using contact::LocalState;

namespace {

ConstVectorView view(const Vector &vector) { return {vector.data(), vector.size()}; }

// Velocities behind coordinates.
auto velocities(const Vector &state, Index n) { return state.segment(n, n); }

} // namespace

KeyNeighbour KeyNeighbour::of(double offset, model::Model model, contact::ContactSet contacts) {
  return {.offset = offset,
          .model = std::make_shared<model::Model>(std::move(model)),
          .contacts = std::make_shared<contact::ContactSet>(std::move(contacts))};
}

model::Model KeyNeighbour::own_model() const {
  model::Model own = *model;
  if (frequency)
    own.set_frequency(frequency->source, frequency->angular);
  return own;
}

Histories KeyNeighbour::histories() const {
  Histories list;
  for (const model::Source &source : model->sources())
    list.push_back(source.function);
  if (frequency)
    list[frequency->source] = list[frequency->source]->with_frequency(frequency->angular);
  return list;
}

KeyTangent::KeyTangent(std::string key, const model::Model &model,
                       const contact::ContactSet &contacts, std::vector<KeyNeighbour> neighbours)
    : key_(std::move(key)), model_(model), contacts_(contacts), keeps_linear_(model.linear()) {
  if (contacts.has_planes())
    throw InputError("the motion has no known derivative by the key " + key_ +
                     ": a contact has two directions of friction (Directions).");
  static std::atomic<long> next{0};
  identity_ = next++;
  std::vector<double> offsets;
  for (const KeyNeighbour &neighbour : neighbours) {
    offsets.push_back(neighbour.offset);
    reach_ = std::max(reach_, std::abs(neighbour.offset));
    keeps_linear_ = keeps_linear_ && neighbour.model->linear();
  }
  const Vector weights = derivative_weights(offsets);
  std::vector<Histories> histories;
  for (const KeyNeighbour &neighbour : neighbours)
    histories.push_back(neighbour.histories());
  if (!std::all_of(neighbours.begin(), neighbours.end(),
                   [this](const KeyNeighbour &near) { return is_unchanged(near); }))
    for (KeyNeighbour &neighbour : neighbours) {
      const double weight = weights[static_cast<Index>(near_.size())];
      near_.push_back({.data = std::move(neighbour), .equations = nullptr, .weight = weight});
    }
  check_structure();
  check_smoothness();
  sources_ = std::make_unique<SourceTangent>(model_, std::move(histories), weights);
  std::vector<WeightedModel> weighted;
  for (const Near &near : near_)
    weighted.push_back({.model = near.data.model.get(),
                        .contacts = near.data.contacts.get(),
                        .weight = near.weight});
  data_ = std::make_unique<ModelTangent>(model_, contacts_, weighted);
}

void KeyTangent::check_structure() const {
  if (near_.empty())
    return;
  const std::vector<std::size_t> present = structure_of(model_, contacts_);
  for (const Near &near : near_)
    if (structure_of(*near.data.model, *near.data.contacts) != present)
      throw NumericalError("the key " + key_ +
                           " changes which coordinates, contacts or excitations there are: the "
                           "motion has no derivative by it");
}

void KeyTangent::check_smoothness() const {
  if (near_.empty())
    return;
  std::vector<double> offsets;
  std::vector<ModelData> data;
  for (const Near &near : near_) {
    offsets.push_back(near.data.offset);
    data.push_back(data_of(*near.data.model, *near.data.contacts));
  }
  if (!is_smooth(offsets, data_of(model_, contacts_), data))
    throw NumericalError("the model does not change smoothly with the key " + key_ +
                         ": the motion has no derivative by it");
}

// With rotors, of a neighbouring model or the present one, at the forces of the contacts and the
// values of the sources that the present one has. What is equal in both cancels to the last digit.
Vector KeyTangent::acceleration(const model::Model &model, const contact::ContactSet &contacts,
                                double time, const Vector &state,
                                const std::vector<SourceValues> &sources,
                                const Vector &forces) const {
  const Index n = model.size();
  const ConstVectorView q(state.data(), n);
  const ConstVectorView velocity(state.data() + n, n);
  Vector elastic;
  Vector damping;
  model.stiffness().apply(q, elastic);
  model.damping().apply(velocity, damping);
  Vector force = -elastic - damping;
  for (std::size_t k = 0; k < sources.size(); ++k)
    force += sources[k][0] * model.sources()[k].load +
             sources[k][1] * model.sources()[k].rate_load +
             sources[k][2] * model.sources()[k].inertial_load;
  model.add_run_up_forces(time, q, velocity, VectorView(force.data(), n));
  for (const model::Connection &spring : model.connections()) {
    double elongation = spring.elongation.row.dot(q);
    for (std::size_t k = 0; k < sources.size(); ++k)
      elongation += spring.elongation.base_coefficients[k] * sources[k][0];
    force -= spring.cubic_stiffness * elongation * elongation * elongation *
             spring.elongation.row.transpose();
  }
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (forces[static_cast<Index>(c)] != 0)
      force += forces[static_cast<Index>(c)] * contacts.pairs()[c].gap.row.transpose();
  const model::RotorSet &rotors = model.rotors();
  const Index drive = 2 * n + contacts.n_internal();
  const VectorView acceleration(force.data(), n);
  rotors.add_torques(ConstVectorView(state.data() + drive, rotors.n_drive()), acceleration);
  force = force.cwiseQuotient(model.mass()).eval();
  Vector frame;
  model.rotor_frame(time, frame);
  rotors.couple(model.mass(), q, velocity, frame, acceleration);
  return force;
}

// What the rotors' own data and those of the model below them add to the rates.
void KeyTangent::add_rates_with_rotors(const Equations &equations, double time, const Vector &state,
                                       const std::vector<SourceValues> &sources,
                                       const Vector &contact_forces, const Vector &rates,
                                       Vector &change) const {
  const StateLayout &layout = equations.layout();
  const Index n = layout.n;
  const Vector present = acceleration(model_, contacts_, time, state, sources, contact_forces);
  Vector drive(layout.n_drive);
  for (const Near &near : near_) {
    change.segment(layout.velocity(), n) +=
        near.weight *
        (acceleration(*near.data.model, *near.data.contacts, time, state, sources, contact_forces) -
         present);
    near.data.model->rotors().drive_rates(
        ConstVectorView(state.data() + n, n),
        ConstVectorView(state.data() + layout.drive(), layout.n_drive),
        VectorView(drive.data(), drive.size()));
    change.segment(layout.drive(), layout.n_drive) +=
        near.weight * (drive - rates.segment(layout.drive(), layout.n_drive));
  }
}

// What the changes of the sources add, as a force: by loads and by cubic springs to moving bases.
Vector KeyTangent::force_of_sources(const Equations &equations, double time, const Vector &state,
                                    const std::vector<SourceValues> &sources) const {
  const model::Model &model = equations.model();
  Vector force = Vector::Zero(model.size());
  std::vector<double> moved;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const std::array<double, 3> change = sources_->at(k, time);
    force += change[0] * model.sources()[k].load + change[1] * model.sources()[k].rate_load +
             change[2] * model.sources()[k].inertial_load;
    moved.push_back(change[0]);
  }
  for (const model::Connection &spring : model.connections()) {
    if (spring.cubic_stiffness == 0)
      continue;
    double elongation = spring.elongation.row.dot(state.head(model.size()));
    double change = 0;
    for (std::size_t k = 0; k < sources.size(); ++k) {
      elongation += spring.elongation.base_coefficients[k] * sources[k][0];
      change += spring.elongation.base_coefficients[k] * moved[k];
    }
    force -= 3 * spring.cubic_stiffness * elongation * elongation * change *
             spring.elongation.row.transpose();
  }
  return force;
}

// The forces that hold gaps change so that these stay what they are:
//   d(gap'' + (a + b) gap' + a b gap)/dp = 0
void KeyTangent::hold(const Equations &equations, double time, const Vector &state,
                      const Vector &rates, Vector &change) const {
  const ActiveConstraints &holding = equations.holding();
  const Index n = model_.size();
  auto accelerations = change.segment(n, n);
  Vector missing = -holding.rows() * accelerations;
  for (Index k = 0; k < holding.size(); ++k) {
    const HeldDirection &held = holding.held(k);
    missing[k] -=
        data_->along(held.contact, held.direction).projection.row.dot(velocities(rates, n)) +
        gap_by_sources(held.contact, time, 2, held.direction);
    missing[k] -= holding.by_rate(k) * gap_rate(held.contact, time, state, held.direction) +
                  holding.by_position(k) * gap(held.contact, time, state, held.direction);
  }
  accelerations += holding.response() * holding.forces(missing);
}

Vector KeyTangent::rates(const Equations &equations, double time, const Vector &state) const {
  if (equations.layout().n_sliding > 0 && LinearSystem::holds(equations))
    return linear_rates(equations, time, state);
  refuse_friction(equations);
  const StateLayout &layout = equations.layout();
  const Index n = layout.n;
  Vector rates(layout.size());
  equations.rates(time, view(state), VectorView(rates.data(), rates.size()));
  std::vector<SourceValues> sources;
  equations.source_values(time, sources);
  Vector change = Vector::Zero(layout.physical_size());
  const Forces forces = this->forces(equations, time, state, rates, change);
  Vector force = force_of_sources(equations, time, state, sources) + forces.change;
  if (model_.rotors().empty())
    force += data_->force(ConstVectorView(state.data(), n), ConstVectorView(state.data() + n, n),
                          ConstVectorView(rates.data() + n, n), sources, forces.present);
  change.segment(layout.velocity(), n) =
      equations.response_to(force.transpose(), time, view(state));
  if (!model_.rotors().empty())
    add_rates_with_rotors(equations, time, state, sources, forces.present, rates, change);
  if (!equations.holding().empty())
    hold(equations, time, state, rates, change);
  return change;
}

// Of a linear phase, friction and what it holds included.
Vector KeyTangent::linear_rates(const Equations &equations, double time,
                                const Vector &state) const {
  const LinearSystem own(equations);
  const LinearTangent &tangent = linear(equations.modes(), own);
  Vector change = tangent.matrix * state.head(own.size()) + tangent.constant;
  std::vector<SourceValues> sources;
  equations.source_values(time, sources);
  for (std::size_t k = 0; k < own.loads().size(); ++k) {
    const LinearSystem::Load &by_key = tangent.loads[k];
    const LinearSystem::Load &load = own.loads()[k];
    const std::array<double, 3> moved = sources_->at(k, time);
    change += sources[k][0] * by_key.value + sources[k][1] * by_key.rate +
              sources[k][2] * by_key.acceleration + moved[0] * load.value + moved[1] * load.rate +
              moved[2] * load.acceleration;
  }
  return change;
}

// v+ - v- = -M^-1 W^T (W M^-1 W^T)^-1 (1 + e) gap_rate-, of the contacts that take an impulse. One
// whose restitution counts as zero (1 + e = 1) keeps that.
Vector KeyTangent::jump(const Equations &equations, const Collision &collision, double time,
                        const Vector &before) const {
  const Index n = model_.size();
  const auto size = static_cast<Index>(collision.contacts.size());
  Vector change = Vector::Zero(n);
  if (size == 0)
    return change;
  if (std::ranges::any_of(collision.directions, [](int direction) { return direction > 0; }))
    throw NumericalError("contact " + contacts_.pairs()[collision.contacts.front()].name +
                         ": impacts of rigid sides with friction have no known derivative by keys");
  Vector gap_rates(size);
  Vector moved(size);
  for (Index k = 0; k < size; ++k) {
    const std::size_t c = collision.contacts[static_cast<std::size_t>(k)];
    gap_rates[k] = equations.local_state(c, time, view(before)).gap_rate;
    moved[k] = gap_rate(c, time, before);
  }
  change = collision.response * (collision.impulse_by_rate * moved);
  const Vector present = collision.response * (collision.impulse_by_rate * gap_rates);
  const Vector factor =
      -(collision.rows * collision.response * collision.impulse_by_rate).diagonal();
  for (const Near &near : near_) {
    const Matrix rows = gap_rows(*near.data.contacts, collision.contacts, n);
    // Collisions of models with rotors have no derivative.
    const Matrix response = near.data.model->mass().cwiseInverse().asDiagonal() * rows.transpose();
    Vector wanted(size);
    for (Index k = 0; k < size; ++k) {
      const std::size_t c = collision.contacts[static_cast<std::size_t>(k)];
      const double speed = -gap_rates[k];
      const double other = near.data.contacts->pairs()[c].law->restitution(speed);
      const double own = contacts_.pairs()[c].law->restitution(speed);
      const bool bounces = factor[k] > 1 + 1e-9;
      wanted[k] = (factor[k] + (bounces || own == 0 ? other - own : 0)) * gap_rates[k];
    }
    // At fixed velocities: what other rows do to the gap rates is in `moved`.
    const Vector jump = -response * least_norm_solution(rows * response, wanted);
    change += near.weight * (jump - present);
  }
  return change;
}

const KeyTangent::LinearTangent &KeyTangent::linear(const std::vector<int> &modes,
                                                    const LinearSystem &own) const {
  const auto known = linear_.find(modes);
  return known != linear_.end() ? known->second
                                : linear_.emplace(modes, make_linear(modes, own)).first->second;
}

KeyTangent::LinearTangent KeyTangent::make_linear(const std::vector<int> &modes,
                                                  const LinearSystem &own) const {
  const Vector zero = Vector::Zero(own.size());
  LinearTangent tangent{.matrix = Matrix::Zero(own.size(), own.size()),
                        .constant = zero,
                        .loads = {own.loads().size(), {zero, zero, zero}}};
  for (const Near &near : near_) {
    if (!near.equations)
      near.equations = std::make_unique<Equations>(*near.data.model, *near.data.contacts);
    for (std::size_t c = 0; c < modes.size(); ++c)
      near.equations->set_mode(c, modes[c]);
    const LinearSystem other(*near.equations);
    tangent.matrix += near.weight * (other.matrix() - own.matrix());
    tangent.constant += near.weight * (other.constant() - own.constant());
    for (std::size_t k = 0; k < own.loads().size(); ++k) {
      tangent.loads[k].value += near.weight * (other.loads()[k].value - own.loads()[k].value);
      tangent.loads[k].rate += near.weight * (other.loads()[k].rate - own.loads()[k].rate);
      tangent.loads[k].acceleration +=
          near.weight * (other.loads()[k].acceleration - own.loads()[k].acceleration);
    }
  }
  return tangent;
}

} // namespace vibroimpact::motion
