#include "motion/system/linear_system.h"

#include <stdexcept>

namespace vibroimpact::motion {

using contact::ContactPair;

namespace {

const std::optional<contact::AffineLaw> &affine_law(const Equations &equations,
                                                    std::size_t contact) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  return pair.law->modes()[static_cast<std::size_t>(equations.modes()[contact])].affine;
}

// Adds rows of products a b. What is left of terms that cancel is none: rounding would tie
// coordinates to each other that constraints have made independent.
template <class Rows> void add_product(const Matrix &a, const Matrix &b, Rows &&rows) {
  constexpr double rounding = 1e-14;
  const Matrix sizes = rows.cwiseAbs() + a.cwiseAbs() * b.cwiseAbs();
  rows += a * b;
  rows = (rows.array().abs() <= rounding * sizes.array()).select(0.0, rows);
}

} // namespace

bool LinearSystem::holds(const Equations &equations) {
  if (!equations.model().linear())
    return false;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (!affine_law(equations, c))
      return false;
  return true;
}

namespace {

std::vector<contact::AffineLaw> laws_of(const Equations &equations) {
  std::vector<contact::AffineLaw> laws;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    laws.push_back(affine_law(equations, c).value_or(contact::AffineLaw{}));
  return laws;
}

// In a circular gap, by u and u'.
contact::AffineLaw tangent_law(const ContactPair &pair, const contact::LawResponse &response,
                               const contact::CircularFrame &frame) {
  const std::array<contact::AffineForm, 2> force = pair.circle->force_gradient(frame, response);
  contact::AffineLaw law{.force = force[0], .internal_rate = {}, .tangential_force = {force[1]}};
  for (int i = 0; i < pair.n_internal(); ++i)
    law.internal_rate.push_back(
        pair.circle->gradient(frame, internal_rate_gradient(response, i, pair.n_internal())));
  return law;
}

// By its derivatives at a local state, but for what internal states of friction do.
contact::AffineLaw tangent_law(const Equations &equations, std::size_t contact, double time,
                               ConstVectorView x) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  contact::LawResponse response;
  pair.law->evaluate(equations.modes()[contact], equations.local_state(contact, time, x), response);
  if (pair.circle)
    return tangent_law(pair, response, equations.frame(contact, time, x));
  contact::AffineLaw law;
  law.force = {.gap = response.force_by_gap,
               .gap_rate = response.force_by_gap_rate,
               .internal = response.force_by_internal};
  for (std::size_t k = 0; k < pair.tangential.size(); ++k)
    law.tangential_force[k] = response.tangential[k].by;
  const auto n = static_cast<std::size_t>(pair.n_internal());
  for (std::size_t i = 0; i < n; ++i) {
    const double *by_internal = response.internal_rate_by_internal.data() + i * n;
    law.internal_rate.push_back({.gap = response.internal_rate_by_gap[i],
                                 .gap_rate = response.internal_rate_by_gap_rate[i],
                                 .internal = {by_internal, by_internal + n}});
  }
  return law;
}

} // namespace

LinearSystem::LinearSystem(const Equations &equations) : laws_(laws_of(equations)) {
  if (!holds(equations))
    throw std::logic_error("this phase of the motion is not linear");
  assemble(equations, equations.model().stiffness().dense(), equations.model().damping().dense());
}

LinearSystem LinearSystem::of_modes(const Equations &equations) {
  LinearSystem system(laws_of(equations));
  system.assemble(equations, equations.model().stiffness().dense(),
                  equations.model().damping().dense());
  return system;
}

LinearSystem LinearSystem::tangent(const Equations &equations, double time, const Vector &state) {
  const ConstVectorView x(state.data(), state.size());
  std::vector<contact::AffineLaw> laws;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    laws.push_back(tangent_law(equations, c, time, x));
  LinearSystem system(std::move(laws));
  const model::Model &model = equations.model();
  Matrix stiffness = model.stiffness().dense();
  Matrix damping = model.damping().dense();
  if (!model.linear()) {
    model.add_cubic_stiffness(equations.source_time(time),
                              ConstVectorView(state.data(), model.size()), stiffness);
    model.add_run_up_stiffness(equations.source_time(time), stiffness);
    model.add_run_up_damping(equations.source_time(time), damping);
  }
  system.assemble(equations, stiffness, damping);
  return system;
}

