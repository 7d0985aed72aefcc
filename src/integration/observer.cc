#include "integration/observer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact {

namespace {

// Value, rate and acceleration at one end of a step.
std::array<double, 3> end_values(const Projection &projection, const Equations &equations,
                                 double time, const Vector &state, const Vector &rates) {
  const StateLayout &layout = equations.layout();
  const Index n = layout.n;
  const double source_time = equations.source_time(time);
  std::array<double, 3> values = {projection.row.dot(state.head(n)),
                                  projection.row.dot(state.segment(layout.velocity(), n)),
                                  projection.row.dot(rates.segment(layout.velocity(), n))};
  for (std::size_t k = 0; k < projection.carrier.size(); ++k)
    if (projection.carrier[k] != 0) {
      const TimeFunction &function = *equations.model().sources()[k].function;
      values[0] += projection.carrier[k] * function.value(source_time);
      values[1] += projection.carrier[k] * function.rate(source_time);
      values[2] += projection.carrier[k] * function.acceleration(source_time);
    }
  return values;
}

} // namespace

StepView::StepView(const Equations &equations, double start, double end, const Vector &start_state,
                   const Vector &end_state, const Vector &start_rates, const Vector &end_rates)
    : equations_(&equations), start_(start), end_(end), start_state_(&start_state),
      end_state_(&end_state), start_rates_(&start_rates), end_rates_(&end_rates) {}

Bernstein StepView::displacement(const Projection &projection) const {
  return Bernstein::quintic(
      length(), end_values(projection, *equations_, start_, *start_state_, *start_rates_),
      end_values(projection, *equations_, end_, *end_state_, *end_rates_));
}

// Over a short step differences of positions are rounding alone; then the velocities at the ends
// say more.
Bernstein StepView::velocity(const Projection &projection) const {
  const auto a = end_values(projection, *equations_, start_, *start_state_, *start_rates_);
  const auto b = end_values(projection, *equations_, end_, *end_state_, *end_rates_);
  const double h = length();
  const double rounding = 64 * std::numeric_limits<double>::epsilon();
  if (rounding * std::max(std::abs(a[0]), std::abs(b[0])) >
      1e-10 * h * std::max(std::abs(a[1]), std::abs(b[1])))
    return Bernstein::cubic(h, {a[1], a[2]}, {b[1], b[2]});
  Bernstein rate = Bernstein::quintic(h, a, b).derivative();
  rate *= 1 / h;
  return rate;
}

// Differences of positions over a short step say nothing of the acceleration any more; then those
// of the velocities do, and at last the accelerations at the ends alone.
Bernstein StepView::acceleration(const Projection &projection) const {
  const auto a = end_values(projection, *equations_, start_, *start_state_, *start_rates_);
  const auto b = end_values(projection, *equations_, end_, *end_state_, *end_rates_);
  const double h = length();
  const double rounding = 64 * std::numeric_limits<double>::epsilon();
  const double allowed = 1e-9 * std::max(std::abs(a[2]), std::abs(b[2]));
  if (rounding * std::max(std::abs(a[1]), std::abs(b[1])) > allowed * h)
    return Bernstein::line(a[2], b[2]);
  if (rounding * std::max(std::abs(a[0]), std::abs(b[0])) > allowed * h * h) {
    Bernstein slope = Bernstein::cubic(h, {a[1], a[2]}, {b[1], b[2]}).derivative();
    slope *= 1 / h;
    return slope;
  }
  Bernstein second = Bernstein::quintic(h, a, b).derivative().derivative();
  second *= 1 / (h * h);
  return second;
}

Bernstein StepView::coordinate(Index j) const {
  const Index v = equations_->layout().velocity() + j;
  return Bernstein::quintic(length(), {(*start_state_)[j], (*start_state_)[v], (*start_rates_)[v]},
                            {(*end_state_)[j], (*end_state_)[v], (*end_rates_)[v]});
}

Bernstein StepView::gap(std::size_t contact) const {
  const ContactPair &pair = equations_->contacts().pairs()[contact];
  Bernstein gap = displacement(pair.gap);
  gap += pair.clearance;
  return gap;
}

Bernstein StepView::gap_rate(std::size_t contact) const {
  return velocity(equations_->contacts().pairs()[contact].gap);
}

Bernstein StepView::first_order_state(Index place) const {
  return Bernstein::cubic(length(), {(*start_state_)[place], (*start_rates_)[place]},
                          {(*end_state_)[place], (*end_rates_)[place]});
}

Bernstein StepView::internal(Index i) const {
  return first_order_state(equations_->layout().internal() + i);
}

Bernstein StepView::drive(Index i) const {
  return first_order_state(equations_->layout().drive() + i);
}

Bernstein StepView::indicator(std::size_t contact, const AffineForm &form) const {
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
  return sum;
}

ContactCurves StepView::contact_curves(std::size_t contact) const {
  const ContactPair &pair = equations_->contacts().pairs()[contact];
  ContactCurves curves{.gap = gap(contact), .gap_rate = gap_rate(contact), .internal = {}};
  for (int i = 0; i < pair.n_internal(); ++i)
    curves.internal.push_back(internal(pair.internal_offset + i));
  return curves;
}

double StepView::force(std::size_t contact, const ContactCurves &curves, double tau) const {
  std::vector<double> internal_values;
  for (const Bernstein &curve : curves.internal)
    internal_values.push_back(curve(tau));
  return equations_->force(
      contact, equations_->modes()[contact],
      {.gap = curves.gap(tau), .gap_rate = curves.gap_rate(tau), .internal = internal_values});
}

double StepView::force(std::size_t contact, double tau) const {
  return force(contact, contact_curves(contact), tau);
}

} // namespace vibroimpact
