#include "motion/interval/guard_forms.h"

#include <algorithm>

namespace vibroimpact::motion {

LinearRow linear_row(const Equations &equations, std::size_t contact,
                     const contact::AffineForm &form) {
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  LinearRow result{.row = RowVector::Zero(layout.physical_size() + 3 * n_sources),
                   .constant = form.constant + form.gap * pair.clearance};
  RowVector &row = result.row;
  row.head(layout.n) = form.gap * pair.gap.row;
  row.segment(layout.velocity(), layout.n) = form.gap_rate * pair.gap.row;
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    row[layout.internal() + pair.internal_offset + static_cast<Index>(i)] = form.internal[i];
  for (std::size_t k = 0; k < pair.gap.base_coefficients.size(); ++k) {
    const Index source = layout.physical_size() + 3 * static_cast<Index>(k);
    row[source] = form.gap * pair.gap.base_coefficients[k];
    row[source + 1] = form.gap_rate * pair.gap.base_coefficients[k];
  }
  if (form.normal_force == 0 || !equations.mode(contact).holds_gap)
    return result;
  const LinearSystem::ConstraintForces held = LinearSystem::constraint_forces(equations);
  const auto place = std::find(held.contacts.begin(), held.contacts.end(), contact);
  const Index k = place - held.contacts.begin();
  row += form.normal_force * held.rows.row(k);
  result.constant += form.normal_force * held.constants[k];
  return result;
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
