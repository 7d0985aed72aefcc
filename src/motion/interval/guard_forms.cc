#include "motion/interval/guard_forms.h"

namespace vibroimpact::motion {

LinearRow linear_row(const Equations &equations, std::size_t contact,
                     const contact::AffineForm &form) {
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  LinearRow result{.row = RowVector::Zero(layout.physical_size() + 3 * n_sources),
                   .constant = form.constant};
  RowVector &row = result.row;
  for (int d = 0; d < pair.n_directions(); ++d) {
    const contact::DirectionForm of = form.along(d);
    const contact::Direction along = pair.along(d);
    const std::vector<double> &base = along.projection->base_coefficients;
    row.head(layout.n) += of.position * along.projection->row;
    row.segment(layout.velocity(), layout.n) += of.rate * along.projection->row;
    result.constant += of.position * along.offset + of.rate * along.speed;
    for (std::size_t k = 0; k < base.size(); ++k) {
      const Index source = layout.physical_size() + 3 * static_cast<Index>(k);
      row[source] += of.position * base[k];
      row[source + 1] += of.rate * base[k];
    }
  }
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    row[layout.internal() + pair.internal_offset + static_cast<Index>(i)] = form.internal[i];
  if (!form.sees_forces() || !equations.mode(contact).holds())
    return result;
  const LinearSystem::ConstraintForces held = LinearSystem::constraint_forces(equations);
  for (int d = 0; d < pair.n_directions(); ++d)
    if (const Index k = equations.holding().place(contact, d); k < held.rows.rows()) {
      row += form.along(d).force * held.rows.row(k);
      result.constant += form.along(d).force * held.constants[k];
    }
  return result;
}

contact::AffineForm force_along(const contact::Mode &mode, int direction) {
  if (direction == 0)
    return mode.affine->force;
  return mode.holds(direction)
             ? contact::AffineForm::force_along(direction)
             : mode.affine->tangential_force[static_cast<std::size_t>(direction - 1)];
}

GuardForms guard_forms(const Equations &equations) {
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  GuardForms forms{.rows = Matrix(0, equations.layout().physical_size() + 3 * n_sources),
                   .constants = Vector(0)};
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const contact::ContactLaw &law = *equations.contacts().pairs()[c].law;
    for (const contact::Guard &guard :
         law.modes()[static_cast<std::size_t>(equations.modes()[c])].guards) {
      const LinearRow form = linear_row(equations, c, guard.indicator);
      const Index last = forms.rows.rows();
      forms.rows.conservativeResize(last + 1, Eigen::NoChange);
      forms.constants.conservativeResize(last + 1);
      forms.rows.row(last) = form.row;
      forms.constants[last] = form.constant;
    }
  }
  return forms;
}

} // namespace vibroimpact::motion
