#include "motion/interval/guard_forms.h"

namespace vibroimpact::motion {

LinearRow linear_row(const Equations &equations, std::size_t contact,
                     const contact::AffineForm &form) {
  if (!form.sees_forces() ||
      !(equations.mode(contact).holds() || equations.mode(contact).sees_force_rate))
    return row_of_motion(equations, contact, form);
  return LinearSystem::of_modes(equations).row(equations, contact, form);
}

LinearRow tangent_row(const Equations &equations, std::size_t contact,
                      const contact::AffineForm &form, double time, const Vector &state) {
  if (!form.sees_forces() || LinearSystem::holds(equations))
    return linear_row(equations, contact, form);
  return LinearSystem::tangent(equations, time, state).row(equations, contact, form);
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