void LinearSystem::assemble(const Equations &equations, const Matrix &stiffness,
                            const Matrix &damping) {
  const model::Model &model = equations.model();
  const Index n = model.size();
  const Index size = equations.layout().physical_size();
  mass_ = model.mass();
  const Vector inverse_mass = mass_.cwiseInverse();
  matrix_ = Matrix::Zero(size, size);
  matrix_.block(0, n, n, n).setIdentity();
  matrix_.block(n, 0, n, n) = -(inverse_mass.asDiagonal() * stiffness);
  matrix_.block(n, n, n, n) = -(inverse_mass.asDiagonal() * damping);
  constant_ = Vector::Zero(size);
  for (const model::Source &source : model.sources()) {
    const auto acceleration = [&](const Vector &load) {
      Vector y = Vector::Zero(size);
      y.segment(n, n) = inverse_mass.cwiseProduct(load);
      return y;
    };
    loads_.push_back({acceleration(source.load), acceleration(source.rate_load),
                      acceleration(source.inertial_load)});
  }
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (!equations.mode(c).holds_gap)
      add_contact(equations, c);
  if (!equations.holding().empty())
    hold(equations);
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    follow_normal_force(equations, c);
}

// Internal rates that go with the rate of the normal force, once the accelerations are known.
void LinearSystem::follow_normal_force(const Equations &equations, std::size_t contact) {
  const contact::AffineLaw &law = laws_[contact];
  const Index first =
      equations.layout().internal() + equations.contacts().pairs()[contact].internal_offset;
  for (std::size_t i = 0; i < law.internal_rate.size(); ++i) {
    const double factor = law.internal_rate[i].normal_force_rate;
    if (factor == 0)
      continue;
    const LinearRow rate = derivative(row_of_motion(equations, contact, law.force));
    const Index place = first + static_cast<Index>(i);
    matrix_.row(place) += factor * rate.row.head(size());
    constant_[place] += factor * rate.constant;
    for (std::size_t k = 0; k < loads_.size(); ++k) {
      const Index source = size() + 3 * static_cast<Index>(k);
      loads_[k].value[place] += factor * rate.row[source];
      loads_[k].rate[place] += factor * rate.row[source + 1];
      loads_[k].acceleration[place] += factor * rate.row[source + 2];
    }
  }
}

LinearRow LinearSystem::derivative(const LinearRow &row) const {
  const auto by_state = row.row.head(size());
  LinearRow rate{.row = RowVector::Zero(row.row.size()), .constant = by_state.dot(constant_)};
  rate.row.head(size()) = by_state * matrix_;
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    const Index source = size() + 3 * static_cast<Index>(k);
    rate.row[source] = by_state.dot(loads_[k].value);
    rate.row[source + 1] = by_state.dot(loads_[k].rate) + row.row[source];
    rate.row[source + 2] = by_state.dot(loads_[k].acceleration) + row.row[source + 1];
  }
  return rate;
}

LinearRow LinearSystem::row(const Equations &equations, std::size_t contact,
                            const contact::AffineForm &form) const {
  LinearRow result = row_of_motion(equations, contact, form);
  if (!form.sees_forces())
    return result;
  const auto add = [&](double factor, const LinearRow &other) {
    result.row += factor * other.row;
    result.constant += factor * other.constant;
  };
  const ActiveConstraints &holding = equations.holding();
  const contact::Mode &mode = equations.mode(contact);
  for (int d = 0; d < equations.contacts().pairs()[contact].n_directions(); ++d)
    if (const Index k = holding.place(contact, d); k < holding.size())
      add(form.along(d).force,
          {.row = constraint_forces_.rows.row(k), .constant = constraint_forces_.constants[k]});
  if (mode.holds_gap || !form.sees_normal_force())
    return result;
  const LinearRow force = row_of_motion(equations, contact, laws_[contact].force);
  add(form.normal_force, force);
  if (form.normal_force_rate != 0)
    add(form.normal_force_rate, derivative(force));
  return result;
}

