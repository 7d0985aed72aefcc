#include "motion/interval/step_view.h"

#include "motion/interval/constraint_force.h"
#include "motion/interval/guard_products.h"

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
  const StateLayout &layout = equations().layout();
  return Bernstein::hermite(length(), end_values(projection, layout, *start_).list(),
                            end_values(projection, layout, *end_).list());
}

namespace {

// What differences of values as large as these lose in rounding.
double lost(double a, double b) {
  return 64 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

// Where errors of two Hermite polynomials or their derivatives do not vanish.
bool differ(const Bernstein &a, const Bernstein &b, double by) {
  return std::abs(a(0.25) - b(0.25)) > by;
}

} // namespace

// Over a short step differences of positions are rounding alone; then the velocities at the ends
// say more: where the two differ by no more than that rounding.
Bernstein StepView::velocity(const Projection &projection) const {
  const EndValues start = end_values(projection, equations().layout(), *start_);
  const EndValues end = end_values(projection, equations().layout(), *end_);
  const double h = length();
  const Bernstein by_positions = Bernstein::hermite_rate(h, start.list(), end.list());
  const Bernstein by_rates = Bernstein::hermite(h, start.list().subspan(1), end.list().subspan(1));
  return differ(by_positions, by_rates, lost(start.values[0], end.values[0]) / h) ? by_positions
                                                                                  : by_rates;
}

// Likewise by the positions, the velocities, or at last the accelerations at the ends alone. Third
// derivatives at the ends that change the acceleration by far more than it is are left out: a force
// like u^(1/4) begins and ends with an infinite one. Where a step resolves the motion,
// h |third| = |change of the acceleration| is twice as large as that at most.
Bernstein StepView::acceleration(const Projection &projection) const {
  EndValues start = end_values(projection, equations().layout(), *start_);
  EndValues end = end_values(projection, equations().layout(), *end_);
  const double h = length();
  constexpr std::size_t third = 3;
  constexpr double most = 8;
  if (start.count > third &&
      h * std::max(std::abs(start.values[third]), std::abs(end.values[third])) >
          most * std::max(std::abs(start.values[2]), std::abs(end.values[2])))
    start.count = end.count = third;
  Bernstein by_positions =
      Bernstein::hermite(h, start.list(), end.list()).derivative().derivative();
  by_positions *= 1 / (h * h);
  Bernstein by_rates =
      Bernstein::hermite(h, start.list().subspan(1), end.list().subspan(1)).derivative();
  by_rates *= 1 / h;
  if (differ(by_positions, by_rates, lost(start.values[0], end.values[0]) / (h * h)))
    return by_positions;
  const Bernstein by_ends = Bernstein::hermite(h, start.list().subspan(2), end.list().subspan(2));
  return differ(by_rates, by_ends, lost(start.values[1], end.values[1]) / h) ? by_rates : by_ends;
}

Bernstein StepView::coordinate(Index j) const {
  const Index v = equations().layout().velocity() + j;
  EndValues start{.values = {start_->state[j]}, .count = 1};
  EndValues end{.values = {end_->state[j]}, .count = 1};
  add_derivatives(*start_, v, start);
  add_derivatives(*end_, v, end);
  return Bernstein::hermite(length(), start.list(), end.list());
}

Bernstein StepView::position(std::size_t contact, int direction) const {
  if (equations().contacts().pairs()[contact].circle)
    return local_curve(*this, contact, contact::AffineForm::position_along(direction));
  const contact::Direction along = equations().contacts().pairs()[contact].along(direction);
  Bernstein position = displacement(*along.projection);
  position += along.offset;
  return position;
}

Bernstein StepView::rate(std::size_t contact, int direction) const {
  if (equations().contacts().pairs()[contact].circle)
    return local_curve(*this, contact, contact::AffineForm::rate_along(direction));
  const contact::Direction along = equations().contacts().pairs()[contact].along(direction);
  Bernstein rate = velocity(*along.projection);
  rate += along.speed;
  return rate;
}

Bernstein StepView::first_order_state(Index place) const {
  EndValues start{.values = {}, .count = 0};
  EndValues end{.values = {}, .count = 0};
  add_derivatives(*start_, place, start);
  add_derivatives(*end_, place, end);
  return Bernstein::hermite(length(), start.list(), end.list());
}

Bernstein StepView::internal(Index i) const {
  return first_order_state(equations().layout().internal() + i);
}

Bernstein StepView::drive(Index i) const {
  return first_order_state(equations().layout().drive() + i);
}

Bernstein StepView::constraint_force(std::size_t contact, int direction) const {
  return motion::constraint_force(*this, contact, direction);
}

Bernstein StepView::friction_force(std::size_t contact, int direction) const {
  const contact::Mode &mode = equations().mode(contact);
  if (mode.holds(direction))
    return constraint_force(contact, direction);
  const auto place = static_cast<std::size_t>(direction - 1);
  if (mode.affine)
    return indicator(contact, mode.affine->tangential_force[place]);
  return local_curve(*this, contact, [&](const contact::LocalState &state) {
    contact::LawResponse response;
    equations().contacts().pairs()[contact].law->evaluate(equations().modes()[contact], state,
                                                          response);
    return response.tangential[place].force;
  });
}

Bernstein StepView::squared_distance(std::size_t contact) const {
  const contact::ContactPair &pair = equations().contacts().pairs()[contact];
  Bernstein sum;
  for (int d = 0; d < 2; ++d) {
    Bernstein u = displacement(*pair.along(d).projection);
    u += pair.along(d).offset;
    sum += u * u;
  }
  return sum;
}

Bernstein StepView::internal_part(std::size_t contact, const contact::AffineForm &form) const {
  const Index first = equations().contacts().pairs()[contact].internal_offset;
  Bernstein sum(form.constant);
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    if (form.internal[i] != 0) {
      Bernstein state = internal(first + static_cast<Index>(i));
      state *= form.internal[i];
      sum += state;
    }
  return sum;
}

Bernstein StepView::circular_indicator(std::size_t contact, const contact::AffineForm &form) const {
  if (!is_product(form))
    return local_curve(*this, contact, form);
  const contact::CircularGap &circle = *equations().contacts().pairs()[contact].circle;
  const Bernstein radius = internal_part(contact, touching_radius(circle, form));
  Bernstein squared = squared_distance(contact);
  squared *= -1;
  Bernstein product = radius * radius;
  product += squared;
  product *= form.gap * circle.sense() / (2 * circle.clearance());
  return product;
}

// Of twice the degree where it is a sum of squares.
Bernstein StepView::margin(std::size_t contact) const {
  const auto &limit = equations().mode(contact).limit;
  if (!limit)
    return local_curve(*this, contact, contact::AffineForm{.margin = 1});
  const Bernstein radius = indicator(contact, limit->radius);
  Bernstein product = radius * radius;
  for (const contact::AffineForm &form : limit->across) {
    const Bernstein part = indicator(contact, form);
    Bernstein square = part * part;
    square *= -1;
    product += square;
  }
  return product;
}

Bernstein StepView::indicator(std::size_t contact, const contact::AffineForm &form) const {
  const contact::ContactPair &pair = equations().contacts().pairs()[contact];
  if (pair.circle)
    return circular_indicator(contact, form);
  Bernstein sum;
  const auto add = [&sum](double factor, Bernstein curve) {
    curve *= factor;
    if (sum.degree() == 0 && sum.start() == 0)
      sum = curve;
    else
      sum += curve;
  };
  for (int d = 0; d < pair.n_directions(); ++d) {
    const contact::DirectionForm of = form.along(d);
    if (of.position != 0)
      add(of.position, position(contact, d));
    if (of.rate != 0)
      add(of.rate, rate(contact, d));
  }
  sum += form.constant;
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    if (form.internal[i] != 0)
      add(form.internal[i], internal(pair.internal_offset + static_cast<Index>(i)));
  if (form.margin != 0)
    add(form.margin, margin(contact));
  const bool by_value = form.sees_normal_force() && !equations().mode(contact).holds_gap;
  for (int d = by_value ? 1 : 0; d < pair.n_directions(); ++d)
    if (form.along(d).force != 0)
      add(form.along(d).force, constraint_force(contact, d));
  if (by_value)
    add(1, local_curve(*this, contact,
                       contact::AffineForm{.normal_force = form.normal_force,
                                           .normal_force_rate = form.normal_force_rate}));
  return sum;
}

ContactCurves StepView::contact_curves(std::size_t contact) const {
  const contact::ContactPair &pair = equations().contacts().pairs()[contact];
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
  return equations().force(contact, equations().modes()[contact],
                           {.gap = curves.gap(tau),
                            .gap_rate = curves.gap_rate(tau),
                            .internal = internal_values,
                            .normal_force = curves.normal_force(tau)});
}

double StepView::force(std::size_t contact, double tau) const {
  return force(contact, contact_curves(contact), tau);
}

} // namespace vibroimpact::motion
