#include "motion/moments/contact_course.h"

#include "common/decompositions.h"
#include "contact/free_mode.h"
#include "motion/episode/gauss_jacobi.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

using contact::AffineForm;

namespace {

constexpr int degree = n_moments + 3;
constexpr std::size_t most_changes = 24; ///< of one contact in a step
/// Of the terms of a guard: what rounding leaves of one that is zero where a mode begins.
constexpr double zero_at_start = 1e-13;

struct Rule {
  std::vector<double> nodes, weights;
};

Rule gauss_rule(int count) {
  const GaussRule rule = JacobiPolynomials(0, 0, count).rule();
  Rule result;
  for (Index i = 0; i < count; ++i) {
    result.nodes.push_back(static_cast<double>(rule.nodes[i]));
    result.weights.push_back(static_cast<double>(rule.weights[i]));
  }
  return result;
}

// x = s^2 (3 - 2 s): a force that begins or ends with a power p of the time does so with 2 p in s.
Rule graded_rule(int count) {
  Rule rule = gauss_rule(count);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double s = rule.nodes[i];
    rule.weights[i] *= 6 * s * (1 - s);
    rule.nodes[i] = s * s * (3 - 2 * s);
  }
  return rule;
}

double basis_at_node(int j, Index node) {
  return Bernstein::basis(degree, j)(moment_nodes()[static_cast<std::size_t>(node)]);
}

// From both values and differences at the ends to what is left at the nodes, and from this to the
// coefficients between: the inner ones by the outer four and the values at the nodes.
struct InnerCoefficients {
  Matrix by_outer = Matrix(n_moments, 4), by_nodes;

  InnerCoefficients() {
    constexpr std::array<int, 4> outer = {0, 1, degree - 1, degree};
    Matrix inner(n_moments, n_moments);
    for (Index i = 0; i < n_moments; ++i) {
      for (Index j = 0; j < n_moments; ++j)
        inner(i, j) = basis_at_node(static_cast<int>(j) + 2, i);
      for (Index j = 0; j < 4; ++j)
        by_outer(i, j) = -basis_at_node(outer[static_cast<std::size_t>(j)], i);
    }
    by_nodes = vibroimpact::inverse(inner);
    by_outer = (by_nodes * by_outer).eval();
  }
};

bool positive(const Bernstein &curve) { return curve.lower_bound() > 0; }

double largest(const Bernstein &curve) {
  return std::max(std::abs(curve.lower_bound()), std::abs(curve.upper_bound()));
}

// The part of the step from x on at which the form falls through zero; `negligible`: what rounding
// makes of its value at x.
template <class Negligible>
std::optional<double> fall_behind(const Bernstein &form, double x, const Negligible &negligible) {
  Bernstein rest = x > 0 ? form.behind(x) : form;
  if (positive(rest))
    return {};
  if (const double size = negligible(); std::abs(rest.start()) <= size)
    rest.clear_start(size);
  const std::optional<double> fall = rest.first_down_crossing();
  return fall ? std::optional(x + *fall * (1 - x)) : std::nullopt;
}

// (2 k + 1) times the integral of P_k(2 x - 1) and each Bernstein polynomial.
const std::array<std::array<double, degree + 1>, n_moments> &moments_of_polynomials() {
  static const auto values = [] {
    std::array<std::array<double, degree + 1>, n_moments> list{};
    const Rule rule = gauss_rule(6);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const auto p = shifted_legendre(rule.nodes[i]);
      for (std::size_t k = 0; k < n_moments; ++k)
        for (int j = 0; j <= degree; ++j)
          list[k][static_cast<std::size_t>(j)] += (2 * static_cast<double>(k) + 1) *
                                                  rule.weights[i] * p[k] *
                                                  Bernstein::basis(degree, j)(rule.nodes[i]);
    }
    return list;
  }();
  return values;
}

// Six nodes integrate the product of a gap of degree 7 and P_3 exactly. A force that is no affine
// form may begin and end in a power.
const Rule &rule_for(const contact::Mode &mode) {
  static const Rule plain = gauss_rule(6), graded = graded_rule(12);
  return mode.affine ? plain : graded;
}

} // namespace

const std::array<double, n_moments> &moment_nodes() {
  static const auto nodes = [] {
    std::array<double, n_moments> list{};
    std::ranges::copy(gauss_rule(n_moments).nodes, list.begin());
    return list;
  }();
  return nodes;
}

DirectionCurve::DirectionCurve(const PathValues &values, double h, double speed) {
  static const InnerCoefficients inner;
  constexpr double n = degree;
  std::array<double, degree + 1> list{};
  list[0] = values.start;
  list[1] = values.start + h * values.start_rate / n;
  list[degree - 1] = values.end - h * values.end_rate / n;
  list[degree] = values.end;
  const Eigen::Vector4d outer(list[0], list[1], list[degree - 1], list[degree]);
  for (Index j = 0; j < n_moments; ++j) {
    double &coefficient = list[static_cast<std::size_t>(j) + 2];
    coefficient = inner.by_outer.row(j) * outer;
    for (Index i = 0; i < n_moments; ++i)
      coefficient += inner.by_nodes(j, i) * values.nodes[static_cast<std::size_t>(i)];
  }
  position = way = Bernstein::of_coefficients(list);
  rate = position.derivative();
  rate *= 1 / h;
  if (speed != 0) {
    rate += speed;
    way += Bernstein::line(0, speed * h);
  }
}

