#include "motion/moments/contact_course.h"

#include "common/decompositions.h"
#include "motion/episode/gauss_jacobi.h"
#include "motion/interval/bernstein.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

constexpr std::size_t degree = GapCurve::size - 1;
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

// The inner coefficients from what the outer ones leave at the nodes.
const Matrix &inner_coefficients() {
  static const Matrix inverse = [] {
    Matrix values(n_moments, n_moments);
    for (Index i = 0; i < n_moments; ++i)
      for (Index j = 0; j < n_moments; ++j)
        values(i, j) = bernstein_polynomials(
            moment_nodes()[static_cast<std::size_t>(i)])[static_cast<std::size_t>(j) + 2];
    return vibroimpact::inverse(values);
  }();
  return inverse;
}

// The outer coefficients' polynomials at the nodes.
const std::array<std::array<double, 4>, n_moments> &outer_polynomials() {
  static const auto values = [] {
    std::array<std::array<double, 4>, n_moments> list{};
    for (std::size_t i = 0; i < n_moments; ++i) {
      const auto all = bernstein_polynomials(moment_nodes()[i]);
      list[i] = {all[0], all[1], all[degree - 1], all[degree]};
    }
    return list;
  }();
  return values;
}

// Of the part from x to 1 (de Casteljau).
GapCurve::Coefficients behind(const GapCurve::Coefficients &coefficients, double x) {
  GapCurve::Coefficients b = coefficients;
  for (std::size_t first = 1; first <= degree; ++first)
    for (std::size_t j = 0; j + first <= degree; ++j)
      b[j] += x * (b[j + 1] - b[j]);
  return b;
}

bool positive(const GapCurve::Coefficients &coefficients) {
  return *std::min_element(coefficients.begin(), coefficients.end()) > 0;
}

// The part of the step from x on at which the form falls through zero; `rounding`: of its value at
// x = 0.
std::optional<double> fall_behind(const GapCurve::Coefficients &form, double x, double rounding) {
  const GapCurve::Coefficients rest = x > 0 ? behind(form, x) : form;
  if (positive(rest))
    return {};
  Bernstein curve = Bernstein::of_coefficients(rest);
  double largest = 0;
  for (const double coefficient : form)
    largest = std::max(largest, std::abs(coefficient));
  const double negligible = std::max(zero_at_start * largest, x == 0 ? rounding : 0);
  if (std::abs(rest[0]) <= negligible)
    curve.clear_start(negligible);
  const std::optional<double> fall = curve.first_down_crossing();
  return fall ? std::optional(x + *fall * (1 - x)) : std::nullopt;
}

