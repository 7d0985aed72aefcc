// The powers of a linear phase.
#include "motion/interval/phase_forms.h"
#include "motion/phase/quadratic_form.h"

#include <optional>
#include <stdexcept>

namespace vibroimpact::motion {

namespace {

// The forms that make up the local state of a contact: gap, its rate, internal states, the force
// that holds it and the rate of the normal force, and for each tangential direction slip, slip rate
// and the force that holds it.
std::vector<contact::AffineForm> local_forms(const contact::ContactPair &pair) {
  using contact::AffineForm;
  const auto n_internal = static_cast<std::size_t>(pair.n_internal());
  std::vector<AffineForm> forms = {AffineForm::position_along(0), AffineForm::rate_along(0)};
  for (std::size_t i = 0; i < n_internal; ++i) {
    forms.push_back({.internal = std::vector<double>(n_internal, 0.0)});
    forms.back().internal[i] = 1;
  }
  forms.push_back(AffineForm::force_along(0));
  if (!pair.tangential.empty())
    forms.push_back({.normal_force_rate = 1});
  for (int d = 1; d < pair.n_directions(); ++d)
    forms.insert(forms.end(), {AffineForm::position_along(d), AffineForm::rate_along(d),
                               AffineForm::force_along(d)});
  return forms;
}

// The local state with these values of local_forms().
contact::LocalState local_state(const Vector &x, const contact::ContactPair &pair) {
  const auto n_internal = static_cast<std::size_t>(pair.n_internal());
  const double *next = x.data() + 2 + n_internal;
  contact::LocalState state{.gap = x[0],
                            .gap_rate = x[1],
                            .internal = {x.data() + 2, n_internal},
                            .normal_force = *next++};
  if (!pair.tangential.empty())
    state.normal_force_rate = *next++;
  for (int d = 1; d < pair.n_directions(); ++d, next += 3)
    state.tangential[static_cast<std::size_t>(d - 1)] = {
        .slip = next[0], .slip_rate = next[1], .force = next[2]};
  return state;
}

LinearRow constant_row(const Equations &equations, double constant) {
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  return {.row = RowVector::Zero(equations.layout().physical_size() + 3 * n_sources),
          .constant = constant};
}

LinearRow unit_row(const Equations &equations, Index entry) {
  LinearRow form = constant_row(equations, 0);
  form.row[entry] = 1;
  return form;
}

} // namespace

PowerForms::PowerForms(const Equations &equations)
    : rows_(0, constant_row(equations, 0).row.size()), constants_(0) {
  add_loads(equations);
  add_damping(equations);
  add_circulatory(equations);
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (!equations.inactive(c))
      add_contact(equations, c);
}

void PowerForms::add(Index entry, const LinearRow &a, const LinearRow &b) {
  if ((a.row.isZero(0) && a.constant == 0) || (b.row.isZero(0) && b.constant == 0))
    return;
  entries_.push_back(entry);
  const Index first = rows_.rows();
  rows_.conservativeResize(first + 2, Eigen::NoChange);
  constants_.conservativeResize(first + 2);
  rows_.row(first) = a.row;
  rows_.row(first + 1) = b.row;
  constants_[first] = a.constant;
  constants_[first + 1] = b.constant;
}

void PowerForms::add_loads(const Equations &equations) {
  const StateLayout &layout = equations.layout();
  for (std::size_t k = 0; k < equations.model().sources().size(); ++k) {
    const model::Source &source = equations.model().sources()[k];
    Index row = layout.physical_size() + 3 * static_cast<Index>(k);
    for (const Vector *load : {&source.load, &source.rate_load, &source.inertial_load}) {
      LinearRow speed = constant_row(equations, 0);
      speed.row.segment(layout.velocity(), layout.n) = load->transpose();
      add(layout.input_work(), speed, unit_row(equations, row++));
    }
  }
}

void PowerForms::add_damping(const Equations &equations) {
  const StateLayout &layout = equations.layout();
  const model::LinearForm &damping = equations.model().damping();
  for (Index j = 0; j < layout.n; ++j) {
    LinearRow force = constant_row(equations, 0);
    force.row[layout.velocity() + j] = damping.diagonal[j];
    if (damping.coupling.size() > 0)
      force.row.segment(layout.velocity(), layout.n) += damping.coupling.row(j);
    add(layout.damping_work(), unit_row(equations, layout.velocity() + j), force);
  }
}

void PowerForms::add_circulatory(const Equations &equations) {
  const StateLayout &layout = equations.layout();
  const Matrix &circulatory = equations.model().circulatory();
  for (Index j = 0; j < circulatory.rows(); ++j) {
    LinearRow force = constant_row(equations, 0);
    force.row.head(layout.n) = -circulatory.row(j);
    add(layout.input_work(), unit_row(equations, layout.velocity() + j), force);
  }
}

void PowerForms::add_contact(const Equations &equations, std::size_t contact) {
  const StateLayout &layout = equations.layout();
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  add_dissipation(equations, contact, layout.contact_work(static_cast<Index>(contact)),
                  &contact::LawResponse::dissipated_power);
  for (int d = 0; d < pair.n_directions(); ++d) {
    const LinearRow force = linear_row(equations, contact, force_along(equations.mode(contact), d));
    if (d == 0)
      add(layout.impulse(static_cast<Index>(contact)), force, constant_row(equations, 1));
    const contact::Direction along = pair.along(d);
    LinearRow carried = constant_row(equations, -along.speed);
    for (std::size_t k = 0; k < along.projection->base_coefficients.size(); ++k)
      carried.row[layout.physical_size() + 3 * static_cast<Index>(k) + 1] =
          -along.projection->base_coefficients[k];
    add(layout.input_work(), force, carried);
  }
  if (!pair.tangential.empty())
    add_friction(equations, contact);
}

void PowerForms::add_friction(const Equations &equations, std::size_t contact) {
  const StateLayout &layout = equations.layout();
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  const contact::AffineLaw &law = *equations.mode(contact).affine;
  add_dissipation(equations, contact, layout.friction_work(pair.sliding_place),
                  &contact::LawResponse::friction_power);
  const LinearRow speed = linear_row(equations, contact, law.sliding_speed);
  add(layout.sliding_way(pair.sliding_place), speed, constant_row(equations, 1));
  add(layout.wear_work(pair.sliding_place), linear_row(equations, contact, law.force), speed);
}

void PowerForms::add_dissipation(const Equations &equations, std::size_t contact, Index entry,
                                 double contact::LawResponse::*power) {
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  const int mode = equations.modes()[contact];
  std::vector<LinearRow> rows;
  for (const contact::AffineForm &form : local_forms(pair))
    rows.push_back(linear_row(equations, contact, form));
  contact::LawResponse response;
  const std::optional<Matrix> dissipated = quadratic_form(
      [&](const Vector &x) {
        pair.law->evaluate(mode, local_state(x, pair), response);
        return response.*power;
      },
      static_cast<Index>(rows.size()));
  if (!dissipated)
    throw std::logic_error("the law '" + pair.law->name() +
                           "' is linear, but the power it dissipates is no quadratic form");
  rows.push_back(constant_row(equations, 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    LinearRow force = constant_row(equations, 0);
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const double factor = (*dissipated)(static_cast<Index>(i), static_cast<Index>(j));
      force.row += factor * rows[j].row;
      force.constant += factor * rows[j].constant;
    }
    add(entry, rows[i], force);
  }
}

} // namespace vibroimpact::motion