bool ContactCourse::holds(const contact::ContactLaw &law) {
  const auto follows = [](AffineForm form) {
    form.gap_rate = 0;
    for (contact::DirectionForm &along : form.tangential)
      along.rate = 0;
    return form.zero();
  };
  return !law.rigid() && std::ranges::all_of(law.modes(), [&](const contact::Mode &mode) {
    return !mode.holds() &&
           (law.n_internal() == 0 ||
            (mode.affine && std::ranges::all_of(mode.affine->internal_rate, follows)));
  });
}

contact::LocalState ContactCourse::at(const CourseStretch &stretch, double x) const {
  contact::LocalState state{.gap = curves_[0].position(x), .gap_rate = curves_[0].rate(x)};
  for (std::size_t k = 0; k < contact::most_tangential; ++k)
    state.tangential[k] = {.slip = curves_[k + 1].position(x), .slip_rate = curves_[k + 1].rate(x)};
  internal_.clear();
  for (const Bernstein &curve : stretch.internal)
    internal_.push_back(curve(x));
  state.internal = internal_;
  return state;
}

Bernstein ContactCourse::form(const AffineForm &form, const CourseStretch &stretch) const {
  Bernstein result = curves_[0].position; // of the full degree
  result *= form.gap;
  result += form.constant;
  const auto add = [&](double factor, Bernstein curve) {
    if (factor == 0)
      return;
    curve *= factor;
    result += curve;
  };
  for (std::size_t d = 0; d < most_directions; ++d) {
    const contact::DirectionForm along = form.along(static_cast<int>(d));
    if (d > 0)
      add(along.position, curves_[d].position);
    add(along.rate, curves_[d].rate);
  }
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    add(form.internal[i], stretch.internal[i]);
  return result;
}

// From their values at x on.
std::vector<Bernstein> ContactCourse::internal_of(const contact::Mode &mode, double x,
                                                  std::span<const double> values) const {
  std::vector<Bernstein> list;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Bernstein curve(values[i]);
    if (mode.affine && i < mode.affine->internal_rate.size())
      for (std::size_t d = 0; d < most_directions; ++d)
        if (const double factor = mode.affine->internal_rate[i].along(static_cast<int>(d)).rate;
            factor != 0) {
          Bernstein way = curves_[d].way;
          way += -way(x);
          way *= factor;
          curve += way;
        }
    list.push_back(curve);
  }
  return list;
}

// The internal states where a stretch has ended.
std::vector<double> ContactCourse::behind(const contact::Guard &guard,
                                          const CourseStretch &stretch) const {
  const contact::LocalState state = at(stretch, stretch.to);
  std::vector<double> values(state.internal.begin(), state.internal.end());
  for (std::size_t i = 0; i < guard.reset.size(); ++i)
    values[i] = guard.reset[i](state);
  return values;
}

// Internal states are sums of ways, which may be far larger.
double ContactCourse::negligible(const AffineForm &form, const CourseStretch &stretch,
                                 const contact::Mode &mode, std::array<double, 2> rounding) const {
  double size = std::abs(form.constant), lost = 0;
  for (std::size_t d = 0; d < most_directions; ++d) {
    const contact::DirectionForm along = form.along(static_cast<int>(d));
    size += std::abs(along.position) * largest(curves_[d].position) +
            std::abs(along.rate) * largest(curves_[d].rate);
    lost += std::abs(along.position) * rounding[0] + std::abs(along.rate) * rounding[1];
    for (std::size_t i = 0; i < form.internal.size(); ++i)
      size += std::abs(form.internal[i] *
                       mode.affine->internal_rate[i].along(static_cast<int>(d)).rate) *
              largest(curves_[d].way);
  }
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    size += std::abs(form.internal[i]) * largest(stretch.internal[i]);
  return std::max(zero_at_start * size, stretch.from == 0 ? lost : 0);
}