// (2 k + 1) times the integral of P_k(2 x - 1) and each Bernstein polynomial.
const std::array<std::array<double, GapCurve::size>, n_moments> &moments_of_polynomials() {
  static const auto values = [] {
    std::array<std::array<double, GapCurve::size>, n_moments> list{};
    const Rule rule = gauss_rule(6);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const auto p = shifted_legendre(rule.nodes[i]);
      const auto polynomials = bernstein_polynomials(rule.nodes[i]);
      for (std::size_t k = 0; k < n_moments; ++k)
        for (std::size_t j = 0; j <= degree; ++j)
          list[k][j] += (2 * static_cast<double>(k) + 1) * rule.weights[i] * p[k] * polynomials[j];
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

GapCurve::Coefficients bernstein_polynomials(double x) {
  GapCurve::Coefficients list{1};
  for (std::size_t n = 1; n <= degree; ++n) { // one degree more
    for (std::size_t j = n; j > 0; --j)
      list[j] = x * list[j - 1] + (1 - x) * list[j];
    list[0] *= 1 - x;
  }
  return list;
}

bool forceless(const contact::Mode &mode) { return mode.affine && mode.affine->force.zero(); }

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
  constexpr double n = degree;
  gap_[0] = values.start;
  gap_[1] = values.start + h * values.start_rate / n;
  gap_[degree - 1] = values.end - h * values.end_rate / n;
  gap_[degree] = values.end;
  std::array<double, n_moments> left{};
  for (std::size_t i = 0; i < n_moments; ++i) {
    const auto &outer = outer_polynomials()[i];
    left[i] = values.nodes[i] - outer[0] * gap_[0] - outer[1] * gap_[1] -
              outer[2] * gap_[degree - 1] - outer[3] * gap_[degree];
  }
  const Matrix &inner = inner_coefficients();
  for (Index j = 0; j < n_moments; ++j)
    for (Index i = 0; i < n_moments; ++i)
      gap_[static_cast<std::size_t>(j) + 2] += inner(j, i) * left[static_cast<std::size_t>(i)];
  std::array<double, degree> slopes{};
  for (std::size_t j = 0; j < degree; ++j)
    slopes[j] = n * (gap_[j + 1] - gap_[j]) / h;
  for (std::size_t j = 0; j <= degree; ++j) { // raised by one degree
    const double share = static_cast<double>(j) / n;
    rate_[j] = (j > 0 ? share * slopes[j - 1] : 0) + (j < degree ? (1 - share) * slopes[j] : 0);
  }
}

GapCurve::Coefficients GapCurve::form(const contact::AffineForm &form) const {
  Coefficients result{};
  for (std::size_t j = 0; j < size; ++j)
    result[j] = form.constant + form.gap * gap_[j] + form.gap_rate * rate_[j];
  return result;
}

double GapCurve::slope(const contact::AffineForm &form, double x) const {
  return Bernstein::of_coefficients(this->form(form)).derivative()(x);
}

double GapCurve::start_rounding(const contact::AffineForm &form) const {
  return std::abs(form.gap) * rounding_ + std::abs(form.gap_rate) * rate_rounding_;
}

contact::LocalState GapCurve::at(const Coefficients &polynomials) const {
  contact::LocalState state;
  for (std::size_t j = 0; j < size; ++j) {
    state.gap += polynomials[j] * gap_[j];
    state.gap_rate += polynomials[j] * rate_[j];
  }
  return state;
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
    const GapCurve::Coefficients force = curve_.form(first.affine->force);
    for (std::size_t k = 0; k < n_moments; ++k)
      for (std::size_t j = 0; j <= degree; ++j)
        result[k] += moments_of_polynomials()[k][j] * force[j];
    return result;
  }
  for (const CourseStretch &stretch : stretches_) {
    const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
    const double length = stretch.to - stretch.from;
    if (forceless(mode) || length == 0)
      continue;
    const Rule &rule = rule_for(mode);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double x = stretch.from + length * rule.nodes[i];
      law.evaluate(stretch.mode, curve_.at(bernstein_polynomials(x)), response);
      const std::array<double, n_responses> p = shifted_legendre(x);
      for (std::size_t k = 0; k < n_moments; ++k)
        result[k] +=
            (2 * static_cast<double>(k) + 1) * length * rule.weights[i] * response.force * p[k];
    }
  }
  return result;
}

std::array<double, 2> ContactCourse::lacking(const contact::ContactLaw &law, const double *moments,
                                             double x, contact::LawResponse &response) const {
  std::array<double, 2> sums{};
  for (const CourseStretch &stretch : stretches_) {
    const double length = std::min(x, stretch.to) - stretch.from;
    if (!(length > 0))
      break;
    const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
    const Rule &rule = rule_for(mode);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double s = stretch.from + length * rule.nodes[i];
      const std::array<double, n_responses> p = shifted_legendre(s);
      double force = 0;
      for (std::size_t k = 0; k < n_moments; ++k)
        force -= moments[k] * p[k];
      if (!forceless(mode)) {
        law.evaluate(stretch.mode, curve_.at(bernstein_polynomials(s)), response);
        force += response.force;
      }
      sums[0] += length * rule.weights[i] * force;
      sums[1] += length * rule.weights[i] * (x - s) * force;
    }
  }
  return sums;
}

ForceIntegrals ContactCourse::integrals(const contact::ContactLaw &law,
                                        const CourseStretch &stretch,
                                        const std::function<double(double)> &base_rate,
                                        contact::LawResponse &response) const {
  const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
  ForceIntegrals result;
  if (forceless(mode))
    return result;
  const Rule &rule = rule_for(mode);
  const double length = stretch.to - stretch.from;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double x = stretch.from + length * rule.nodes[i];
    law.evaluate(stretch.mode, curve_.at(bernstein_polynomials(x)), response);
    result.force += length * rule.weights[i] * response.force;
    result.dissipated += length * rule.weights[i] * response.dissipated_power;
    if (base_rate)
      result.carried += length * rule.weights[i] * response.force * base_rate(x);
  }
  return result;
}

} // namespace vibroimpact::motion