// The forces of equations.holding() as rows, and what they add to the equations.
void LinearSystem::hold(const Equations &equations) {
  const ActiveConstraints &holding = equations.holding();
  const Index n = equations.model().size();
  const auto n_sources = static_cast<Index>(loads_.size());
  const Matrix &w = holding.rows();
  Matrix missing = Matrix::Zero(holding.size(), size() + 3 * n_sources + 1);
  missing.leftCols(size()) = w * matrix_.middleRows(n, n);
  missing.rightCols(1) = w * constant_.segment(n, n);
  for (Index s = 0; s < n_sources; ++s) {
    const Load &load = loads_[static_cast<std::size_t>(s)];
    missing.col(size() + 3 * s) = w * load.value.segment(n, n);
    missing.col(size() + 3 * s + 1) = w * load.rate.segment(n, n);
    missing.col(size() + 3 * s + 2) = w * load.acceleration.segment(n, n);
  }
  for (Index k = 0; k < holding.size(); ++k) {
    const HeldDirection &held = holding.held(k);
    const contact::Direction along =
        equations.contacts().pairs()[held.contact].along(held.direction);
    const std::vector<double> &base = along.projection->base_coefficients;
    missing.row(k).head(n) += holding.by_position(k) * w.row(k);
    missing.row(k).segment(n, n) += holding.by_rate(k) * w.row(k);
    missing(k, missing.cols() - 1) +=
        holding.by_position(k) * along.offset + holding.by_rate(k) * along.speed;
    for (std::size_t s = 0; s < base.size(); ++s)
      missing.row(k).segment(size() + 3 * static_cast<Index>(s), 3) +=
          base[s] * Eigen::RowVector3d(holding.by_position(k), holding.by_rate(k), 1);
  }
  const Matrix forces = -holding.forces(missing);
  constraint_forces_.rows = forces.leftCols(forces.cols() - 1);
  constraint_forces_.constants = forces.rightCols(1);
  const Matrix &response = holding.response();
  add_product(response, forces.leftCols(size()), matrix_.middleRows(n, n));
  add_product(response, forces.rightCols(1), constant_.segment(n, n));
  for (Index s = 0; s < n_sources; ++s) {
    Load &load = loads_[static_cast<std::size_t>(s)];
    add_product(response, forces.col(size() + 3 * s), load.value.segment(n, n));
    add_product(response, forces.col(size() + 3 * s + 1), load.rate.segment(n, n));
    add_product(response, forces.col(size() + 3 * s + 2), load.acceleration.segment(n, n));
  }
}

void LinearSystem::add_contact(const Equations &equations, std::size_t contact) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  const contact::AffineLaw &law = laws_[contact];
  for (int d = 0; d < pair.n_directions(); ++d) {
    Vector into = Vector::Zero(size());
    into.segment(layout.n, layout.n) = equations.model().mass().cwiseInverse().cwiseProduct(
        pair.along(d).projection->row.transpose());
    add_form(equations, contact,
             d == 0 ? law.force : law.tangential_force[static_cast<std::size_t>(d - 1)], into);
  }
  for (std::size_t i = 0; i < law.internal_rate.size(); ++i)
    add_form(
        equations, contact, law.internal_rate[i],
        Vector::Unit(size(), layout.internal() + pair.internal_offset + static_cast<Index>(i)));
}

// y' += into * form(positions, rates, internal states)
void LinearSystem::add_form(const Equations &equations, std::size_t contact,
                            const contact::AffineForm &form, const Vector &into) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  double constant = form.constant;
  for (int d = 0; d < pair.n_directions(); ++d) {
    const contact::DirectionForm of = form.along(d);
    const contact::Direction along = pair.along(d);
    matrix_.leftCols(layout.n) += of.position * into * along.projection->row;
    matrix_.middleCols(layout.n, layout.n) += of.rate * into * along.projection->row;
    constant += of.position * along.offset + of.rate * along.speed;
    for (std::size_t k = 0; k < along.projection->base_coefficients.size(); ++k) {
      loads_[k].value += of.position * along.projection->base_coefficients[k] * into;
      loads_[k].rate += of.rate * along.projection->base_coefficients[k] * into;
    }
  }
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    matrix_.col(layout.internal() + pair.internal_offset + static_cast<Index>(i)) +=
        form.internal[i] * into;
  constant_ += constant * into;
}

LinearRow row_of_motion(const Equations &equations, std::size_t contact,
                        const contact::AffineForm &form) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
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
  return result;
}

void LinearSystem::differentiate(Matrix &rows) const {
  for (Index j = 1; j < rows.cols(); ++j) {
    auto next = rows.col(j).head(size());
    next.noalias() = matrix_ * rows.col(j - 1).head(size());
    if (j == 1)
      next += constant_;
    for (std::size_t k = 0; k < loads_.size(); ++k) {
      const double *s = &rows(size() + 3 * static_cast<Index>(k), j - 1);
      next += s[0] * loads_[k].value + s[1] * loads_[k].rate + s[2] * loads_[k].acceleration;
    }
  }
}

} // namespace vibroimpact::motion
