#include "motion/interval/guard_forms.h"

#include "common/error.h"

namespace vibroimpact::motion {

LinearRow linear_row(const Equations &equations, std::size_t contact,
                     const contact::AffineForm &form) {
  if (!form.sees_forces() ||
      !(equations.mode(contact).holds() || equations.mode(contact).sees_force_rate))
    return row_of_motion(equations, contact, form);
  return LinearSystem::of_modes(equations).row(equations, contact, form);
}

namespace {

// N and its rate by their partial derivatives.
contact::AffineForm without_normal_force(const Equations &equations, std::size_t contact,
                                         const contact::AffineForm &form, double time,
                                         ConstVectorView x) {
  if (!form.sees_normal_force())
    return form;
  if (form.normal_force_rate != 0)
    throw NumericalError("contact " + equations.contacts().pairs()[contact].name +
                         ": derivatives of a spring-slider in a circular gap are not known");
  contact::LawResponse response;
  equations.contacts().pairs()[contact].law->evaluate(
      equations.modes()[contact], equations.local_state(contact, time, x), response);
  contact::AffineForm made = form;
  made.normal_force = 0;
  return made + form.normal_force * contact::normal_force_gradient(response);
}

} // namespace

contact::AffineForm without_margin(const Equations &equations, std::size_t contact,
                                   const contact::AffineForm &form, double time,
                                   const Vector &state) {
  contact::AffineForm made = form;
  made.margin = 0;
  if (form.margin != 0)
    made += form.margin *
            equations.margin_gradient(contact, time, ConstVectorView(state.data(), state.size()));
  return made;
}

LinearRow tangent_row(const Equations &equations, std::size_t contact,
                      const contact::AffineForm &form, double time, const Vector &state) {
  if (form.margin != 0)
    return tangent_row(equations, contact, without_margin(equations, contact, form, time, state),
                       time, state);
  if (const auto &circle = equations.contacts().pairs()[contact].circle) {
    const ConstVectorView x(state.data(), state.size());
    return row_of_motion(equations, contact,
                         circle->gradient(equations.frame(contact, time, x),
                                          without_normal_force(equations, contact, form, time, x)));
  }
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

Index GuardForms::n_guards() const {
  Index count = constants.size();
  if (products)
    for (const GuardProduct &product : *products)
      count -= static_cast<Index>(product.forms.size());
  return count;
}

GuardForms guard_forms(const Equations &equations) {
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  GuardForms forms{.rows = Matrix(0, equations.layout().physical_size() + 3 * n_sources),
                   .constants = Vector(0),
                   .products = guard_products(equations)};
  const auto add = [&](const LinearRow &form) {
    const Index last = forms.rows.rows();
    forms.rows.conservativeResize(last + 1, Eigen::NoChange);
    forms.constants.conservativeResize(last + 1);
    forms.rows.row(last) = form.row;
    forms.constants[last] = form.constant;
  };
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    for (const contact::Guard &guard : equations.mode(c).guards)
      add(linear_row(equations, c, guard.indicator));
  if (forms.products)
    for (const GuardProduct &product : *forms.products)
      for (const contact::AffineForm &form : product.forms)
        add(linear_row(equations, product.contact, form));
  return forms;
}

} // namespace vibroimpact::motion
