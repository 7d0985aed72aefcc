#include "analyses/derivatives/form_tangents.h"

#include "common/decompositions.h"
#include "common/scalar.h"
#include "motion/variation/key_stencil.h"

#include <algorithm>

namespace vibroimpact::analyses {

using motion::Equations;
using motion::LinearForm;

namespace {

ConstVectorView vector_view(const Vector &vector) { return {vector.data(), vector.size()}; }

const contact::ContactLaw &law_of(const Equations &equations, std::size_t contact) {
  return *equations.contacts().pairs()[contact].law;
}

/// M^-1 W^T and its pseudo-inverse give the impulses that a jump of the velocities needs.
Vector impulses_of(const model::Model &model, const contact::ContactSet &contacts,
                   const std::vector<std::size_t> &which, const Vector &jump) {
  Matrix rows(static_cast<Index>(which.size()), model.size());
  for (std::size_t k = 0; k < which.size(); ++k)
    rows.row(static_cast<Index>(k)) = contacts.pairs()[which[k]].gap.row;
  const Matrix response = model.mass().cwiseInverse().asDiagonal() * rows.transpose();
  return least_norm_solution(response, jump);
}

constexpr Tangent unknown{nan, nan, nan};

bool is_circular(const Equations &equations, std::size_t contact) {
  return equations.contacts().pairs()[contact].circle != nullptr;
}

const Observable &same_in(const std::vector<Observable> &list, const Observable &observed) {
  return *std::find_if(list.begin(), list.end(),
                       [&](const Observable &one) { return one.path == observed.path; });
}

} // namespace

FormTangents::FormTangents(const System &system,
                           const std::vector<motion::KeyNeighbour> &neighbours)
    : system_(system) {
  std::vector<double> offsets;
  for (const motion::KeyNeighbour &neighbour : neighbours)
    offsets.push_back(neighbour.offset);
  const Vector weights = motion::derivative_weights(offsets);
  for (const motion::KeyNeighbour &neighbour : neighbours)
    near_.push_back(std::make_unique<Near>(System{.model = neighbour.own_model(),
                                                  .contacts = *neighbour.contacts,
                                                  .integration = system.integration,
                                                  .initial = system.initial},
                                           weights[static_cast<Index>(near_.size())]));
}

Tangent FormTangents::linear(const FormMaker &make, const TangentPoint &at) {
  const LinearForm own = make(0, at.equations());
  const Vector &values = own.differentiated ? at.rates() : at.values();
  const Vector &change = own.differentiated ? at.change_of_rates() : at.change();
  const Vector &rates = own.differentiated ? at.second_rates() : at.rates();
  const RowVector &row = own.row.row;
  Tangent tangent{.value = row.dot(values) + own.row.constant,
                  .change = row.dot(change),
                  .rate = row.dot(rates)};
  for (std::size_t i = 0; i < near_.size(); ++i) {
    Equations &equations = near_[i]->equations;
    for (std::size_t c = 0; c < equations.modes().size(); ++c)
      if (equations.modes()[c] != at.equations().modes()[c])
        equations.set_mode(c, at.equations().modes()[c]);
    const LinearForm other = make(i + 1, equations);
    tangent.change += near_[i]->weight *
                      ((other.row.row - row).dot(values) + (other.row.constant - own.row.constant));
  }
  return tangent;
}

TangentOf FormTangents::of(const Observable &observed) {
  if (const auto *form = std::get_if<motion::ForceForm>(&observed.form))
    return [this, c = form->contact](const TangentPoint &at) { return force(c, at); };
  std::vector<Observable> all{observed}; // of the system and its neighbours
  for (const auto &near : near_)
    all.push_back(same_in(near->observables, observed));
  return [this, all = std::move(all)](const TangentPoint &at) {
    if (!motion::is_linear(all.front().form, at.equations()))
      return unknown;
    return linear(
        [&](std::size_t system, const Equations &equations) {
          return linear_form(all[system].form, equations);
        },
        at);
  };
}

Tangent FormTangents::contact_form(std::size_t contact, const FormOfLaw &form,
                                   const TangentPoint &at) {
  if (is_circular(at.equations(), contact))
    return unknown;
  return linear(
      [&](std::size_t, const Equations &of) {
        return LinearForm{.row = motion::linear_row(of, contact, form(law_of(of, contact)))};
      },
      at);
}

Tangent FormTangents::gap(std::size_t contact, const TangentPoint &at) {
  return contact_form(
      contact, [](const auto &) { return contact::AffineForm{.gap = 1}; }, at);
}

Tangent FormTangents::gap_rate(std::size_t contact, const TangentPoint &at) {
  return contact_form(
      contact, [](const auto &) { return contact::AffineForm{.gap_rate = 1}; }, at);
}

Tangent FormTangents::force(std::size_t contact, const TangentPoint &at) {
  const Equations &equations = at.equations();
  if (equations.inactive(contact))
    return {};
  const contact::Mode &mode = equations.mode(contact);
  if (mode.holds_gap && !motion::LinearSystem::holds(equations))
    return unknown;
  if (!mode.affine)
    return nonlinear_force(contact, at);
  const auto present = static_cast<std::size_t>(equations.modes()[contact]);
  return contact_form(
      contact, [&](const auto &law) { return law.modes()[present].affine->force; }, at);
}

Tangent FormTangents::nonlinear_force(std::size_t contact, const TangentPoint &at) {
  const Equations &equations = at.equations();
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  const contact::LocalState local =
      equations.local_state(contact, at.time(), vector_view(at.state()));
  const int mode = equations.modes()[contact];
  contact::LawResponse own;
  contact::LawResponse other;
  pair.law->evaluate(mode, local, own);
  const Tangent gap = this->gap(contact, at), gap_rate = this->gap_rate(contact, at);
  Tangent force{.value = own.force,
                .change = own.force_by_gap * gap.change + own.force_by_gap_rate * gap_rate.change,
                .rate = own.force_by_gap * gap.rate + own.force_by_gap_rate * gap_rate.rate};
  const Index first = equations.layout().internal() + pair.internal_offset;
  for (int i = 0; i < pair.n_internal(); ++i) {
    const double slope = own.force_by_internal[static_cast<std::size_t>(i)];
    force.change += slope * at.change()[first + i];
    force.rate += slope * at.rates()[first + i];
  }
  for (const auto &near : near_) {
    law_of(near->equations, contact).evaluate(mode, local, other);
    force.change += near->weight * (other.force - own.force);
  }
  return force;
}

// The guard of an impact is the gap itself.
double FormTangents::delay(const motion::ContactEvent &event, const TangentPoint &before) {
  const auto to_delay = [](const Tangent &guard) {
    return guard.rate == 0 ? nan : -guard.change / guard.rate;
  };
  if (event.guard->action == contact::GuardAction::impact)
    return to_delay(gap(event.contact, before));
  const auto mode = static_cast<std::size_t>(event.from);
  const std::vector<contact::Guard> &guards =
      law_of(before.equations(), event.contact).modes()[mode].guards;
  const contact::AffineForm &own = event.guard->indicator;
  if (own.sees_normal_force() && !motion::LinearSystem::holds(before.equations()))
    return nan;
  const auto place = static_cast<std::size_t>(event.guard - guards.data());
  return to_delay(contact_form(
      event.contact, [&](const auto &law) { return law.modes()[mode].guards[place].indicator; },
      before));
}

Vector FormTangents::impulses(const motion::Collision &collision, const Vector &jump,
                              const Vector &change_of_jump) const {
  const Vector own = impulses_of(system_.model, system_.contacts, collision.contacts, jump);
  Vector change = impulses_of(system_.model, system_.contacts, collision.contacts, change_of_jump);
  for (const auto &near : near_)
    change +=
        near->weight *
        (impulses_of(near->system.model, near->system.contacts, collision.contacts, jump) - own);
  return change;
}

} // namespace vibroimpact::analyses
