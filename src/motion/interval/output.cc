#include "motion/interval/output.h"

#include "motion/interval/peak_force.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vibroimpact::motion {

namespace {

template <class... Cases> struct Overloaded : Cases... { using Cases::operator()...; };

LinearRow nothing(const Equations &equations) {
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  return {.row = RowVector::Zero(equations.layout().physical_size() + 3 * n_sources)};
}

// An acceleration is the derivative of a velocity.
LinearForm linear_form_of_point(const PointForm &form, const Equations &equations) {
  const StateLayout &layout = equations.layout();
  const Index derivative = form.order == 0 ? 0 : 1;
  const model::Projection &seen = form.projection;
  LinearForm made{.row = nothing(equations), .differentiated = form.order == 2};
  made.row.row.segment(derivative * layout.velocity(), layout.n) = seen.row;
  for (std::size_t k = 0; k < seen.base_coefficients.size(); ++k)
    made.row.row[layout.physical_size() + 3 * static_cast<Index>(k) + derivative] =
        seen.base_coefficients[k];
  return made;
}

LinearForm linear_form_of_state(const StateForm &form, const Equations &equations) {
  LinearForm made{.row = nothing(equations)};
  made.row.row[equations.layout().internal() + form.place] = 1;
  made.row.constant = form.constant;
  return made;
}

LinearForm linear_form_of_force(const ForceForm &form, const Equations &equations) {
  const contact::Mode &mode = equations.mode(form.contact);
  if (!mode.affine)
    throw std::logic_error("the force of this contact is not linear in the motion");
  return {.row = linear_row(equations, form.contact, mode.affine->force)};
}

// By the squared distance, which is a polynomial.
void include_circular_gap(const StepView &view, std::size_t contact, ValueRange &range) {
  const contact::CircularGap &circle = *view.equations().contacts().pairs()[contact].circle;
  const Bernstein squared = view.squared_distance(contact);
  for (const double extreme : {squared.minimum(), squared.maximum()})
    range.include(circle.sense() * (circle.clearance() - std::sqrt(std::max(0.0, extreme))));
}

contact::AffineForm affine_form(const SlipForm &form) {
  return form.rate ? contact::AffineForm::rate_along(form.direction)
                   : contact::AffineForm::position_along(form.direction);
}

} // namespace

LinearForm linear_form(const OutputForm &form, const Equations &equations) {
  return std::visit(
      Overloaded{[&](const PointForm &point) { return linear_form_of_point(point, equations); },
                 [&](const GapForm &gap) {
                   return LinearForm{.row = linear_row(equations, gap.contact, {.gap = 1})};
                 },
                 [&](const StateForm &state) { return linear_form_of_state(state, equations); },
                 [&](const ForceForm &force) { return linear_form_of_force(force, equations); },
                 [&](const SlipForm &slip) {
                   return LinearForm{.row = linear_row(equations, slip.contact, affine_form(slip))};
                 },
                 [&](const FrictionForm &friction) {
                   return LinearForm{.row = linear_row(equations, friction.contact,
                                                       force_along(equations.mode(friction.contact),
                                                                   friction.direction))};
                 },
                 [](const CurveForm & /*curve*/) -> LinearForm {
                   throw std::logic_error("this output is not linear in the motion");
                 }},
      form);
}

bool is_linear(const OutputForm &form, const Equations &equations) {
  const auto straight = [&](std::size_t contact) {
    return !equations.contacts().pairs()[contact].circle;
  };
  return std::visit(Overloaded{[&](const GapForm &gap) { return straight(gap.contact); },
                               [&](const SlipForm &slip) { return straight(slip.contact); },
                               [&](const FrictionForm &friction) {
                                 const contact::Mode &mode = equations.mode(friction.contact);
                                 return straight(friction.contact) &&
                                        (mode.affine || mode.holds(friction.direction));
                               },
                               [](const CurveForm & /*curve*/) { return false; },
                               [](const auto & /*others*/) { return true; }},
                    form);
}

Bernstein curve(const OutputForm &form, const StepView &view) {
  return std::visit(Overloaded{[&](const PointForm &point) {
                                 return point.order == 0   ? view.displacement(point.projection)
                                        : point.order == 1 ? view.velocity(point.projection)
                                                           : view.acceleration(point.projection);
                               },
                               [&](const GapForm &gap) { return view.gap(gap.contact); },
                               [&](const StateForm &state) {
                                 Bernstein value = view.internal(state.place);
                                 value += state.constant;
                                 return value;
                               },
                               [](const ForceForm & /*force*/) -> Bernstein {
                                 throw std::logic_error("a contact force is no polynomial");
                               },
                               [&](const SlipForm &slip) {
                                 return slip.rate ? view.rate(slip.contact, slip.direction)
                                                  : view.position(slip.contact, slip.direction);
                               },
                               [&](const FrictionForm &friction) {
                                 return view.friction_force(friction.contact, friction.direction);
                               },
                               [&](const CurveForm &along) { return along(view); }},
                    form);
}

void Output::include(const StepView &view) const {
  if (const auto *force = std::get_if<ForceForm>(form))
    range->include(peak_force(view, force->contact));
  else if (const auto *gap = std::get_if<GapForm>(form);
           gap && view.equations().contacts().pairs()[gap->contact].circle)
    include_circular_gap(view, gap->contact, *range);
  else
    range->include(curve(*form, view));
}

LinearOutputs::LinearOutputs(const std::vector<Output> &outputs, const Equations &equations) {
  for (const Output &output : outputs)
    if (const auto *force = std::get_if<ForceForm>(output.form);
        force && !equations.mode(force->contact).affine)
      forces.push_back({.contact = force->contact, .range = output.range});
    else
      add(linear_form(*output.form, equations), *output.range);
}

void LinearOutputs::add(const LinearForm &form, ValueRange &range) {
  const auto place = static_cast<Index>(ranges.size());
  rows.conservativeResize(place + 1, form.row.row.size());
  rows.row(place) = form.row.row;
  constants.push_back(form.row.constant);
  differentiated.push_back(form.differentiated);
  ranges.push_back(&range);
}

} // namespace vibroimpact::motion
