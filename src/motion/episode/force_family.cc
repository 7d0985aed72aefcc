#include "motion/episode/force_family.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vibroimpact::motion {

namespace {

// A polynomial lies within the hull of its Bernstein coefficients; those of its halves by de
// Casteljau's algorithm lie closer.
bool positive(Vector coefficients, int halvings) {
  if (coefficients.minCoeff() > 0)
    return true;
  const Index degree = coefficients.size() - 1;
  if (halvings == 0 || !(coefficients[0] > 0) || !(coefficients[degree] > 0))
    return false;
  Vector left(degree + 1);
  for (Index k = 0; k <= degree; ++k) {
    left[k] = coefficients[0];
    for (Index i = 0; i < degree - k; ++i)
      coefficients[i] = 0.5 * (coefficients[i] + coefficients[i + 1]);
  }
  Vector right(degree + 1);
  right = coefficients;
  return positive(std::move(left), halvings - 1) && positive(std::move(right), halvings - 1);
}

} // namespace

ForceFamily::ForceFamily(const ForceShape &shape)
    : shape_(shape), stretch_(shape.begin_root, shape.end_root), rule_(polynomials().rule()),
      nodes_(shape.nodes), weights_(shape.nodes), denominators_(shape.nodes) {
  for (int j = 0; j < shape.nodes; ++j) {
    const EpisodeTime::Point at = stretch_.at(rule_.nodes[j], rule_.rest[j]);
    nodes_[j] = static_cast<double>(at.x);
    weights_[j] = std::pow(at.x, static_cast<long double>(shape.begin)) *
                  std::pow(at.rest, static_cast<long double>(shape.end));
    denominators_[j] = 1;
    for (int k = 0; k < shape.nodes; ++k)
      if (k != j)
        denominators_[j] *= rule_.nodes[j] - rule_.nodes[k];
  }
  set_coefficients();
  set_bernstein();
}

long double ForceFamily::smooth_weight(long double xi, long double rest) const {
  const EpisodeTime::Point at = stretch_.at(xi, rest);
  return std::pow(at.begin, static_cast<long double>(shape_.begin)) *
         std::pow(at.end, static_cast<long double>(shape_.end)) * at.slope_factor;
}

// What the weight has beside powers is analytic far around [0, 1]: so many points more give its
// products with polynomials to the last digit.
JacobiPolynomials ForceFamily::polynomials() const {
  constexpr int points_more = 80;
  if (shape_.begin_root == 1 && shape_.end_root == 1)
    return {shape_.begin, shape_.end, shape_.nodes};
  GaussRule rule = JacobiPolynomials(begin_power(), end_power(), shape_.nodes + points_more).rule();
  for (Index i = 0; i < rule.nodes.size(); ++i)
    rule.weights[i] *= smooth_weight(rule.nodes[i], rule.rest[i]);
  return {rule, shape_.nodes};
}

LongArray ForceFamily::quotients(long double xi) const {
  LongArray values(size());
  for (int j = 0; j < size(); ++j) {
    long double product = 1;
    for (int k = 0; k < size(); ++k)
      if (k != j)
        product *= xi - rule_.nodes[k];
    values[j] = product / denominators_[j] / weights_[j];
  }
  return values;
}

LongArray ForceFamily::functions(long double xi, long double rest) const {
  const EpisodeTime::Point at = stretch_.at(xi, rest);
  return quotients(xi) * (std::pow(at.x, static_cast<long double>(shape_.begin)) *
                          std::pow(at.rest, static_cast<long double>(shape_.end)));
}

// The Gauss rule is exact for the product of two polynomials of the family.
void ForceFamily::set_coefficients() {
  const JacobiPolynomials orthonormal = polynomials();
  coefficients_.resize(3, size());
  for (int j = 0; j < size(); ++j) {
    const LongArray p = orthonormal.at(rule_.nodes[j]) * (rule_.weights[j] / weights_[j]);
    coefficients_(0, j) = static_cast<double>(p[0]);
    coefficients_(1, j) = static_cast<double>(p[std::max(0, size() - 2)]);
    coefficients_(2, j) = static_cast<double>(p[size() - 1]);
  }
}

void ForceFamily::set_bernstein() {
  const int degree = size() - 1;
  LongMatrix values(size(), size());
  for (int j = 0; j < size(); ++j) {
    long double binomial = 1;
    for (int k = 0; k <= degree; ++k) {
      values(j, k) = binomial * std::pow(rule_.nodes[j], static_cast<long double>(k)) *
                     std::pow(rule_.rest[j], static_cast<long double>(degree - k));
      binomial *= static_cast<long double>(degree - k) / (k + 1);
    }
  }
  const LongMatrix scaled = LongMatrix(weights_.cwiseInverse().asDiagonal());
  bernstein_ = extended::solve_fully_pivoted(values, scaled).cast<double>();
}

double ForceFamily::tail(const double *forces, const double *whole) const {
  const Vector parts = coefficients_ * ConstVectorView(forces, size());
  const double last = std::max(std::abs(parts[1]), std::abs(parts[2]));
  return last / std::abs(coefficients_.row(0).dot(ConstVectorView(whole, size())));
}

bool ForceFamily::is_positive(const double *forces, bool falls_to_zero) const {
  constexpr int most_halvings = 6;
  Vector coefficients = bernstein_ * ConstVectorView(forces, size());
  if (falls_to_zero) // the last is the value at the end
    coefficients[size() - 1] = std::numeric_limits<double>::min();
  return positive(std::move(coefficients), most_halvings);
}

} // namespace vibroimpact::motion
