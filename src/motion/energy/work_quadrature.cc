#include "motion/energy/work_quadrature.h"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>

namespace vibroimpact::motion {

namespace {

using Rule = boost::math::quadrature::gauss<double, WorkQuadrature::points>;

// Boost keeps the non-negative abscissae.
struct Point {
  double abscissa, weight; // on [0, 1]
};

std::array<Point, WorkQuadrature::points> make_rule() {
  std::array<Point, WorkQuadrature::points> rule{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double x = Rule::abscissa()[i];
    const double weight = 0.5 * Rule::weights()[i];
    rule[count++] = {0.5 + 0.5 * x, weight};
    if (x != 0)
      rule[count++] = {0.5 - 0.5 * x, weight};
  }
  return rule;
}

const std::array<Point, WorkQuadrature::points> rule = make_rule();

} // namespace

WorkQuadrature::WorkQuadrature(const Equations &equations) : equations_(equations) {}

std::array<double, WorkQuadrature::points> WorkQuadrature::instants(double start, double h) {
  std::array<double, points> list{};
  for (int i = 0; i < points; ++i)
    list[i] = start + h * rule[i].abscissa;
  return list;
}

void WorkQuadrature::add(double h, const Matrix &rows, const LinearSystem::ConstraintForces &held,
                         Vector &state) {
  held_ = &held;
  for (Index i = 0; i < points; ++i)
    add_point(h * rule[static_cast<std::size_t>(i)].weight, rows, i, state);
}

void WorkQuadrature::add_point(double weight, const Matrix &rows, Index point, Vector &state) {
  const StateLayout &layout = equations_.layout();
  const model::Model &model = equations_.model();
  const double *y = &rows(0, point);
  const double *velocity = y + layout.velocity();
  double power = 0;
  for (std::size_t k = 0; k < model.sources().size(); ++k) {
    const model::Source &source = model.sources()[k];
    const double *s = y + layout.physical_size() + 3 * static_cast<Index>(k);
    for (Index j = 0; j < layout.n; ++j)
      power += velocity[j] * (s[0] * source.load[j] + s[1] * source.rate_load[j] +
                              s[2] * source.inertial_load[j]);
  }
  power += add_contacts(weight, y, state);
  state[layout.input_work()] += weight * power;
  state[layout.absolute_input_work()] += weight * std::abs(power);
  state[layout.damping_work()] += weight * damping_power(ConstVectorView(velocity, layout.n));
}

double WorkQuadrature::damping_power(ConstVectorView velocity) {
  const model::LinearForm &damping = equations_.model().damping();
  double power = 0;
  for (Index j = 0; j < velocity.size(); ++j)
    power += damping.diagonal[j] * velocity[j] * velocity[j];
  if (damping.coupling.size() > 0) {
    damping_.noalias() = damping.coupling * velocity;
    power += damping_.dot(velocity);
  }
  return power;
}

// Zero of contacts that are not held.
double WorkQuadrature::constraint_force(std::size_t contact, const double *y) const {
  for (std::size_t k = 0; k < held_->contacts.size(); ++k)
    if (held_->contacts[k] == contact) {
      const auto row = static_cast<Index>(k);
      return held_->constants[row] +
             held_->rows.row(row).dot(ConstVectorView(y, held_->rows.cols()));
    }
  return 0;
}

// Returns the power that moving bases put into the contacts.
double WorkQuadrature::add_contacts(double weight, const double *y, Vector &state) {
  const StateLayout &layout = equations_.layout();
  const contact::ContactSet &contacts = equations_.contacts();
  double power = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (equations_.inactive(c))
      continue;
    const contact::ContactPair &pair = contacts.pairs()[c];
    contact::LocalState local{
        .gap = pair.clearance + pair.gap.row.dot(ConstVectorView(y, layout.n)),
        .gap_rate = pair.gap.row.dot(ConstVectorView(y + layout.velocity(), layout.n)),
        .internal = {y + layout.internal() + pair.internal_offset,
                     static_cast<std::size_t>(pair.n_internal())}};
    double carried = 0;
    for (std::size_t k = 0; k < pair.gap.base_coefficients.size(); ++k)
      if (pair.gap.base_coefficients[k] != 0) {
        const double *s = y + layout.physical_size() + 3 * static_cast<Index>(k);
        local.gap += pair.gap.base_coefficients[k] * s[0];
        carried += pair.gap.base_coefficients[k] * s[1];
      }
    local.gap_rate += carried;
    local.normal_force = constraint_force(c, y);
    pair.law->evaluate(equations_.modes()[c], local, response_);
    power -= response_.force * carried;
    state[layout.impulse(static_cast<Index>(c))] += weight * response_.force;
    state[layout.contact_work(static_cast<Index>(c))] += weight * response_.dissipated_power;
  }
  return power;
}

} // namespace vibroimpact::motion
