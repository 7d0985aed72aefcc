#include "motion/collocation/force_family.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {

namespace {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

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
    : shape_(shape), rule_(JacobiPolynomials(shape.begin, shape.end, shape.nodes).rule()),
      nodes_(rule_.nodes.cast<double>()), weights_(shape.nodes), denominators_(shape.nodes) {
  for (int j = 0; j < shape.nodes; ++j) {
    weights_[j] = std::pow(rule_.nodes[j], static_cast<long double>(shape.begin)) *
                  std::pow(rule_.rest[j], static_cast<long double>(shape.end));
    denominators_[j] = 1;
    for (int k = 0; k < shape.nodes; ++k)
      if (k != j)
        denominators_[j] *= rule_.nodes[j] - rule_.nodes[k];
  }
  set_coefficients();
  set_bernstein();
}

LongArray ForceFamily::quotients(long double x) const {
  LongArray values(size());
  for (int j = 0; j < size(); ++j) {
    long double product = 1;
    for (int k = 0; k < size(); ++k)
      if (k != j)
        product *= x - rule_.nodes[k];
    values[j] = product / denominators_[j] / weights_[j];
  }
  return values;
}

LongArray ForceFamily::functions(long double x, long double rest) const {
  return quotients(x) * (std::pow(x, static_cast<long double>(shape_.begin)) *
                         std::pow(rest, static_cast<long double>(shape_.end)));
}

// The Gauss rule is exact for the product of two polynomials of the family.
void ForceFamily::set_coefficients() {
  const JacobiPolynomials polynomials(shape_.begin, shape_.end, size());
  coefficients_.resize(3, size());
  for (int j = 0; j < size(); ++j) {
    const LongArray p = polynomials.at(rule_.nodes[j]) * (rule_.weights[j] / weights_[j]);
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
  bernstein_ = values.fullPivLu().solve(scaled).cast<double>();
}

double ForceFamily::tail(const double *forces) const {
  const Vector parts = coefficients_ * ConstVectorView(forces, size());
  const double last = std::max(std::abs(parts[1]), std::abs(parts[2]));
  return last / std::abs(parts[0]);
}

bool ForceFamily::is_positive(const double *forces) const {
  constexpr int most_halvings = 6;
  return positive(bernstein_ * ConstVectorView(forces, size()), most_halvings);
}

} // namespace vibroimpact::motion
