#include "motion/moments/contact_course.h"

#include "common/decompositions.h"
#include "contact/free_mode.h"
#include "motion/episode/gauss_jacobi.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

constexpr int degree = n_moments + 3;
constexpr std::size_t most_changes = 24; ///< of one contact in a step
/// Of the largest coefficient of the step: what rounding leaves of a guard that is zero where a
/// mode begins.
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

// The part of the step from x on at which the form falls through zero; `rounding`: of its value at
// x = 0.
std::optional<double> fall_behind(const Bernstein &form, double x, double rounding) {
  Bernstein rest = x > 0 ? form.behind(x) : form;
  if (positive(rest))
    return {};
  const double largest = std::max(std::abs(form.lower_bound()), std::abs(form.upper_bound()));
  const double negligible = std::max(zero_at_start * largest, x == 0 ? rounding : 0);
  if (std::abs(rest.start()) <= negligible)
    rest.clear_start(negligible);
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

GapCurve::GapCurve(const GapValues &values, double h)
    : rounding_(values.rounding), rate_rounding_(values.rate_rounding) {
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
  gap_ = Bernstein::of_coefficients(list);
  rate_ = gap_.derivative();
  rate_ *= 1 / h;
}

Bernstein GapCurve::form(const contact::AffineForm &form) const {
  Bernstein result = gap_;
  result *= form.gap;
  if (form.gap_rate != 0) {
    Bernstein rate = rate_;
    rate *= form.gap_rate;
    result += rate;
  }
  result += form.constant;
  return result;
}

double GapCurve::start_rounding(const contact::AffineForm &form) const {
  return std::abs(form.gap) * rounding_ + std::abs(form.gap_rate) * rate_rounding_;
}

bool ContactCourse::follow(const contact::ContactLaw &law, const GapCurve &curve, int mode) {
  curve_ = curve;
  stretches_.clear();
  double x = 0;
  for (;;) {
    const contact::Mode &present = law.modes()[static_cast<std::size_t>(mode)];
    CourseStretch stretch{.from = x, .to = 1, .mode = mode};
    for (std::size_t g = 0; g < present.guards.size(); ++g) {
      const contact::AffineForm &indicator = present.guards[g].indicator;
      const auto fall = fall_behind(curve.form(indicator), x, curve.start_rounding(indicator));
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
    x = stretch.to;
    mode = present.guards[*stretch.guard].target;
  }
}

ContactCourse::Moments ContactCourse::moments(const contact::ContactLaw &law,
                                              contact::LawResponse &response) const {
  Moments result{};
  const contact::Mode &first = law.modes()[static_cast<std::size_t>(stretches_.front().mode)];
  if (!changes() && first.affine) {
    const Bernstein force = curve_.form(first.affine->force);
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
      law.evaluate(stretch.mode, curve_.at(x), response);
      const std::array<double, n_responses> p = shifted_legendre(x);
      for (std::size_t k = 0; k < n_moments; ++k)
        result[k] +=
            (2 * static_cast<double>(k) + 1) * length * rule.weights[i] * response.force * p[k];
    }
  }
  return result;
}

// Of F - p and s (F - p).
ContactCourse::Lack ContactCourse::lack(const contact::ContactLaw &law, const double *moments,
                                        const CourseStretch &stretch, double to,
                                        contact::LawResponse &response) const {
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
      law.evaluate(stretch.mode, curve_.at(s), response);
      force += response.force;
    }
    sums[0] += length * rule.weights[i] * force;
    sums[1] += length * rule.weights[i] * s * force;
  }
  return sums;
}

void ContactCourse::sum_lacks(const contact::ContactLaw &law, const double *moments,
                              contact::LawResponse &response) {
  lacks_.assign(1, {});
  for (const CourseStretch &stretch : stretches_) {
    const Lack next = lack(law, moments, stretch, stretch.to, response);
    lacks_.push_back({lacks_.back()[0] + next[0], lacks_.back()[1] + next[1]});
  }
}

std::array<double, 2> ContactCourse::lacking(const contact::ContactLaw &law, const double *moments,
                                             double x, contact::LawResponse &response) const {
  std::size_t k = 0;
  while (k + 1 < stretches_.size() && stretches_[k].to < x)
    ++k;
  const Lack part = lack(law, moments, stretches_[k], x, response);
  const double force = lacks_[k][0] + part[0];
  return {force, x * force - lacks_[k][1] - part[1]};
}

ForceIntegrals ContactCourse::integrals(const contact::ContactLaw &law,
                                        const CourseStretch &stretch,
                                        const std::function<double(double)> &base_rate,
                                        contact::LawResponse &response) const {
  const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
  ForceIntegrals result;
  if (contact::forceless(mode))
    return result;
  const Rule &rule = rule_for(mode);
  const double length = stretch.to - stretch.from;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double x = stretch.from + length * rule.nodes[i];
    law.evaluate(stretch.mode, curve_.at(x), response);
    result.force += length * rule.weights[i] * response.force;
    result.dissipated += length * rule.weights[i] * response.dissipated_power;
    if (base_rate)
      result.carried += length * rule.weights[i] * response.force * base_rate(x);
  }
  return result;
}

} // namespace vibroimpact::motion
