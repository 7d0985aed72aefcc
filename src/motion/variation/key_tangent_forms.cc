// How forms of the local state of a contact change with a key.
#include "motion/interval/guard_forms.h"
#include "motion/variation/key_tangent.h"

namespace vibroimpact::motion {

using contact::LocalState;

namespace {

// The part of a form that sees forces.
contact::AffineForm forces_of(const contact::AffineForm &form) {
  contact::AffineForm forces{.normal_force = form.normal_force,
                             .normal_force_rate = form.normal_force_rate};
  for (std::size_t k = 0; k < contact::most_tangential; ++k)
    forces.tangential[k].force = form.tangential[k].force;
  return forces;
}

// [y, then s, s', s'' of each source]
Vector phase_of(const Equations &equations, double time, const Vector &state) {
  std::vector<SourceValues> sources;
  equations.source_values(time, sources);
  const Index size = equations.layout().physical_size();
  Vector phase(size + 3 * static_cast<Index>(sources.size()));
  phase.head(size) = state.head(size);
  for (std::size_t k = 0; k < sources.size(); ++k)
    for (std::size_t order = 0; order < 3; ++order)
      phase[size + 3 * static_cast<Index>(k) + static_cast<Index>(order)] = sources[k][order];
  return phase;
}

} // namespace

// What a form that sees forces alone changes by, in a linear phase at a fixed state.
double KeyTangent::held_forces(const Equations &equations, std::size_t contact,
                               const contact::AffineForm &forces, double time,
                               const Vector &state) const {
  const LinearRow row = linear_row(equations, contact, forces);
  const Vector phase = phase_of(equations, time, state);
  double change = 0;
  for (const Near &near : near_) {
    if (!near.equations)
      near.equations = std::make_unique<Equations>(*near.data.model, *near.data.contacts);
    for (std::size_t c = 0; c < contacts_.size(); ++c)
      near.equations->set_mode(c, equations.modes()[c]);
    const LinearRow there = linear_row(*near.equations, contact, forces);
    change += near.weight * ((there.row - row.row).dot(phase) + there.constant - row.constant);
  }
  const Index first = equations.layout().physical_size();
  for (std::size_t k = 0; k < model_.sources().size(); ++k)
    for (std::size_t order = 0; order < 3; ++order)
      change += row.row[first + 3 * static_cast<Index>(k) + static_cast<Index>(order)] *
                sources_->at(k, time)[order];
  return change;
}

double KeyTangent::form(const Equations &equations, std::size_t contact, const Pick &pick,
                        double time, const Vector &state) const {
  const LocalState local =
      equations.local_state(contact, time, ConstVectorView(state.data(), state.size()));
  const contact::AffineForm &own = pick(*contacts_.pairs()[contact].law);
  const double value = own(local);
  double change = 0;
  for (const Near &near : near_)
    change += near.weight * (pick(*near.data.contacts->pairs()[contact].law)(local) - value);
  for (int d = 0; d < contacts_.pairs()[contact].n_directions(); ++d) {
    const contact::DirectionForm of = own.along(d);
    if (of.position != 0)
      change += of.position * gap(contact, time, state, d);
    if (of.rate != 0)
      change += of.rate * gap_rate(contact, time, state, d);
  }
  // In other phases laws see the normal force by value, and rigid sides part without force.
  if (own.sees_forces() && LinearSystem::holds(equations))
    change += held_forces(equations, contact, forces_of(own), time, state);
  else if (own.normal_force != 0 && !equations.mode(contact).holds_gap)
    change += own.normal_force * normal_force(equations, contact, time, state);
  return change;
}

} // namespace vibroimpact::motion
