#include "motion/observer.h"

#include "motion/segment/constraint_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vibroimpact::motion {

using model::Projection;

namespace {

// Value and derivatives at one end of a step.
struct EndValues {
  std::array<double, 5> values{};
  std::size_t count = 3;
  std::span<const double> list() const { return {values.data(), count}; }
};

EndValues end_values(const Projection &projection, const StateLayout &layout,
                     const EndPoint &point) {
  const Index n = layout.n;
  const Index v = layout.velocity();
  EndValues end;
  end.values = {projection.row.dot(point.state.head(n)),
                projection.row.dot(point.state.segment(v, n)),
                projection.row.dot(point.rates.segment(v, n))};
  for (Index m = 0; m < point.higher.cols(); ++m)
    end.values[end.count++] = projection.row.dot(point.higher.col(m).segment(v, n));
  for (std::size_t k = 0; k < projection.base_coefficients.size(); ++k)
    if (projection.base_coefficients[k] != 0)
      for (std::size_t m = 0; m < end.count; ++m)
        end.values[m] += projection.base_coefficients[k] * point.sources[k][m];
  return end;
}

// Of one entry of the state; those of a velocity are further derivatives of its coordinate.
void add_derivatives(const EndPoint &point, Index entry, EndValues &end) {
  end.values[end.count++] = point.state[entry];
  end.values[end.count++] = point.rates[entry];
  for (Index m = 0; m < point.higher.cols(); ++m)
    end.values[end.count++] = point.higher(entry, m);
}

} // namespace

Bernstein StepView::displacement(const Projection &projection) const {
  const StateLayout &layout = equations_->layout();
  return Bernstein::hermite(length(), end_values(projection, layout, *start_).list(),
                            end_values(projection, layout, *end_).list());
}

// Over a short step differences of positions are rounding alone; then the velocities at the ends
// say more.
Bernstein StepView::velocity(const Projection &projection) const {
  const EndValues start = end_values(projection, equations_->layout(), *start_);
  const EndValues end = end_values(projection, equations_->layout(), *end_);
  const auto &a = start.values;
  const auto &b = end.values;
  const double h = length();
  const double rounding = 64 * std::numeric_limits<double>::epsilon();
  if (rounding * std::max(std::abs(a[0]), std::abs(b[0])) >
      1e-10 * h * std::max(std::abs(a[1]), std::abs(b[1])))
    return Bernstein::hermite(h, start.list().subspan(1), end.list().subspan(1));
  return Bernstein::hermite_rate(h, start.list(), end.list());
}

// Differences of positions over a short step say nothing of the acceleration any more; then those
// of the velocities do, and at last the accelerations at the ends alone.
Bernstein StepView::acceleration(const Projection &projection) const {
  const EndValues start = end_values(projection, equations_->layout(), *start_);
  const EndValues end = end_values(projection, equations_->layout(), *end_);
  const auto &a = start.values;
  const auto &b = end.values;
  const double h = length();
  const double rounding = 64 * std::numeric_limits<double>::epsilon();
  const double allowed = 1e-9 * std::max(std::abs(a[2]), std::abs(b[2]));
  if (rounding * std::max(std::abs(a[1]), std::abs(b[1])) > allowed * h)
    return Bernstein::hermite(h, start.list().subspan(2), end.list().subspan(2));
  if (rounding * std::max(std::abs(a[0]), std::abs(b[0])) > allowed * h * h) {
    Bernstein slope =
        Bernstein::hermite(h, start.list().subspan(1), end.list().subspan(1)).derivative();
    slope *= 1 / h;
    return slope;
  }
  Bernstein second = Bernstein::hermite(h, start.list(), end.list()).derivative().derivative();
  second *= 1 / (h * h);
  return second;
}

Bernstein StepView::coordinate(Index j) const {
  const Index v = equations_->layout().velocity() + j;
  EndValues start{.values = {start_->state[j]}, .count = 1};
  EndValues end{.values = {end_->state[j]}, .count = 1};
  add_derivatives(*start_, v, start);
  add_derivatives(*end_, v, end);
  return Bernstein::hermite(length(), start.list(), end.list());
}

Bernstein StepView::gap(std::size_t contact) const {
  const contact::ContactPair &pair = equations_->contacts().pairs()[contact];
  Bernstein gap = displacement(pair.gap);
  gap += pair.clearance;
  return gap;
}

Bernstein StepView::gap_rate(std::size_t contact) const {
  return velocity(equations_->contacts().pairs()[contact].gap);
}

Bernstein StepView::first_order_state(Index place) const {
  EndValues start{.values = {}, .count = 0};
  EndValues end{.values = {}, .count = 0};
  add_derivatives(*start_, place, start);
  add_derivatives(*end_, place, end);
  return Bernstein::hermite(length(), start.list(), end.list());
}

Bernstein StepView::internal(Index i) const {
  return first_order_state(equations_->layout().internal() + i);
}

Bernstein StepView::drive(Index i) const {
  return first_order_state(equations_->layout().drive() + i);
}

Bernstein StepView::constraint_force(std::size_t contact) const {
  return motion::constraint_force(*this, contact);
}

Bernstein StepView::indicator(std::size_t contact, const contact::AffineForm &form) const {
  Bernstein sum;
  if (form.gap != 0) {
    sum = gap(contact);
    sum *= form.gap;
  }
  if (form.gap_rate != 0) {
    Bernstein rate = gap_rate(contact);
    rate *= form.gap_rate;
    sum += rate;
  }
  sum += form.constant;
  const Index first = equations_->contacts().pairs()[contact].internal_offset;
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    if (form.internal[i] != 0) {
      Bernstein term = internal(first + static_cast<Index>(i));
      term *= form.internal[i];
      sum += term;
    }
  if (form.normal_force != 0) {
    Bernstein force = constraint_force(contact);
    force *= form.normal_force;
    sum += force;
  }
  return sum;
}

ContactCurves StepView::contact_curves(std::size_t contact) const {
  const contact::ContactPair &pair = equations_->contacts().pairs()[contact];
  ContactCurves curves{.gap = gap(contact),
                       .gap_rate = gap_rate(contact),
                       .internal = {},
                       .normal_force = constraint_force(contact)};
  for (int i = 0; i < pair.n_internal(); ++i)
    curves.internal.push_back(internal(pair.internal_offset + i));
  return curves;
}

double StepView::force(std::size_t contact, const ContactCurves &curves, double tau) const {
  std::vector<double> internal_values;
  for (const Bernstein &curve : curves.internal)
    internal_values.push_back(curve(tau));
  return equations_->force(contact, equations_->modes()[contact],
                           {.gap = curves.gap(tau),
                            .gap_rate = curves.gap_rate(tau),
                            .internal = internal_values,
                            .normal_force = curves.normal_force(tau)});
}

double StepView::force(std::size_t contact, double tau) const {
  return force(contact, contact_curves(contact), tau);
}

Observers::Observers(std::vector<Observer *> list) : list_(std::move(list)) {
  for (Observer *observer : list_) {
    monitors_.push_back(observer->output_monitor());
    all_monitor_ = all_monitor_ && monitors_.back();
  }
}

void Observers::add_forms(const Equations &equations, std::vector<MonitoredForm> &forms) {
  for (OutputMonitor *monitor : monitors_)
    monitor->add_forms(equations, forms);
}

void Observers::part_done(const Equations &equations, double start, double end) {
  for (OutputMonitor *monitor : monitors_)
    monitor->part_done(equations, start, end);
}

} // namespace vibroimpact::motion