bool ContactCourse::follow(const contact::ContactLaw &law, int mode,
                           std::span<const double> internal, std::array<double, 2> rounding) {
  std::vector<double> values(internal.begin(), internal.end());
  stretches_.clear();
  double x = 0;
  for (;;) {
    const contact::Mode &present = law.modes()[static_cast<std::size_t>(mode)];
    CourseStretch stretch{
        .from = x, .to = 1, .mode = mode, .internal = internal_of(present, x, values)};
    for (std::size_t g = 0; g < present.guards.size(); ++g) {
      const AffineForm &indicator = present.guards[g].indicator;
      const auto fall = fall_behind(form(indicator, stretch), x, [&] {
        return negligible(indicator, stretch, present, rounding);
      });
      if (fall && (!stretch.guard || *fall < stretch.to)) {
        stretch.to = *fall;
        stretch.guard = g;
      }
    }
    stretches_.push_back(stretch);
    if (!stretch.guard)
      return true;
    if (stretches_.size() > most_changes)
      return false;
    const contact::Guard &passed = present.guards[*stretch.guard];
    if (!values.empty())
      values = behind(passed, stretch);
    x = stretch.to;
    mode = passed.target;
    if (passed.by_slip)
      mode = law.mode_by_slip(mode, at(stretch, x));
  }
}

ContactCourse::Moments ContactCourse::moments(const contact::ContactLaw &law, std::size_t direction,
                                              contact::LawResponse &response) const {
  Moments result{};
  const contact::Mode &first = law.modes()[static_cast<std::size_t>(stretches_.front().mode)];
  if (!changes() && first.affine) {
    const Bernstein force =
        form(direction == 0 ? first.affine->force : first.affine->tangential_force[direction - 1],
             stretches_.front());
    for (std::size_t k = 0; k < n_moments; ++k)
      for (std::size_t j = 0; j <= degree; ++j)
        result[k] += moments_of_polynomials()[k][j] * force.coefficients()[j];
    return result;
  }
  for (const CourseStretch &stretch : stretches_) {
    const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
    const double length = stretch.to - stretch.from;
    if (contact::forceless(mode) || length == 0)
      continue;
    const Rule &rule = rule_for(mode);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double x = stretch.from + length * rule.nodes[i];
      law.evaluate(stretch.mode, at(stretch, x), response);
      const std::array<double, n_responses> p = shifted_legendre(x);
      for (std::size_t k = 0; k < n_moments; ++k)
        result[k] += (2 * static_cast<double>(k) + 1) * length * rule.weights[i] *
                     component_force(response, direction) * p[k];
    }
  }
  return result;
}

// Of F - p and s (F - p).
ContactCourse::Lack ContactCourse::lack(const contact::ContactLaw &law, std::size_t direction,
                                        const double *moments, const CourseStretch &stretch,
                                        double to, contact::LawResponse &response) const {
  Lack sums{};
  const double length = to - stretch.from;
  const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
  const Rule &rule = rule_for(mode);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double s = stretch.from + length * rule.nodes[i];
    const std::array<double, n_responses> p = shifted_legendre(s);
    double force = 0;
    for (std::size_t k = 0; k < n_moments; ++k)
      force -= moments[k] * p[k];
    if (!contact::forceless(mode)) {
      law.evaluate(stretch.mode, at(stretch, s), response);
      force += component_force(response, direction);
    }
    sums[0] += length * rule.weights[i] * force;
    sums[1] += length * rule.weights[i] * s * force;
  }
  return sums;
}

void ContactCourse::sum_lacks(const contact::ContactLaw &law, std::size_t direction,
                              const double *moments, contact::LawResponse &response) {
  std::vector<Lack> &sums = lacks_[direction];
  sums.assign(1, {});
  for (const CourseStretch &stretch : stretches_) {
    const Lack next = lack(law, direction, moments, stretch, stretch.to, response);
    sums.push_back({sums.back()[0] + next[0], sums.back()[1] + next[1]});
  }
}

std::array<double, 2> ContactCourse::lacking(const contact::ContactLaw &law, std::size_t direction,
                                             const double *moments, double x,
                                             contact::LawResponse &response) const {
  std::size_t k = 0;
  while (k + 1 < stretches_.size() && stretches_[k].to < x)
    ++k;
  const Lack part = lack(law, direction, moments, stretches_[k], x, response);
  const double force = lacks_[direction][k][0] + part[0];
  return {force, x * force - lacks_[direction][k][1] - part[1]};
}

ForceIntegrals ContactCourse::integrals(const contact::ContactLaw &law,
                                        const CourseStretch &stretch,
                                        const std::function<double(std::size_t, double)> &base_rate,
                                        contact::LawResponse &response) const {
  const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
  ForceIntegrals result;
  if (contact::forceless(mode))
    return result;
  const Rule &rule = rule_for(mode);
  const double length = stretch.to - stretch.from;
  const std::size_t directions = 1 + static_cast<std::size_t>(law.n_tangential());
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double x = stretch.from + length * rule.nodes[i], weight = length * rule.weights[i];
    law.evaluate(stretch.mode, at(stretch, x), response);
    result.force += weight * response.force;
    result.dissipated += weight * response.dissipated_power;
    for (std::size_t d = 0; d < directions; ++d)
      result.carried += weight * component_force(response, d) * base_rate(d, x);
    if (directions == 1)
      continue;
    result.friction += weight * response.friction_power;
    result.wear += weight * response.force * response.sliding_speed;
    result.sliding += weight * response.sliding_speed;
  }
  return result;
}

} // namespace vibroimpact::motion
