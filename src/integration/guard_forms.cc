#include "integration/guard_forms.h"

namespace vibroimpact {

namespace {

void add_row(const Equations &equations, const LinearSystem &system, std::size_t contact,
             const AffineForm &form, GuardForms &forms) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  const Index last = forms.rows.rows();
  forms.rows.conservativeResize(last + 1, Eigen::NoChange);
  forms.constants.conservativeResize(last + 1);
  auto row = forms.rows.row(last);
  row.setZero();
  row.head(layout.n) = form.gap * pair.gap.row;
  row.segment(layout.velocity(), layout.n) = form.gap_rate * pair.gap.row;
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    row[layout.internal() + pair.internal_offset + static_cast<Index>(i)] = form.internal[i];
  for (std::size_t k = 0; k < pair.gap.carrier.size(); ++k) {
    const Index source = layout.physical_size() + 3 * static_cast<Index>(k);
    row[source] = form.gap * pair.gap.carrier[k];
    row[source + 1] = form.gap_rate * pair.gap.carrier[k];
  }
  forms.constants[last] = form.constant + form.gap * pair.clearance;
  const LinearSystem::HeldForces &held = system.held_forces();
  for (std::size_t k = 0; k < held.contacts.size(); ++k)
    if (held.contacts[k] == contact) {
      row += form.normal_force * held.rows.row(static_cast<Index>(k));
      forms.constants[last] += form.normal_force * held.constants[static_cast<Index>(k)];
    }
}

} // namespace

GuardForms guard_forms(const Equations &equations, const LinearSystem &system) {
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  GuardForms forms{.rows = Matrix(0, equations.layout().physical_size() + 3 * n_sources),
                   .constants = Vector(0)};
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const ContactLaw &law = *equations.contacts().pairs()[c].law;
    for (const Guard &guard : law.modes()[static_cast<std::size_t>(equations.modes()[c])].guards)
      add_row(equations, system, c, guard.indicator, forms);
  }
  return forms;
}

} // namespace vibroimpact
